// SPDX-License-Identifier: BSD-3-Clause
// The pages of virtual maps that pixels ask for, each on the level that its own kernel needs: exact
// page requests, after Lefohn, Sengupta and Owens, Resolution-matched shadow maps, 2007. What a
// pixel sees then does not depend on what others ask for.
//
//   table  RGBA32F buffer  pages by open addressing: number, 1 + view and level, layer,
//                         whether it was kept

#ifndef vtkVirtualShadowRequests_h
#define vtkVirtualShadowRequests_h

#include "vtkSoftShadowsVirtualShadowMapsModule.h" // For export macro
#include "vtkVirtualShadowTile.h"                  // For tiles

#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <vector>

class VTKSOFTSHADOWSVIRTUALSHADOWMAPS_EXPORT vtkVirtualShadowRequests
{
public:
  /** A page's number along an axis is less than 2 to this. */
  static constexpr int MostHalvings = 12;

  /** Read what pixels ask for: see vtkVirtualKernelFS.glsl. Gives how many ask. */
  std::size_t Read(const std::vector<glm::vec4>& requests);
  /** The pages, of side x side texels, levels as many halvings coarser. */
  std::vector<vtkVirtualShadowTile> GetTiles(int side, int coarser) const;
  /** The table of tiles that have their place; views count from the first one. */
  static std::vector<glm::vec4> GetTable(
    const std::vector<vtkVirtualShadowTile>& tiles, int firstView);

private:
  std::unordered_set<std::uint64_t> Pages; // view, level and number in one
};

#endif
