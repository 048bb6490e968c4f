// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowPass
 * @brief   What VTK draws, with each light's colour times its visibility.
 *
 * @code{.cpp}
 * auto shadows = vtkSmartPointer<vtkShadowPass>::New(); // technique "map-pcss"
 * shadows->SetTechnique("map-soft");                    // or another
 * shadows->PutOn(renderer);
 * @endcode
 *
 * How visibility is found is its technique's, an object that it owns and can change at any time
 * (SetTechnique). The classes that are named after techniques are this one, beginning with theirs.
 *
 * For light i and surface point p, visibility V_i(p) in [0,1] is the fraction of the light's area
 * that p sees past the casters (a colour for a textured light). Shading multiplies light i's colour
 * by 1 - A_i (1 - V_i), A_i being vtkLight::GetShadowAttenuation(). All else of shading is VTK's.
 *
 * A frame, ordered by what the technique declares that it needs (vtkShadowTraits):
 *   1. gather lights and casters (kept while unchanged),
 *   2. the technique builds its light data (kept while lights, casters and parameters are unchanged;
 *      a moving camera rebuilds nothing, unless the technique's light data depends on the camera);
 *      before it, the receivers are drawn if it is made from them,
 *   3. where visibility is evaluated in screen space: draw the receivers' positions and normals, if they
 *      are not yet, then V_i of each light; signed shares of it are added up and kept within 0 and 1;
 *      both again for the nearest translucent surfaces, if there are any,
 *   4. the delegate draws what VTK draws, with V_i injected into each prop's fragment shader: from
 *      the technique's GLSL (forward) or from the buffer of stage 3,
 *   5. a debug view, if one is set.
 *
 * Textures: receivers RGBA32F, viewport size (position in VC, normal packed); visibility R32F or,
 * with a textured light, RGBA32F, viewport size, a layer each light (each part of a light, where
 * translucent casters count by their opacity); what the technique adds.
 *
 * A pass serves any number of renderers: each further one gets a copy of it, with light data of its own
 * and the same settings. GetVisibility and GetStatistics are about the renderer that was drawn last.
 * A renderer's shadows are drawn by one pass at a time: a shadow pass within another one says so and
 * draws without. The pass frees the GPU's memory when it leaves the renderer's chain of passes, and when
 * the window closes. Beyond the frame it keeps no prop.
 */

#ifndef vtkShadowPass_h
#define vtkShadowPass_h

#include "vtkOpenGLRenderPass.h"
#include "vtkSoftShadowsCoreModule.h" // For export macro

#include <memory> // For Internal
#include <string> // For parameters

class vtkImageData;
class vtkInformationIntegerKey;
class vtkLight;
class vtkProp;
class vtkRenderWindow;
class vtkShadowTechnique;

class VTKSOFTSHADOWSCORE_EXPORT vtkShadowPass : public vtkOpenGLRenderPass
{
public:
  /** With the technique "map-pcss", where its module is linked; else with none. */
  static vtkShadowPass* New();
  vtkTypeMacro(vtkShadowPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Give a renderer this pass, take all of its shadow passes off, or find it (nullptr if there is none),
   * wherever it stands: as the renderer's pass or within VTK's own ones, as a delegate, in a sequence or
   * a step. PutOn takes the place of the shadow pass that is there, and its delegate; where there is
   * none, this becomes the renderer's pass and the one before its delegate. TakeOff leaves the delegate
   * in the place; without one the renderer has no pass, and another pass VTK's own steps
   * (vtkRenderStepsPass).
   */
  void PutOn(vtkRenderer* renderer);
  static void TakeOff(vtkRenderer* renderer);
  static vtkShadowPass* FindOn(vtkRenderer* renderer);
  ///@}

  ///@{
  /**
   * What is shaded. Default: none, which draws everything that VTK draws without a pass: opaque,
   * translucent, volumetric and overlay, with the renderer's depth peeling, SSAO and FXAA. An error,
   * and nothing changes, for a pass that this one is within.
   */
  void SetDelegatePass(vtkRenderPass* delegate);
  vtkRenderPass* GetDelegatePass();
  ///@}

  ///@{
  /**
   * How visibility is found: any name that vtkShadowTechniques knows, also while a window runs: casters
   * and buffers stay, and the old technique's light data is freed at the next frame. Setting it restores
   * the default parameters, and the debug view "none" unless the new technique has it too. False, with an
   * error that names the choices, if the name is unknown; the technique is then as before.
   */
  bool SetTechnique(const std::string& name);
  std::string GetTechnique();
  ///@}

  ///@{
  /**
   * Parameters as text, as vtkShadowTechniques::Describe lists them. Numbers have a decimal point,
   * whatever the program's locale; a whole number may be written in any way (64, 64.0, 6.4e1); a
   * boolean is on, true or 1, or off, false or 0. SetParameter gives false, with an error that names
   * the choices, for an unknown name or a value that is out of range, and changes nothing then.
   * GetParameter gives the value, a whole number or a boolean in its plain form (64, on), or "", with
   * an error, for an unknown name.
   */
  bool SetParameter(const std::string& name, const std::string& value);
  bool SetParameter(const std::string& name, double value);
  std::string GetParameter(const std::string& name);
  ///@}

  ///@{
  /**
   * Set the parameters that trade quality for time to their presets. Preview is for interaction: less than
   * Low where a technique has less. Default: High.
   */
  void SetQualityToPreview() { this->SetQuality(-1); }
  void SetQualityToLow() { this->SetQuality(0); }
  void SetQualityToMedium() { this->SetQuality(1); }
  void SetQualityToHigh() { this->SetQuality(2); }
  void SetQualityToReference() { this->SetQuality(3); }
  ///@}

  ///@{
  /**
   * Show this instead of the picture: "none", "visibility" (of the light of the lowest V at each
   * pixel), "penumbra" (pixels with V in 0.02 to 0.98 coloured by V), "cost" (samples spent per
   * pixel; black 0, white the most), or what the technique adds (GetDebugViews). False, with an
   * error, for an unknown one.
   */
  bool SetDebugView(const std::string& view);
  std::string GetDebugView();
  ///@}
  /** The debug views of this technique, separated by spaces. */
  std::string GetDebugViews();

  ///@{
  /**
   * Radius, in world units, of the sphere that plain positional vtkLights are taken for. Default: 0,
   * points with hard shadows.
   */
  vtkSetClampMacro(DefaultLightRadius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(DefaultLightRadius, double);
  ///@}

  ///@{
  /**
   * Angle, in degrees, under which plain directional vtkLights are seen, among them those of a vtkLightKit: 0
   * to 90. The sun has 0.53; a lamp as large as a third of the scene, from one and a half of its diameters
   * away, 12.7. Default: 0, with hard shadows.
   */
  vtkSetClampMacro(DefaultLightAngle, double, 0.0, 90.0);
  vtkGetMacro(DefaultLightAngle, double);
  ///@}

  ///@{
  /**
   * Whether passes say, once each by a warning, what is probably not meant: lights that all shine from the
   * camera, none with a size, one inside the scene, or one that is far too small or large. Default: they do.
   */
  static void SetAdvice(bool advice);
  static bool GetAdvice();
  ///@}

  ///@{
  /**
   * Whether a prop or a light casts shadows, whether a prop receives them. Default: all do. Kept
   * in the prop's property keys and the light's information: CASTS_SHADOW, RECEIVES_SHADOW. An
   * assembly's switch holds for all of its parts: VTK lends them its keys.
   */
  static vtkInformationIntegerKey* CASTS_SHADOW();
  static vtkInformationIntegerKey* RECEIVES_SHADOW();
  static void SetCasting(vtkProp* prop, bool casts);
  static bool GetCasting(vtkProp* prop);
  static void SetReceiving(vtkProp* prop, bool receives);
  static bool GetReceiving(vtkProp* prop);
  static void SetLightCasting(vtkLight* light, bool casts);
  static bool GetLightCasting(vtkLight* light);
  ///@}

  ///@{
  /**
   * A shadow catcher is invisible but for the shadow on it: black, as opaque as the share of its
   * light that is in shadow, times its property's opacity. It is translucent, so that it is blended
   * over what lies behind, and casts nothing; a physically based one is shaded by Phong, for only its
   * lights are to count. Both are changes of the actors and their properties, which end with the catcher:
   * what the user has set of them stays. A picture with alpha, to be laid over another, needs the
   * renderer's depth peeling (VTK 9.1 writes a wrong alpha without). Default: none is. Kept in the
   * prop's property keys (SHADOW_CATCHER). VTK draws it as an ordinary prop where there is no shadow
   * pass.
   */
  static vtkInformationIntegerKey* SHADOW_CATCHER();
  static void SetShadowCatcher(vtkProp* prop, bool catches);
  static bool GetShadowCatcher(vtkProp* prop);
  ///@}

  ///@{
  /**
   * Whether the technique runs in a window (its OpenGL version, and what else it needs). If not,
   * GetUnsupportedReason says why, and Render reports it once and draws without shadows.
   */
  bool IsSupported(vtkRenderWindow* window);
  std::string GetUnsupportedReason();
  ///@}

  ///@{
  /**
   * Visibility of a light at the pixels of the last frame, as point data of an image the size of the
   * viewport: "Visibility", float, 1 component (3 for a textured light), 1 where nothing is seen;
   * "Receiver", unsigned char, 1 where a surface is seen that is lit and receives, else 0; "Cosine", float,
   * N.L of the direction to the middle of a light that casts, 0 where the surface turns away: as much diffuse
   * shading shows of V (1 of other lights, and where there is no receiver). Translucent
   * surfaces are seen through, but not shadow catchers.
   * The light is given by itself or by its number, from 0: first the lights that cast here (those
   * that are on, supported by the technique, and not beyond the sixteenth), then the renderer's
   * others. A light that casts no shadow gives 1, and so does number 0 where there is no light at all.
   * A pass that evaluates forward draws the receivers for it, at the first call after a frame, of the
   * scene and camera as they are then.
   * Each call makes an image of its own. The pass keeps it until the next call for the same light;
   * whoever needs it longer holds a reference, as vtkSmartPointer and Python do. nullptr, with an
   * error, before the first frame and for a light that is not there.
   */
  vtkImageData* GetVisibility(int light);
  vtkImageData* GetVisibility(vtkLight* light);
  ///@}

  /**
   * Whether another frame of what the last one showed would be the same. False before the first frame, and
   * with accumulate=on until all samples are taken:
   * @code{.cpp}
   * do
   * {
   *   window->Render();
   * } while (!shadows->IsFinished());
   * @endcode
   */
  bool IsFinished();

  ///@{
  /**
   * How far the visibility of a light in the last frame is from the truth, as JSON: from some two thousand of
   * its receivers, chosen at random (pixels that show a part of the light as many as others), by 256
   * rays each. "receivers", over all of them, and "penumbrae", over those that see 0.02 to 0.98 of the
   * light, have "rmse" and "bias" (V shown less V), each with a 95 % interval ("rmseInterval",
   * "biasInterval"), in V; "pixels" are those that were asked; "milliseconds" is what it took. Lights
   * are given as to GetVisibility. "", with an error, before the first frame, for a light that is not there
   * and where the module RayTracing is not built or linked. GetStatistics holds what was estimated of the
   * last frame, by the light's number ("errors").
   */
  std::string GetErrorEstimate(int light);
  std::string GetErrorEstimate(vtkLight* light);
  ///@}

  /**
   * JSON about the last frame: technique, GPU milliseconds by stage ("milliseconds"), what was
   * rebuilt, reused and skipped ("counts": casters, triangles, dropped triangles, maps drawn, ...),
   * bytes held on the GPU ("bytes"), and the lights and how each was treated.
   */
  std::string GetStatistics();

  ///@{
  /** The pass's part in VTK's rendering; not for users. */
  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override;
  ///@}

protected:
  vtkShadowPass();
  ~vtkShadowPass() override;

  /**
   * Give the technique what a subclass keeps for it beside its parameters. Called before each
   * frame.
   */
  virtual void PrepareTechnique(vtkShadowTechnique&) {}
  /**
   * Take over the settings of another pass: those that are here. A subclass with further ones adds them.
   */
  virtual void CopySettings(vtkShadowPass* other);

  double DefaultLightRadius = 0.0;
  double DefaultLightAngle = 0.0;

private:
  vtkShadowPass(const vtkShadowPass&) = delete;
  void operator=(const vtkShadowPass&) = delete;

  void SetQuality(int level);

  void RenderShadowed(const vtkRenderState* s);
  void FitUnplacedLights(vtkRenderer* renderer);
  bool PrepareShadows(vtkRenderer* renderer, bool accumulates);
  void DrawReceivers(bool translucent, bool withCatchers);
  bool EvaluateVisibility(bool withCatchers);
  bool EvaluateScreen(bool translucent, bool withCatchers);
  void RenderDelegate(const vtkRenderState* s);
  bool UpdateVisibility();
  vtkImageData* MakeVisibility(vtkLight* light);
  std::string EstimateError(vtkImageData* visibility, int light);

  vtkShadowPass* FindCopy(vtkRenderer* renderer);
  bool IsInChain(vtkRenderer* renderer);
  void Attach(vtkRenderer* renderer);
  void Detach();
  void ReleaseWhenRemoved(vtkObject* caller, unsigned long event, void* data);

  class Internals;
  std::unique_ptr<Internals> Internal;
};

/**
 * What a class that is the pass under a technique's name needs beside its declaration: New, which begins
 * with that technique.
 */
#define vtkShadowPassOfTechniqueMacro(Class, technique) \
  vtkStandardNewMacro(Class);                           \
  Class::Class()                                        \
  {                                                     \
    this->SetTechnique(technique);                      \
  }                                                     \
  Class::~Class() = default

#endif
