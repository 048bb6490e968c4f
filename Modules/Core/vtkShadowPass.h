/**
 * @class   vtkShadowPass
 * @brief   Base of all shadow passes: what VTK draws, with each light's colour times its visibility.
 *
 * @code{.cpp}
 * auto pass = vtkSmartPointer<vtkShadowPass>::Take(vtkShadowTechniques::Create("map-pcss"));
 * renderer->SetPass(pass);
 * @endcode
 *
 * For light i and surface point p, visibility V_i(p) in [0,1] is the fraction of the light's area
 * that p sees past the casters (a colour for a textured light). Shading multiplies light i's colour
 * by 1 - A_i (1 - V_i), A_i being vtkLight::GetShadowAttenuation(). All else of shading is VTK's.
 *
 * A frame:
 *   1. gather lights and casters (kept while unchanged),
 *   2. the technique builds its light data (kept while lights, casters and parameters are unchanged;
 *      a moving camera rebuilds nothing),
 *   3. where visibility is evaluated in screen space: draw the receivers' positions and normals,
 *      then V_i of each light; both again for the nearest translucent surfaces, if there are any,
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

#include <functional> // For ForEachPart
#include <memory>     // For Internal
#include <string>     // For parameters
#include <utility>    // For std::pair
#include <vector>     // For common parameters

class vtkImageData;
class vtkInformationIntegerKey;
class vtkLight;
class vtkMatrix4x4;
class vtkProp;
class vtkRenderWindow;
class vtkVisibilityBuffer;
struct vtkShadowFrame;
struct vtkShadowLight;
struct vtkShadowParameter;
struct vtkShadowTechnique;
struct vtkShadowValue;

class VTKSOFTSHADOWSCORE_EXPORT vtkShadowPass : public vtkOpenGLRenderPass
{
public:
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
   * Which technique of the class this is, for a class that has several ("volume-hard",
   * "volume-soft"). Setting it restores the default parameters. vtkShadowTechniques::Create does
   * this. False, with an error, if the name is not one of this class.
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
  std::string GetParameter(const std::string& name);
  ///@}

  ///@{
  /**
   * Set the parameters that trade quality for time to their presets. Default: High.
   */
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
  virtual std::string GetDebugViews();

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
   * "Receiver", unsigned char, 1 where a surface is seen that is lit and receives, else 0. Translucent
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
   * JSON about the last frame: technique, GPU milliseconds by stage ("milliseconds"), what was
   * rebuilt, reused and skipped ("counts": casters, triangles, dropped triangles, maps drawn, ...),
   * bytes held on the GPU ("bytes"), and the lights and how each was treated.
   */
  std::string GetStatistics();

  /** Parameters that all techniques share. */
  static const std::vector<vtkShadowParameter>& GetCommonParameters();

  /**
   * Call a function with each prop in space that a prop draws, and its matrix: itself, the visible
   * parts of an assembly, or the chosen level of detail of a vtkLODProp3D.
   */
  static void ForEachPart(
    vtkProp* prop, const std::function<void(vtkProp*, vtkMatrix4x4*)>& function);

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

  //@{
  /** What a technique does; called with the window current, within a frame. */

  /**
   * Stage 2: bring the light data of frame.Lights up to date; count in frame.Counts. False where
   * it cannot be had, after an error that says why: the frame is then drawn without shadows.
   */
  virtual bool UpdateLightData(vtkShadowFrame& frame) = 0;
  /**
   * GLSL that defines `SHADOW_VISIBILITY shadowVisibility(int light, vec3 positionVC, vec3 normalVC)`
   * with what vtkShadowLightsFS.glsl declares, counting what it spends in shadowCost. Empty for a
   * technique that fills the buffer itself.
   */
  virtual std::string GetVisibilityGLSL() { return ""; }
  /** Whether the light data is such that the GLSL can run in each prop's shader. */
  virtual bool CanEvaluateForward() { return !this->GetVisibilityGLSL().empty(); }
  /** Forward is better where this is true and the user has not said which. */
  virtual bool PrefersForward(const vtkShadowFrame&) { return true; }
  /** Bind the light data's textures, before drawing; and unbind them. */
  virtual void ActivateLightData(vtkShadowFrame&) {}
  virtual void DeactivateLightData(vtkShadowFrame&) {}
  /** Set what the GLSL needs, on each program that has it. */
  virtual void SetVisibilityParameters(vtkShaderProgram*) {}
  /**
   * Stage 3: fill the layer of each of frame.Lights in the buffer's target: the visibility, or the
   * quantity that a debug view wants. By default from the GLSL.
   */
  virtual void FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer);
  /** What "cost" shows as white: the most samples that a pixel can take. */
  virtual double GetMaximumCost() { return 1.0; }
  /**
   * The variable of the GLSL that a debug view shows as grey, its largest value white; empty for a
   * view that shows something else. The white is told by GetStatistics(): "debugViewWhite".
   */
  virtual std::string GetDebugQuantity(const std::string& view);
  /** A debug view of another kind, drawn over the viewport that is set. */
  virtual void DrawDebugView(vtkShadowFrame&, const std::string&) {}
  /** Free the light data. */
  virtual void ReleaseLightData(vtkRenderWindow* window) = 0;
  /** Bytes of the light data, by name. */
  virtual std::vector<std::pair<std::string, std::size_t>> GetLightDataBytes() { return {}; }
  /** Whether the window has what the technique needs; else a reason. */
  virtual std::string FindUnsupported(vtkRenderWindow*) { return ""; }
  //@}

  //@{
  /**
   * Whether the technique declares a parameter; and values of declared ones. To ask for another is an
   * error, and gives 0 or "".
   */
  bool HasParameter(const std::string& name) const;
  int GetInteger(const std::string& name);
  double GetReal(const std::string& name);
  bool GetBoolean(const std::string& name);
  std::string GetText(const std::string& name);
  //@}
  /** When parameters last changed: light data that depends on them is then to be built anew. */
  vtkMTimeType GetParameterTime();
  /**
   * Draw the GLSL's visibility of a light into the framebuffer that is bound. With a share, what is
   * drawn is the (negative) change of visibility, to be added up over parts of the light: the share
   * is this part's.
   */
  void DrawEvaluation(
    vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int light, double share = 0.0);
  /**
   * For a shader of the technique's own: what declares the lights (vtkShadowLightsFS.glsl), and its
   * uniforms.
   */
  std::string GetLightsGLSL();
  void SetLightParameters(vtkShaderProgram* program);
  /**
   * Take over the settings of another pass of this class: those that are here. A subclass with further
   * ones adds them.
   */
  virtual void CopySettings(vtkShadowPass* other);
  /** Free all that is on the GPU; a subclass's destructor calls this while it can still free. */
  void Detach();
  /** Draw a fragment shader over the viewport that is set. */
  void DrawQuad(
    const std::string& fragmentShader, const std::function<void(vtkShaderProgram*)>& setParameters);
  /** Say something once until the technique or a parameter is set again. */
  void WarnOnce(const std::string& message);
  void ErrorOnce(const std::string& message);

  double DefaultLightRadius = 0.0;

private:
  vtkShadowPass(const vtkShadowPass&) = delete;
  void operator=(const vtkShadowPass&) = delete;

  void SetQuality(int level);
  const vtkShadowParameter* FindParameter(const std::string& name) const;
  const vtkShadowValue& GetValue(const std::string& name);

  void RenderShadowed(const vtkRenderState* s);
  vtkShadowPass* FindCopy(vtkRenderer* renderer);
  bool IsInChain(vtkRenderer* renderer);
  void Attach(vtkRenderer* renderer);
  void ReleaseWhenRemoved(vtkObject* caller, unsigned long event, void* data);
  bool PrepareShadows(vtkRenderer* renderer);
  void SplitLights();
  void EvaluateVisibility(bool withCatchers);
  bool EvaluateReceivers(vtkVisibilityBuffer& buffer, bool translucent, bool withCatchers);
  void RenderReceivers(vtkVisibilityBuffer& buffer, bool translucent, bool withCatchers);
  void UpdateInjection(bool writesReceivers);
  void MarkProps(bool mark);
  void RenderDelegate(const vtkRenderState* s);
  void DrawDebug();
  bool UpdateVisibility();
  vtkImageData* MakeVisibility(vtkLight* light);

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
