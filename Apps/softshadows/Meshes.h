// SPDX-License-Identifier: BSD-3-Clause
// What a file gave, made into triangles that can be drawn.

#ifndef Meshes_h
#define Meshes_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace Meshes
{
struct Report
{
  vtkIdType Points = 0;
  vtkIdType BadPoints = 0;   // NaN, infinite, or too large for 32-bit floats
  vtkIdType BadPolygons = 0; // refer to points that there are not
};

/**
 * The triangles of a surface, with normals: its own or, where it has none, those of its faces,
 * smoothed over edges of up to 60 degrees. Polygons with bad points are left out. Adds to the report.
 */
vtkSmartPointer<vtkPolyData> Prepare(vtkPolyData* surface, Report& report);

/** Polygons counted as the triangles that they are drawn as. */
vtkIdType CountTriangles(vtkPolyData* surface);
}

#endif
