// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowInjector.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDataSet.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMapper.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLShaderProperty.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkShaderProgram.h"
#include "vtkShadowFrame.h"
#include "vtkShadowInjectFS.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowScreen.h"
#include "vtkShadowTags.h"
#include "vtkShadowTechnique.h"

#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat2x2.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

vtkStandardNewMacro(vtkShadowCatcherMark);

namespace
{
/** What the user's replacements put into a fragment shader after the mapper's own. */
std::string GetLaterReplacements(vtkActor* actor)
{
  std::string later;
  if (auto* property = vtkOpenGLShaderProperty::SafeDownCast(actor->GetShaderProperty()))
  {
    for (const auto& replacement : property->GetAllShaderReplacements())
    {
      if (replacement.first.ShaderType == vtkShader::Fragment && !replacement.first.ReplaceFirst)
      {
        later += replacement.second.Replacement + "\n";
      }
    }
  }
  return later;
}

/** Flat along an axis: its normals stand for nothing but itself. */
bool IsFlat(vtkAbstractMapper* mapper)
{
  auto* data = mapper && mapper->GetNumberOfInputConnections(0) > 0
                 ? vtkDataSet::SafeDownCast(mapper->GetInputDataObject(0, 0))
                 : nullptr;
  if (!data)
  {
    return false;
  }
  const double* bounds = data->GetBounds();
  const glm::dvec3 size(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  return std::min({ size.x, size.y, size.z }) <= 1e-6 * std::max({ size.x, size.y, size.z });
}

/** Of a prop's rounding: the square of it, times two, is still a normal float. */
constexpr int LeastExponent = -62;
}

//------------------------------------------------------------------------------
vtkShadowInjector::Marks::Marks(vtkShadowInjector& injector, vtkOpenGLRenderPass* pass,
  const std::vector<vtkSmartPointer<vtkProp>>& props)
  : Injector(injector)
  , Pass(pass)
{
  // Not vtkOpenGLRenderPass::PreRender: actors within assemblies need the key too, but a
  // vtkAssembly lends its own keys to its parts, and a pass that stands there twice injects twice.
  injector.UpToDatePrograms.clear();
  for (vtkProp* prop : props)
  {
    this->Add(prop);
    vtkShadowTags::ForEachPart(prop, [this](vtkProp* part, vtkMatrix4x4*) { this->Add(part); });
  }
}

//------------------------------------------------------------------------------
void vtkShadowInjector::Marks::Add(vtkProp* prop)
{
  if (!prop->GetPropertyKeys())
  {
    vtkNew<vtkInformation> keys;
    prop->SetPropertyKeys(keys);
  }
  vtkInformation* keys = prop->GetPropertyKeys();
  for (int i = 0; i < keys->Length(vtkOpenGLRenderPass::RenderPasses()); ++i)
  {
    if (keys->Get(vtkOpenGLRenderPass::RenderPasses(), i) == this->Pass)
    {
      return;
    }
  }
  keys->Append(vtkOpenGLRenderPass::RenderPasses(), this->Pass);
  if (vtkShadowTags::GetShadowCatcher(prop))
  {
    keys->Append(vtkOpenGLRenderPass::RenderPasses(), this->Injector.CatcherMark);
  }
  this->Keys.emplace_back(keys);
}

//------------------------------------------------------------------------------
vtkShadowInjector::Marks::~Marks()
{
  this->Injector.UpToDatePrograms.clear();
  for (vtkInformation* keys : this->Keys)
  {
    keys->Remove(vtkOpenGLRenderPass::RenderPasses(), this->Pass);
    keys->Remove(vtkOpenGLRenderPass::RenderPasses(), this->Injector.CatcherMark);
    if (keys->Length(vtkOpenGLRenderPass::RenderPasses()) == 0)
    {
      keys->Remove(vtkOpenGLRenderPass::RenderPasses());
    }
  }
}

//------------------------------------------------------------------------------
void vtkShadowInjector::SetToPixel(
  vtkShaderProgram* program, const std::array<int, 4>& viewport) const
{
  glm::vec4 scaleAndOffset(1.0, 1.0, -viewport[0], -viewport[1]);
  auto* camera = vtkOpenGLCamera::SafeDownCast(this->Frame->Renderer->GetActiveCamera());
  if (camera && (viewport[2] != this->Frame->Size[0] || viewport[3] != this->Frame->Size[1]))
  {
    vtkMatrix4x4 *wcvc, *vcdc, *wcdc;
    vtkMatrix3x3* normals;
    camera->GetKeyMatrices(this->Frame->Renderer, wcvc, normals, vcdc, wcdc);
    const glm::dmat4 drawn =
      glm::make_mat4(vcdc->GetData()) * glm::dmat4(glm::inverse(this->Frame->VTKToVC));
    const glm::dvec4 w = glm::row(drawn, 3);
    for (int axis = 0; axis < 2; ++axis)
    {
      // The views differ in their angle alone: a row of the one is scale * (its row in the other) +
      // offset * w. Solved for both, by least squares of what is equal.
      const glm::dvec4 from = glm::row(drawn, axis);
      const glm::dvec4 to = glm::row(this->Frame->VCToClip, axis);
      const glm::dmat2 products(
        glm::dot(from, from), glm::dot(from, w), glm::dot(from, w), glm::dot(w, w));
      const glm::dvec2 fit =
        glm::inverse(products) * glm::dvec2(glm::dot(to, from), glm::dot(to, w));
      const double size = 0.5 * this->Frame->Size[axis];
      const double scale = size * fit.x * 2.0 / viewport[2 + axis];
      scaleAndOffset[axis] = static_cast<float>(scale);
      scaleAndOffset[2 + axis] =
        static_cast<float>(size * (1.0 + fit.y - fit.x) - scale * viewport[axis]);
    }
  }
  program->SetUniform4f("shadowToPixel", glm::value_ptr(scaleAndOffset));
}

//------------------------------------------------------------------------------
// VTK multiplies points by a matrix from model to view coordinates, all rounded to 24 bits. Where data
// lie far from their origin, or that from the eye, the terms cancel, and what they are rounded by
// stays: 2^-21 of their sum holds six roundings of 2^-24 and some more. Very far data are shifted to
// their middle first, and nothing cancels.
double vtkShadowInjector::GetRounding(vtkAbstractMapper* mapper, vtkProp* prop) const
{
  auto* actor = vtkActor::SafeDownCast(prop);
  vtkMapper* whole = actor ? actor->GetMapper() : nullptr;
  const bool glyphs = whole && whole->IsA("vtkGlyph3DMapper");
  const double* bounds = nullptr;
  if (whole && whole->GetNumberOfInputConnections(0) > 0)
  {
    // A data set's own are kept while it is unchanged; a mapper's are found anew.
    auto* data = glyphs ? nullptr : vtkDataSet::SafeDownCast(whole->GetInputDataObject(0, 0));
    bounds = data ? data->GetBounds() : whole->GetBounds();
  }
  const vtkShadowFrame& frame = *this->Frame;
  double rounding = frame.IsParallel() ? 0.5 * frame.Size[1] * glm::length(frame.GetPixelVC(1)) *
                                           vtkShadowView::PositionRounding
                                       : 0.0;
  if (bounds && bounds[0] <= bounds[1])
  {
    auto* glMapper = vtkOpenGLPolyDataMapper::SafeDownCast(mapper);
    vtkOpenGLVertexBufferObject* points =
      glMapper && !glyphs ? glMapper->GetVBOs()->GetVBO("vertexMC") : nullptr;
    const bool shifted = points && points->GetCoordShiftAndScaleEnabled();
    // VTK's view coordinates, before they are made rigid.
    const glm::dmat4 modelToVC =
      this->WorldToVTK * glm::transpose(glm::make_mat4(actor->GetMatrix()->GetData()));
    const glm::dvec3 low(bounds[0], bounds[2], bounds[4]);
    const glm::dvec3 high(bounds[1], bounds[3], bounds[5]);
    const glm::dvec3 middle = 0.5 * (low + high);
    const glm::dvec3 half = 0.5 * (high - low);
    const glm::dvec3 largest = shifted ? half : glm::abs(middle) + half;
    glm::dvec3 sum =
      glm::abs(glm::dvec3(modelToVC * glm::dvec4(shifted ? middle : glm::dvec3(0.0), 1.0)));
    for (int axis = 0; axis < 3; ++axis)
    {
      sum += glm::abs(glm::dvec3(modelToVC[axis])) * largest[axis];
    }
    const glm::dmat3 axes(modelToVC);
    rounding += std::max({ sum.x, sum.y, sum.z }) / 2097152.0 +
                glm::length(2.0 * (glm::abs(axes[0]) * half.x + glm::abs(axes[1]) * half.y +
                                    glm::abs(axes[2]) * half.z)) /
                  4194304.0;
  }
  if (!frame.Rigid)
  {
    rounding *=
      glm::length(frame.VTKToVC[0]) + glm::length(frame.VTKToVC[1]) + glm::length(frame.VTKToVC[2]);
  }
  // To a power of two, as the receivers' buffer keeps it; what is not finite bounds nothing.
  int exponent = LeastExponent;
  if (rounding > 0.0 && std::isfinite(rounding))
  {
    std::frexp(rounding, &exponent);
  }
  return std::ldexp(1.0, std::clamp(exponent, LeastExponent, -LeastExponent));
}

//------------------------------------------------------------------------------
void vtkShadowInjector::Mark(const vtkShadowInjection::Shaders& shaders, vtkProp* prop)
{
  if (vtkActor::SafeDownCast(prop))
  {
    vtkShadowInjection::Mark(shaders);
  }
}

//------------------------------------------------------------------------------
std::string vtkShadowInjector::Fill(
  const vtkShadowInjection::Shaders& shaders, vtkAbstractMapper* mapper, vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!actor)
  {
    return "";
  }
  vtkShadowInjection::Code code = this->Code;
  if (code.Smooth && IsFlat(mapper))
  {
    code.Smooth = false;
    if (std::find(this->FlatMappers.begin(), this->FlatMappers.end(), mapper) ==
        this->FlatMappers.end())
    {
      this->FlatMappers.emplace_back(mapper);
    }
  }
  return vtkShadowInjection::Fill(
    shaders, code, vtkShadowTags::GetShadowCatcher(prop), GetLaterReplacements(actor));
}

