// SPDX-License-Identifier: BSD-3-Clause
/**
 * The bunny: found as bunny.ply, or modelled. See vtkShadowScenes for where it is looked for.
 */

#ifndef ShadowSceneBunny_h
#define ShadowSceneBunny_h

#include "vtkSmartPointer.h" // For the poly data

#include <string>

class vtkPolyData;

namespace ShadowSceneBunny
{
/**
 * The bunny with point normals: z up, height 1, standing on z = 0, centred in x and y. It has its
 * 3,674 triangles, or 16,301: then it is subdivided (three Loop steps) and decimated. That takes
 * seconds, so the result is kept as bunny-16301.vtp next to bunny.ply if that directory can be
 * written.
 */
constexpr int OriginalTriangles = 3674;
constexpr int SubdividedTriangles = 16301;
vtkSmartPointer<vtkPolyData> GetBunny(int triangles);

///@{
/**
 * Why the last bunny is a stand-in; empty if it is not.
 */
std::string GetNote();
void ClearNote();
///@}
}

#endif
