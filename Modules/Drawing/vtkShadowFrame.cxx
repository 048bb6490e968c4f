// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowFrame.h"

#include "vtkShaderProgram.h"
#include "vtkShadowCasters.h"
#include "vtkShadowLightsFS.h"
#include "vtkShadowMessages.h"
#include "vtkShadowNumber.h"
#include "vtkShadowOpenGL.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <numeric>

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
double vtkShadowFrame::CountLargeLights() const
{
  constexpr double largest = 0.25; // tangent of half its angle: 28 degrees across
  std::vector<int> all(this->Casters->Get().size());
  std::iota(all.begin(), all.end(), 0);
  const glm::dvec3 middle = this->Casters->GetMiddle(all) + this->Casters->GetOrigin();
  return static_cast<double>(std::count_if(this->Lights.begin(), this->Lights.end(),
    [&](const vtkShadowLight& light)
    {
      const double distance = light.IsDirectional() ? 1.0 : glm::length(light.Position - middle);
      return std::max(glm::length(light.U), glm::length(light.V)) > largest * distance;
    }));
}

//------------------------------------------------------------------------------
std::string vtkShadowFrame::GetLightsGLSL(const std::string& definitions) const
{
  return "#define SHADOW_LIGHTS " + std::to_string(std::max<std::size_t>(1, this->Parts.size())) +
         "\n#define SHADOW_VISIBILITY " + (this->Color ? "vec3" : "float") + "\n" +
         "#define SHADOW_POSITION_ROUNDING " + vtkShadowNumber::Print(PositionRounding) + "\n" +
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
