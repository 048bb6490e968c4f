// The settings of vtkShadowPass: technique, parameters, debug view, casting keys, statistics.

#include "vtkShadowPassInternals.h"

#include "vtkAbstractMapper3D.h"
#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLODProp3D.h"
#include "vtkLight.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <sstream>

vtkInformationKeyMacro(vtkShadowPass, CASTS_SHADOW, Integer);
vtkInformationKeyMacro(vtkShadowPass, RECEIVES_SHADOW, Integer);
vtkInformationKeyMacro(vtkShadowPass, SHADOW_CATCHER, Integer);

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

/** The value in its plain form, or "" if it is not one of this parameter. */
std::string Normalize(const vtkShadowParameter& parameter, const std::string& value)
{
  using Type = vtkShadowParameter::Type;
  if (parameter.ValueType == Type::Boolean)
  {
    const bool on = value == "on" || value == "true" || value == "1";
    const bool off = value == "off" || value == "false" || value == "0";
    return on ? "on" : (off ? "off" : "");
  }
  if (parameter.ValueType == Type::Choice)
  {
    const auto& choices = parameter.Choices;
    return std::find(choices.begin(), choices.end(), value) != choices.end() ? value : "";
  }
  char* end = nullptr;
  const double number = std::strtod(value.c_str(), &end);
  const bool whole = parameter.ValueType != Type::Integer || number == std::floor(number);
  // The comparisons are false for NaN.
  const bool valid = !value.empty() && *end == '\0' && whole && number >= parameter.Minimum &&
                     number <= parameter.Maximum;
  return valid ? value : "";
}

std::string DescribeRange(const vtkShadowParameter& parameter)
{
  using Type = vtkShadowParameter::Type;
  std::ostringstream text;
  switch (parameter.ValueType)
  {
    case Type::Boolean:
      text << "on or off";
      break;
    case Type::Choice:
      text << "one of: " << Join(parameter.Choices);
      break;
    default:
      text << (parameter.ValueType == Type::Integer ? "a whole number" : "a number") << " from "
           << parameter.Minimum << " to " << parameter.Maximum;
  }
  return text.str();
}

bool GetSwitch(vtkInformation* keys, vtkInformationIntegerKey* key)
{
  return !keys || !keys->Has(key) || keys->Get(key) != 0;
}

/** The level that was drawn last, or the first one; nullptr where it is no actor. */
vtkActor* GetShownLevel(vtkLODProp3D* levels)
{
  // The level of a frame is chosen while it is drawn.
  const int last = levels->GetLastRenderedLODID();
  vtkNew<vtkPropCollection> actors;
  levels->GetActors(actors);
  for (int i = 0; i < actors->GetNumberOfItems(); ++i)
  {
    auto* actor = vtkActor::SafeDownCast(actors->GetItemAsObject(i));
    if (last < 0 ||
        static_cast<vtkAbstractMapper3D*>(actor->GetMapper()) == levels->GetLODMapper(last))
    {
      return actor;
    }
  }
  return nullptr;
}

/** What SetShadowCatcher has to undo, kept in the key. */
enum CatcherBits
{
  Catches = 1,
  MadeTranslucent = 2,
  MadePhong = 4
};

void SetSwitch(vtkProp* prop, vtkInformationIntegerKey* key, bool on)
{
  if (!prop->GetPropertyKeys())
  {
    vtkNew<vtkInformation> keys;
    prop->SetPropertyKeys(keys);
  }
  prop->GetPropertyKeys()->Set(key, on ? 1 : 0);
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
  };
  return parameters;
}

