// SPDX-License-Identifier: BSD-3-Clause
// Where a surface has holes by its own alpha: its colours' times its texture's. The opacity of its
// property, or of its block, is no part of it.
//
//   colours of points    RGBA, or through a lookup table, with its colours of NaN and out of range;
//                        also looked up between the points (InterpolateScalarsBeforeMapping)
//   colours of cells     a cell is there or not
//   a texture            the actor's, or its property's only one; of a physically based material
//                        the albedo, which stands in the place of the colours
//
// What several textures make of each other, or a texture over colours that are looked up between
// points, is not known.

#ifndef vtkShadowAlpha_h
#define vtkShadowAlpha_h

#include "vtkSmartPointer.h" // For polygons
#include "vtkType.h"         // For vtkMTimeType

#include <memory>
#include <vector>

class vtkActor;
class vtkDataSet;
class vtkMapper;
class vtkPolyData;
class vtkTexture;
struct vtkShadowAlphaMap;

struct vtkShadowAlpha
{
  /** The points' array of what Apply gives: texture coordinates and alpha. */
  static constexpr const char* ArrayName = "shadowHoles";

  bool Colors = false;           // have alpha, perhaps
  bool LookedUp = false;         // and are looked up between points
  vtkTexture* Texture = nullptr; // that has alpha, perhaps
  bool Unknown = false;          // there is alpha, but how much is not known
  vtkMTimeType Time = 0;         // when what decides it last changed; 0 where all is opaque
  vtkMTimeType MapTime = 0;      // when what MakeMap makes last changed

  ///@{
  /** What decides the alpha of data that a mapper draws, for an actor or of colours alone. */
  static vtkShadowAlpha Find(vtkActor* actor, vtkMapper* mapper, vtkDataSet* data);
  static vtkShadowAlpha FindColors(vtkMapper* mapper, vtkDataSet* data);
  ///@}

  /** Polygons and strips without the cells whose colour is below a threshold, with the array. */
  vtkSmartPointer<vtkPolyData> Apply(
    vtkMapper* mapper, vtkPolyData* polygons, double threshold) const;
  /** What the texture coordinates look up; nullptr where that is nothing. */
  std::shared_ptr<const vtkShadowAlphaMap> MakeMap(vtkMapper* mapper, vtkDataSet* data) const;

  /** Which points are there: their colours' alpha is not below a threshold. Empty: all are. */
  static std::vector<bool> FindPoints(vtkMapper* mapper, vtkDataSet* data, double threshold);
};

#endif