//------------------------------------------------------------------------------
void vtkShadowInjector::Update(const Use& use)
{
  // A shader holds the code in use: none without shadows, and forward only what shades. In screen
  // space both halves serve every frame, and one shader holds them: changing it would make the
  // mappers build their sources anew each time.
  this->Current = use;
  this->Frame = use.Frame;
  this->WorldToVTK = glm::dmat4(glm::inverse(use.Frame->VTKToVC)) * use.Frame->GetWorldToVC();
  // VTK does not make a shader anew with its data.
  const auto bends = [](vtkAbstractMapper* mapper) { return mapper && !IsFlat(mapper); };
  if (std::any_of(this->FlatMappers.begin(), this->FlatMappers.end(), bends))
  {
    this->FlatMappers.clear();
    this->Time.Modified();
  }
  const vtkShadowFrame& frame = *use.Frame;
  const bool active = use.Technique != nullptr;
  vtkShadowInjection::Code code;
  code.Receivers = use.Written || (active && use.ScreenSpace);
  code.Shading = active && (use.ScreenSpace || !use.Written);
  code.Rigid = frame.Rigid || !active;
  code.Smooth = active && use.Smooth;
  if (code.Receivers || code.Shading)
  {
    const bool forward = code.Shading && !use.ScreenSpace;
    const std::string visibility = forward ? use.Technique->GetVisibilityGLSL() : "";
    const std::string definitions =
      std::string(code.Receivers ? "#define SHADOW_RECEIVERS\n" : "") +
      "#define SHADOW_INJECTED\n" +
      (code.Shading && use.ScreenSpace ? "#define SHADOW_BUFFER\n" : "") +
      (forward ? "#define SHADOW_FORWARD\n" : "");
    code.Declarations = frame.GetLightsGLSL(definitions) + visibility + vtkShadowInjectFS;
    for (std::size_t i = 0; i < frame.Parts.size(); ++i)
    {
      const auto slot = static_cast<std::size_t>(frame.Parts[i].Light.Slot);
      code.LightsOfSlot.resize(std::max(code.LightsOfSlot.size(), slot + 1));
      code.LightsOfSlot[slot].push_back(static_cast<int>(i));
    }
    // A light that is a constant costs half of one that is a loop's; but of long code a software
    // rasterizer compiles each copy for a second.
    constexpr std::size_t longest = 40000;
    const std::size_t length = forward ? visibility.size() : std::strlen(vtkShadowInjectFS);
    code.Unrolled = length * frame.Parts.size() <= longest;
  }
  if (!(code == this->Code))
  {
    this->Code = std::move(code);
    this->FlatMappers.clear();
    this->Time.Modified();
  }
}

