#include "vtkDepthMapShadowPass.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasters.h"
#include "vtkShadowFrame.h"
#include "vtkShadowMapParameters.h"
#include "vtkShadowMapViewFS.h"
#include "vtkShadowMaps.h"
#include "vtkShadowMapsFS.h"
#include "vtkShadowVTKVersion.h"

#include <algorithm>
#include <cmath>

namespace
{
/** Of one of many maps, whose errors are averaged. */
constexpr int ResolutionOfMany = 512;

/**
 * About a texel a pixel where casters fill the picture, and four along a side of the finest mesh's
 * triangles if it does: a rough surface's own shadows are as fine. In powers of two, so that a window
 * can be resized without new maps.
 */
int FindResolution(const vtkShadowFrame& frame)
{
  std::size_t triangles = 0;
  for (const auto& caster : frame.Casters->Get())
  {
    triangles = std::max(triangles, caster.Mesh->GetNumberOfTriangles());
  }
  const double pixels = std::min(4096, std::max(frame.Size[0], frame.Size[1]));
  const double sides = std::min(2048.0, 4.0 * std::sqrt(static_cast<double>(triangles)));
  int resolution = 1024;
  while (resolution < std::max(pixels, sides))
  {
    resolution *= 2;
  }
  return resolution;
}
}

//------------------------------------------------------------------------------
vtkDepthMapShadowPass::vtkDepthMapShadowPass()
  : Maps(new vtkShadowMaps)
{
}

//------------------------------------------------------------------------------
vtkDepthMapShadowPass::~vtkDepthMapShadowPass()
{
  this->Detach();
}

//------------------------------------------------------------------------------
bool vtkDepthMapShadowPass::UpdateMaps(vtkShadowFrame& frame, int samples, double megabytes)
{
  vtkShadowMapSettings settings;
  settings.Samples = samples;
  settings.Midpoint = this->GetBoolean("midpoint");
  settings.Bilinear = this->GetText("filter") == "bilinear";
  settings.MemoryLimit = static_cast<std::size_t>(megabytes * 1048576.0);
  settings.Resolution = this->GetInteger("resolution");
  if (settings.Resolution == 0)
  {
    settings.Resolution = samples == 1 || frame.Hard ? FindResolution(frame) : ResolutionOfMany;
  }
  settings.Resolution = std::max(vtkShadowMapParameters::LeastResolution, settings.Resolution);
  int largest = settings.Resolution;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  if (settings.Resolution > largest)
  {
    this->WarnOnce("resolution " + std::to_string(settings.Resolution) +
                   " is more than this GPU allows; it is " + std::to_string(largest) + ".");
    settings.Resolution = largest;
  }
  this->SetMapSettings(settings);
  if (!this->Maps->Update(frame, settings))
  {
    const std::string side = std::to_string(settings.Resolution);
    this->ErrorOnce("no memory for a map of " + side + " x " + side + "; drawn without shadows.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkDepthMapShadowPass::GetVisibilityGLSL()
{
  return this->Maps->GetGLSL() + vtkShadowMapsFS;
}

//------------------------------------------------------------------------------
void vtkDepthMapShadowPass::ActivateLightData(vtkShadowFrame& frame)
{
  this->Maps->Activate(frame);
}

//------------------------------------------------------------------------------
void vtkDepthMapShadowPass::DeactivateLightData(vtkShadowFrame& frame)
{
  this->Maps->Deactivate(frame);
}

//------------------------------------------------------------------------------
void vtkDepthMapShadowPass::SetVisibilityParameters(vtkShaderProgram* program)
{
  this->Maps->SetParameters(program);
}

//------------------------------------------------------------------------------
double vtkDepthMapShadowPass::GetMaximumCost()
{
  return this->Maps->GetNumberOfViews();
}

//------------------------------------------------------------------------------
std::string vtkDepthMapShadowPass::GetDebugViews()
{
  return this->Superclass::GetDebugViews() + " map";
}

//------------------------------------------------------------------------------
void vtkDepthMapShadowPass::DrawDebugView(vtkShadowFrame& frame, const std::string&)
{
  vtkShadowTexture& texture = this->Maps->GetTexture();
  texture.SetSampling(frame.Window, vtkShadowTexture::Sampling::Nearest);
  texture.Activate(frame.Window);
  int viewport[4];
  frame.Window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const int columns =
    static_cast<int>(std::ceil(std::sqrt(static_cast<double>(texture.GetLayers()))));
  this->DrawQuad(vtkShadowMapViewFS,
    [&](vtkShaderProgram* program)
    {
      program->SetUniformi("shadowMaps", texture.GetUnit());
      program->SetUniform2i("shadowViewportOrigin", viewport);
      program->SetUniform2i("shadowViewportSize", viewport + 2);
      program->SetUniformi("shadowColumns", columns);
    });
  texture.SetSampling(frame.Window, this->GetText("filter") == "bilinear"
                                      ? vtkShadowTexture::Sampling::CompareLinear
                                      : vtkShadowTexture::Sampling::CompareNearest);
}

//------------------------------------------------------------------------------
void vtkDepthMapShadowPass::ReleaseLightData(vtkRenderWindow* window)
{
  this->Maps->Release(vtkOpenGLRenderWindow::SafeDownCast(window));
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::size_t>> vtkDepthMapShadowPass::GetLightDataBytes()
{
  return this->Maps->GetBytes();
}

//------------------------------------------------------------------------------
void vtkDepthMapShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Maps: " << this->Maps->GetNumberOfViews() << "\n";
}
