// SPDX-License-Identifier: BSD-3-Clause
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
// area (lines, points, wireframes) has no polygons. Polygons are in model coordinates. Where the alpha
// of colours or a texture makes holes in a surface, see vtkShadowAlpha.h.

#ifndef vtkShadowSurfaces_h
#define vtkShadowSurfaces_h

#include "vtkSmartPointer.h" // For polygons
#include "vtkType.h"         // For vtkMTimeType

#include <functional>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

class vtkMatrix4x4;
class vtkPolyData;
class vtkProp;
struct vtkShadowAlphaMap;

struct vtkShadowSurface
{
  /** Where the polygons come from, and how they are cut. */
  struct Origin
  {
    const void* Input = nullptr;
    const void* Mapper = nullptr;  // nullptr where it changes nothing
    const void* Texture = nullptr; // that has alpha
    std::vector<double> Details;   // clipping planes, four coefficients each; a slice's box
    bool operator<(const Origin& other) const
    {
      return std::tie(this->Input, this->Mapper, this->Texture, this->Details) <
             std::tie(other.Input, other.Mapper, other.Texture, other.Details);
    }
  };
  Origin From;
  /**
   * When the shape last changed. No two objects ever have the same time: with the origin it tells
   * polygons apart, even after their source is gone.
   */
  vtkMTimeType Time = 0;
  /** When its alpha, without its opacity, last changed; 0 where all of it is opaque. */
  vtkMTimeType AlphaTime = 0;
  /** It has alpha that is not known, and casts without. */
  bool AlphaUnknown = false;
  /** By its property, or the block; alpha of colours and textures makes holes instead. */
  bool Translucent = false;
  double Opacity = 1.0;
  /** Without what is seen to have an alpha below a threshold. */
  std::function<vtkSmartPointer<vtkPolyData>(double threshold)> MakePolygons;
  /** What its alpha is looked up in, made from Map as of that time; nullptr: in nothing. */
  const void* Map = nullptr;
  vtkMTimeType MapTime = 0;
  std::function<std::shared_ptr<const vtkShadowAlphaMap>()> MakeMap;
};

/**
 * Call a function with each surface that a prop (no assembly; see vtkShadowTags::ForEachPart) draws
 * by a matrix. Updates its mapper's inputs, unless it is static.
 */
void vtkForEachShadowSurface(vtkProp* prop, vtkMatrix4x4* matrix,
  const std::function<void(const vtkShadowSurface&)>& function);

#endif
