// SPDX-License-Identifier: BSD-3-Clause
/**
 * The builders of the scenes, one function each. To add a scene: write a builder, declare it here
 * and give it a row in the table of vtkShadowScenes.cxx.
 *
 * A builder adds actors and one vtkAreaLight and sets the camera. The rest (background, clipping
 * range, automatic light) is done for all by vtkShadowScenes::Build().
 */

#ifndef ShadowSceneBuilders_h
#define ShadowSceneBuilders_h

class vtkRenderer;

namespace ShadowSceneBuilders
{
// The square blocker and its rectangular light, both centred over the origin.
constexpr double BlockerHalfSide = 1.0;
constexpr double BlockerHeight = 2.0;
constexpr double BlockerLightHalfSide = 1.0;
constexpr double BlockerLightHeight = 6.0;

// ShadowSceneSolids.cxx
void Basic(vtkRenderer* renderer, int triangles);
void Blocker(vtkRenderer* renderer, int triangles);
void Boxes(vtkRenderer* renderer, int triangles);
void Cylinder(vtkRenderer* renderer, int triangles);
void Grid(vtkRenderer* renderer, int triangles);

// ShadowSceneBunny.cxx
void Bunny(vtkRenderer* renderer, int triangles);
void Huge(vtkRenderer* renderer, int triangles);

// ShadowSceneTree.cxx
void Tree(vtkRenderer* renderer, int triangles);

// ShadowScenePlant.cxx
void Plant(vtkRenderer* renderer, int triangles);

// ShadowSceneScan.cxx
void Scan(vtkRenderer* renderer, int triangles);

// ShadowSceneData.cxx
void Isosurface(vtkRenderer* renderer, int triangles);
void Streamtubes(vtkRenderer* renderer, int triangles);
void Terrain(vtkRenderer* renderer, int triangles);

// ShadowSceneFigure.cxx
void Figure(vtkRenderer* renderer, int triangles);

// ShadowSceneMolecule.cxx
void Molecule(vtkRenderer* renderer, int triangles);
}

#endif
