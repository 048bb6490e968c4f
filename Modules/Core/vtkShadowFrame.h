// What a technique sees of the frame that is being drawn.

#ifndef vtkShadowFrame_h
#define vtkShadowFrame_h

#include "vtkShadowLight.h" // For Lights

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
  /** View coordinates to WC (world axes, origin at Casters->GetOrigin()). */
  glm::dmat4 VCToWC{ 1.0 };
  /** View coordinates to clip coordinates, as VTK's mappers draw with. */
  glm::dmat4 VCToClip{ 1.0 };
  glm::dmat4 GetWCToVC() const;
  glm::dmat4 GetWorldToVC() const;
  /** What positions on the casters can be off at least, by rounding to floats, in world units. */
  double LeastRounding = 0.0;
  /** Counts for GetStatistics(), by name; a technique adds its own. */
  std::map<std::string, double> Counts;
};

#endif
