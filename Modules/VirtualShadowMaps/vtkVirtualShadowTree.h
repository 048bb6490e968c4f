// SPDX-License-Identifier: BSD-3-Clause
// Which tiles of the virtual maps of a light are needed, and how fine: what pixels ask for is
// scattered by minimum over all cells of a grid that their kernels cover; a kd-tree over the grid
// ends where a map of the tile limit is as fine as any cell of it asks. Shen and others 2011,
// section 5.2, steps 4 to 6; Giegl and Wimmer, Fitted virtual shadow maps, 2007.
//
// It asks for texel sizes, not for resolutions: cells that nobody asks for are infinitely coarse.

#ifndef vtkVirtualShadowTree_h
#define vtkVirtualShadowTree_h

#include "vtkSoftShadowsVirtualShadowMapsModule.h" // For export macro
#include "vtkVirtualShadowTile.h"                  // For tiles

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <vector>

class VTKSOFTSHADOWSVIRTUALSHADOWMAPS_EXPORT vtkVirtualShadowTree
{
public:
  /** Cells along a side of a view's grid. */
  static constexpr int Cells = 64;

  struct Options
  {
    /** Texels along a side of a tile's map, at most. */
    int Side = 512;
    /** One map a view of Side x Side texels, whatever is asked for. */
    bool Fixed = false;
  };

  /** Forget all requests; for so many views. */
  void Start(int views);
  /**
   * Add what pixels ask for: four floats each, see vtkVirtualKernelFS.glsl. Gives how many ask.
   */
  std::size_t AddRequests(const std::vector<glm::vec4>& requests);

  void Build(const Options& options);
  std::vector<vtkVirtualShadowTile>& GetTiles() { return this->Tiles; }

  /**
   * The trees' nodes in the order of a walk, three vectors each: rectangle; next node beside it,
   * kind (0 inner, 1 empty, 2 tile), layer, batch; corner and size in texels.
   */
  std::vector<glm::vec4> GetNodes() const;
  /** Of a view; of the number of views, the end. */
  int GetFirstNode(int view) const { return this->FirstNodes[view]; }

private:
  struct Node
  {
    glm::dvec2 Low;
    glm::dvec2 High;
    int Next = 0;
    int Tile = -1;
    bool Leaf = false;
  };
  /** The finest texel that is asked for within a rectangle of cells; infinite where none is. */
  glm::dvec2 FindLeast(int view, const glm::ivec2& first, const glm::ivec2& end) const;
  void AddNode(int view, const std::array<int, 4>& place, const Options& options);

  std::vector<std::vector<glm::vec2>> Grids; // of each view
  std::vector<Node> Nodes;
  std::vector<int> FirstNodes;
  std::vector<vtkVirtualShadowTile> Tiles;
};

#endif