//------------------------------------------------------------------------------
void vtkShadowInjector::SetParameters(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop)
{
  if (this->Code.Declarations.empty())
  {
    return;
  }
  const vtkShadowFrame& frame = *this->Frame;
  const Use& use = this->Current;
  const bool receives = vtkShadowTags::GetReceiving(prop);
  const int count = static_cast<int>(frame.Parts.size());
  std::array<float, vtkShadowFrame::MostParts> attenuation{};
  for (int i = 0; receives && i < count; ++i)
  {
    attenuation[i] = static_cast<float>(frame.Parts[i].Light.Attenuation * frame.Parts[i].Share);
  }
  program->SetUniform1fv("shadowAttenuation", std::max(1, count), attenuation.data());
  program->SetUniformi("shadowLightCount", count);
  program->SetUniformi("shadowReceives", receives);
  program->SetUniformi("shadowCasts", vtkShadowTags::GetCasting(prop));
  const double rounding = this->GetRounding(mapper, prop);
  program->SetUniformf("shadowRoundingOfProp", static_cast<float>(rounding));
  program->SetUniformf("shadowReceiverScale", static_cast<float>(rounding * rounding));
  if (use.Technique && use.ScreenSpace)
  {
    auto* actor = vtkActor::SafeDownCast(prop);
    const bool translucent =
      use.Translucent && actor && actor->IsRenderingTranslucentPolygonalGeometry();
    program->SetUniformi("shadowWritesReceivers", use.Written != nullptr);
    program->SetUniformi("shadowTranslucent", prop->HasTranslucentPolygonalGeometry() != 0);
    // Set while receivers are written too, or they would share a unit with the prop's own textures.
    // The receivers themselves cannot be bound then.
    auto& screen = use.Written ? *use.Written : (translucent ? *use.Translucent : *use.Opaque);
    auto& visibility = use.Written ? screen.Visibility.GetTarget() : screen.Visibility.GetShown();
    auto& receivers = use.Written ? visibility : screen.Receivers.GetTexture();
    program->SetUniformi("shadowReceivers", receivers.GetUnit());
    program->SetUniformi("shadowBuffer", visibility.GetUnit());
  }
  std::array<int, 4> viewport;
  frame.Window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport.data());
  if (viewport != this->Viewport)
  {
    this->Viewport = viewport;
    this->UpToDatePrograms.clear();
  }
  if (this->UpToDatePrograms.insert(program).second)
  {
    this->SetFrameParameters(program, viewport);
  }
}

