// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowInjection.h"

#include "vtkShaderProgram.h"
#include "vtkShadowCatchFS.h"
#include "vtkShadowShaderText.h"
#include "vtkShadowTerminatorFS.h"
#include "vtkShadowTerminatorVS.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <numeric>
#include <set>

namespace
{
using Code = vtkShadowInjection::Code;
using Text = vtkShadowShaderText;

const std::string LightColor = "lightColor";

/** N of lightColorN; -1 of any other name. */
int GetSlot(const std::string& name)
{
  const std::string number = name.substr(std::min(name.size(), LightColor.size()));
  const bool is = name.compare(0, LightColor.size(), LightColor) == 0 && !number.empty() &&
                  number.size() < 4 && number.find_first_not_of("0123456789") == std::string::npos;
  return is ? std::stoi(number) : -1;
}

/** A text's insertions, in the order in which they were asked for where they share a place. */
class Insertions
{
public:
  void Add(std::size_t place, const std::string& text) { this->At[place] += text; }
  void Apply(std::string& source) const
  {
    for (auto at = this->At.rbegin(); at != this->At.rend(); ++at)
    {
      source.insert(at->first, "\n" + at->second);
    }
  }

private:
  std::map<std::size_t, std::string> At;
};

bool HasWord(const std::string& text, const std::string& word)
{
  const auto isWord = [](char c)
  { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (std::size_t at = text.find(word); at != Text::None; at = text.find(word, at + 1))
  {
    const std::size_t end = at + word.size();
    if ((at == 0 || !isWord(text[at - 1])) && (end == text.size() || !isWord(text[end])))
    {
      return true;
    }
  }
  return false;
}

/** Where a mark's line ends, None where it is not. */
std::size_t FindMark(const std::string& source, const std::string& mark)
{
  const std::size_t at = source.find(mark);
  return at == Text::None ? at : at + mark.size();
}
}

//------------------------------------------------------------------------------
bool vtkShadowInjection::Code::operator==(const Code& other) const
{
  return this->Declarations == other.Declarations && this->LightsOfSlot == other.LightsOfSlot &&
         this->Receivers == other.Receivers && this->Shading == other.Shading &&
         this->Unrolled == other.Unrolled && this->Rigid == other.Rigid &&
         this->Smooth == other.Smooth;
}

//------------------------------------------------------------------------------
std::size_t vtkShadowInjection::Code::GetNumberOfLights() const
{
  return std::accumulate(this->LightsOfSlot.begin(), this->LightsOfSlot.end(), std::size_t(0),
    [](std::size_t sum, const std::vector<int>& parts) { return sum + parts.size(); });
}

//------------------------------------------------------------------------------
void vtkShadowInjection::Mark(const Shaders& shaders)
{
  const auto mark = [](std::string& source, const std::string& theirs, const std::string& ours,
                      const std::string& after = "", bool all = false)
  { vtkShaderProgram::Substitute(source, theirs, ours + "\n  " + theirs + after, all); };
  mark(shaders.Fragment, "//VTK::Light::Dec", "//SHADOW::Dec");
  mark(shaders.Fragment, "//VTK::UniformFlow::Impl", "//SHADOW::UniformFlow");
  mark(shaders.Fragment, "//VTK::Light::Impl", "//SHADOW::Impl", "\n  //SHADOW::End");
  mark(shaders.Geometry, "//VTK::Normal::Dec", "//SHADOW::Normal::Dec");
  mark(shaders.Geometry, "//VTK::Normal::Impl", "//SHADOW::Normal::Impl", "", true);
}

namespace
{
/** One shader that is being filled. */
class Filling
{
public:
  Filling(const vtkShadowInjection::Shaders& shaders, const Code& code, bool catches,
    const std::string& later)
    : Target(shaders)
    , Source(shaders.Fragment)
    , Content(code)
    , Catches(catches)
    , Known(this->Source)
    , Later(later)
  {
  }

