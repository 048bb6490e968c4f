// SPDX-License-Identifier: BSD-3-Clause
#include "vtkJitteredShadowMapTechnique.h"

#include "vtkJitteredShadowMapFS.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkShadowFrame.h"
#include "vtkShadowGL.h"
#include "vtkShadowMapConstantFS.h"
#include "vtkShadowMapFilterFS.h"
#include "vtkShadowMapJitterFS.h"
#include "vtkShadowMapLayersFS.h"
#include "vtkShadowSampling.h"

#include <glm/gtc/constants.hpp>

#include <cmath>

namespace
{
/** Side of the tile of pixels whose points differ; a power of two. */
constexpr int Tile = 16;

/** A point of [0,1) turns around the disk (equations 3.1, 3.2), or around the square's border. */
glm::dvec2 GoAround(double turn, bool square)
{
  if (!square)
  {
    const double angle = glm::two_pi<double>() * turn;
    return { std::cos(angle), std::sin(angle) };
  }
  const double side = 4.0 * turn;
  const double along = 2.0 * (side - std::floor(side)) - 1.0;
  switch (static_cast<int>(side))
  {
    case 0:
      return { 1.0, along };
    case 1:
      return { -along, 1.0 };
    case 2:
      return { -1.0, -along };
    default:
      return { along, -1.0 };
  }
}
}

//------------------------------------------------------------------------------
vtkJitteredShadowMapTechnique::vtkJitteredShadowMapTechnique(const vtkShadowSettings& settings)
  : vtkFilteredShadowMapTechnique(settings)
  , Jitter(new vtkShadowTexture)
{
}

//------------------------------------------------------------------------------
vtkJitteredShadowMapTechnique::~vtkJitteredShadowMapTechnique() = default;

//------------------------------------------------------------------------------
void vtkJitteredShadowMapTechnique::UpdatePatterns(vtkShadowFrame& frame)
{
  // As many sectors as rings, or up to four times as many.
  const int wanted = this->Settings.GetInteger("samples");
  int sectors = 2;
  while (sectors * sectors < wanted)
  {
    sectors *= 2;
  }
  const int rings = (wanted + sectors - 1) / sectors;
  const int samples = sectors * rings;
  std::uint32_t seed = 0;
  const auto random = [&seed] { return vtkShadowSampling::Hash(seed++) / 4294967296.0; };
  std::vector<glm::vec4> pairs(static_cast<std::size_t>(samples) * Tile * Tile);
  for (int form = 0; form < 2; ++form)
  {
    for (int texel = 0; texel < Tile * Tile; ++texel)
    {
      for (int i = 0; i < samples; ++i)
      {
        // From the outer ring inwards; those of a pair are opposite.
        const int sector = i % sectors / 2 + i % 2 * (sectors / 2);
        const double turn = (sector + random()) / sectors;
        const int ring = i / sectors;
        const double radius = std::sqrt((rings - 1 - ring + random()) / rings);
        const glm::vec2 point(radius * GoAround(turn, form == 1));
        glm::vec4& pair = pairs[(form * samples / 2 + i / 2) * Tile * Tile + texel];
        pair[i % 2 * 2] = point.x;
        pair[i % 2 * 2 + 1] = point.y;
      }
    }
  }
  this->Jitter->UploadBuffer(frame.Window, pairs);
  this->Samples = samples;
  this->Estimates = sectors;
}

//------------------------------------------------------------------------------
std::string vtkJitteredShadowMapTechnique::GetFilterGLSL()
{
  return std::string(vtkShadowMapFilterFS) + vtkShadowMapLayersFS + vtkShadowMapConstantFS +
         vtkShadowMapJitterFS + vtkJitteredShadowMapFS;
}

//------------------------------------------------------------------------------
std::string vtkJitteredShadowMapTechnique::GetKernelDefinitions()
{
  return this->Settings.GetBoolean("branching") ? "#define SHADOW_BRANCHING\n" : "";
}

//------------------------------------------------------------------------------
void vtkJitteredShadowMapTechnique::Activate(vtkShadowFrame& frame)
{
  vtkFilteredShadowMapTechnique::Activate(frame);
  if (!this->Hard)
  {
    this->Jitter->Activate(frame.Window);
  }
}

//------------------------------------------------------------------------------
void vtkJitteredShadowMapTechnique::Deactivate(vtkShadowFrame& frame)
{
  this->Jitter->Deactivate(frame.Window);
  vtkFilteredShadowMapTechnique::Deactivate(frame);
}

//------------------------------------------------------------------------------
void vtkJitteredShadowMapTechnique::SetVisibilityParameters(vtkShaderProgram* program)
{
  vtkFilteredShadowMapTechnique::SetVisibilityParameters(program);
  if (!this->Hard)
  {
    program->SetUniformi("shadowJitter", this->Jitter->GetUnit());
    program->SetUniformi("shadowJitterPairs", this->Samples / 2);
    program->SetUniformi("shadowEstimatePairs", this->Estimates / 2);
  }
}

//------------------------------------------------------------------------------
double vtkJitteredShadowMapTechnique::GetMaximumCost()
{
  return vtkFilteredShadowMapTechnique::GetMaximumCost() +
         (this->Hard ? 0 : this->GetLookUps() * this->Samples);
}

//------------------------------------------------------------------------------
void vtkJitteredShadowMapTechnique::Release(vtkOpenGLRenderWindow* window)
{
  this->Jitter->Release(window);
  vtkFilteredShadowMapTechnique::Release(window);
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::size_t>> vtkJitteredShadowMapTechnique::GetBytes()
{
  auto bytes = vtkFilteredShadowMapTechnique::GetBytes();
  bytes.emplace_back("jitter", this->Jitter->GetBytes());
  return bytes;
}
