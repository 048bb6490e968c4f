// SPDX-License-Identifier: BSD-3-Clause
// The meshes of surfaces, and the maps of their alpha, kept while they are unchanged.

#ifndef vtkShadowMeshes_h
#define vtkShadowMeshes_h

#include "vtkShadowMesh.h"     // For vtkShadowMesh
#include "vtkShadowSurfaces.h" // For vtkShadowSurface::Origin

#include <map>
#include <memory>

class vtkShadowMeshes
{
public:
  /**
   * The mesh of a surface: that of before, if it still casts the same. Surfaces of one origin share
   * it. It has holes where alpha is below a threshold.
   */
  std::shared_ptr<const vtkShadowMesh> Find(
    const vtkShadowSurface& surface, double threshold, const vtkShadowMeshes& before);

private:
  struct Entry
  {
    vtkMTimeType Time = 0;
    vtkMTimeType AlphaTime = 0;
    double Threshold = 0.0; // where there is alpha
    std::shared_ptr<const vtkShadowMesh> Mesh;
  };
  struct MapEntry
  {
    vtkMTimeType Time = 0;
    std::shared_ptr<const vtkShadowAlphaMap> Map;
  };

  std::shared_ptr<const vtkShadowAlphaMap> FindMap(
    const vtkShadowSurface& surface, const vtkShadowMeshes& before);

  std::map<vtkShadowSurface::Origin, Entry> Entries;
  std::map<const void*, MapEntry> Maps; // by what they are made of
};

#endif
