// The pass's part in the shaders of VTK's mappers: what is injected, and its uniforms.

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDataSet.h"
#include "vtkMapper.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLShaderProperty.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkShaderProgram.h"
#include "vtkShadowInjectFS.h"
#include "vtkShadowInjection.h"
#include "vtkShadowLightsFS.h"
#include "vtkShadowPassInternals.h"
#include "vtkShadowReceiversFS.h"
#include "vtkShadowVTKVersion.h"

#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat2x2.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <sstream>

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
std::string vtkShadowPass::Internals::GetPreamble() const
{
  std::string text = "#define SHADOW_LIGHTS " +
                     std::to_string(std::max<std::size_t>(1, this->Frame.Lights.size())) +
                     "\n#define SHADOW_VISIBILITY " + (this->Frame.Color ? "vec3" : "float") + "\n";
  return this->Frame.Hard ? text + "#define SHADOW_HARD\n" : text;
}

//------------------------------------------------------------------------------
void vtkShadowPass::Internals::SetLights(vtkShaderProgram* program)
{
  float place[MaximumLights][4] = {};
  float u[MaximumLights][4] = {};
  float v[MaximumLights][4] = {};
  const glm::dmat4 worldToVC = this->Frame.GetWorldToVC();
  const auto set = [&worldToVC](float* target, const glm::dvec3& vector, double isPoint, double w)
  {
    const glm::dvec4 vectorVC = worldToVC * glm::dvec4(vector, isPoint);
    for (int c = 0; c < 3; ++c)
    {
      target[c] = static_cast<float>(vectorVC[c]);
    }
    target[3] = static_cast<float>(w);
  };
  const int count = static_cast<int>(this->Frame.Lights.size());
  for (int i = 0; i < count; ++i)
  {
    const vtkShadowLight& light = this->Frame.Lights[i];
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

//------------------------------------------------------------------------------
void vtkShadowPass::Internals::SetToPixel(
  vtkShaderProgram* program, const std::array<int, 4>& viewport)
{
  glm::vec4 scaleAndOffset(1.0, 1.0, -viewport[0], -viewport[1]);
  auto* camera = vtkOpenGLCamera::SafeDownCast(this->Renderer->GetActiveCamera());
  if (camera && (viewport[2] != this->Size[0] || viewport[3] != this->Size[1]))
  {
    vtkMatrix4x4 *wcvc, *vcdc, *wcdc;
    vtkMatrix3x3* normals;
    camera->GetKeyMatrices(this->Renderer, wcvc, normals, vcdc, wcdc);
    const glm::dmat4 drawn =
      glm::make_mat4(vcdc->GetData()) * glm::dmat4(glm::inverse(this->Frame.VTKToVC));
    const glm::dvec4 w = glm::row(drawn, 3);
    for (int axis = 0; axis < 2; ++axis)
    {
      // The views differ in their angle alone: a row of the one is scale * (its row in the other) +
      // offset * w. Solved for both, by least squares of what is equal.
      const glm::dvec4 from = glm::row(drawn, axis);
      const glm::dvec4 to = glm::row(this->Frame.VCToClip, axis);
      const glm::dmat2 products(
        glm::dot(from, from), glm::dot(from, w), glm::dot(from, w), glm::dot(w, w));
      const glm::dvec2 fit =
        glm::inverse(products) * glm::dvec2(glm::dot(to, from), glm::dot(to, w));
      const double size = 0.5 * this->Size[axis];
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
double vtkShadowPass::Internals::GetRounding(vtkAbstractMapper* mapper, vtkProp* prop) const
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
  const vtkShadowFrame& frame = this->Frame;
  double rounding =
    frame.IsParallel() ? 0.5 * this->Size[1] * glm::length(frame.GetPixelVC(1)) / 524288.0 : 0.0;
  if (bounds && bounds[0] <= bounds[1])
  {
    auto* glMapper = vtkOpenGLPolyDataMapper::SafeDownCast(mapper);
    vtkOpenGLVertexBufferObject* points =
      glMapper && !glyphs ? glMapper->GetVBOs()->GetVBO("vertexMC") : nullptr;
    const bool shifted = points && points->GetCoordShiftAndScaleEnabled();
    // VTK's view coordinates, before they are made rigid.
    const glm::dmat4 modelToVC = glm::dmat4(glm::inverse(frame.VTKToVC)) * frame.GetWorldToVC() *
                                 glm::transpose(glm::make_mat4(actor->GetMatrix()->GetData()));
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
std::string vtkShadowPass::GetLightsGLSL()
{
  return this->Internal->GetPreamble() + vtkShadowLightsFS + vtkShadowReceiversFS;
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetLightParameters(vtkShaderProgram* program)
{
  this->Internal->SetLights(program);
}

//------------------------------------------------------------------------------
bool vtkShadowPass::PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
  std::string& fragmentShader, vtkAbstractMapper*, vtkProp* prop)
{
  if (vtkActor::SafeDownCast(prop))
  {
    vtkShadowInjection::Mark({ vertexShader, geometryShader, fragmentShader });
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowPass::PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
  std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!actor)
  {
    return true;
  }
  vtkShadowInjection::Code code = this->Internal->Injected;
  if (code.Smooth && IsFlat(mapper))
  {
    code.Smooth = false;
    auto& flat = this->Internal->FlatMappers;
    if (std::find(flat.begin(), flat.end(), mapper) == flat.end())
    {
      flat.emplace_back(mapper);
    }
  }
  const std::string problem =
    vtkShadowInjection::Fill({ vertexShader, geometryShader, fragmentShader }, code,
      vtkShadowPass::GetShadowCatcher(prop), GetLaterReplacements(actor));
  if (!problem.empty())
  {
    std::ostringstream text;
    text << "the fragment shader of a " << prop->GetClassName() << " (" << prop
         << ") is drawn without shadows, or without some of them: " << problem << ".";
    this->WarnOnce(text.str());
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowPass::UpdateInjection(bool writesReceivers)
{
  // A shader holds the code in use: none without shadows, and forward only what shades. In screen
  // space both halves serve every frame, and one shader holds them: changing it would make the
  // mappers build their sources anew each time.
  Internals& my = *this->Internal;
  // VTK does not make a shader anew with its data.
  const auto bends = [](vtkAbstractMapper* mapper) { return mapper && !IsFlat(mapper); };
  if (std::any_of(my.FlatMappers.begin(), my.FlatMappers.end(), bends))
  {
    my.FlatMappers.clear();
    my.StageTime.Modified();
  }
  vtkShadowInjection::Code code;
  code.Receivers = writesReceivers || (my.Active && my.ScreenSpace);
  code.Shading = my.Active && (my.ScreenSpace || !writesReceivers);
  code.Rigid = my.Frame.Rigid || !my.Active;
  code.Smooth = my.Active && this->GetText("terminator") == "smooth";
  if (code.Receivers || code.Shading)
  {
    const bool forward = code.Shading && !my.ScreenSpace;
    const std::string visibility = forward ? this->GetVisibilityGLSL() : "";
    code.Declarations = my.GetPreamble() + (code.Receivers ? "#define SHADOW_RECEIVERS\n" : "") +
                        "#define SHADOW_INJECTED\n" +
                        (code.Shading && my.ScreenSpace ? "#define SHADOW_BUFFER\n" : "") +
                        (forward ? "#define SHADOW_FORWARD\n" : "") + vtkShadowLightsFS +
                        visibility + vtkShadowInjectFS;
    for (std::size_t i = 0; i < my.Frame.Lights.size(); ++i)
    {
      code.LightsOfSlot.resize(
        std::max<std::size_t>(code.LightsOfSlot.size(), my.Frame.Lights[i].Slot + 1));
      code.LightsOfSlot[my.Frame.Lights[i].Slot].push_back(static_cast<int>(i));
    }
    // A light that is a constant costs half of one that is a loop's; but of long code a software
    // rasterizer compiles each copy for a second.
    constexpr std::size_t longest = 40000;
    const std::size_t length = forward ? visibility.size() : std::strlen(vtkShadowInjectFS);
    code.Unrolled = length * my.Frame.Lights.size() <= longest;
  }
  my.WritesReceivers = writesReceivers;
  if (!(code == my.Injected))
  {
    my.Injected = std::move(code);
    my.FlatMappers.clear();
    my.StageTime.Modified();
  }
}

//------------------------------------------------------------------------------
vtkMTimeType vtkShadowPass::GetShaderStageMTime()
{
  return this->Internal->StageTime;
}

//------------------------------------------------------------------------------
bool vtkShadowPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  Internals& my = *this->Internal;
  if (my.Injected.Declarations.empty())
  {
    return true;
  }
  const bool receives = vtkShadowPass::GetReceiving(prop);
  std::array<float, Internals::MaximumLights> attenuation{};
  for (std::size_t i = 0; receives && i < my.Frame.Lights.size(); ++i)
  {
    attenuation[i] = static_cast<float>(my.Frame.Lights[i].Attenuation * my.Frame.Lights[i].Share);
  }
  program->SetUniform1fv(
    "shadowAttenuation", std::max(1, static_cast<int>(my.Frame.Lights.size())), attenuation.data());
  program->SetUniformi("shadowLightCount", static_cast<int>(my.Frame.Lights.size()));
  program->SetUniformi("shadowReceives", receives);
  program->SetUniformi("shadowCasts", vtkShadowPass::GetCasting(prop));
  const double rounding = my.GetRounding(mapper, prop);
  program->SetUniformf("shadowRoundingOfProp", static_cast<float>(rounding));
  program->SetUniformf("shadowReceiverScale", static_cast<float>(rounding * rounding));
  if (my.ScreenSpace)
  {
    auto* actor = vtkActor::SafeDownCast(prop);
    const bool glass = my.GlassValid && actor && actor->IsRenderingTranslucentPolygonalGeometry();
    program->SetUniformi("shadowWritesReceivers", my.WritesReceivers);
    program->SetUniformi("shadowTranslucent", prop->HasTranslucentPolygonalGeometry() != 0);
    // Set while receivers are written too, or they would share a unit with the prop's own textures.
    // The receivers themselves cannot be bound then.
    auto& buffer = my.WritesReceivers ? *my.Written : (glass ? my.Glass : my.Buffer);
    auto& receivers = my.WritesReceivers ? buffer.GetTarget() : buffer.GetReceivers();
    program->SetUniformi("shadowReceivers", receivers.GetUnit());
    program->SetUniformi("shadowBuffer", buffer.GetTarget().GetUnit());
  }
  // The rest is the same for all props that are drawn to one place.
  std::array<int, 4> viewport;
  my.Window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport.data());
  if (viewport != my.Viewport)
  {
    my.Viewport = viewport;
    my.UpToDatePrograms.clear();
  }
  if (!my.UpToDatePrograms.insert(program).second)
  {
    return true;
  }
  // VTK sets lights when they or the camera were modified, but this program's may be those of another
  // renderer since.
  if (auto* glRenderer = vtkOpenGLRenderer::SafeDownCast(my.Renderer))
  {
    program->SetUniformGroupUpdateTime(vtkShaderProgram::LightingGroup, 0);
    glRenderer->UpdateLightingUniforms(program);
  }
  if (!my.Injected.Rigid)
  {
    glm::mat3 VTKToVC(my.Frame.VTKToVC);
    program->SetUniformMatrix3x3("shadowVTKToVC", glm::value_ptr(VTKToVC));
  }
  if (my.Injected.Smooth)
  {
    const glm::vec4 eye(my.Frame.GetEyeVC());
    program->SetUniform4f("shadowEyeVC", glm::value_ptr(eye));
  }
  vtkCamera* camera = my.Renderer->GetActiveCamera();
  // Anything of the magnitude of a pixel at the focal point does.
  const double height =
    camera->GetParallelProjection() ? camera->GetParallelScale() : camera->GetDistance();
  // The usual projection has a negative determinant.
  const bool mirrors = glm::determinant(my.Frame.VCToClip) > 0.0;
  program->SetUniformf("shadowUnit", static_cast<float>((mirrors ? -500.0 : 500.0) / height));
  my.SetLights(program);
  my.SetToPixel(program, viewport);
  if (!my.ScreenSpace && !my.WritesReceivers)
  {
    this->SetVisibilityParameters(program);
  }
  return true;
}
