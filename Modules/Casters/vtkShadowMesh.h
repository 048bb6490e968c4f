// SPDX-License-Identifier: BSD-3-Clause
// The triangles of one vtkPolyData, ready to cast shadows.

#ifndef vtkShadowMesh_h
#define vtkShadowMesh_h

#include "vtkShadowAlphaMap.h"           // For vtkShadowHoles
#include "vtkSmartPointer.h"             // For triangles
#include "vtkSoftShadowsCastersModule.h" // For export macro
#include "vtkType.h"                     // For vtkMTimeType

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

class vtkPolyData;

struct VTKSOFTSHADOWSCASTERS_EXPORT vtkShadowMesh
{
  glm::dvec3 Centre{ 0.0 };     // model coordinates; positions are relative to it
  std::vector<float> Positions; // x, y, z each; after the last one float of padding, for Embree
  std::vector<std::uint32_t> Indices; // three a triangle
  glm::dvec3 Minimum{ 0.0 };          // bounds, relative to Centre
  glm::dvec3 Maximum{ 0.0 };
  glm::dvec3 Middle{ 0.0 };     // mean of the vertices, relative to Centre
  double Radius = 0.0;          // of the sphere around Middle that holds them
  bool Flat = false;            // all vertices lie in one plane:
  glm::dvec3 Normal{ 0.0 };     // its unit normal
  glm::dvec3 PlanePoint{ 0.0 }; // one of its points
  bool Sheet = false;           // flat, and no body, however far from the model's origin
  std::size_t Dropped = 0;      // triangles that were degenerate or not finite
  std::size_t NotFinite = 0;    // those of them that were not finite
  std::size_t Clear = 0;        // triangles that were left out because alpha makes them one hole
  /** Holes by alpha within the triangles; nullptr where there are none. */
  std::shared_ptr<const vtkShadowHoles> Holes;

  std::size_t GetNumberOfVertices() const { return this->Positions.size() / 3; }
  std::size_t GetNumberOfTriangles() const { return this->Indices.size() / 3; }

  /**
   * Polygons and strips of a vtkPolyData, triangulated. Vertices that no triangle uses go. With the
   * array of vtkShadowAlpha, they have holes where alpha times a map's is below a threshold.
   */
  static std::shared_ptr<const vtkShadowMesh> Make(vtkPolyData* source,
    std::shared_ptr<const vtkShadowAlphaMap> map = nullptr, float threshold = 0.0f);
  /** The triangles that VTK's mappers draw of it; itself where it has no other polygons. */
  static vtkSmartPointer<vtkPolyData> Triangulate(vtkPolyData* source);
  /** When the shape last changed: points and connectivity, not colours. */
  static vtkMTimeType GetShapeTime(vtkPolyData* source);

  /** Whether it casts the same: triangles and holes. */
  bool IsSame(const vtkShadowMesh& other) const;
};

#endif
