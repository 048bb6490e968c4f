#include "vtkShadowFrame.h"

#include "vtkShaderProgram.h"
#include "vtkShadowCasters.h"
#include "vtkShadowLightsFS.h"
#include "vtkShadowMessages.h"
#include "vtkShadowOpenGL.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
bool vtkShadowFrame::SetCamera(const glm::dmat4& worldToVTK, const glm::dmat4& VTKToClip)
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
  const glm::dmat4 toWorld = glm::inverse(worldToVTK);
  const glm::dmat4 toOrigin = glm::translate(glm::dmat4(1.0), -this->Casters->GetOrigin());
  this->VTKToVC = glm::dmat3(1.0);
  this->VCToClip = VTKToClip;
  this->VCToWC = toOrigin * toWorld;
  if (!this->Rigid)
  {
    // Depth's direction first, so that depth is not mixed with what lies beside it.
    const glm::dvec3 z = glm::normalize(glm::row(turn, 2));
    const glm::dvec3 x = glm::normalize(glm::row(turn, 0) - glm::dot(glm::row(turn, 0), z) * z);
    glm::dmat4 VCToWorld(glm::dmat3(x, glm::cross(z, x), z));
    VCToWorld[3] = toWorld[3];
    this->VTKToVC = glm::transpose(glm::dmat3(VCToWorld)) * glm::inverse(turn);
    this->VCToClip = VTKToClip * glm::dmat4(glm::inverse(this->VTKToVC));
    this->VCToWC = toOrigin * VCToWorld;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowFrame::IsParallel() const
{
  return glm::dvec3(glm::row(this->VCToClip, 3)) == glm::dvec3(0.0);
}

//------------------------------------------------------------------------------
glm::dvec4 vtkShadowFrame::GetEyeVC() const
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
glm::dvec3 vtkShadowFrame::GetPixelVC(int axis) const
{
  const glm::dvec3 depth(this->IsParallel() ? this->GetEyeVC() : glm::row(this->VCToClip, 3));
  const glm::dmat3 rows(
    glm::dvec3(glm::row(this->VCToClip, 0)), glm::dvec3(glm::row(this->VCToClip, 1)), depth);
  // What moves x / w is x alone, as w stays.
  return glm::inverse(glm::transpose(rows))[axis] * (2.0 / this->Size[axis]);
}

//------------------------------------------------------------------------------
glm::dmat4 vtkShadowFrame::GetWCToVC() const
{
  return glm::inverse(this->VCToWC);
}

//------------------------------------------------------------------------------
glm::dmat4 vtkShadowFrame::GetWorldToVC() const
{
  return glm::translate(this->GetWCToVC(), -this->Casters->GetOrigin());
}

//------------------------------------------------------------------------------
int vtkShadowFrame::ChooseResolution(int asked, int smallest, int least, double detail) const
{
  int resolution = std::max(smallest, asked);
  if (asked == 0)
  {
    const double pixels = std::min(4096, std::max(this->Size[0], this->Size[1]));
    resolution = least;
    while (resolution < std::max(pixels, detail))
    {
      resolution *= 2;
    }
  }
  int largest = resolution;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  if (resolution > largest)
  {
    this->Messages->Warn("resolution " + std::to_string(resolution) +
                         " is more than this GPU allows; it is " + std::to_string(largest) + ".");
  }
  return std::min(resolution, largest);
}

//------------------------------------------------------------------------------
std::string vtkShadowFrame::GetLightsGLSL(const std::string& definitions) const
{
  return "#define SHADOW_LIGHTS " + std::to_string(std::max<std::size_t>(1, this->Parts.size())) +
         "\n#define SHADOW_VISIBILITY " + (this->Color ? "vec3" : "float") + "\n" +
         (this->Hard ? "#define SHADOW_HARD\n" : "") + definitions + vtkShadowLightsFS;
}

//------------------------------------------------------------------------------
void vtkShadowFrame::SetLights(vtkShaderProgram* program) const
{
  float place[MostParts][4] = {};
  float u[MostParts][4] = {};
  float v[MostParts][4] = {};
  const glm::dmat4 worldToVC = this->GetWorldToVC();
  const auto set = [&worldToVC](float* target, const glm::dvec3& vector, double isPoint, double w)
  {
    const glm::dvec4 vectorVC = worldToVC * glm::dvec4(vector, isPoint);
    for (int c = 0; c < 3; ++c)
    {
      target[c] = static_cast<float>(vectorVC[c]);
    }
    target[3] = static_cast<float>(w);
  };
  const int count = static_cast<int>(this->Parts.size());
  for (int i = 0; i < count; ++i)
  {
    const vtkShadowLight& light = this->Parts[i].Light;
    const bool sphere = light.Kind == vtkShadowLight::Shape::Sphere;
    const double isPoint = light.IsDirectional() ? 0.0 : 1.0;
    set(place[i], light.IsDirectional() ? -light.Direction : light.Position, isPoint, isPoint);
    set(u[i], light.U, 0.0, sphere ? glm::length(light.U) : 0.0);
    set(v[i], light.V, 0.0, light.Kind == vtkShadowLight::Shape::Rectangle ? 1.0 : 0.0);
  }
  if (count > 0)
  {
    program->SetUniform4fv("shadowLightPlaceVC", count, place);
    program->SetUniform4fv("shadowLightUVC", count, u);
    program->SetUniform4fv("shadowLightVVC", count, v);
  }
}
