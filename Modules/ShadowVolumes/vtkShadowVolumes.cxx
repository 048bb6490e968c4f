#include "vtkShadowVolumes.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkLightFrusta.h"
#include "vtkMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPlaneCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShadowFrame.h"
#include "vtkShadowVolumeCapVS.h"
#include "vtkShadowVolumeCountFS.h"
#include "vtkShadowVolumeResolveFS.h"
#include "vtkShadowVolumeSidesGS.h"
#include "vtkShadowVolumeViewFS.h"
#include "vtkVisibilityBuffer.h"
#include "vtk_glew.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace
{
using Counting = vtkShadowVolumeSettings::Counting;

/** How close to a plane counts as on both sides, as a share of the lengths involved. */
constexpr double Nearness = 1e-6;

/** A step of the rasterizer's positions, a 256th of a pixel, in device coordinates of one pixel. */
constexpr float RasterStep = 2.0f / 256.0f;

/** A step of the 24-bit depth, in device coordinates. */
constexpr float DepthStep = 1.0f / 8388608.0f;

double Side(const glm::dvec4& plane, const glm::dvec3& point)
{
  return glm::dot(plane, glm::dvec4(point, 1.0));
}

/** A plane of unit normal through a point. */
glm::dvec4 MakePlane(const glm::dvec3& normal, const glm::dvec3& point)
{
  const glm::dvec3 unit = glm::normalize(normal);
  return { unit, -glm::dot(unit, point) };
}

/** Faces are drawn from both sides, nothing but the count is written. */
class CountingState
{
public:
  CountingState(vtkOpenGLState* state, bool color)
    : DepthMask(state)
    , DepthFunc(state)
    , ColorMask(state)
    , BlendFunc(state)
    , DepthTest(state, GL_DEPTH_TEST)
    , CullFace(state, GL_CULL_FACE)
    , StencilTest(state, GL_STENCIL_TEST)
    , Blend(state, GL_BLEND)
  {
    state->vtkglDepthMask(GL_FALSE);
    state->vtkglColorMask(color, color, color, color);
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDisable(GL_CULL_FACE);
    state->vtkglDisable(GL_STENCIL_TEST);
    state->vtkglDisable(GL_BLEND);
  }

private:
  vtkOpenGLState::ScopedglDepthMask DepthMask;
  vtkOpenGLState::ScopedglDepthFunc DepthFunc;
  vtkOpenGLState::ScopedglColorMask ColorMask;
  vtkOpenGLState::ScopedglBlendFuncSeparate BlendFunc;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglEnableDisable CullFace;
  vtkOpenGLState::ScopedglEnableDisable StencilTest;
  vtkOpenGLState::ScopedglEnableDisable Blend;
};
}

