#include "vtkShadowInjection.h"

#include "vtkShaderProgram.h"
#include "vtkShadowCatchFS.h"
#include "vtkShadowEvaluateFS.h"
#include "vtkShadowLightsFS.h"

#include <cctype>
#include <functional>
#include <numeric>

namespace
{
bool IsWord(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/**
 * Replace every lightColorN outside its declaration by what a function makes of N. True if there is
 * any.
 */
bool ReplaceLightColors(
  std::string& source, const std::function<std::string(std::size_t)>& getReplacement)
{
  static const std::string token = "lightColor";
  static const std::string declaration = "uniform vec3 ";
  bool lit = false;
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
    const bool declared = at >= declaration.size() && source.compare(at - declaration.size(),
                                                        declaration.size(), declaration) == 0;
    const bool whole = !number.empty() && (at == 0 || !IsWord(source[at - 1])) &&
                       (end == source.size() || !IsWord(source[end]));
    result += source.substr(from, at - from);
    lit = lit || (whole && !declared);
    result += whole && !declared ? getReplacement(std::stoul(number)) : token + number;
    from = end;
  }
  source = result + source.substr(from);
  return lit;
}
}

//------------------------------------------------------------------------------
bool vtkShadowInjection::Code::operator==(const Code& other) const
{
  return this->Declarations == other.Declarations && this->LightsOfSlot == other.LightsOfSlot &&
         this->Receivers == other.Receivers && this->Shading == other.Shading &&
         this->Unrolled == other.Unrolled;
}

//------------------------------------------------------------------------------
std::size_t vtkShadowInjection::Code::GetNumberOfLights() const
{
  return std::accumulate(this->LightsOfSlot.begin(), this->LightsOfSlot.end(), std::size_t(0),
    [](std::size_t sum, const std::vector<int>& parts) { return sum + parts.size(); });
}

//------------------------------------------------------------------------------
void vtkShadowInjection::Mark(std::string& source)
{
  vtkShaderProgram::Substitute(
    source, "//VTK::Light::Dec", "//SHADOW::Dec\n//VTK::Light::Dec", false);
  vtkShaderProgram::Substitute(
    source, "//VTK::UniformFlow::Impl", "//SHADOW::UniformFlow\n  //VTK::UniformFlow::Impl", false);
  vtkShaderProgram::Substitute(
    source, "//VTK::Light::Impl", "//SHADOW::Impl\n  //VTK::Light::Impl\n  //SHADOW::End", false);
}

//------------------------------------------------------------------------------
void vtkShadowInjection::Fill(std::string& source, const Code& code, bool catches)
{
  if (code.Declarations.empty() && !catches)
  {
    return;
  }
  const bool positioned = source.find("vec4 vertexVC =") != std::string::npos;
  const auto hasShadow = [&](std::size_t slot)
  {
    return positioned && code.Shading && slot < code.LightsOfSlot.size() &&
           !code.LightsOfSlot[slot].empty();
  };
  const bool lit = ReplaceLightColors(source,
    [&](std::size_t slot)
    {
      const std::string number = std::to_string(slot);
      const std::string color = "lightColor" + number;
      const std::string factor = "shadowFactor" + number;
      if (catches)
      {
        return "shadowBrightness(" + color + ", vec3(" + (hasShadow(slot) ? factor : "1.0") + "))";
      }
      return hasShadow(slot) ? "(" + color + " * " + factor + ")" : color;
    });
  std::string declarations;
  std::string body;
  if (positioned && lit && !code.Declarations.empty())
  {
    declarations = code.Declarations;
    vtkShaderProgram::Substitute(source, "//SHADOW::UniformFlow",
      "vec3 shadowDxVC = dFdx(vertexVC.xyz);\n  vec3 shadowDyVC = dFdy(vertexVC.xyz);");
    // Imposters move the position after its derivatives are taken; their own normal is exact.
    const bool imposter = source.find("gl_FragDepth =") != std::string::npos;
    body = imposter ? "vec3 shadowNormalVC = normalVCVSOutput;\n"
                    : "vec3 shadowNormalVC = shadowGeometricNormal(shadowDxVC, shadowDyVC);\n";
    if (code.Receivers)
    {
      body += "  if (shadowWritesReceivers)\n"
              "  {\n"
              "    gl_FragData[0] = vec4(vertexVC.xyz, !shadowReceives ? 0.0 :\n"
              "      (shadowCasts ? 1.0 : -1.0) * shadowPackNormal("
              "shadowNormalVC == vec3(0.0) ? normalVCVSOutput : shadowNormalVC));\n"
              "    return;\n"
              "  }\n";
    }
    if (code.Shading)
    {
      body += "  float shadowFootprint = 4.0 * (length(shadowDxVC) + length(shadowDyVC));\n";
      body += "  SHADOW_VISIBILITY shadowFactors[SHADOW_LIGHTS];\n";
      const auto call = [](const std::string& light)
      {
        return "  shadowFactors[" + light + "] = shadowFactor(" + light +
               ", vertexVC.xyz, shadowNormalVC, shadowFootprint);\n";
      };
      if (code.Unrolled)
      {
        for (std::size_t light = 0; light < code.GetNumberOfLights(); ++light)
        {
          body += call(std::to_string(light));
        }
      }
      else
      {
        body += "  for (int shadowI = 0; shadowI < shadowLightCount; ++shadowI)\n  {\n  " +
                call("shadowI") + "  }\n";
      }
    }
    for (std::size_t slot = 0; slot < code.LightsOfSlot.size(); ++slot)
    {
      if (hasShadow(slot))
      {
        // Of its parts: 1 minus what each takes.
        std::string factor;
        for (const int light : code.LightsOfSlot[slot])
        {
          factor +=
            (factor.empty() ? "" : " - 1.0 + ") + ("shadowFactors[" + std::to_string(light)) + "]";
        }
        body += "  SHADOW_VISIBILITY shadowFactor" + std::to_string(slot) + " = " + factor + ";\n";
      }
    }
  }
  else if (code.Receivers)
  {
    // Unlit: it hides what lies behind it, and receives nothing.
    declarations = code.Shading ? "uniform bool shadowWritesReceivers;"
                                : "const bool shadowWritesReceivers = true;";
    body = "if (shadowWritesReceivers) { gl_FragData[0] = vec4(0.0); return; }\n";
  }
  if (catches)
  {
    declarations += vtkShadowCatchFS;
    body += "  ambientColor = vec3(0.0); diffuseColor = vec3(1.0); specularColor = vec3(0.0);\n";
    vtkShaderProgram::Substitute(source, "//SHADOW::End",
      lit ? "gl_FragData[0] = shadowCatch(gl_FragData[0]);" : "gl_FragData[0] = vec4(0.0);");
  }
  vtkShaderProgram::Substitute(source, "//SHADOW::Dec", declarations);
  vtkShaderProgram::Substitute(source, "//SHADOW::Impl", body);
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
