// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowStudio
 * @brief   The light of a photographer's studio for a renderer: large, soft, and never black or burnt.
 *
 * @code{.cpp}
 * vtkNew<vtkShadowStudio> studio;
 * studio->PutOn(renderer); // and a vtkShadowPass, which draws the shadows
 * @endcode
 *
 * A key light casts the shadows; two fills, from the camera and from its other side, light what the key does
 * not reach and cast none; and a ground catches the shadow of what stands on it, and fades out. Nothing depends on the scene's size or
 * place: the key is a distant disk (a directional vtkAreaLight), whose angle is that of a light as large as
 * `Softness` of the scene, and the ground lies under the bounds of what is seen, in every frame.
 *
 * Exposure is kept: the brightest that the two lights together can make a white surface, whatever way it
 * faces, is just white. In shadow and on unlit sides alike the fills leave 1 - `Darkness`.
 *
 * The renderer's lights that are on are switched off meanwhile, VTK's own headlight among them. TakeOff puts
 * everything back: the lights, the renderer's settings, the camera's clipping range. A renderer keeps its
 * studio.
 */

#ifndef vtkShadowStudio_h
#define vtkShadowStudio_h

#include "vtkObject.h"
#include "vtkSoftShadowsCoreModule.h" // For export macro

#include <memory> // For Internal

class vtkActor;
class vtkAreaLight;
class vtkLight;
class vtkRenderer;

class VTKSOFTSHADOWSCORE_EXPORT vtkShadowStudio : public vtkObject
{
public:
  static vtkShadowStudio* New();
  vtkTypeMacro(vtkShadowStudio, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Light a renderer, in the place of the studio that it has; take the studio off it, as if it had never
   * been there; find it (nullptr if there is none). A studio lights one renderer at a time.
   */
  void PutOn(vtkRenderer* renderer);
  static void TakeOff(vtkRenderer* renderer);
  static vtkShadowStudio* FindOn(vtkRenderer* renderer);
  ///@}

  ///@{
  /**
   * How large the key light is, as a share of the scene: its diameter, seen from one and a half diameters
   * of the scene away. 0 casts hard shadows. Default: a third.
   */
  vtkSetClampMacro(Softness, double, 0.0, 3.0);
  vtkGetMacro(Softness, double);
  ///@}

  ///@{
  /**
   * What a shadow takes from a white surface that faces the camera, as from a side that the key does not
   * reach: 0 nothing, and then nothing is in shadow, 1 all of it. The pass's own parameter "darkness" is a factor on it. Default: 0.65.
   */
  vtkSetClampMacro(Darkness, double, 0.0, 1.0);
  vtkGetMacro(Darkness, double);
  ///@}

  ///@{
  /**
   * Where the key stands: degrees above the ground, -90 to 90, and to the right of the camera as seen from
   * above, -180 to 180. Default: 50 and -40, high on the left.
   */
  vtkSetClampMacro(Elevation, double, -90.0, 90.0);
  vtkGetMacro(Elevation, double);
  vtkSetClampMacro(Azimuth, double, -180.0, 180.0);
  vtkGetMacro(Azimuth, double);
  ///@}

  ///@{
  /**
   * Whether the key goes round the scene with the camera. Off, the default, it stands where the first frame
   * that shows something put it, so that a moving camera rebuilds no light data; Aim lets the next frame place
   * it anew.
   */
  vtkSetMacro(FollowCamera, bool);
  vtkGetMacro(FollowCamera, bool);
  vtkBooleanMacro(FollowCamera, bool);
  void Aim();
  /** Place it by the camera as it is now, whatever that is when the next frame is drawn. */
  void AimNow();
  ///@}

  ///@{
  /**
   * The way up; (0, 0, 0), the default, is the axis nearest to the camera's view up, when the key is placed.
   */
  vtkSetVector3Macro(UpVector, double);
  vtkGetVector3Macro(UpVector, double);
  ///@}

  enum GroundType
  {
    None = 0,
    Catcher,
    Solid
  };
  ///@{
  /**
   * What lies under the scene: nothing, a shadow catcher, or a white ground. Seen from below, neither is
   * there. Default: a catcher.
   */
  vtkSetClampMacro(Ground, int, None, Solid);
  vtkGetMacro(Ground, int);
  void SetGroundToNone() { this->SetGround(None); }
  void SetGroundToCatcher() { this->SetGround(Catcher); }
  void SetGroundToSolid() { this->SetGround(Solid); }
  ///@}

  ///@{
  /**
   * Darken what lies close together, by the renderer's SSAO with a radius of a share of the scene. VTK's SSAO
   * has but one sample a pixel: edges are not smooth then. Default: off.
   */
  vtkSetMacro(ContactShading, bool);
  vtkGetMacro(ContactShading, bool);
  vtkBooleanMacro(ContactShading, bool);
  ///@}

  ///@{
  /** What it is made of; whatever else is set of these stays. */
  vtkAreaLight* GetKeyLight();
  vtkLight* GetFillLight();
  vtkLight* GetSideLight();
  vtkActor* GetGroundActor();
  ///@}

protected:
  vtkShadowStudio();
  ~vtkShadowStudio() override;

  double Softness = 1.0 / 3.0;
  double Darkness = 0.65;
  double Elevation = 50.0;
  double Azimuth = -40.0;
  bool FollowCamera = false;
  double UpVector[3] = { 0.0, 0.0, 0.0 };
  int Ground = Catcher;
  bool ContactShading = false;

private:
  vtkShadowStudio(const vtkShadowStudio&) = delete;
  void operator=(const vtkShadowStudio&) = delete;

  void Detach();
  void Update();
  void AimAtCamera();
  void UpdateLights();
  void UpdateContactShading(double size);
  void EndContactShading();
  void WidenClippingRange();

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