//------------------------------------------------------------------------------
void vtkShadowVolumes::Update(vtkShadowFrame& frame, const vtkShadowVolumeSettings& settings)
{
  const bool all = !(settings == this->Current) || this->Lights.size() != frame.Lights.size() ||
                   frame.Casters->GetVersion() != this->CasterVersion;
  const bool receiversMoved = frame.Casters->GetReceiverVersion() != this->ReceiverVersion;
  this->Current = settings;
  this->CasterVersion = frame.Casters->GetVersion();
  this->ReceiverVersion = frame.Casters->GetReceiverVersion();
  this->Lights.resize(frame.Lights.size());
  for (const char* name : { "adjacenciesBuilt", "silhouettesFound", "silhouettesReused",
         "volumesZPass", "volumesZFail", "volumesOutOfView", "wideCounts" })
  {
    frame.Counts[name] = 0;
  }

  std::size_t bytes = 0;
  for (std::size_t i = 0; i < this->Lights.size(); ++i)
  {
    LightState& state = this->Lights[i];
    const vtkShadowLight& light = frame.Lights[i];
    const bool same = !all && state.Light.SameGeometry(light);
    if (!same || receiversMoved)
    {
      const auto casters = vtkLightFrusta(light, *frame.Casters, 0.0).GetCasters();
      if (!same || casters != state.Casters)
      {
        state.Light = light;
        state.Casters = casters;
        state.Samples = casters.empty()
                          ? std::vector<vtkLightSample>()
                          : light.GetPlaces(light.IsPoint() ? 1 : settings.Samples,
                              frame.Casters->GetMiddle(casters) + frame.Casters->GetOrigin());
        state.Places.clear();
        for (const auto& sample : state.Samples)
        {
          state.Places.push_back(light.IsDirectional()
                                   ? glm::dvec4(sample.Point, 0.0)
                                   : glm::dvec4(sample.Point - frame.Casters->GetOrigin(), 1.0));
        }
        for (auto& batch : state.Batches)
        {
          batch->Lines->ReleaseGraphicsResources();
        }
        state.Batches.clear();
        this->CapLight = this->PassingLight = -1;
        frame.Counts["adjacenciesBuilt"] += this->Adjacencies.Add(*frame.Casters, casters);
        const int batches =
          (static_cast<int>(state.Samples.size()) + vtkShadowSilhouettes::MostPlaces - 1) /
          vtkShadowSilhouettes::MostPlaces;
        for (int k = 0; k < batches && bytes < settings.MemoryLimit; ++k)
        {
          auto batch = std::make_unique<Batch>();
          this->FindSilhouettes(frame, state, k, *batch);
          bytes += batch->Bytes;
          state.Batches.push_back(std::move(batch));
        }
        continue;
      }
    }
    for (const auto& batch : state.Batches)
    {
      frame.Counts["silhouettesReused"] += static_cast<double>(batch->Silhouettes.Get().size());
      bytes += batch->Bytes;
    }
  }
  this->Adjacencies.Prune(*frame.Casters);
  for (const auto& entry : this->Adjacencies.GetAll())
  {
    frame.Counts["adjacencyBytes"] += static_cast<double>(entry.second->GetBytes());
    frame.Counts["adjacencyTriangles"] += static_cast<double>(entry.second->Flags.size());
    frame.Counts["edgesOpen"] += static_cast<double>(entry.second->OpenEdges);
    frame.Counts["edgesNonManifold"] += static_cast<double>(entry.second->NonManifoldEdges);
    frame.Counts["edgesInconsistent"] += static_cast<double>(entry.second->InconsistentEdges);
    frame.Counts["trianglesDuplicate"] += static_cast<double>(entry.second->DuplicateFaces);
  }

  // The view.
  this->WCToClip = frame.VCToClip * frame.GetWCToVC();
  // A camera that mirrors turns all faces around; the usual projection has a negative determinant.
  this->Mirrored = glm::determinant(this->WCToClip) > 0.0;
  this->Parallel = frame.Renderer->GetActiveCamera()->GetParallelProjection() != 0;
  this->FrustumPlanes.clear();
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double sign : { 1.0, -1.0 })
    {
      const glm::dvec4 plane = glm::row(this->WCToClip, 3) + sign * glm::row(this->WCToClip, axis);
      this->FrustumPlanes.push_back(plane / glm::length(glm::dvec3(plane)));
    }
  }
  const glm::dmat4 clipToWC = glm::inverse(this->WCToClip);
  this->FrustumCorners.clear();
  for (const double z : { -1.0, 1.0 })
  {
    for (const glm::dvec2& corner : { glm::dvec2(-1.0, -1.0), glm::dvec2(1.0, -1.0),
           glm::dvec2(1.0, 1.0), glm::dvec2(-1.0, 1.0) })
    {
      const glm::dvec4 p = clipToWC * glm::dvec4(corner, z, 1.0);
      this->FrustumCorners.push_back(glm::dvec3(p) / p.w);
    }
  }
}

