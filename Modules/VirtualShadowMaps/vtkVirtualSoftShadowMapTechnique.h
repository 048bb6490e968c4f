// SPDX-License-Identifier: BSD-3-Clause
// Technique virtual-maps: see vtkVirtualSoftShadowMapPass.

#ifndef vtkVirtualSoftShadowMapTechnique_h
#define vtkVirtualSoftShadowMapTechnique_h

#include "vtkShadowGL.h"           // For textures
#include "vtkShadowTechnique.h"    // For the base class
#include "vtkVirtualShadowPages.h" // For pages
#include "vtkVirtualShadowTree.h"  // For tiles
#include "vtkVirtualShadowViews.h" // For views

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
  vtkVirtualShadowTree::Options GetTreeOptions() const;
  /** Kernels and requests of a part of a light; gives how many pixels are to be filtered. */
  std::size_t FindKernels(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int part);
  /** The tiles, within the budget; false when out of memory. */
  bool FindTiles(vtkShadowFrame& frame, int part);
  void Sum(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int part);
  void SetTree(vtkShaderProgram* program);

  vtkVirtualShadowViews Views;
  vtkVirtualShadowTree Tree;
  vtkVirtualShadowPages Pages;
  int MostPages = 1;
  int Part = 0;            // whose kernels and sums there are
  vtkShadowFrame* Frame = nullptr; // while visibility is filled
  vtkShadowTexture Kernels;
  vtkShadowTexture Requests;
  vtkShadowTexture Sums;
  vtkShadowTexture Nodes;
  vtkShadowFramebuffer Framebuffer;
  std::vector<glm::vec4> Asked; // memory that is kept
};

#endif
