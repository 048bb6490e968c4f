// What a prop draws that can cast a shadow: polygons, also where its mapper makes them on the GPU.
//
//   polygons of the input    as they are; the blocks of composite data each for itself
//   the skin of a grid       as vtkDataSetMapper draws it
//   glyphs                   the sources' polygons at each point (vtkGlyph3DMapper)
//   spheres, sticks          of imposters: inscribed polyhedra, finer the fewer there are
//   Gaussian points          that do not glow: spheres out to where they are half opaque, or of their
//                            radius where a splat shader of the user's says how they look
//   image slices             along an axis of the image: rectangles
//
// What a mapper's clipping planes cut away is cut away, hidden blocks are left out, and what has no
// area (lines, points, wireframes) has no polygons. Polygons are in model coordinates.

#ifndef vtkShadowSurfaces_h
#define vtkShadowSurfaces_h

#include "vtkSmartPointer.h" // For polygons
#include "vtkType.h"         // For vtkMTimeType

#include <functional>
#include <string>
#include <tuple>
#include <vector>

class vtkMatrix4x4;
class vtkPolyData;
class vtkProp;

struct vtkShadowSurface
{
  /** Where the polygons come from, and how they are cut. */
  struct Origin
  {
    const void* Input = nullptr;
    const void* Mapper = nullptr; // nullptr where it changes nothing
    std::vector<double> Details;  // clipping planes, four coefficients each; a slice's box
    bool operator<(const Origin& other) const
    {
      return std::tie(this->Input, this->Mapper, this->Details) <
             std::tie(other.Input, other.Mapper, other.Details);
    }
  };
  Origin From;
  /**
   * When the shape last changed. No two objects ever have the same time: with the origin it tells
   * polygons apart, even after their source is gone.
   */
  vtkMTimeType Time = 0;
  bool Translucent = false;
  /** Of the property or the block; translucent colours and textures do not count. */
  double Opacity = 1.0;
  std::function<vtkSmartPointer<vtkPolyData>()> MakePolygons;
};

/**
 * Call a function with each surface that a prop (no assembly; see vtkShadowPass::ForEachPart) draws
 * by a matrix. Updates its mapper's inputs.
 */
void vtkForEachShadowSurface(vtkProp* prop, vtkMatrix4x4* matrix,
  const std::function<void(const vtkShadowSurface&)>& function);

#endif