//------------------------------------------------------------------------------
void vtkShadowVolumes::FindSilhouettes(
  vtkShadowFrame& frame, LightState& state, int batch, Batch& result)
{
  const std::size_t first = static_cast<std::size_t>(batch) * vtkShadowSilhouettes::MostPlaces;
  const std::size_t count =
    std::min<std::size_t>(vtkShadowSilhouettes::MostPlaces, state.Places.size() - first);
  const auto start = std::chrono::steady_clock::now();
  result.Silhouettes.Find(*frame.Casters, this->Adjacencies, state.Casters,
    state.Places.data() + first, static_cast<int>(count));
  const auto& lines = result.Silhouettes.GetLines();
  frame.Counts["silhouetteMilliseconds"] +=
    std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  frame.Counts["silhouetteEdges"] += static_cast<double>(lines.size() / 2);
  result.Bytes = lines.size() * sizeof(std::uint32_t);
  glBindVertexArray(0); // or the buffer would become that array's
  result.Lines->Upload(lines, vtkOpenGLBufferObject::ElementArrayBuffer);
  result.Silhouettes.ReleaseLines();
  frame.Counts["silhouettesFound"] += static_cast<double>(count);
}

//------------------------------------------------------------------------------
const vtkShadowVolumes::Batch& vtkShadowVolumes::GetBatch(
  vtkShadowFrame& frame, int light, int sample)
{
  LightState& state = this->Lights[light];
  const int index = sample / vtkShadowSilhouettes::MostPlaces;
  if (index < static_cast<int>(state.Batches.size()))
  {
    return *state.Batches[index];
  }
  if (this->PassingLight != light || this->PassingBatch != index)
  {
    this->FindSilhouettes(frame, state, index, this->Passing);
    this->PassingLight = light;
    this->PassingBatch = index;
  }
  return this->Passing;
}

//------------------------------------------------------------------------------
std::vector<glm::dvec4> vtkShadowVolumes::GetShadingPlanes(const glm::dvec4& place) const
{
  const glm::dvec3 light(place);
  const auto& corners = this->FrustumCorners;
  const glm::dvec3 middle = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
  const glm::dvec3 ahead = glm::dvec3(this->FrustumPlanes[4]);
  const double size = glm::length(corners[2] - corners[0]);
  std::vector<glm::dvec4> planes;
  const auto add = [&](const glm::dvec3& normal, const glm::dvec3& point, const glm::dvec3& inside)
  {
    // A pyramid without height keeps the planes that are sure.
    if (!(glm::length(normal) > 0.0))
    {
      return;
    }
    const glm::dvec4 plane = MakePlane(normal, point);
    const double side = Side(plane, inside);
    const double slack = Nearness * (size + glm::length(inside - point));
    if (std::abs(side) > slack)
    {
      planes.push_back((side > 0.0 ? plane : -plane) + glm::dvec4(0.0, 0.0, 0.0, slack));
    }
  };
  const bool positional = place.w != 0.0;
  for (int i = 0; i < 4; ++i)
  {
    const glm::dvec3& a = corners[i];
    const glm::dvec3& b = corners[(i + 1) % 4];
    add(positional ? glm::cross(a - light, b - light) : glm::cross(light, b - a), a, middle);
  }
  const glm::dvec3 inside = positional ? light : middle + size * light;
  add(ahead, middle, inside);
  if (positional)
  {
    add(ahead, light, middle);
  }
  return planes;
}

