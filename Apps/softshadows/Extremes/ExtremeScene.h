// SPDX-License-Identifier: BSD-3-Clause
// The scene of a case, and where it lies.

#ifndef ExtremeScene_h
#define ExtremeScene_h

#include "vtkSmartPointer.h"

#include <glm/vec3.hpp>

#include <functional>
#include <string>
#include <utility>
#include <vector>

class vtkActor;
class vtkAreaLight;
class vtkPolyData;
class vtkRenderWindow;
class vtkRenderer;

/**
 * How what is built comes to lie where it is shown: by its points, then by its actors' scale and
 * position, or a user matrix. Light and camera are shown where both together put them.
 */
struct ExtremePlace
{
  glm::dvec3 PointScale{ 1.0 };
  glm::dvec3 PointOffset{ 0.0 };
  glm::dvec3 ActorScale{ 1.0 };
  glm::dvec3 ActorOffset{ 0.0 };
  bool UserMatrix = false; // instead of scale and position
  bool Floats = false;     // points of single precision
  int ShiftScale = -1;     // of the mappers' points (vtkOpenGLVertexBufferObject::ShiftScaleMethod)

  glm::dvec3 InPoints(const glm::dvec3& p) const
  {
    return this->PointScale * p + this->PointOffset;
  }
  glm::dvec3 operator()(const glm::dvec3& p) const
  {
    return this->ActorScale * this->InPoints(p) + this->ActorOffset;
  }
  /** Of lengths; of an even scale. */
  double GetUnit() const { return this->ActorScale.x * this->PointScale.x; }
};

class ExtremeScene
{
public:
  enum class Shape
  {
    Point,
    Sphere,
    Disk,
    Rectangle,
    Directional
  };

  /** Takes all away that the renderer has. */
  ExtremeScene(vtkRenderWindow* window, vtkRenderer* renderer);

  ///@{ Coordinates and lengths are those before the place.
  vtkActor* Add(vtkPolyData* polygons);
  vtkActor* AddQuad(const glm::dvec3& corner, const glm::dvec3& a, const glm::dvec3& b);
  vtkActor* AddFloor(double halfSide = 4.0, double height = 0.0);
  vtkActor* AddBox(const glm::dvec3& centre, const glm::dvec3& size);
  vtkActor* AddSphere(const glm::dvec3& centre, double radius, int resolution = 24);
  vtkAreaLight* AddLight(Shape shape, const glm::dvec3& position = { -2.5, -2.0, 5.5 },
    const glm::dvec3& focus = glm::dvec3(0.0));
  void LookAt(const glm::dvec3& position, const glm::dvec3& focus, double viewAngle = 35.0);
  /** Floor, box, sphere and post, and the camera on them. */
  void AddThings();
  ///@}

  vtkRenderer* GetRenderer() const { return this->Renderer; }
  vtkRenderWindow* GetWindow() const { return this->Window; }

  /** Places what is added after it is set. */
  ExtremePlace Place;
  /** Parameters of the techniques that have them. */
  std::vector<std::pair<std::string, std::string>> Settings;
  /** Called before each frame with its number; there are so many frames. */
  std::function<void(int)> BeforeFrame;
  int Frames = 1;
  /** Where on the floor visibility counts; unset: on all that receives. */
  std::function<bool(const glm::dvec3&)> Counts;

  ///@{ For the measurement.
  /** Lights without a size: what hard techniques promise. Gives the sizes back when called again. */
  void MakeLightsPoints(bool points);
  /** Where the floor, the plane z = 0, is seen at a place of the picture, 0 to 1 along its sides. */
  glm::dvec3 FindFloor(double x, double y) const;
  /** Whether only what is flat receives: what planar techniques promise. */
  void LetBodiesReceive(bool receive);
  vtkAreaLight* GetLight() const { return this->Lights.empty() ? nullptr : this->Lights.front(); }
  ///@}

private:
  struct Size
  {
    double Radius, Width, Height, Angle;
  };
  vtkRenderWindow* Window;
  vtkRenderer* Renderer;
  std::vector<vtkAreaLight*> Lights;
  std::vector<Size> Sizes;
  std::vector<std::pair<vtkActor*, bool>> Actors; // and whether it is flat
};

#endif
