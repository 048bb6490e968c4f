// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowView.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
bool vtkShadowView::SetCamera(
  const glm::dmat4& worldToVTK, const glm::dmat4& VTKToClip, const glm::dvec3& origin)
{
  const glm::dmat3 turn(worldToVTK);
  const double determinant = glm::determinant(turn);
  if (glm::row(worldToVTK, 3) != glm::dvec4(0.0, 0.0, 0.0, 1.0) || !std::isfinite(determinant) ||
      determinant == 0.0 || !std::isfinite(glm::dot(worldToVTK[3], worldToVTK[3])))
  {
    return false;
  }
  // A mirror is rigid here: it keeps lengths and angles.
  const glm::dmat3 product = turn * glm::transpose(turn);
  double off = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      off = std::max(off, std::abs(product[i][j] - (i == j ? 1.0 : 0.0)));
    }
  }
  this->Rigid = off <= 1e-9;
  this->Origin = origin;
  const glm::dmat4 toWorld = glm::inverse(worldToVTK);
  const glm::dmat4 toOrigin = glm::translate(glm::dmat4(1.0), -this->Origin);
  this->VTKToVC = glm::dmat3(1.0);
  this->VCToClip = VTKToClip;
  this->VCToSWC = toOrigin * toWorld;
  if (!this->Rigid)
  {
    // Depth's direction first, so that depth is not mixed with what lies beside it.
    const glm::dvec3 z = glm::normalize(glm::row(turn, 2));
    const glm::dvec3 x = glm::normalize(glm::row(turn, 0) - glm::dot(glm::row(turn, 0), z) * z);
    glm::dmat4 VCToWorld(glm::dmat3(x, glm::cross(z, x), z));
    VCToWorld[3] = toWorld[3];
    this->VTKToVC = glm::transpose(glm::dmat3(VCToWorld)) * glm::inverse(turn);
    this->VCToClip = VTKToClip * glm::dmat4(glm::inverse(this->VTKToVC));
    this->VCToSWC = toOrigin * VCToWorld;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowView::IsParallel() const
{
  return glm::dvec3(glm::row(this->VCToClip, 3)) == glm::dvec3(0.0);
}

//------------------------------------------------------------------------------
glm::dvec4 vtkShadowView::GetEyeVC() const
{
  const glm::dvec4 x = glm::row(this->VCToClip, 0);
  const glm::dvec4 y = glm::row(this->VCToClip, 1);
  const glm::dvec4 w = glm::row(this->VCToClip, 3);
  if (this->IsParallel())
  {
    // Depth falls towards the viewer.
    const glm::dvec3 direction = glm::normalize(glm::cross(glm::dvec3(x), glm::dvec3(y)));
    const double depth = glm::dot(glm::dvec3(glm::row(this->VCToClip, 2)), direction);
    return glm::dvec4(depth > 0.0 ? -direction : direction, 0.0);
  }
  const glm::dmat3 rows{ glm::dvec3(x), glm::dvec3(y), glm::dvec3(w) };
  return glm::dvec4(glm::inverse(glm::transpose(rows)) * -glm::dvec3(x.w, y.w, w.w), 1.0);
}

//------------------------------------------------------------------------------
glm::dvec3 vtkShadowView::GetPixelVC(int axis) const
{
  const glm::dvec3 depth(this->IsParallel() ? this->GetEyeVC() : glm::row(this->VCToClip, 3));
  const glm::dmat3 rows(
    glm::dvec3(glm::row(this->VCToClip, 0)), glm::dvec3(glm::row(this->VCToClip, 1)), depth);
  // What moves x / w is x alone, as w stays.
  return glm::inverse(glm::transpose(rows))[axis] * (2.0 / this->Size[axis]);
}

//------------------------------------------------------------------------------
glm::dmat4 vtkShadowView::GetSWCToVC() const
{
  return glm::inverse(this->VCToSWC);
}

//------------------------------------------------------------------------------
glm::dmat4 vtkShadowView::GetWorldToVC() const
{
  return glm::translate(this->GetSWCToVC(), -this->Origin);
}