//------------------------------------------------------------------------------
vtkShadowVolumes::Selection vtkShadowVolumes::Select(vtkShadowFrame& frame, int light, int sample)
{
  const LightState& state = this->Lights[light];
  const glm::dvec4& place = state.Places[sample];
  Selection selection;
  selection.Lines = &this->GetBatch(frame, light, sample);
  const vtkShadowSilhouette& silhouette =
    selection.Lines->Silhouettes.Get()[sample % vtkShadowSilhouettes::MostPlaces];
  const auto shading = this->GetShadingPlanes(place);
  std::vector<int> capped;
  for (const auto& part : silhouette.Parts)
  {
    const vtkShadowCaster& caster = frame.Casters->Get()[part.Caster];
    if (this->IsOutOfView(caster, place))
    {
      ++frame.Counts["volumesOutOfView"];
    }
    else if (this->Current.Method == Counting::ZFail ||
             (this->Current.Method == Counting::Auto && NeedsCaps(caster, shading)))
    {
      selection.ZFail.push_back(part);
      capped.push_back(part.Caster);
    }
    else
    {
      selection.ZPass.push_back(part);
    }
  }
  frame.Counts["volumesZPass"] += static_cast<double>(selection.ZPass.size());
  frame.Counts["volumesZFail"] += static_cast<double>(selection.ZFail.size());
  selection.Wide = this->Current.Method != Counting::Xor && silhouette.MostNested > 255;
  frame.Counts["wideCounts"] += selection.Wide ? 1 : 0;
  if (!capped.empty())
  {
    this->UpdateCaps(frame, light, sample, capped);
  }
  return selection;
}

//------------------------------------------------------------------------------
bool vtkShadowVolumes::IsOutOfView(const vtkShadowCaster& caster, const glm::dvec4& place) const
{
  return std::any_of(this->FrustumPlanes.begin(), this->FrustumPlanes.end(),
    [&](const glm::dvec4& plane)
    {
      // All of the caster is outside, and the light not further out: then so is all that is behind.
      const double light = place.w == 0.0 ? glm::dot(glm::dvec3(plane), glm::dvec3(place)) : 0.0;
      return std::all_of(caster.Corners.begin(), caster.Corners.end(),
        [&](const glm::dvec3& corner)
        {
          const double side = Side(plane, corner);
          return side < 0.0 &&
                 (place.w == 0.0 ? light >= 0.0 : side <= Side(plane, glm::dvec3(place)));
        });
    });
}

//------------------------------------------------------------------------------
bool vtkShadowVolumes::NeedsCaps(
  const vtkShadowCaster& caster, const std::vector<glm::dvec4>& shading)
{
  // Where the caster's surface can be looked through, a view ray enters its volume unseen.
  if (auto* actor = vtkActor::SafeDownCast(caster.Prop))
  {
    vtkPlaneCollection* clipping = actor->GetMapper()->GetClippingPlanes();
    if (actor->GetProperty()->GetBackfaceCulling() || actor->GetProperty()->GetFrontfaceCulling() ||
        (clipping && clipping->GetNumberOfItems() > 0) ||
        caster.Mesh->NotFinite > 0) // VTK culls what has such bounds
    {
      return true;
    }
  }
  return std::none_of(shading.begin(), shading.end(),
    [&](const glm::dvec4& plane)
    {
      return std::all_of(caster.Corners.begin(), caster.Corners.end(),
        [&](const glm::dvec3& corner) { return Side(plane, corner) < 0.0; });
    });
}

//------------------------------------------------------------------------------
void vtkShadowVolumes::UpdateCaps(
  vtkShadowFrame& frame, int light, int sample, const std::vector<int>& casters)
{
  if (light == this->CapLight && sample == this->CapSample && casters == this->CapCasters)
  {
    return;
  }
  std::vector<std::uint32_t> triangles;
  this->CapParts.clear();
  for (const int i : casters)
  {
    const vtkShadowCaster& caster = frame.Casters->Get()[i];
    const std::size_t first = triangles.size();
    vtkShadowSilhouettes::AddCap(
      caster, this->Adjacencies.Get(caster.Mesh), this->Lights[light].Places[sample], triangles);
    this->CapParts.push_back({ i, first, triangles.size() - first });
  }
  glBindVertexArray(0);
  this->Caps->Upload(triangles, vtkOpenGLBufferObject::ElementArrayBuffer);
  this->CapBytes = triangles.size() * sizeof(std::uint32_t);
  this->CapLight = light;
  this->CapSample = sample;
  this->CapCasters = casters;
}

