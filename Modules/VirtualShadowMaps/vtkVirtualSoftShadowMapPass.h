// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVirtualSoftShadowMapPass
 * @brief   Technique virtual-maps: soft shadow maps as fine as the picture's penumbrae need.
 *
 * Shen, Guennebaud, Yang and Feng, Predicted virtual soft shadow maps with high quality filtering,
 * Computer Graphics Forum 30(2), Eurographics 2011. Percentage-closer soft shadows over a virtual
 * map, whose texels are squares that the filter clips, and of which only those tiles are drawn that
 * pixels in a penumbra look up, each as fine as a perceptual metric asks.
 *
 * Stages: 1. the receivers (vtkShadowReceivers); 2. a coarse map of each view of a light,
 * conservatively rasterized, kept while light and casters are unchanged; 3. each pixel's kernel,
 * from the mean depth of blockers in that map, and the pixel's footprint; 4. the texel that it
 * needs, scattered by minimum over the cells of a grid; 5. and 6. a kd-tree over the least of the
 * cells; 7. the tiles' maps, which are pages that are kept from frame to frame (cache=on), or are
 * drawn anew in turn (cache=off, the paper's own); 8. the sums over all texels within a kernel, 9.
 * widened by the pixel's footprint (antialias=on); then the visibility, normalised by the sum of
 * weights.
 *
 * Textures: see vtkVirtualShadowViews (coarse maps), vtkVirtualShadowPages (tiles);
 *
 *   kernels   RGBA32F  a pixel: half axes of the kernel over the map, a parallelogram
 *   requests  RGBA32F  a pixel: cells that it covers, its view, level and shape, the texel that is
 *                      asked for
 *   sums      RGBA32F  a pixel: weights above the horizon, hidden and all; all weights; look-ups
 *   nodes     RGBA32F  buffer: table of the pages, 16 bytes an entry; or kd-trees, 48 bytes a node
 *
 * Parameters: metric (dynamic, static, none; default dynamic), texel (0.0625 to
 * 16 times the metric's, default 1), antialias (default on), resolution
 * (side of a tile's map, 16 to 16384 texels, default 0: 512, with metric=none as the picture's),
 * cache (default on), budget (of pages, 1 to 16384 MB, default 256), taps (most texels
 * along a side of a kernel, 1 to 16384, default 48), coarse (side of the coarse maps, 32 to 4096
 * texels, default 256).
 *
 * Statistics: "tiles", "tilesDrawn", "tilesKept", "tileTexels", "tileTrianglesDrawn",
 * "tileChunksDrawn", "chunksPerTile", "pixelsFiltered", "coarseMapsDrawn", "coarser" (1, or how many times coarser texels are than
 * asked for).
 *
 * Debug views: "tiles", "predicted-resolution", "kernel-size", "lit-mask", "cache-hits".
 */

#ifndef vtkVirtualSoftShadowMapPass_h
#define vtkVirtualSoftShadowMapPass_h

#include "vtkShadowPass.h"
#include "vtkSoftShadowsVirtualShadowMapsModule.h" // For export macro

class VTKSOFTSHADOWSVIRTUALSHADOWMAPS_EXPORT vtkVirtualSoftShadowMapPass : public vtkShadowPass
{
public:
  static vtkVirtualSoftShadowMapPass* New();
  vtkTypeMacro(vtkVirtualSoftShadowMapPass, vtkShadowPass);

protected:
  vtkVirtualSoftShadowMapPass();
  ~vtkVirtualSoftShadowMapPass() override;

private:
  vtkVirtualSoftShadowMapPass(const vtkVirtualSoftShadowMapPass&) = delete;
  void operator=(const vtkVirtualSoftShadowMapPass&) = delete;
};

#endif
