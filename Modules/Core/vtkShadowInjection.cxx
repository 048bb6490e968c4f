#include "vtkShadowInjection.h"

#include "vtkCamera.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkShaderProgram.h"
#include "vtkShadowEvaluateFS.h"
#include "vtkShadowInjectFS.h"
#include "vtkShadowLightsFS.h"
#include "vtkShadowPassInternals.h"
#include "vtk_glew.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <cctype>

namespace
{
bool IsWord(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/** Multiply every lightColorN outside its declaration; the largest N + 1 is the number of lights. */
int MultiplyLightColors(std::string& source)
{
  static const std::string token = "lightColor";
  static const std::string declaration = "uniform vec3 ";
  int lights = 0;
  std::string result;
  std::size_t from = 0;
  for (std::size_t at = source.find(token); at != std::string::npos; at = source.find(token, from))
  {
    std::size_t end = at + token.size();
    while (end < source.size() && std::isdigit(static_cast<unsigned char>(source[end])))
    {
      ++end;
    }
    const std::string number = source.substr(at + token.size(), end - at - token.size());
    const bool declared = at >= declaration.size() &&
      source.compare(at - declaration.size(), declaration.size(), declaration) == 0;
    const bool whole = !number.empty() && (at == 0 || !IsWord(source[at - 1])) &&
      (end == source.size() || !IsWord(source[end]));
    result += source.substr(from, at - from);
    if (whole && !declared)
    {
      result += "(lightColor" + number + " * shadowFactor" + number + ")";
      lights = std::max(lights, std::stoi(number) + 1);
    }
    else
    {
      result += source.substr(at, end - at);
    }
    from = end;
  }
  source = result + source.substr(from);
  return lights;
}
}

//------------------------------------------------------------------------------
void vtkShadowInjection::Mark(std::string& source)
{
  vtkShaderProgram::Substitute(
    source, "//VTK::Light::Dec", "//SHADOW::Dec\n//VTK::Light::Dec", false);
  vtkShaderProgram::Substitute(source, "//VTK::UniformFlow::Impl",
    "//SHADOW::UniformFlow\n  //VTK::UniformFlow::Impl", false);
  vtkShaderProgram::Substitute(
    source, "//VTK::Light::Impl", "//SHADOW::Impl\n  //VTK::Light::Impl", false);
}

//------------------------------------------------------------------------------
void vtkShadowInjection::Fill(std::string& source, const std::string& declarations)
{
  const bool positioned = source.find("vec4 vertexVC =") != std::string::npos;
  const int lights = positioned ? MultiplyLightColors(source) : 0;
  if (lights == 0)
  {
    // Unlit: it hides what lies behind it, and receives nothing.
    vtkShaderProgram::Substitute(source, "//SHADOW::Dec", "uniform int shadowMode;");
    vtkShaderProgram::Substitute(source, "//SHADOW::Impl",
      "if (shadowMode == 2) { gl_FragData[0] = vec4(0.0); return; }");
    return;
  }
  // Imposters move the position after its derivatives are taken; their own normal is exact.
  const bool imposter = source.find("gl_FragDepth =") != std::string::npos;
  std::string code = imposter
    ? "vec3 shadowNormalVC = normalVCVSOutput;\n"
    : "vec3 shadowNormalVC = shadowGeometricNormal("
      "vertexVC.xyz, shadowDxVC, shadowDyVC, normalVCVSOutput);\n";
  code += "  if (shadowMode == 2)\n"
          "  {\n"
          "    gl_FragData[0] = vec4(vertexVC.xyz, !shadowReceives ? 0.0 :\n"
          "      (shadowCasts ? 1.0 : -1.0) * shadowPackNormal(shadowNormalVC));\n"
          "    return;\n"
          "  }\n"
          "  float shadowFootprint = 4.0 * (length(shadowDxVC) + length(shadowDyVC));\n";
  for (int i = 0; i < lights; ++i)
  {
    const std::string n = std::to_string(i);
    code += "  SHADOW_VISIBILITY shadowFactor" + n + " = shadowFactor(" + n +
      ", vertexVC.xyz, shadowNormalVC, shadowFootprint);\n";
  }
  vtkShaderProgram::Substitute(source, "//SHADOW::Dec", declarations);
  vtkShaderProgram::Substitute(source, "//SHADOW::UniformFlow",
    "vec3 shadowDxVC = dFdx(vertexVC.xyz);\n  vec3 shadowDyVC = dFdy(vertexVC.xyz);");
  vtkShaderProgram::Substitute(source, "//SHADOW::Impl", code);
}

//------------------------------------------------------------------------------
std::string vtkShadowInjection::GetDeclarations(
  const std::string& preamble, bool forward, const std::string& visibilityGLSL)
{
  return preamble + (forward ? "#define SHADOW_FORWARD\n" : "#define SHADOW_BUFFER\n") +
    vtkShadowLightsFS + (forward ? visibilityGLSL : "") + vtkShadowInjectFS;
}

//------------------------------------------------------------------------------
std::string vtkShadowInjection::GetEvaluation(
  const std::string& preamble, const std::string& visibilityGLSL)
{
  std::string source = vtkShadowEvaluateFS;
  vtkShaderProgram::Substitute(
    source, "//SHADOW::Declarations", preamble + vtkShadowLightsFS + visibilityGLSL);
  return source;
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::Internals::GetPreamble() const
{
  return "#define SHADOW_MAX_LIGHTS " + std::to_string(MaximumLights) +
    "\n#define SHADOW_MAX_SLOTS " + std::to_string(MaximumSlots) +
    "\n#define SHADOW_VISIBILITY " + (this->Frame.Color ? "vec3" : "float") + "\n";
}

//------------------------------------------------------------------------------
void vtkShadowPass::Internals::SetLights(vtkShaderProgram* program)
{
  float place[MaximumLights][4] = {};
  float u[MaximumLights][4] = {};
  float v[MaximumLights][4] = {};
  const auto set = [](float* target, const glm::dvec3& vector, double w) {
    for (int c = 0; c < 3; ++c)
    {
      target[c] = static_cast<float>(vector[c]);
    }
    target[3] = static_cast<float>(w);
  };
  for (std::size_t i = 0; i < this->Frame.Lights.size(); ++i)
  {
    const vtkShadowLight& light = this->Frame.Lights[i];
    const bool sphere = light.Kind == vtkShadowLight::Shape::Sphere;
    if (light.IsDirectional())
    {
      set(place[i], -light.Direction, 0.0);
    }
    else
    {
      set(place[i], light.Position - this->Casters.GetOrigin(), 1.0);
    }
    set(u[i], light.U, sphere ? glm::length(light.U) : 0.0);
    set(v[i], light.V, light.Kind == vtkShadowLight::Shape::Rectangle ? 1.0 : 0.0);
  }
  program->SetUniform4fv("shadowLightPlaceWC", MaximumLights, place);
  program->SetUniform4fv("shadowLightUWC", MaximumLights, u);
  program->SetUniform4fv("shadowLightVWC", MaximumLights, v);
  const glm::mat4 matrix(this->Frame.VCToWC);
  program->SetUniformMatrix4x4("shadowVCToWC", const_cast<float*>(glm::value_ptr(matrix)));
}

//------------------------------------------------------------------------------
bool vtkShadowPass::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  vtkShadowInjection::Mark(fragmentShader);
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowPass::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  vtkShadowInjection::Fill(fragmentShader, this->Internal->Declarations);
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowPass::UpdateInjection()
{
  // What was injected last stays while no shadows are drawn: the mode switches it off.
  Internals& my = *this->Internal;
  if (!my.Active && !my.Declarations.empty())
  {
    return;
  }
  const bool forward = my.Active && !my.ScreenSpace;
  std::string declarations = vtkShadowInjection::GetDeclarations(
    my.GetPreamble(), forward, forward ? this->GetVisibilityGLSL() : "");
  if (declarations != my.Declarations)
  {
    my.Declarations = std::move(declarations);
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
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  Internals& my = *this->Internal;
  program->SetUniformi("shadowMode", my.Mode);
  if (my.Mode == 0)
  {
    return true;
  }
  program->SetUniformi("shadowReceives", vtkShadowPass::GetReceiving(prop));
  program->SetUniformi("shadowCasts", vtkShadowPass::GetCasting(prop));
  if (my.ScreenSpace)
  {
    program->SetUniformi("shadowTranslucent", prop->HasTranslucentPolygonalGeometry() != 0);
  }
  // The rest is the same for all props of this frame.
  if (!my.UpToDatePrograms.insert(program).second)
  {
    return true;
  }
  std::array<int, Internals::MaximumSlots> lightOfSlot;
  lightOfSlot.fill(-1);
  std::array<float, Internals::MaximumLights> attenuation{};
  for (std::size_t i = 0; i < my.Frame.Lights.size(); ++i)
  {
    lightOfSlot[my.Frame.Lights[i].Slot] = static_cast<int>(i);
    attenuation[i] = static_cast<float>(my.Frame.Lights[i].Attenuation);
  }
  program->SetUniform1iv("shadowLightOfSlot", Internals::MaximumSlots, lightOfSlot.data());
  program->SetUniform1fv("shadowAttenuation", Internals::MaximumLights, attenuation.data());
  program->SetUniformi(
    "shadowParallel", my.Frame.Renderer->GetActiveCamera()->GetParallelProjection());
  my.SetLights(program);
  if (my.Mode == 1 && my.ScreenSpace)
  {
    int viewport[4];
    my.Window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
    program->SetUniform2i("shadowOrigin", viewport);
    program->SetUniformi("shadowReceivers", my.Buffer.GetReceivers().GetUnit());
    program->SetUniformi("shadowBuffer", my.Buffer.GetTarget().GetUnit());
  }
  else if (my.Mode == 1)
  {
    this->SetVisibilityParameters(program);
  }
  return true;
}