//------------------------------------------------------------------------------
void vtkShadowVolumes::SetExtrusion(
  vtkShaderProgram* program, const vtkShadowCaster& caster, const glm::dvec4& place) const
{
  // What is far from the light is keep x vertex - light, in clip coordinates: at infinity, keep is 1
  // and the light its position, or keep 0 and the light the direction to it.
  const bool positional = place.w != 0.0;
  glm::dvec4 light = this->WCToClip * place;
  double keep = positional ? 1.0 : 0.0;
  if (this->Parallel)
  {
    // Far enough to leave the picture: by scaling the caster about the light until it is further
    // away than all that is seen, or by moving it as far along the direction.
    double reach = 0.0;
    const glm::dvec3 from = positional ? glm::dvec3(place) : caster.GetMiddle();
    for (const auto& corner : this->FrustumCorners)
    {
      reach = std::max(reach, glm::length(corner - from));
    }
    const double radius = caster.GetRadius();
    if (positional)
    {
      const double gap = glm::length(caster.GetMiddle() - from) - radius;
      light *= 1.0 - std::min(1.0, std::max(0.9 * gap / reach, 1e-6));
    }
    else
    {
      keep = 0.5 / (reach + radius);
    }
  }
  const glm::vec4 lightDC(light);
  program->SetUniform4f("shadowLightDC", glm::value_ptr(lightDC));
  program->SetUniformf("shadowKeep", static_cast<float>(keep));
}

//------------------------------------------------------------------------------
void vtkShadowVolumes::DrawSides(vtkShadowFrame& frame, const glm::dvec4& place,
  const Selection& selection, const std::vector<vtkShadowCasterPart>& parts, const char* shader,
  const std::function<void(vtkShaderProgram*)>& setParameters)
{
  vtkShadowCasterDraw how;
  how.GeometryShader = vtkShadowVolumeSidesGS;
  how.FragmentShader = shader;
  how.SetParameters = [&](vtkShaderProgram* program)
  {
    const float step[3] = { RasterStep / static_cast<float>(frame.Size[0]),
      RasterStep / static_cast<float>(frame.Size[1]), this->Mirrored ? -DepthStep : DepthStep };
    program->SetUniform3f("shadowStep", step);
    if (setParameters)
    {
      setParameters(program);
    }
  };
  how.SetCasterParameters = [&](vtkShaderProgram* program, const vtkShadowCaster& caster)
  { this->SetExtrusion(program, caster, place); };
  frame.Casters->DrawParts(
    frame.Window, this->WCToClip, GL_LINES, selection.Lines->Lines, parts, how);
}

