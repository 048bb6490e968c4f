// SPDX-License-Identifier: BSD-3-Clause
// The camera of a frame, as shadows see it.

#ifndef vtkShadowView_h
#define vtkShadowView_h

#include "vtkSoftShadowsDrawingModule.h" // For export macro

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

struct VTKSOFTSHADOWSDRAWING_EXPORT vtkShadowView
{
  /**
   * What a receiver's position can be off by as a share of its distance: it was transformed and
   * interpolated in 24-bit floats, over triangles that may reach far out of the picture.
   */
  static constexpr double PositionRounding = 1.0 / 524288.0;
  /** The viewport's width and height in pixels. */
  int Size[2] = { 0, 0 };
  /**
   * View coordinates to SWC: shifted world coordinates, world axes with the origin amid the casters
   * (vtkShadowCasters::GetOrigin()), in which nothing is lost far from the world's origin. Lengths and angles in VC are
   * those of the world: where the camera scales or shears VTK's own view coordinates, VC is the world
   * turned so that planes of equal depth are the same, about the same origin.
   */
  glm::dmat4 VCToSWC{ 1.0 };
  /** View coordinates to clip coordinates, as VTK's mappers draw with. */
  glm::dmat4 VCToClip{ 1.0 };
  /** VTK's view coordinates to VC; the identity, and Rigid, where both are the same. */
  glm::dmat3 VTKToVC{ 1.0 };
  bool Rigid = true;
  /**
   * Set these by the camera's matrices and the origin of SWC in the world. False where the view's is
   * not one that can be undone: nothing can be said of shadows then.
   */
  bool SetCamera(
    const glm::dmat4& worldToVTK, const glm::dmat4& VTKToClip, const glm::dvec3& origin);
  /** Of a parallel projection. */
  bool IsParallel() const;
  /** Where all lines of sight meet, w 1; or the direction towards the viewer, w 0. */
  glm::dvec4 GetEyeVC() const;
  /**
   * What moves a point in the picture by a pixel along an axis, 0 or 1, without a change of depth, in
   * world units: times w of its clip coordinates.
   */
  glm::dvec3 GetPixelVC(int axis) const;
  glm::dmat4 GetSWCToVC() const;
  glm::dmat4 GetWorldToVC() const;

private:
  glm::dvec3 Origin{ 0.0 }; // of SWC
};

#endif
