// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPenumbraWedgePass
 * @brief   Technique wedges: soft shadow volumes by penumbra wedges.
 *
 * Assarsson, Dougherty, Mounier and Akenine-Moeller, An optimized soft shadow volume algorithm with
 * real-time performance, EGSR 2003; and, beyond it, counts for each sample of the light. A textured light
 * is looked up in tables, of each channel; one without emission is decided by geometry.
 *
 * Stages:
 *   1. Silhouettes from the light's centre, where light or casters changed (vtkShadowSilhouetteCache).
 *   2. Runs of short edges that are one edge (vtkPenumbraLines), where the picture's pixels are too coarse
 *      to tell.
 *   3. The bound of the space in which each edge hides a part of the light, within the box of what
 *      receives (vtkShadowWedge): of these edges, or of all at which casters may end.
 *   4. Receivers, and how many volumes hold each, as its sight of the light's centre: z-pass, or z-fail, by
 *      which side of each volume's sides it is on.
 *   5. Over each wedge, what its edge lets through of the light where the centre is hidden, and hides
 *      where it is not; or how it changes the counts of samples.
 *   6. One step over the picture, that takes the sum, or the samples that are hidden, from full light.
 *
 * Parameters, each with default and range:
 *   overlap  sum     sum, loops or count: all edges together, max + min / 2 of the silhouettes' loops as in
 *                    the paper's section 5.1, or a count for each sample of the light
 *   samples  64      1 to 256: of overlap=count
 *   split    1       1 to 4: the light is split x split lights, of overlap=sum and loops
 *   merge    0       0 to 4 pixels: runs of edges that are straight to within this are one, of overlap=sum
 *                    and loops; 0: none
 *   bounds   tight   tight or sphere: what bounds a wedge; the picture is the same
 *
 * Debug views: "centre", how often the light's centre is hidden; "inner" and "outer", what the halves of
 * the wedges let through and hide; "edges", the former less the latter; "wedges", outlines of the faces
 * that bound them; "cost", wedges drawn over a pixel.
 * The statistics have each view's sum over the pixels: centrePixels and so on; wedgePixels of the cost.
 *
 * Textures and buffers, beside those of vtkShadowSilhouetteCache and vtkShadowVolumes:
 *   wedges   vertex buffer     76 bytes a corner (108 with overlap=count), about 50 corners a wedge
 *   lines    index buffer      8 bytes a line of the silhouettes, some of which are runs
 *   planes   RGBA32F           1024 wide: two texels a line
 *   sums     RG32F, RGBA32F with a textured light
 *                              viewport size: how often the centre is hidden, what edges let through
 *   loops    2 x RG32F         viewport size: what loops hide, what holes let through; of overlap=loops, a
 *                              layer each channel of a textured light
 *   emission RGBA32F           65 x 33, 129 layers: tables of vtkPenumbraEmission.h, of each textured area
 *   counts   1 to 8 x RGBA32F  viewport size: of samples, 4, 3 or 2 digits a channel
 */

#ifndef vtkPenumbraWedgePass_h
#define vtkPenumbraWedgePass_h

#include "vtkShadowPass.h"
#include "vtkSoftShadowsShadowVolumesModule.h" // For export macro

class VTKSOFTSHADOWSSHADOWVOLUMES_EXPORT vtkPenumbraWedgePass : public vtkShadowPass
{
public:
  static vtkPenumbraWedgePass* New();
  vtkTypeMacro(vtkPenumbraWedgePass, vtkShadowPass);

protected:
  vtkPenumbraWedgePass();
  ~vtkPenumbraWedgePass() override;

private:
  vtkPenumbraWedgePass(const vtkPenumbraWedgePass&) = delete;
  void operator=(const vtkPenumbraWedgePass&) = delete;
};

#endif
