// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPenumbraEmission.h"

#include "vtkPenumbraEmissionFS.h"
#include "vtkShadowLight.h"

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
constexpr int Angles = 128;
constexpr int Heights = 33;
constexpr int Places = 65;
constexpr int OfBorder = 256; // texels to a half side
constexpr int BorderEnd = 8 * OfBorder;
static_assert(BorderEnd < Places * Heights, "the border's table is a layer");
constexpr double Farthest = glm::root_two<double>();

/** R of points up to twice as far off as the border's middles, from a polar table. */
class ThinTriangles
{
public:
  template <typename Function>
  explicit ThinTriangles(const Function& emission)
    : Values(static_cast<std::size_t>(Turns) * (Steps + 1))
  {
    for (int i = 0; i < Turns; ++i)
    {
      const double angle = glm::two_pi<double>() * i / Turns;
      const glm::dvec2 direction(std::cos(angle), std::sin(angle));
      glm::dvec3* values = &this->Values[static_cast<std::size_t>(i) * (Steps + 1)];
      glm::dvec3 sum(0.0);
      values[0] = 0.5 * emission(glm::dvec2(0.0));
      for (int j = 1; j <= Steps; ++j)
      {
        sum += (j - 0.5) * emission((j - 0.5) * Step * direction);
        values[j] = sum / static_cast<double>(j * j);
      }
    }
  }

  glm::dvec3 Get(const glm::dvec2& p) const
  {
    const double turn = std::atan2(p.y, p.x) / glm::two_pi<double>();
    const double angle = (turn < 0.0 ? turn + 1.0 : turn) * Turns;
    const double distance = std::min(std::hypot(p.x, p.y) / Step, Steps - 1e-9);
    const int i = static_cast<int>(angle);
    const int j = static_cast<int>(distance);
    const glm::dvec3* a = &this->Values[static_cast<std::size_t>(i % Turns) * (Steps + 1) + j];
    const glm::dvec3* b =
      &this->Values[static_cast<std::size_t>((i + 1) % Turns) * (Steps + 1) + j];
    return glm::mix(
      glm::mix(a[0], a[1], distance - j), glm::mix(b[0], b[1], distance - j), angle - i);
  }

private:
  static constexpr int Turns = 1024;
  static constexpr int Steps = 256;
  static constexpr double Step = 2.0 / Steps;
  std::vector<glm::dvec3> Values;
};

/** Where a perimeter coordinate is: see shadowPerimeter. */
glm::dvec2 GetBorder(double s)
{
  return s < 2.0   ? glm::dvec2(1.0, s - 1.0)
         : s < 4.0 ? glm::dvec2(3.0 - s, 1.0)
         : s < 6.0 ? glm::dvec2(-1.0, 5.0 - s)
                   : glm::dvec2(s - 7.0, -1.0);
}
}

//------------------------------------------------------------------------------
void vtkPenumbraEmission::Set(vtkOpenGLRenderWindow* window, const vtkShadowLight& light,
  const glm::dvec2& low, const glm::dvec2& high)
{
  const ThinTriangles thin(
    [&](const glm::dvec2& p) { return light.GetEmission(glm::mix(low, high, 0.5 + 0.5 * p)); });
  std::vector<glm::dvec3> border(1, glm::dvec3(0.0));
  for (int i = 0; i < BorderEnd; ++i)
  {
    border.push_back(border.back() + thin.Get(GetBorder((i + 0.5) / OfBorder)) / double(OfBorder));
  }
  this->Whole = border.back();
  const glm::dvec3 whole = this->Whole;
  // A constant emission of 1 has 0.5 everywhere: the square's area of 4 from 8 of the border.
  const auto share = [&](const glm::dvec3& value, double even)
  {
    glm::dvec4 result(0.0);
    for (int c = 0; c < 3; ++c)
    {
      result[c] = whole[c] > 0.0 ? value[c] / whole[c] : even / 8.0;
    }
    return result;
  };
  std::vector<float> texels(4 * static_cast<std::size_t>(Places) * Heights);
  const auto set = [&](int texel, const glm::dvec4& value)
  {
    for (int c = 0; c < 4; ++c)
    {
      texels[4 * static_cast<std::size_t>(texel) + c] = static_cast<float>(value[c]);
    }
  };
  this->Texture.Allocate(window, vtkShadowTexture::Format::Float4, Places, Heights, Angles + 1);
  constexpr int middle = Places / 2;
  constexpr int parts = 2; // of an interval that are summed up
  constexpr double step = Farthest / (middle * parts);
  for (int k = 0; k < Angles; ++k)
  {
    const double angle = glm::two_pi<double>() * k / Angles;
    const glm::dvec2 normal(std::cos(angle), std::sin(angle));
    const glm::dvec2 tangent(-normal.y, normal.x);
    for (int j = 0; j < Heights; ++j)
    {
      const glm::dvec2 foot = Farthest * j / (Heights - 1) * normal;
      for (const int way : { -1, 1 })
      {
        glm::dvec3 sum(0.0);
        for (int i = 0; i <= middle; ++i)
        {
          set(Places * j + middle + way * i, share(way * step * sum, way * step * i * parts));
          for (int n = 0; n < parts; ++n)
          {
            sum += thin.Get(foot + way * step * (i * parts + n + 0.5) * tangent);
          }
        }
      }
    }
    this->Texture.UploadLayer(window, k, texels.data());
  }
  for (int i = 0; i <= BorderEnd; ++i)
  {
    set(i, share(border[i], static_cast<double>(i) / OfBorder));
  }
  this->Texture.UploadLayer(window, Angles, texels.data());
}

//------------------------------------------------------------------------------
std::string vtkPenumbraEmission::GetGLSL()
{
  return "#define SHADOW_WEDGE_EMISSION\n#define SHADOW_ANGLES " + std::to_string(Angles) +
         "\n#define SHADOW_HEIGHTS " + std::to_string(Heights) + "\n#define SHADOW_PLACES " +
         std::to_string(Places) + "\n#define SHADOW_OF_BORDER " + std::to_string(OfBorder) + "\n" +
         vtkPenumbraEmissionFS;
}