//------------------------------------------------------------------------------
bool vtkShadowPass::SetTechnique(const std::string& name)
{
  const vtkShadowTechnique* technique = vtkShadowTechniqueRegistration::Find(name);
  if (!technique || technique->ClassName != this->GetClassName())
  {
    vtkErrorMacro("'" << name << "' is not a technique of " << this->GetClassName() << ".");
    return false;
  }
  this->Internal->Technique = technique;
  this->Internal->Values.clear();
  for (const auto* list : { &technique->Parameters, &vtkShadowPass::GetCommonParameters() })
  {
    for (const auto& parameter : *list)
    {
      this->Internal->Values[parameter.Name] = parameter.Default;
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
    std::vector<std::string> known;
    for (const auto& entry : this->Internal->Values)
    {
      known.push_back(entry.first);
    }
    vtkErrorMacro(<< this->GetTechnique() << " has no parameter '" << name
                  << "'. Known: " << Join(known) << ".");
    return false;
  }
  const std::string plain = Normalize(*parameter, value);
  if (plain.empty())
  {
    vtkErrorMacro(<< this->GetTechnique() << ": parameter '" << name << "' cannot be '" << value
                  << "'; it is " << DescribeRange(*parameter) << ".");
    return false;
  }
  std::string& current = this->Internal->Values[name];
  if (current != plain)
  {
    current = plain;
    this->Internal->Said.clear();
    this->Internal->ParameterTime.Modified();
    this->Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::GetParameter(const std::string& name)
{
  if (!this->FindParameter(name))
  {
    vtkErrorMacro(<< this->GetTechnique() << " has no parameter '" << name << "'.");
    return "";
  }
  return this->Internal->Values[name];
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
int vtkShadowPass::GetInteger(const std::string& name)
{
  return static_cast<int>(this->GetReal(name));
}

//------------------------------------------------------------------------------
double vtkShadowPass::GetReal(const std::string& name)
{
  return std::strtod(this->Internal->Values[name].c_str(), nullptr);
}

//------------------------------------------------------------------------------
bool vtkShadowPass::GetBoolean(const std::string& name)
{
  return this->Internal->Values[name] == "on";
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::GetText(const std::string& name)
{
  return this->Internal->Values[name];
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
void vtkShadowPass::SetCasting(vtkProp* prop, bool casts)
{
  SetSwitch(prop, vtkShadowPass::CASTS_SHADOW(), casts);
}

//------------------------------------------------------------------------------
bool vtkShadowPass::GetCasting(vtkProp* prop)
{
  return GetSwitch(prop->GetPropertyKeys(), vtkShadowPass::CASTS_SHADOW());
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetReceiving(vtkProp* prop, bool receives)
{
  SetSwitch(prop, vtkShadowPass::RECEIVES_SHADOW(), receives);
}

//------------------------------------------------------------------------------
bool vtkShadowPass::GetReceiving(vtkProp* prop)
{
  return GetSwitch(prop->GetPropertyKeys(), vtkShadowPass::RECEIVES_SHADOW());
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetShadowCatcher(vtkProp* prop, bool catches)
{
  if (catches == vtkShadowPass::GetShadowCatcher(prop))
  {
    return;
  }
  vtkInformation* before = prop->GetPropertyKeys();
  int made = catches ? static_cast<int>(Catches) : before->Get(vtkShadowPass::SHADOW_CATCHER());
  vtkShadowPass::ForEachPart(prop,
    [&](vtkProp* part, vtkMatrix4x4*)
    {
      auto* actor = vtkActor::SafeDownCast(part);
      if (!actor)
      {
        return;
      }
      // It is blended over what lies behind; and only its lights are to count.
      if (catches && !actor->GetForceTranslucent())
      {
        actor->ForceTranslucentOn();
        made |= MadeTranslucent;
      }
      else if (!catches && (made & MadeTranslucent) != 0)
      {
        actor->ForceTranslucentOff();
      }
      if (catches && actor->GetProperty()->GetInterpolation() == VTK_PBR)
      {
        actor->GetProperty()->SetInterpolationToPhong();
        made |= MadePhong;
      }
      else if (!catches && (made & MadePhong) != 0)
      {
        actor->GetProperty()->SetInterpolationToPBR();
      }
    });
  SetSwitch(prop, vtkShadowPass::SHADOW_CATCHER(), catches);
  if (catches)
  {
    prop->GetPropertyKeys()->Set(vtkShadowPass::SHADOW_CATCHER(), made);
  }
}

//------------------------------------------------------------------------------
bool vtkShadowPass::GetShadowCatcher(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  return keys && keys->Has(vtkShadowPass::SHADOW_CATCHER()) &&
         keys->Get(vtkShadowPass::SHADOW_CATCHER()) != 0;
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetLightCasting(vtkLight* light, bool casts)
{
  if (!light->GetInformation())
  {
    vtkNew<vtkInformation> keys;
    light->SetInformation(keys);
  }
  light->GetInformation()->Set(vtkShadowPass::CASTS_SHADOW(), casts ? 1 : 0);
}

//------------------------------------------------------------------------------
bool vtkShadowPass::GetLightCasting(vtkLight* light)
{
  return GetSwitch(light->GetInformation(), vtkShadowPass::CASTS_SHADOW());
}

//------------------------------------------------------------------------------
void vtkShadowPass::ForEachPart(
  vtkProp* prop, const std::function<void(vtkProp*, vtkMatrix4x4*)>& function)
{
  const auto visit = [&function](vtkProp* part, vtkMatrix4x4* matrix)
  {
    auto* levels = vtkLODProp3D::SafeDownCast(part);
    vtkProp* shown = levels ? GetShownLevel(levels) : part;
    if (shown && matrix)
    {
      function(shown, matrix);
    }
  };
  if (prop->IsA("vtkAssembly") || prop->IsA("vtkPropAssembly"))
  {
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetNextPath())
    {
      vtkAssemblyNode* node = path->GetLastNode();
      vtkProp* part = node->GetViewProp();
      vtkMatrix4x4* matrix = node->GetMatrix() ? node->GetMatrix() : part->GetMatrix();
      if (part->GetVisibility())
      {
        visit(part, matrix);
      }
    }
  }
  else
  {
    visit(prop, prop->GetMatrix());
  }
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
    this->Internal->UnsupportedReason = major > 3 || (major == 3 && minor >= 2)
                                          ? this->FindUnsupported(window)
                                          : "OpenGL 3.2 is needed, the window has " +
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
    os << indent << entry.first << ": " << entry.second << "\n";
  }
  os << indent << "DebugView: " << this->Internal->DebugView << "\n";
  os << indent << "DefaultLightRadius: " << this->DefaultLightRadius << "\n";
  os << indent << "DelegatePass: " << this->Internal->Delegate.Get() << "\n";
}