  /** Insert all that can be; what cannot is told. */
  std::string Fill()
  {
    if (this->Known.GetMainBegin() == Text::None)
    {
      return "its main() cannot be made out";
    }
    this->FindPlaces();
    if (this->IsTaken())
    {
      this->Positioned = this->Lit = false;
    }
    this->AddColors();
    this->AddTerminator();
    this->AddVisibility();
    this->AddReceivers();
    this->AddCatching();
    const std::size_t mark = FindMark(this->Source, "//SHADOW::Dec");
    this->Inserted.Add(
      this->Known.IsGlobal(mark) ? mark : this->Known.GetMainHead(), this->Declarations + "\n");
    this->Inserted.Apply(this->Target.Fragment);
    return this->Problem;
  }

private:
  void FindPlaces()
  {
    // Names that stand for a light's colour: in what is there, and what the user will put there later.
    const auto isLight = [](const std::string& name) { return GetSlot(name) >= 0; };
    const std::set<std::string> names = this->Known.GetNamesFor(isLight);
    const std::size_t use = this->Known.GetFirst(names);
    const auto& later = this->Later.GetNames();
    const bool usedLater = std::any_of(later.begin(), later.end(),
      [&](const std::string& name) { return isLight(name) || names.count(name) != 0; });
    this->Lit = use != Text::None || usedLater;

    std::size_t known = Text::None;
    for (const char* position : { "vertexVC", "vertexVCVSOutput" })
    {
      if (known == Text::None)
      {
        known = this->Known.GetDeclaration("vec4", position);
        this->Position = position;
      }
    }
    const std::size_t mark = FindMark(this->Source, "//SHADOW::Impl");
    this->Marked = this->Known.IsInMain(mark);
    this->Positioned = this->Lit && !this->Content.Declarations.empty() && known != Text::None;
    this->Place = this->Marked ? mark : this->Known.GetPlaceAfter(this->Known.GetMainBegin());
    if (!this->Positioned)
    {
      if (this->Lit && known == Text::None)
      {
        this->Problem = "it has no position, \"vec4 vertexVC\"";
      }
      return;
    }
    this->Flow = FindMark(this->Source, "//SHADOW::UniformFlow");
    this->Flow = this->Known.IsInMain(this->Flow) ? std::max(this->Flow, known) : known;
    // Imposters move the position after its derivatives are taken; their own normal is exact.
    this->Imposter = this->Known.GetLast("gl_FragDepth") != Text::None &&
                     (this->Known.IsAssigned(this->Position, known) ||
                       this->Known.GetNames().count("ZCalcR") != 0);
    std::size_t earliest = this->Flow;
    if (this->Imposter)
    {
      const std::size_t normal = this->Known.GetDeclaration("vec3", "normalVCVSOutput");
      this->Imposter = normal != Text::None;
      earliest = std::max({ earliest, this->Imposter ? normal : 0,
        this->Known.GetPlaceAfter(this->Known.GetLast("gl_FragDepth")) });
    }
    if (this->Marked && mark >= earliest && use > mark && !usedLater)
    {
      return; // as VTK's shaders are
    }
    this->Place = usedLater ? Text::None : this->Known.GetPlaceBefore(use);
    if (this->Place == Text::None || this->Place < earliest)
    {
      this->Place = this->Known.GetPlaceAfter(earliest);
      if (use < this->Place)
      {
        this->Problem = "it uses a light's colour before its position and normal are known";
      }
    }
    this->Marked = this->Marked && mark >= this->Place;
  }

