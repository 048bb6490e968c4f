// SPDX-License-Identifier: BSD-3-Clause
// Technique virtual-maps: see vtkVirtualSoftShadowMapPass.

#ifndef vtkVirtualSoftShadowMapTechnique_h
#define vtkVirtualSoftShadowMapTechnique_h

#include "vtkShadowGL.h"              // For textures
#include "vtkShadowTechnique.h"       // For the base class
#include "vtkVirtualShadowPages.h"    // For pages
#include "vtkVirtualShadowRequests.h" // For pages that are asked for
#include "vtkVirtualShadowTree.h"     // For tiles
#include "vtkVirtualShadowViews.h"    // For views

#include <glm/vec4.hpp>

#include <string>
#include <utility>
#include <vector>

class vtkVirtualSoftShadowMapTechnique : public vtkShadowTechnique
{
public:
  using vtkShadowTechnique::vtkShadowTechnique;

  std::string FindUnsupported(vtkOpenGLRenderWindow* window) override;
  bool UpdateLightData(vtkShadowFrame& frame) override;
  std::string GetVisibilityGLSL() override;
  void Activate(vtkShadowFrame& frame) override;
  void Deactivate(vtkShadowFrame& frame) override;
  void SetVisibilityParameters(vtkShaderProgram* program) override;
  void FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer) override;
  double GetMaximumCost() override;
  std::string GetDebugQuantity(const std::string& view) override;
  std::vector<std::pair<std::string, std::size_t>> GetBytes() override;
  void Release(vtkOpenGLRenderWindow* window) override;

private:
  /** What differs between pixels' own pages and tiles of kd-trees: vtkVirtualTilesFS.glsl. */
  std::string GetTilesGLSL() const;
  void FindSide(vtkShadowFrame& frame);
  /** Kernels and requests of the part, in some of its views; gives how many pixels filter. */
  std::size_t FindKernels(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer);
  /** The tiles, within the budget; false when out of memory. */
  bool FindTiles(vtkShadowFrame& frame);
  void Sum(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer);
  void FillPart(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer);
  void SetTiles(vtkShaderProgram* program);

  vtkVirtualShadowViews Views;
  vtkVirtualShadowRequests Asked; // of cache=on
  vtkVirtualShadowTree Tree;      // of cache=off
  vtkVirtualShadowPages Pages;
  std::vector<vtkVirtualShadowTile> Tiles;
  bool Keeps = true; // the setting cache
  int Side = 16;     // of a tile's map
  int MostPages = 1;
  int Coarser = 0; // halvings that pages go without
  int TableSize = 4;
  int Part = 0; // whose kernels and sums there are
  vtkVirtualShadowViews::Turn Turn;
  vtkShadowFrame* Frame = nullptr; // while visibility is filled
  vtkShadowTexture Kernels;
  vtkShadowTexture Requests;
  vtkShadowTexture Sums;
  vtkShadowTexture Nodes;
  vtkShadowFramebuffer Framebuffer;
  std::vector<glm::vec4> Texels; // memory that is kept
};

#endif
