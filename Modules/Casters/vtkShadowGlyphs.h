// SPDX-License-Identifier: BSD-3-Clause
// The polygons of mappers that make their geometry on the GPU; see vtkShadowSurfaces.h.

#ifndef vtkShadowGlyphs_h
#define vtkShadowGlyphs_h

#include "vtkSmartPointer.h" // For the result
#include "vtkType.h"         // For vtkMTimeType

class vtkMapper;
class vtkPolyData;

namespace vtkShadowGlyphs
{
/** Whether a mapper is of that kind. */
bool IsMadeBy(vtkMapper* mapper);
/** Whether the property's representation (surface, wireframe, points) matters to it. */
bool IsRepresented(vtkMapper* mapper);
/** When the shape last changed: places, sizes, directions, sources and settings, not colours. */
vtkMTimeType GetShapeTime(vtkMapper* mapper);
/** When their colours' alpha last changed; 0 where all are opaque. */
vtkMTimeType GetAlphaTime(vtkMapper* mapper);
/**
 * The polygons in model coordinates; without any where it draws nothing that has an area. What has
 * a colour of alpha below a threshold is left out.
 */
vtkSmartPointer<vtkPolyData> Make(vtkMapper* mapper, double threshold);
}

#endif
