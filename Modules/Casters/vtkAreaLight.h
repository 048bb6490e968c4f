// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAreaLight
 * @brief   A light with a size, which therefore casts soft shadows.
 *
 * A positional vtkAreaLight is a point, a sphere, a disk or a rectangle centred at its position. A
 * directional one (PositionalOff) is a distant disk, such as the sun, seen under AngularDiameter.
 * A disk or rectangle faces the focal point; the rectangle's width runs along
 * (focal point - position) x UpVector, its height along the up vector made perpendicular.
 *
 * A positional light that was never placed, turned or sized places itself: the shadow pass fits it to what
 * the renderer shows (FitTo, a third as large as that, from above on the left). A camera light's lengths are in
 * units of the camera's distance to its focal point, as its position is.
 *
 * All other lengths are in world units. VTK's own shading sees the light's centre only; its area counts
 * for visibility (see vtkShadowPass). A light of size zero gives hard shadows.
 *
 * Unlike a plain vtkLight, an area light is positional and shines into all directions until it is
 * given a cone: ConeAngle starts at 90 degrees.
 */

#ifndef vtkAreaLight_h
#define vtkAreaLight_h

#include "vtkLight.h"
#include "vtkSmartPointer.h"             // For Texture
#include "vtkSoftShadowsCastersModule.h" // For export macro

class vtkTexture;

class VTKSOFTSHADOWSCASTERS_EXPORT vtkAreaLight : public vtkLight
{
public:
  static vtkAreaLight* New();
  vtkTypeMacro(vtkAreaLight, vtkLight);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ShapeType
  {
    Point = 0,
    Sphere,
    Disk,
    Rectangle
  };

  ///@{
  /**
   * Shape of the emitter of a positional light. Default: Sphere.
   */
  vtkSetClampMacro(Shape, int, Point, Rectangle);
  vtkGetMacro(Shape, int);
  void SetShapeToPoint() { this->SetShape(Point); }
  void SetShapeToSphere() { this->SetShape(Sphere); }
  void SetShapeToDisk() { this->SetShape(Disk); }
  void SetShapeToRectangle() { this->SetShape(Rectangle); }
  const char* GetShapeAsString();
  ///@}

  ///@{
  /**
   * Radius of a sphere or disk, in world units, >= 0: what is not is refused with an error. Default: 0.5,
   * where the light is placed.
   */
  virtual void SetRadius(double radius);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Full side lengths of a rectangle, in world units, >= 0, likewise. Default: 1 x 1.
   */
  virtual void SetWidth(double width);
  vtkGetMacro(Width, double);
  virtual void SetHeight(double height);
  vtkGetMacro(Height, double);
  ///@}

  ///@{
  /**
   * Direction that a rectangle's height follows. It need not be perpendicular to the light's
   * direction, only not parallel to it (then an arbitrary perpendicular is taken).
   * Default: (0, 1, 0).
   */
  vtkSetVector3Macro(UpVector, double);
  vtkGetVector3Macro(UpVector, double);
  ///@}

  ///@{
  /**
   * Angle under which a directional light's disk is seen, in degrees, 0 to 90. Default: 0. The sun
   * has 0.53.
   */
  virtual void SetAngularDiameter(double angle);
  vtkGetMacro(AngularDiameter, double);
  ///@}

  ///@{
  /**
   * Emission over a rectangle: the image's (0,0) texel lies at -width/2, -height/2. Visibility is
   * then a colour: each channel is weighted by the emission. What is negative or no finite number
   * counts as 0; a texture without texels as none. Default: none, uniform emission.
   */
  void SetTexture(vtkTexture* texture);
  vtkTexture* GetTexture();
  ///@}

  /**
   * Place and size the light for a scene of these bounds: in the direction that it stands in now (the
   * way from its focal point to its position), one and a half of the scene's diagonals from its middle, which
   * it faces, and `softness` as large as that diagonal: the radius of a sphere or disk is half of it, a
   * rectangle is a square as large, a directional light is seen under that angle. Nothing for bounds that
   * hold nothing.
   */
  void FitTo(const double bounds[6], double softness = 1.0 / 3.0);

  ///@{
  /** Whether it was placed, turned or sized; the pass fits one that was not. */
  vtkGetMacro(Placed, bool);
  using vtkLight::SetFocalPoint;
  using vtkLight::SetPosition;
  void SetPosition(double x, double y, double z) override;
  void SetPosition(const double a[3]) override { this->SetPosition(a[0], a[1], a[2]); }
  void SetFocalPoint(double x, double y, double z) override;
  void SetFocalPoint(const double a[3]) override { this->SetFocalPoint(a[0], a[1], a[2]); }
  ///@}

  ///@{
  /**
   * Copy a light. Area members are copied where the other light has them.
   */
  vtkLight* ShallowClone() override;
  void DeepCopy(vtkLight* light);
  ///@}

  /**
   * Includes the texture.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkAreaLight();
  ~vtkAreaLight() override;

  int Shape = Sphere;
  double Radius = 0.5;
  double Width = 1.0;
  double Height = 1.0;
  double UpVector[3] = { 0.0, 1.0, 0.0 };
  double AngularDiameter = 0.0;
  vtkSmartPointer<vtkTexture> Texture;

private:
  void CopyArea(vtkLight* light);
  void SetLength(const char* name, double& length, double value);

  bool Placed = false;

  vtkAreaLight(const vtkAreaLight&) = delete;
  void operator=(const vtkAreaLight&) = delete;
};

#endif