  /** The shader has a name of its own that the code needs, or a macro that would change it. */
  bool IsTaken()
  {
    const std::string locals = " shadowDxVC shadowDyVC shadowPositionVC shadowNormalVC "
                               "shadowFootprint shadowSeen shadowI ";
    for (const Text* text : { &this->Known, &this->Later })
    {
      for (const std::string& name : text->GetNames())
      {
        const bool ours = name.compare(0, 6, "shadow") == 0 || name.compare(0, 7, "SHADOW_") == 0;
        const bool isNumbered = ours && std::isdigit(static_cast<unsigned char>(name.back())) != 0;
        const bool isMacro = text->IsMacro(name) && GetSlot(name) < 0;
        if (isNumbered || ((ours || isMacro) &&
                            (HasWord(this->Content.Declarations, name) || HasWord(locals, name) ||
                              (this->Catches && HasWord(vtkShadowCatchFS, name)))))
        {
          this->Problem = "its name \"" + name + "\" is one that the shadows need";
          return true;
        }
      }
    }
    return false;
  }

  ///@{ A shader's position and normal in VC.
  std::string GetPosition(const std::string& position) const
  {
    return this->Content.Rigid ? position + ".xyz" : "(shadowVTKToVC * " + position + ".xyz)";
  }
  std::string GetPosition() const { return this->GetPosition(this->Position); }
  std::string GetNormal() const
  {
    return this->Content.Rigid ? "normalVCVSOutput" : "normalize(" + this->GetTangent() + ")";
  }
  std::string GetTangent() const
  {
    return this->Content.Rigid ? "normalVCVSOutput" : "(normalVCVSOutput * inverse(shadowVTKToVC))";
  }
  ///@}

  bool HasShadow(std::size_t slot) const
  {
    return this->Positioned && this->Content.Shading && slot < this->Content.LightsOfSlot.size() &&
           !this->Content.LightsOfSlot[slot].empty();
  }

  /**
   * A variable takes a light's place from its declaration on: in functions, macros and whatever the
   * user replaces after us, all of which stay as they are written.
   */
  void AddColors()
  {
    for (const std::string& name : this->Known.GetNames())
    {
      const int slot = GetSlot(name);
      if (!this->Lit || slot < 0 || !(this->Catches || this->HasShadow(slot)))
      {
        continue;
      }
      const std::size_t place = this->Known.GetUniform("vec3", name);
      if (place == Text::None || this->Known.IsMacro(name) || this->Later.IsMacro(name))
      {
        this->Problem = "\"" + name + "\" is not the uniform that VTK declares";
        continue;
      }
      const std::string number = std::to_string(slot);
      const std::string color = "shadowColor" + number;
      this->Inserted.Add(
        place, "vec3 " + color + " = " + name + ";\n#define " + name + " " + color + "\n");
      const std::string factor = this->HasShadow(slot) ? "shadowFactor" + number : "1.0";
      this->Colors += "  " + color +
                      (this->Catches ? " = shadowBrightness(" + color + ", vec3(" + factor + "));\n"
                                     : " *= " + factor + ";\n");
    }
  }

  std::string GetTransformation() const
  {
    return this->Content.Rigid ? "" : "uniform mat3 shadowVTKToVC; // where VTK's is not rigid\n";
  }

  /** The user has a macro that would change this code, or a name like ours that it declares. */
  bool HasNameOf(const std::string& code) const
  {
    for (const Text* text : { &this->Known, &this->Later })
    {
      for (const std::string& name : text->GetNames())
      {
        const bool meant = text->IsMacro(name) || name.compare(0, 6, "shadow") == 0;
        if (meant && HasWord(code, name))
        {
          return true;
        }
      }
    }
    return false;
  }