//------------------------------------------------------------------------------
void vtkShadowVolumes::DrawCaps(vtkShadowFrame& frame, const glm::dvec4& place, const char* shader,
  const std::function<void(vtkShaderProgram*)>& setParameters)
{
  for (const bool far : { false, true })
  {
    vtkShadowCasterDraw how;
    how.VertexShader = vtkShadowVolumeCapVS;
    how.FragmentShader = shader;
    how.SetParameters = [&](vtkShaderProgram* program)
    {
      program->SetUniformi("shadowFar", far ? 1 : 0);
      if (setParameters)
      {
        setParameters(program);
      }
    };
    how.SetCasterParameters = [&](vtkShaderProgram* program, const vtkShadowCaster& caster)
    { this->SetExtrusion(program, caster, place); };
    // The near cap lies in surfaces that the light may reach: it counts as behind them, by the
    // depth's own steps and the face's slope. The far cap is the same faces from behind.
    (far ? glDisable : glEnable)(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(far ? 0.0f : 1.0f, far ? 0.0f : 1.0f);
    this->SetFrontFace(far);
    frame.Casters->DrawParts(
      frame.Window, this->WCToClip, GL_TRIANGLES, this->Caps, this->CapParts, how);
  }
  this->SetFrontFace(false);
}

//------------------------------------------------------------------------------
void vtkShadowVolumes::SetFrontFace(bool reversed) const
{
  glFrontFace(this->Mirrored != reversed ? GL_CW : GL_CCW);
}

//------------------------------------------------------------------------------
template <typename SetCounter>
void vtkShadowVolumes::DrawVolumes(vtkShadowFrame& frame, const glm::dvec4& place,
  const Selection& selection, const char* shader, SetCounter setCounter)
{
  vtkOpenGLState* state = frame.Window->GetState();
  this->SetFrontFace(false);
  if (!selection.ZPass.empty())
  {
    // In front of the surface: +1 where a volume is entered, -1 where it is left.
    state->vtkglDepthFunc(GL_LESS);
    this->DrawSides(frame, place, selection, selection.ZPass, shader, setCounter(true));
  }
  if (!selection.ZFail.empty())
  {
    // Behind it the other way round, clamped so that no end of the depth range cuts a volume open.
    state->vtkglDepthFunc(GL_GEQUAL);
    glEnable(GL_DEPTH_CLAMP);
    const auto setParameters = setCounter(false);
    this->DrawSides(frame, place, selection, selection.ZFail, shader, setParameters);
    this->DrawCaps(frame, place, shader, setParameters);
    glDisable(GL_DEPTH_CLAMP);
  }
  glFrontFace(GL_CCW);
}

//------------------------------------------------------------------------------
void vtkShadowVolumes::Subtract(
  vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int light, int sample)
{
  const glm::dvec4& place = this->Lights[light].Places[sample];
  const Selection selection = this->Select(frame, light, sample);
  if (selection.ZPass.empty() && selection.ZFail.empty())
  {
    return;
  }
  vtkOpenGLState* state = frame.Window->GetState();
  if (selection.Wide)
  {
    this->Counts.Allocate(
      frame.Window, vtkShadowTexture::Format::Float1, buffer.GetWidth(), buffer.GetHeight(), 1);
    vtkShadowFramebuffer::Scope target(
      frame.Window, buffer.GetFramebuffer(), &this->Counts, &buffer.GetReceiverDepth(), 0);
    CountingState counting(state, true);
    const float none[] = { 0.0f, 0.0f, 0.0f, 0.0f };
    glClearBufferfv(GL_COLOR, 0, none);
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    this->DrawVolumes(frame, place, selection, vtkShadowVolumeCountFS,
      [](bool passing)
      {
        return [passing](vtkShaderProgram* program)
        {
          program->SetUniformf("shadowFront", passing ? 1.0f : -1.0f);
          program->SetUniformf("shadowBack", passing ? -1.0f : 1.0f);
        };
      });
  }
  vtkShadowFramebuffer::Scope target(
    frame.Window, buffer.GetFramebuffer(), &buffer.GetTarget(), &buffer.GetReceiverDepth(), light);
  CountingState counting(state, false);
  if (!selection.Wide)
  {
    const GLint zero = 0;
    glStencilMask(0xFF);
    glClearBufferiv(GL_STENCIL, 0, &zero);
    state->vtkglEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 0, 0xFF);
    this->DrawVolumes(frame, place, selection, nullptr,
      [this](bool passing) -> std::function<void(vtkShaderProgram*)>
      {
        const bool parity = this->Current.Method == Counting::Xor;
        const GLenum enter = parity ? GL_INVERT : (passing ? GL_INCR_WRAP : GL_DECR_WRAP);
        const GLenum leave = parity ? GL_INVERT : (passing ? GL_DECR_WRAP : GL_INCR_WRAP);
        glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, enter);
        glStencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, leave);
        return {};
      });
    glStencilFunc(GL_NOTEQUAL, 0, 0xFF);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  }
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  std::string source = vtkShadowVolumeResolveFS;
  if (selection.Wide)
  {
    vtkShaderProgram::Substitute(
      source, "//VTK::Output::Dec", "#define SHADOW_WIDE\n//VTK::Output::Dec");
    this->Counts.Activate(frame.Window);
  }
  const glm::vec3 weight(this->Lights[light].Samples[sample].Weight);
  frame.Quad->Draw(frame.Window, source,
    [&](vtkShaderProgram* program)
    {
      program->SetUniform3f("shadowWeight", glm::value_ptr(weight));
      if (selection.Wide)
      {
        program->SetUniformi("shadowCounts", this->Counts.GetUnit());
      }
    });
  this->Counts.Deactivate(frame.Window);
  glStencilFunc(GL_ALWAYS, 0, 0xFF);
}

