// What a technique sees of the frame that is being drawn.

#ifndef vtkShadowFrame_h
#define vtkShadowFrame_h

#include "vtkShadowLight.h" // For Lights

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <map>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkShadowCasters;
class vtkShadowQuad;
class vtkShadowTimers;

struct VTKSOFTSHADOWSCORE_EXPORT vtkShadowFrame
{
  vtkRenderer* Renderer = nullptr;
  vtkOpenGLRenderWindow* Window = nullptr;
  vtkShadowCasters* Casters = nullptr;
  vtkShadowTimers* Timers = nullptr;
  vtkShadowQuad* Quad = nullptr;
  /** The casting lights that this technique can treat. */
  std::vector<vtkShadowLight> Lights;
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
  /** Counts for GetStatistics(), by name; a technique adds its own. */
  std::map<std::string, double> Counts;
};

#endif