  /** The tangent planes of corners, where VTK interpolates normals between them. */
  void AddTerminator()
  {
    const Text vertex(this->Target.Vertex);
    const std::string tangent = "shadowTangent";
    const std::size_t end = vertex.GetMainEnd();
    const bool hasGeometry = !this->Target.Geometry.empty();
    // As a shader's input or output, before main.
    const auto has = [](const Text& text, const char* type, const char* name)
    {
      const std::size_t begin = text.GetMainBegin();
      return begin != Text::None &&
             text.GetDeclaration(type, name, text.GetPlaceAfter(begin)) != Text::None;
    };
    this->Smooth =
      this->Content.Smooth && this->Positioned && !this->Imposter &&
      has(this->Known, "vec3", "normalVCVSOutput") && has(vertex, "vec3", "normalVCVSOutput") &&
      has(vertex, "vec4", "vertexVCVSOutput") &&
      (!hasGeometry || (this->Target.Geometry.find("//SHADOW::Normal::Dec") != Text::None &&
                         this->Target.Geometry.find("//SHADOW::Normal::Impl") != Text::None)) &&
      !this->HasNameOf(std::string(vtkShadowTerminatorFS) + " shadowGetTangent ");
    if (!this->Smooth)
    {
      return;
    }
    Insertions inserted;
    inserted.Add(vertex.GetMainHead(), this->GetTransformation() + vtkShadowTerminatorVS + "\n");
    inserted.Add(end, "  " + tangent +
                        "VSOutput = vec2(dot(vertexVCVSOutput.xyz, normalVCVSOutput), length(" +
                        this->GetTangent() + "));\n");
    inserted.Apply(this->Target.Vertex);
    // VTK renames the fragment shader's input where there is a geometry shader.
    vtkShaderProgram::Substitute(this->Target.Geometry, "//SHADOW::Normal::Dec",
      "in vec2 " + tangent + "VSOutput[];\nout vec2 " + tangent + "GSOutput;");
    vtkShaderProgram::Substitute(this->Target.Geometry, "//SHADOW::Normal::Impl",
      tangent + "GSOutput = " + tangent + "VSOutput[i];");
  }

