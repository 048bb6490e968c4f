#include "vtkPlanarShadowPass.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPlanarShadowMaps.h"
#include "vtkPlanarViewFS.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasters.h"
#include "vtkShadowFrame.h"
#include "vtkShadowPlanes.h"
#include "vtkShadowVTKVersion.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkPlanarShadowPass);

//------------------------------------------------------------------------------
vtkPlanarShadowPass::vtkPlanarShadowPass()
  : Planes(new vtkShadowPlanes)
  , Maps(new vtkPlanarShadowMaps)
{
  this->SetTechnique("planar-hard");
}

//------------------------------------------------------------------------------
vtkPlanarShadowPass::~vtkPlanarShadowPass()
{
  this->Detach();
}

//------------------------------------------------------------------------------
bool vtkPlanarShadowPass::AddPlane(double ox, double oy, double oz, double nx, double ny, double nz)
{
  if (!this->Planes->Add({ ox, oy, oz }, { nx, ny, nz }))
  {
    vtkErrorMacro("AddPlane: point (" << ox << ", " << oy << ", " << oz << ") and normal (" << nx
                                      << ", " << ny << ", " << nz
                                      << ") are no plane: they must be finite, and the normal not "
                                         "zero. It is left out.");
    return false;
  }
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::RemoveAllPlanes()
{
  this->Planes->RemoveAll();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkPlanarShadowPass::GetNumberOfPlanes()
{
  return this->Planes->GetNumberOfGiven();
}

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::CopySettings(vtkShadowPass* other)
{
  this->Superclass::CopySettings(other);
  if (auto* planar = vtkPlanarShadowPass::SafeDownCast(other))
  {
    this->Planes->SetGiven(*planar->Planes);
  }
}

//------------------------------------------------------------------------------
int vtkPlanarShadowPass::GetResolution(const vtkShadowFrame& frame)
{
  if (!this->HasParameter("resolution"))
  {
    return 1;
  }
  int resolution = this->GetInteger("resolution");
  if (resolution == 0)
  {
    // About a texel a pixel where the shadow fills the picture; in powers of two, so that a window
    // can be resized without new layers.
    resolution = 512;
    while (resolution < std::min(4096, std::max(frame.Size[0], frame.Size[1])))
    {
      resolution *= 2;
    }
  }
  resolution = std::max(16, resolution); // a smaller layer has no middle within its border
  int largest = resolution;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  if (resolution > largest)
  {
    this->WarnOnce("resolution " + std::to_string(resolution) +
                   " is more than this GPU allows; it is " + std::to_string(largest) + ".");
    resolution = largest;
  }
  return resolution;
}

//------------------------------------------------------------------------------
bool vtkPlanarShadowPass::UpdateLightData(vtkShadowFrame& frame)
{
  using Kind = vtkPlanarShadowSettings::Kind;
  const std::string technique = this->GetTechnique();
  vtkPlanarShadowSettings settings;
  settings.Technique = technique == "planar-soft"
                         ? Kind::Soft
                         : (technique == "planar-fake" ? Kind::Fake : Kind::Hard);
  settings.Resolution = this->GetResolution(frame);
  settings.Samples = settings.Technique == Kind::Soft ? this->GetInteger("samples") : 1;
  settings.Kernel = settings.Technique == Kind::Fake ? this->GetInteger("kernel") : 1;

  const bool changed = this->Planes->Update(*frame.Casters, this->GetInteger("planes"));
  const auto planes = static_cast<int>(this->Planes->Get().size());
  frame.Counts["planes"] = planes;
  frame.Counts["planesFound"] = this->Planes->GetFound();
  frame.Counts["planesLeftOut"] = this->Planes->GetFound() - planes;
  const auto& casters = frame.Casters->Get();
  if (planes == 0 && std::none_of(casters.begin(), casters.end(),
                       [](const vtkShadowCaster& caster) { return caster.Mesh->Flat; }))
  {
    this->WarnOnce("nothing receives a shadow: no prop is flat, and no plane is given (AddPlane).");
  }
  if (!this->Maps->Update(frame, *this->Planes, changed, settings))
  {
    const std::string width =
      std::to_string(settings.Technique == Kind::Hard ? frame.Size[0] : settings.Resolution);
    const std::string height =
      std::to_string(settings.Technique == Kind::Hard ? frame.Size[1] : settings.Resolution);
    this->ErrorOnce("no memory for " + std::to_string(this->Maps->GetNumberOfLayers()) +
                    " layers of " + width + " x " + height + "; drawn without shadows.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkPlanarShadowPass::GetVisibilityGLSL()
{
  return this->Maps->GetGLSL();
}

//------------------------------------------------------------------------------
bool vtkPlanarShadowPass::PrefersForward(const vtkShadowFrame& frame)
{
  // As vtkFilteredShadowMapPass: the filter's code is long.
  return this->GetTechnique() != "planar-fake" || frame.Lights.size() < 2;
}

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::ActivateLightData(vtkShadowFrame& frame)
{
  this->Maps->Activate(frame);
}

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::DeactivateLightData(vtkShadowFrame& frame)
{
  this->Maps->Deactivate(frame);
}

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::SetVisibilityParameters(vtkShaderProgram* program)
{
  this->Maps->SetParameters(program);
}

//------------------------------------------------------------------------------
double vtkPlanarShadowPass::GetMaximumCost()
{
  return this->Maps->GetMaximumCost();
}

//------------------------------------------------------------------------------
std::string vtkPlanarShadowPass::GetDebugViews()
{
  return this->Superclass::GetDebugViews() + " map";
}

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::DrawDebugView(vtkShadowFrame& frame, const std::string&)
{
  vtkShadowTexture& texture = this->Maps->GetTexture();
  texture.Activate(frame.Window);
  int viewport[4];
  frame.Window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  std::string source = vtkPlanarViewFS;
  vtkShaderProgram::Substitute(
    source, "SHADOW_VIEW_SWIZZLE", frame.Color && !frame.Hard ? "texel.rgb" : "texel.rrr");
  const int layers = this->Maps->GetNumberOfLayers();
  this->DrawQuad(source,
    [&](vtkShaderProgram* program)
    {
      program->SetUniformi("shadowPlanarMaps", texture.GetUnit());
      program->SetUniform2i("shadowViewportOrigin", viewport);
      program->SetUniform2i("shadowViewportSize", viewport + 2);
      program->SetUniformi("shadowLayers", layers);
      program->SetUniformi("shadowCoverage", this->GetTechnique() == "planar-fake");
      program->SetUniformi("shadowColumns",
        static_cast<int>(std::ceil(std::sqrt(static_cast<double>(std::max(1, layers))))));
    });
}

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::ReleaseLightData(vtkRenderWindow* window)
{
  this->Maps->Release(vtkOpenGLRenderWindow::SafeDownCast(window));
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::size_t>> vtkPlanarShadowPass::GetLightDataBytes()
{
  return this->Maps->GetBytes();
}

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfPlanes: " << this->GetNumberOfPlanes() << "\n";
  os << indent << "Layers: " << this->Maps->GetNumberOfLayers() << "\n";
}
