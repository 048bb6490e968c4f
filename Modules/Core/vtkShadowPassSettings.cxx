// The settings of vtkShadowPass: technique, parameters, debug view, statistics.

#include "vtkShadowNumber.h"
#include "vtkShadowPassChain.h"
#include "vtkShadowPassInternals.h"
#include "vtkShadowVTKVersion.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace
{
std::string Join(const std::vector<std::string>& words)
{
  std::string text;
  for (const auto& word : words)
  {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

std::string JoinNames(const std::map<std::string, vtkShadowValue>& values)
{
  std::vector<std::string> names;
  for (const auto& entry : values)
  {
    names.push_back(entry.first);
  }
  return Join(names);
}

/** What a text says as a value of a parameter; nothing if it cannot be one. */
std::optional<vtkShadowValue> Read(const vtkShadowParameter& parameter, const std::string& text)
{
  using Type = vtkShadowParameter::Type;
  if (parameter.ValueType == Type::Boolean)
  {
    if (text == "on" || text == "true" || text == "1")
    {
      return vtkShadowValue{ "on", 1.0 };
    }
    if (text == "off" || text == "false" || text == "0")
    {
      return vtkShadowValue{ "off", 0.0 };
    }
    return std::nullopt;
  }
  if (parameter.ValueType == Type::Choice)
  {
    const auto& choices = parameter.Choices;
    const bool known = std::find(choices.begin(), choices.end(), text) != choices.end();
    return known ? std::optional(vtkShadowValue{ text, 0.0 }) : std::nullopt;
  }
  const auto number = vtkShadowNumber::Parse(text);
  const bool valid = number && *number >= parameter.Minimum && *number <= parameter.Maximum &&
                     (parameter.ValueType != Type::Integer || *number == std::trunc(*number));
  if (!valid)
  {
    return std::nullopt;
  }
  const bool real = parameter.ValueType == Type::Real;
  return vtkShadowValue{ real ? text : vtkShadowNumber::Print(*number), *number };
}

std::string DescribeRange(const vtkShadowParameter& parameter)
{
  using Type = vtkShadowParameter::Type;
  switch (parameter.ValueType)
  {
    case Type::Boolean:
      return "on or off";
    case Type::Choice:
      return "one of: " + Join(parameter.Choices);
    default:
      return (parameter.ValueType == Type::Integer ? "a whole number from " : "a number from ") +
             vtkShadowNumber::Print(parameter.Minimum) + " to " +
             vtkShadowNumber::Print(parameter.Maximum);
  }
}
}

//------------------------------------------------------------------------------
const std::vector<vtkShadowParameter>& vtkShadowPass::GetCommonParameters()
{
  using Type = vtkShadowParameter::Type;
  static const std::vector<vtkShadowParameter> parameters = {
    { "evaluation", Type::Choice, "auto", 0, 0, { "auto", "forward", "screen" }, "",
      "Where visibility is evaluated: in each prop's shader (forward; keeps translucent receivers "
      "and several samples a pixel), or once a pixel into a buffer (screen); auto takes what the "
      "technique measured as the faster",
      {} },
    { "translucent-casters", Type::Choice, "off", 0, 0, { "off", "opaque", "weighted" }, "",
      "Whether translucent props cast: not at all, as if they were opaque, or by their property's "
      "(or "
      "block's) opacity; of several in a row the most opaque counts. Weighted costs one evaluation "
      "more for each opacity that occurs",
      {} },
    { "alpha-threshold", Type::Real, "0.5", 0, 1, {}, "",
      "Where the alpha of a prop's own texture and colours (not its property's opacity) is below "
      "this, it has a hole that light passes; elsewhere it casts. 0: no holes",
      {} },
    { "terminator", Type::Choice, "smooth", 0, 0, { "smooth", "facets" }, "",
      "Whether the shadows on a prop that its normals shade smoothly are those of the smooth "
      "surface that they stand for, or of its facets as they are, which cut the shading where it "
      "is coarse. Facets for measuring",
      {} },
  };
  return parameters;
}

//------------------------------------------------------------------------------
bool vtkShadowPass::SetTechnique(const std::string& name)
{
  const vtkShadowTechnique* technique = vtkShadowTechniqueRegistration::Find(name);
  if (!technique || technique->ClassName != this->GetClassName())
  {
    std::vector<std::string> known;
    for (const auto& entry : vtkShadowTechniqueRegistration::GetAll())
    {
      if (entry.second.ClassName == this->GetClassName())
      {
        known.push_back(entry.first);
      }
    }
    vtkErrorMacro("'" << name << "' is not a technique of " << this->GetClassName()
                      << ". Known: " << Join(known) << ".");
    return false;
  }
  this->Internal->Technique = technique;
  this->Internal->Values.clear();
  for (const auto* list : { &technique->Parameters, &vtkShadowPass::GetCommonParameters() })
  {
    for (const auto& parameter : *list)
    {
      this->Internal->Values[parameter.Name] =
        Read(parameter, parameter.Default).value_or(vtkShadowValue{ parameter.Default, 0.0 });
    }
  }
  this->Internal->DebugView = "none";
  this->Internal->Said.clear();
  this->Internal->ParameterTime.Modified();
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::GetTechnique()
{
  return this->Internal->Technique ? this->Internal->Technique->Name : "";
}

//------------------------------------------------------------------------------
const vtkShadowParameter* vtkShadowPass::FindParameter(const std::string& name) const
{
  if (this->Internal->Technique)
  {
    for (const auto* list :
      { &this->Internal->Technique->Parameters, &vtkShadowPass::GetCommonParameters() })
    {
      for (const auto& parameter : *list)
      {
        if (parameter.Name == name)
        {
          return &parameter;
        }
      }
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
bool vtkShadowPass::SetParameter(const std::string& name, const std::string& value)
{
  const vtkShadowParameter* parameter = this->FindParameter(name);
  if (!parameter)
  {
    vtkErrorMacro(<< this->GetTechnique() << " has no parameter '" << name
                  << "'. Known: " << JoinNames(this->Internal->Values) << ".");
    return false;
  }
  const auto read = Read(*parameter, value);
  if (!read)
  {
    vtkErrorMacro(<< this->GetTechnique() << ": parameter '" << name << "' cannot be '" << value
                  << "'; it is " << DescribeRange(*parameter) << ".");
    return false;
  }
  vtkShadowValue& current = this->Internal->Values[name];
  const bool choice = parameter->ValueType == vtkShadowParameter::Type::Choice;
  const bool changed = choice ? current.Text != read->Text : current.Number != read->Number;
  current = *read;
  if (changed)
  {
    this->Internal->Said.clear();
    this->Internal->ParameterTime.Modified();
    this->Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::GetParameter(const std::string& name)
{
  return this->GetValue(name).Text;
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetQuality(int level)
{
  if (!this->Internal->Technique)
  {
    return;
  }
  for (const auto& parameter : this->Internal->Technique->Parameters)
  {
    if (!parameter.Presets.empty())
    {
      this->SetParameter(parameter.Name, parameter.Presets[level]);
    }
  }
}

//------------------------------------------------------------------------------
bool vtkShadowPass::HasParameter(const std::string& name) const
{
  return this->FindParameter(name) != nullptr;
}

//------------------------------------------------------------------------------
const vtkShadowValue& vtkShadowPass::GetValue(const std::string& name)
{
  const auto found = this->Internal->Values.find(name);
  if (found == this->Internal->Values.end())
  {
    static const vtkShadowValue none;
    vtkErrorMacro(<< this->GetTechnique() << " has no parameter '" << name
                  << "'. Known: " << JoinNames(this->Internal->Values) << ".");
    return none;
  }
  return found->second;
}

//------------------------------------------------------------------------------
int vtkShadowPass::GetInteger(const std::string& name)
{
  return static_cast<int>(this->GetValue(name).Number);
}

//------------------------------------------------------------------------------
double vtkShadowPass::GetReal(const std::string& name)
{
  return this->GetValue(name).Number;
}

//------------------------------------------------------------------------------
bool vtkShadowPass::GetBoolean(const std::string& name)
{
  return this->GetValue(name).Number != 0.0;
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::GetText(const std::string& name)
{
  return this->GetValue(name).Text;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkShadowPass::GetParameterTime()
{
  return this->Internal->ParameterTime;
}

//------------------------------------------------------------------------------
void vtkShadowPass::WarnOnce(const std::string& message)
{
  if (this->Internal->Said.insert(message).second)
  {
    vtkWarningMacro(<< this->GetTechnique() << ": " << message);
  }
}

//------------------------------------------------------------------------------
void vtkShadowPass::ErrorOnce(const std::string& message)
{
  if (this->Internal->Said.insert(message).second)
  {
    vtkErrorMacro(<< this->GetTechnique() << ": " << message);
  }
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::GetDebugViews()
{
  return "none visibility penumbra cost";
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::GetDebugQuantity(const std::string& view)
{
  return view == "cost" ? "shadowCost" : "";
}

//------------------------------------------------------------------------------
bool vtkShadowPass::SetDebugView(const std::string& view)
{
  std::istringstream known(this->GetDebugViews());
  for (std::string name; known >> name;)
  {
    if (name == view)
    {
      this->Internal->DebugView = view;
      this->Modified();
      return true;
    }
  }
  vtkErrorMacro(<< this->GetTechnique() << " has no debug view '" << view
                << "'. Known: " << this->GetDebugViews() << ".");
  return false;
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::GetDebugView()
{
  return this->Internal->DebugView;
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetDelegatePass(vtkRenderPass* delegate)
{
  if (vtkShadowPassChain::Holds(delegate, this))
  {
    vtkErrorMacro("SetDelegatePass: this pass is the delegate itself, or within it.");
    return;
  }
  if (this->Internal->Delegate != delegate)
  {
    this->Internal->Delegate = delegate;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkShadowPass::GetDelegatePass()
{
  return this->Internal->Delegate;
}

//------------------------------------------------------------------------------
void vtkShadowPass::CopySettings(vtkShadowPass* other)
{
  Internals& my = *this->Internal;
  const Internals& from = *other->Internal;
  if (this->GetTechnique() != other->GetTechnique())
  {
    this->SetTechnique(other->GetTechnique());
  }
  const auto same = [](const auto& a, const auto& b)
  { return a.first == b.first && a.second.Text == b.second.Text; };
  if (!std::equal(my.Values.begin(), my.Values.end(), from.Values.begin(), from.Values.end(), same))
  {
    my.Values = from.Values;
    my.Said.clear();
    my.ParameterTime.Modified();
  }
  my.DebugView = from.DebugView;
  this->SetDelegatePass(from.Delegate);
  this->SetDefaultLightRadius(other->GetDefaultLightRadius());
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkShadowPass::IsSupported(vtkRenderWindow* window)
{
  auto* glWindow = vtkOpenGLRenderWindow::SafeDownCast(window);
  if (!glWindow)
  {
    this->Internal->UnsupportedReason = "the window is not a vtkOpenGLRenderWindow";
  }
  else
  {
    glWindow->Initialize();
    glWindow->MakeCurrent();
    int major = 0;
    int minor = 0;
    glWindow->GetOpenGLVersion(major, minor);
    const bool has = major > 3 || (major == 3 && minor >= 3) ||
                     (major == 3 && minor == 2 && VTK_SHADOW_HAS_GL(ARB_shader_bit_encoding));
    this->Internal->UnsupportedReason =
      has ? this->FindUnsupported(window)
          : "OpenGL 3.3 is needed, or 3.2 with ARB_shader_bit_encoding; the window has " +
              std::to_string(major) + "." + std::to_string(minor);
  }
  return this->Internal->UnsupportedReason.empty();
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::GetUnsupportedReason()
{
  return this->Internal->UnsupportedReason;
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::GetStatistics()
{
  Internals& my = *this->Internal;
  if (my.Copy)
  {
    return my.Copy->GetStatistics();
  }
  nlohmann::ordered_json json = { { "technique", this->GetTechnique() }, { "frame", my.Frames },
    { "evaluation", my.Active ? (my.ScreenSpace ? "screen" : "forward") : "none" } };
  if (my.Window && my.Timers.ArePending())
  {
    my.Window->MakeCurrent();
  }
  json["milliseconds"] = my.Timers.GetMilliseconds();
  json["counts"] = my.Frame.Counts;
  json["lights"] = nlohmann::ordered_json::array();
  for (const auto& note : my.LightNotes)
  {
    json["lights"].push_back(note);
  }
  const std::size_t casterBytes = my.Casters.GetGPUBytes();
  json["bytes"]["casters"] = casterBytes;
  const std::size_t bufferBytes = my.Buffer.GetGPUBytes() + my.Glass.GetGPUBytes();
  std::size_t total = casterBytes + bufferBytes;
  json["bytes"]["buffers"] = bufferBytes;
  for (const auto& entry : this->GetLightDataBytes())
  {
    json["bytes"][entry.first] = entry.second;
    total += entry.second;
  }
  json["bytes"]["total"] = total;
  return json.dump(2);
}

//------------------------------------------------------------------------------
void vtkShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Technique: " << this->GetTechnique() << "\n";
  for (const auto& entry : this->Internal->Values)
  {
    os << indent << entry.first << ": " << entry.second.Text << "\n";
  }
  os << indent << "DebugView: " << this->Internal->DebugView << "\n";
  os << indent << "DefaultLightRadius: " << this->DefaultLightRadius << "\n";
  os << indent << "DelegatePass: " << this->Internal->Delegate.Get() << "\n";
}