  void AddVisibility()
  {
    if (!this->Positioned)
    {
      this->Inserted.Add(this->Place, this->Colors);
      return;
    }
    this->Declarations = this->Content.Declarations + this->GetTransformation() +
                         (this->Smooth ? vtkShadowTerminatorFS : "");
    if (this->Smooth)
    {
      // Here the name is still that of the shader's input: main has its own.
      this->Inserted.Add(this->Known.GetMainHead(),
        "vec3 shadowGetTangent() { return " + this->GetTangent() + "; }\n");
    }
    this->Inserted.Add(this->Flow, "  vec3 shadowDxVC = dFdx(" + this->GetPosition() +
                                     ");\n  vec3 shadowDyVC = dFdy(" + this->GetPosition() +
                                     ");\n");
    std::string body =
      this->Imposter ? "  vec3 shadowNormalVC = " + this->GetNormal() + ";\n"
                     : "  vec3 shadowNormalVC = shadowGeometricNormal(shadowDxVC, shadowDyVC);\n";
    body += "  vec3 shadowPositionVC = " + this->GetPosition() + ";\n";
    body +=
      this->Smooth ? "  shadowSmooth(shadowGetTangent(), shadowPositionVC, shadowNormalVC);\n" : "";
    if (this->Content.Shading)
    {
      body += "  float shadowFootprint = 4.0 * (length(shadowDxVC) + length(shadowDyVC));\n";
      body += "  SHADOW_VISIBILITY shadowSeen[SHADOW_LIGHTS];\n";
      const auto call = [](const std::string& light)
      {
        return "  shadowSeen[" + light + "] = shadowSee(" + light +
               ", shadowPositionVC, shadowNormalVC, shadowFootprint);\n";
      };
      if (this->Content.Unrolled)
      {
        for (std::size_t light = 0; light < this->Content.GetNumberOfLights(); ++light)
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
    for (std::size_t slot = 0; slot < this->Content.LightsOfSlot.size(); ++slot)
    {
      if (this->HasShadow(slot))
      {
        const std::string factor = "shadowFactor" + std::to_string(slot);
        body += "  SHADOW_VISIBILITY " + factor + " = SHADOW_VISIBILITY(1.0);\n";
        for (const int light : this->Content.LightsOfSlot[slot])
        {
          const std::string index = "[" + std::to_string(light) + "]";
          body += "  " + factor + " = shadowAddPart(" + factor + ", shadowAttenuation" + index +
                  ", shadowSeen" + index + ");\n";
        }
      }
    }
    this->Inserted.Add(this->Place, body + this->Colors);
  }

  void AddReceivers()
  {
    if (!this->Content.Receivers)
    {
      return;
    }
    if (!this->Positioned)
    {
      // Unlit: it hides what lies behind it, and receives nothing.
      this->Declarations = this->Content.Shading ? "uniform bool shadowWritesReceivers;"
                                                 : "const bool shadowWritesReceivers = true;";
    }
    // After all that discards. What comes before may return, where VTK's lighting is gone.
    const bool returns = this->Known.GetLast("return") != Text::None;
    const std::size_t place = this->Marked ? FindMark(this->Source, "//SHADOW::Impl")
                              : returns    ? this->Place
                                           : this->Known.GetMainEnd();
    const bool hasNormal =
      this->Known.GetDeclaration("vec3", "normalVCVSOutput", place) != Text::None;
    const std::string normal = hasNormal ? this->GetNormal() : "vec3(0.0, 0.0, 1.0)";
    this->Inserted.Add(
      place, "  if (shadowWritesReceivers)\n"
             "  {\n"
             "    gl_FragData[0] = " +
               (this->Positioned ? "vec4(shadowPositionVC, !shadowReceives ? 0.0 :\n"
                                   "      (shadowCasts ? 1.0 : -1.0) * "
                                   "shadowPackReceiver(shadowNormalVC == vec3(0.0) ? " +
                                     normal + " : shadowNormalVC, " +
                                     (this->Imposter ? "false" : "!gl_FrontFacing") + "))"
                                 : "vec4(0.0)") +
               ";\n"
               "    return;\n"
               "  }\n");
  }

  void AddCatching()
  {
    if (!this->Catches)
    {
      return;
    }
    this->Declarations += vtkShadowCatchFS;
    const std::size_t place = this->Marked ? FindMark(this->Source, "//SHADOW::Impl") : this->Place;
    for (const char* color : { "ambientColor", "diffuseColor", "specularColor" })
    {
      if (this->Known.GetDeclaration("vec3", color, place) != Text::None)
      {
        this->Inserted.Add(
          place, std::string("  ") + color +
                   (color == std::string("diffuseColor") ? " = vec3(1.0);\n" : " = vec3(0.0);\n"));
      }
    }
    const std::size_t end = FindMark(this->Source, "//SHADOW::End");
    this->Inserted.Add(this->Known.IsInMain(end) ? end : this->Known.GetMainEnd(),
      this->Lit ? "  gl_FragData[0] = shadowCatch(gl_FragData[0]);\n"
                : "  gl_FragData[0] = vec4(0.0);\n");
  }

  const vtkShadowInjection::Shaders& Target;
  const std::string Source; // the fragment shader as it was
  const Code& Content;
  const bool Catches;
  const Text Known; // what the source holds
  const Text Later; // what the user's replacements put there afterwards
  Insertions Inserted;
  std::string Declarations;
  std::string Colors; // what multiplies them
  std::string Problem;
  std::string Position;
  bool Lit = false;        // main uses a light's colour
  bool Positioned = false; // and all that visibility needs is there
  bool Imposter = false;
  bool Smooth = false; // its normals come from corners
  bool Marked = false; // VTK's lighting comes where it should
  std::size_t Flow = Text::None;
  std::size_t Place = Text::None;
};
}

//------------------------------------------------------------------------------
std::string vtkShadowInjection::Fill(
  const Shaders& shaders, const Code& code, bool catches, const std::string& later)
{
  if (code.Declarations.empty() && !catches)
  {
    return "";
  }
  return Filling(shaders, code, catches, later).Fill();
}

//------------------------------------------------------------------------------
bool vtkShadowInjection::CanFill(const std::string& source)
{
  return source.find("//VTK::Output::Dec") != std::string::npos &&
         Text(source).GetMainBegin() != Text::None;
}
