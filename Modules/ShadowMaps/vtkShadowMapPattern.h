// SPDX-License-Identifier: BSD-3-Clause
// A pattern of points over a light, in its half axes: of the disk, and of the square [-1,1]^2.
//
//   points  RGBA32F buffer  a texel a point: xy of the disk, zw of the square

#ifndef vtkShadowMapPattern_h
#define vtkShadowMapPattern_h

#include "vtkShadowGL.h"                    // For textures
#include "vtkSoftShadowsShadowMapsModule.h" // For export macro

#include <glm/vec4.hpp>

#include <vector>

class VTKSOFTSHADOWSSHADOWMAPS_EXPORT vtkShadowMapPattern
{
public:
  /** n x n cell centres of the square; for the disk, mapped to it with their areas. */
  void SetGrid(vtkOpenGLRenderWindow* window, int n, double scale = 1.0);
  /** Sobol's points over disk and square (see vtkShadowSampling), the first in the centre if wanted. */
  void SetSobol(vtkOpenGLRenderWindow* window, int count, bool centre);
  /**
   * So many of Sobol's points for a search, the first in the centre and the others the denser the nearer
   * they are to it: as many within each distance as in proportion to that. Behind them, not counted,
   * further ones that are spread evenly.
   */
  void SetSearch(vtkOpenGLRenderWindow* window, int count, int further);

  vtkShadowTexture& GetTexture() { return this->Points; }
  const std::vector<glm::vec4>& GetPoints() const { return this->Values; }
  int GetCount() const { return static_cast<int>(this->Values.size()) - this->Further; }
  int GetFurther() const { return this->Further; }

private:
  void Set(vtkOpenGLRenderWindow* window, std::vector<glm::vec4> points, int further = 0);

  vtkShadowTexture Points;
  std::vector<glm::vec4> Values;
  int Further = 0; // of the values
};

#endif
