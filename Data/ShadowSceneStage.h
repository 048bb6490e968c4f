// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the builders share: actors, floors, lights and cameras. All lengths are world units.
 */

#ifndef ShadowSceneStage_h
#define ShadowSceneStage_h

#include "vtkVector.h" // For vtkVector3d

class ShadowSceneMesh;
class vtkActor;
class vtkAreaLight;
class vtkPolyData;
class vtkRenderer;

namespace ShadowSceneStage
{
struct Color
{
  double Red;
  double Green;
  double Blue;
};

constexpr Color Floor = { 0.80, 0.79, 0.76 };
constexpr Color Bone = { 0.88, 0.84, 0.76 };
constexpr Color Clay = { 0.78, 0.47, 0.36 };
constexpr Color Ochre = { 0.84, 0.67, 0.36 };
constexpr Color Sage = { 0.54, 0.66, 0.48 };
constexpr Color Teal = { 0.36, 0.60, 0.62 };
constexpr Color Sky = { 0.47, 0.62, 0.78 };
constexpr Color Plum = { 0.60, 0.46, 0.62 };
constexpr Color Rose = { 0.80, 0.56, 0.58 };
constexpr Color Slate = { 0.45, 0.49, 0.54 };
constexpr Color Bark = { 0.62, 0.52, 0.43 };

/**
 * The directions of a scene: up, right and front (towards a viewer) make a right-handed frame.
 */
struct Frame
{
  vtkVector3d Right;
  vtkVector3d Front;
  vtkVector3d Up;
};
Frame GetFrame(int upAxis);

/**
 * Add an actor of one colour, or of the data's scalar colours. A mesh without triangles adds
 * nothing and gives nullptr.
 */
vtkActor* AddActor(vtkRenderer* renderer, vtkPolyData* polyData, const Color& color);
vtkActor* AddActor(vtkRenderer* renderer, const ShadowSceneMesh& mesh, const Color& color);

/**
 * Make an actor a ground: dull, and not part of what the camera looks at (key GROUND of
 * vtkShadowScenes).
 */
void MarkGround(vtkActor* actor);

/**
 * Add a ground: a square of two triangles that faces up, its points held in double precision.
 */
vtkActor* AddSquare(vtkRenderer* renderer, const vtkVector3d& center, double halfSide, int upAxis);

/**
 * Add the floor of a built-in scene at z = 0: two triangles.
 */
vtkActor* AddFloor(
  vtkRenderer* renderer, double halfSide, double centerX = 0.0, double centerY = 0.0);

///@{
/**
 * Add a white area light that faces `focus`.
 */
vtkAreaLight* AddSphereLight(
  vtkRenderer* renderer, const vtkVector3d& position, const vtkVector3d& focus, double radius);
vtkAreaLight* AddDiskLight(
  vtkRenderer* renderer, const vtkVector3d& position, const vtkVector3d& focus, double radius);
vtkAreaLight* AddRectangleLight(vtkRenderer* renderer, const vtkVector3d& position,
  const vtkVector3d& focus, double width, double height);
///@}

/**
 * Place the active camera, z up.
 */
void SetCamera(vtkRenderer* renderer, const vtkVector3d& position, const vtkVector3d& focus);

/**
 * Place the active camera in that direction from the bounds' centre, as close as they all fit into
 * the picture, times margin.
 */
void FitCamera(vtkRenderer* renderer, const double bounds[6], const vtkVector3d& direction,
  const vtkVector3d& up, double margin);
}

#endif