//------------------------------------------------------------------------------
void vtkShadowInjector::SetFrameParameters(
  vtkShaderProgram* program, const std::array<int, 4>& viewport)
{
  const vtkShadowFrame& frame = *this->Frame;
  // VTK sets lights when they or the camera were modified, but this program's may be those of another
  // renderer since.
  if (auto* glRenderer = vtkOpenGLRenderer::SafeDownCast(frame.Renderer))
  {
    program->SetUniformGroupUpdateTime(vtkShaderProgram::LightingGroup, 0);
    glRenderer->UpdateLightingUniforms(program);
  }
  if (!this->Code.Rigid)
  {
    glm::mat3 VTKToVC(frame.VTKToVC);
    program->SetUniformMatrix3x3("shadowVTKToVC", glm::value_ptr(VTKToVC));
  }
  if (this->Code.Smooth)
  {
    const glm::vec4 eye(frame.GetEyeVC());
    program->SetUniform4f("shadowEyeVC", glm::value_ptr(eye));
  }
  vtkCamera* camera = frame.Renderer->GetActiveCamera();
  // Anything of the magnitude of a pixel at the focal point does.
  const double height =
    camera->GetParallelProjection() ? camera->GetParallelScale() : camera->GetDistance();
  // The usual projection has a negative determinant.
  const bool mirrors = glm::determinant(frame.VCToClip) > 0.0;
  program->SetUniformf("shadowUnit", static_cast<float>((mirrors ? -500.0 : 500.0) / height));
  frame.SetLights(program);
  this->SetToPixel(program, viewport);
  if (this->Current.Technique && !this->Current.ScreenSpace && !this->Current.Written)
  {
    this->Current.Technique->SetVisibilityParameters(program);
  }
}
