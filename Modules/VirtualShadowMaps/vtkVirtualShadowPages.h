// SPDX-License-Identifier: BSD-3-Clause
// Where the maps of tiles lie: pages that are kept from frame to frame, or one tile of the limit's
// size that is filled, looked up and filled again.
//
//   tiles  DEPTH_COMPONENT32F  side^2, a layer each page: as many as are needed, within a budget
//
// A page is known by the tile's place in its view. It is dropped where a caster came, went or moved
// over it, or where that of a chunk of it did whose points moved, and the one that was not used for
// longest where another needs its place. What is kept is
// bit by bit what would be drawn anew, since a tile's place alone decides what it shows.

#ifndef vtkVirtualShadowPages_h
#define vtkVirtualShadowPages_h

#include "vtkShadowCasters.h"                      // For casters
#include "vtkShadowGL.h"                           // For textures
#include "vtkSoftShadowsVirtualShadowMapsModule.h" // For export macro
#include "vtkVirtualShadowTile.h"                  // For tiles

#include <glm/mat4x4.hpp>

#include <array>
#include <cstddef>
#include <map>
#include <vector>

struct vtkLightView;
struct vtkShadowFrame;

class VTKSOFTSHADOWSVIRTUALSHADOWMAPS_EXPORT vtkVirtualShadowPages
{
public:
  /** Pages of side^2 texels within a budget; or, not kept, one tile. Gives how many at most. */
  int SetLimits(int side, std::size_t bytes, bool kept);
  /** Drop what a part of a light shows otherwise than in the last frame. */
  void Follow(vtkShadowFrame& frame, int part, const std::vector<vtkLightView>& views);
  /** Drop all that belongs to parts from this one on. */
  void FollowEnd(int part);

  /**
   * Give each tile of a part its place. Tiles that are not kept, and all of those that do not fit
   * at once, come in batches, which are to be drawn one after another. False when out of memory.
   */
  bool Place(vtkShadowFrame& frame, int part, std::vector<vtkVirtualShadowTile>& tiles);
  int GetNumberOfBatches() const { return this->Batches; }
  /** Draw the tiles of a batch that are not there. */
  void Draw(vtkShadowFrame& frame, const std::vector<vtkLightView>& views,
    const std::vector<vtkVirtualShadowTile>& tiles, int batch);

  vtkShadowTexture& GetTexture() { return this->Tiles; }
  std::size_t GetBytes() const { return this->Tiles.GetBytes(); }
  void Release(vtkOpenGLRenderWindow* window);

private:
  using Key = std::array<int, 6>; // part, view, place
  struct Page
  {
    int Slot = 0;
    unsigned long Used = 0;
  };
  /** A caster as a view saw it. */
  struct Seen
  {
    std::shared_ptr<const vtkShadowMesh> Mesh;
    glm::dmat4 MeshToSWC{ 1.0 };
    std::array<glm::dvec3, 8> Corners;

    bool operator<(const Seen& other) const;
  };
  struct View
  {
    glm::dmat4 SWCToClip{ 0.0 };
    std::vector<Seen> Casters; // sorted
  };

  bool Allocate(vtkShadowFrame& frame, int slots);
  void DropAll();
  /** Of a part and view: what differs between two frames, and what lies over a box. */
  void DropChanges(const std::array<int, 2>& whose, const View& last, const View& now);
  void Drop(const std::array<int, 2>& whose, const glm::dmat4& SWCToClip,
    const std::array<glm::dvec3, 8>& corners);
  bool PlacePages(vtkShadowFrame& frame, int part, std::vector<vtkVirtualShadowTile>& tiles);
  bool PlaceInTurn(vtkShadowFrame& frame, std::vector<vtkVirtualShadowTile>& tiles);

  int Side = 0;
  int Most = 1; // pages
  bool Kept = true;
  int Batches = 1;
  unsigned long Time = 0;
  std::map<Key, Page> Pages;
  std::vector<int> FreeSlots;
  std::map<std::array<int, 2>, View> Views;
  vtkShadowTexture Tiles;
  vtkShadowFramebuffer Framebuffer;
};

#endif