//------------------------------------------------------------------------------
void vtkShadowVolumes::AddFaces(
  vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int light, int sample)
{
  const Selection selection = this->Select(frame, light, sample);
  vtkShadowFramebuffer::Scope target(
    frame.Window, buffer.GetFramebuffer(), &buffer.GetTarget(), nullptr, light);
  vtkOpenGLState* state = frame.Window->GetState();
  CountingState counting(state, true);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  this->DrawVolumes(frame, this->Lights[light].Places[sample], selection, vtkShadowVolumeCountFS,
    [](bool)
    {
      return [](vtkShaderProgram* program)
      {
        program->SetUniformf("shadowFront", 1.0f);
        program->SetUniformf("shadowBack", 1.0f);
      };
    });
}

//------------------------------------------------------------------------------
void vtkShadowVolumes::DrawView(vtkShadowFrame& frame, int light, int sample)
{
  const glm::dvec4& place = this->Lights[light].Places[sample];
  const Selection selection = this->Select(frame, light, sample);
  vtkOpenGLState* state = frame.Window->GetState();
  CountingState drawing(state, true);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);
  this->SetFrontFace(false);
  glEnable(GL_DEPTH_CLAMP);
  const auto setColors = [](const glm::vec4& front, const glm::vec4& back)
  {
    return [front, back](vtkShaderProgram* program)
    {
      program->SetUniform4f("shadowFrontColor", glm::value_ptr(front));
      program->SetUniform4f("shadowBackColor", glm::value_ptr(back));
    };
  };
  for (const auto* parts : { &selection.ZPass, &selection.ZFail })
  {
    this->DrawSides(frame, place, selection, *parts, vtkShadowVolumeViewFS,
      setColors({ 0.2f, 0.4f, 1.0f, 0.2f }, { 1.0f, 0.5f, 0.1f, 0.2f }));
    vtkShadowCasterDraw how;
    how.FragmentShader = vtkShadowVolumeViewFS;
    how.SetParameters = setColors({ 1.0f, 1.0f, 0.2f, 1.0f }, { 1.0f, 1.0f, 0.2f, 1.0f });
    frame.Casters->DrawParts(
      frame.Window, this->WCToClip, GL_LINES, selection.Lines->Lines, *parts, how);
  }
  glDisable(GL_DEPTH_CLAMP);
  glFrontFace(GL_CCW);
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::size_t>> vtkShadowVolumes::GetBytes() const
{
  std::size_t lines = this->Passing.Bytes;
  for (const auto& light : this->Lights)
  {
    for (const auto& batch : light.Batches)
    {
      lines += batch->Bytes;
    }
  }
  return { { "silhouettes", lines }, { "caps", this->CapBytes },
    { "counts", this->Counts.GetBytes() } };
}

//------------------------------------------------------------------------------
void vtkShadowVolumes::Release(vtkOpenGLRenderWindow* window)
{
  for (auto& light : this->Lights)
  {
    for (auto& batch : light.Batches)
    {
      batch->Lines->ReleaseGraphicsResources();
    }
  }
  this->Lights.clear();
  this->Passing.Lines->ReleaseGraphicsResources();
  this->Passing.Bytes = 0;
  this->PassingLight = this->CapLight = -1;
  this->Caps->ReleaseGraphicsResources();
  this->CapBytes = 0;
  this->Counts.Release(window);
  this->Adjacencies.Clear();
}
