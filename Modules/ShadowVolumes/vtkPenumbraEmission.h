// SPDX-License-Identifier: BSD-3-Clause
// Tables of what a textured rectangle, or a part of it, emits: of the sector between the light's
// centre and its border, and of the triangle between the centre and a line. Both are integrals of one
// function, the emission of a thin triangle from the centre to a point p per twice its area,
//
//   R(p) = integral of r E(r p) dr, r from 0 to 1
//
// along the border and along the line. Unlike a table of both ends of a chord (paper, section 4.5)
// they are continuous where the chord passes the centre.
//
//   emission  RGBA32F  Places x Heights texels, Angles + 1 layers:
//     of the triangle: a layer for each angle of the line's normal, a row for each distance of the
//     line from the centre, 0 to sqrt(2), and a texel for each place along it, -sqrt(2) to sqrt(2) from
//     its foot: the integral of R from the foot to there. Times the distance it is the emission.
//     of the sector: the last layer, row after row, as texels of the border's perimeter coordinate from
//     0 to 8: the integral of R from 0 to there.
//
// All are shares of what the rectangle emits, of each channel; one without emission is as if all
// emitted alike.

#ifndef vtkPenumbraEmission_h
#define vtkPenumbraEmission_h

#include "vtkShadowGL.h" // For the texture

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <string>

struct vtkShadowLight;
class vtkOpenGLRenderWindow;

class vtkPenumbraEmission
{
public:
  /** Make those of a part of a light's unit square. */
  void Set(vtkOpenGLRenderWindow* window, const vtkShadowLight& light, const glm::dvec2& low,
    const glm::dvec2& high);
  /** What the part emits, in any unit that is the same for all parts of a light. */
  const glm::dvec3& GetWhole() const { return this->Whole; }

  /** Functions that look them up; shadowEmission is the texture. */
  static std::string GetGLSL();
  vtkShadowTexture& GetTexture() { return this->Texture; }
  void Release(vtkOpenGLRenderWindow* window) { this->Texture.Release(window); }

private:
  glm::dvec3 Whole{ 0.0 };
  vtkShadowTexture Texture;
};

#endif
