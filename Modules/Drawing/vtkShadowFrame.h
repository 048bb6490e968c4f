// What a technique sees of the frame that is being drawn.

#ifndef vtkShadowFrame_h
#define vtkShadowFrame_h

#include "vtkShadowLight.h"              // For lights
#include "vtkSoftShadowsDrawingModule.h" // For export macro

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <map>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkShaderProgram;
class vtkShadowCasterDrawing;
class vtkShadowCasters;
class vtkShadowMessages;
class vtkShadowQuad;
class vtkShadowReceivers;
class vtkShadowTimers;

struct VTKSOFTSHADOWSDRAWING_EXPORT vtkShadowFrame
{
  vtkRenderer* Renderer = nullptr;
  vtkOpenGLRenderWindow* Window = nullptr;
  const vtkShadowCasters* Casters = nullptr;
  vtkShadowCasterDrawing* Drawing = nullptr; // of these
  vtkShadowTimers* Timers = nullptr;
  vtkShadowQuad* Quad = nullptr;
  vtkShadowMessages* Messages = nullptr;
  /** Those of the picture's opaque surfaces, for techniques that declare to need them; else nullptr. */
  vtkShadowReceivers* Receivers = nullptr;
  /** So many parts of lights cast at most: as many as uniforms are sure to hold. */
  static constexpr int MostParts = 16;
  /** The casting lights that this technique can treat. */
  std::vector<vtkShadowLight> Lights;
  /** Their parts, one after another: what light data is made for, and `light` in GLSL. */
  std::vector<vtkShadowLightPart> Parts;
  /** Any of the lights is textured: visibility is then a colour. */
  bool Color = false;
  /** All lights count as their centres: the technique is hard, or they have no size. */
  bool Hard = false;
  /** The viewport's width and height in pixels. */
  int Size[2] = { 0, 0 };
  /**
   * View coordinates to WC (world axes, origin at Casters->GetOrigin()). Lengths and angles in VC are
   * those of the world: where the camera scales or shears VTK's own view coordinates, VC is the world
   * turned so that planes of equal depth are the same, about the same origin.
   */
  glm::dmat4 VCToWC{ 1.0 };
  /** View coordinates to clip coordinates, as VTK's mappers draw with. */
  glm::dmat4 VCToClip{ 1.0 };
  /** VTK's view coordinates to VC; the identity, and Rigid, where both are the same. */
  glm::dmat3 VTKToVC{ 1.0 };
  bool Rigid = true;
  /**
   * Set these by the camera's matrices. False where the view's is not one that can be undone: nothing
   * can be said of shadows then.
   */
  bool SetCamera(const glm::dmat4& worldToVTK, const glm::dmat4& VTKToClip);
  /** Of a parallel projection. */
  bool IsParallel() const;
  /** Where all lines of sight meet, w 1; or the direction towards the viewer, w 0. */
  glm::dvec4 GetEyeVC() const;
  /**
   * What moves a point in the picture by a pixel along an axis, 0 or 1, without a change of depth, in
   * world units: times w of its clip coordinates.
   */
  glm::dvec3 GetPixelVC(int axis) const;
  glm::dmat4 GetWCToVC() const;
  glm::dmat4 GetWorldToVC() const;
  /**
   * Side of a texture, in texels: as it is asked for, but `smallest` at least. 0 asks for about a texel a
   * pixel where what it holds fills the picture, or for `detail` where that is more, from `least` on: a
   * power of two, so that a window can be resized without new textures. More than the GPU allows gives a
   * warning, and what it allows.
   */
  int ChooseResolution(int asked, int smallest, int least, double detail = 0.0) const;
  /** GLSL that declares the lights (vtkShadowLightsFS.glsl), with `#define`s; and the uniforms of it. */
  std::string GetLightsGLSL(const std::string& definitions = "") const;
  void SetLights(vtkShaderProgram* program) const;
  /** Counts for GetStatistics(), by name; a technique adds its own. */
  std::map<std::string, double> Counts;
};

#endif
