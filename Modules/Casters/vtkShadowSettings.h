// SPDX-License-Identifier: BSD-3-Clause
// The values of a technique's parameters.

#ifndef vtkShadowSettings_h
#define vtkShadowSettings_h

#include "vtkShadowParameter.h"          // For vtkShadowValue
#include "vtkSoftShadowsCastersModule.h" // For export macro
#include "vtkTimeStamp.h"                // For when they changed

#include <algorithm>
#include <map>
#include <string>

struct vtkShadowDeclaration;

class VTKSOFTSHADOWSCASTERS_EXPORT vtkShadowSettings
{
public:
  vtkShadowSettings() = default;
  explicit vtkShadowSettings(const vtkShadowDeclaration& declaration) { this->Reset(&declaration); }

  /** The defaults of a technique; nullptr: of none. */
  void Reset(const vtkShadowDeclaration* declaration);
  const vtkShadowDeclaration* GetDeclaration() const { return this->Declaration; }
  /** Its name; empty where there is none. */
  std::string GetTechnique() const;

  /** Set a parameter by a text. Gives what is wrong, as a sentence, and changes nothing then; or "". */
  std::string Set(const std::string& name, const std::string& value);
  /** As text; nullptr for a name that is not declared: GetUnknown says so. */
  const std::string* Find(const std::string& name) const;
  std::string GetUnknown(const std::string& name) const;
  /** Take over the values of the same technique. */
  void Copy(const vtkShadowSettings& other);

  const std::map<std::string, vtkShadowValue>& GetAll() const { return this->Values; }
  ///@{
  /** When any value last changed; and one that is not of shading alone: light data is to be built anew. */
  vtkMTimeType GetTimeOfAny() const
  {
    return std::max(this->Time.GetMTime(), this->ShadingTime.GetMTime());
  }
  vtkMTimeType GetTime() const { return this->Time; }
  ///@}

  bool Has(const std::string& name) const { return this->Values.count(name) != 0; }
  ///@{
  /** The value of a parameter of that type. std::logic_error for one that is not declared so. */
  int GetInteger(const std::string& name) const;
  double GetReal(const std::string& name) const;
  bool GetBoolean(const std::string& name) const;
  std::string GetChoice(const std::string& name) const;
  ///@}

private:
  const vtkShadowValue& Get(const std::string& name, vtkShadowParameter::Type type) const;

  const vtkShadowDeclaration* Declaration = nullptr;
  std::map<std::string, vtkShadowValue> Values;
  vtkTimeStamp Time;
  vtkTimeStamp ShadingTime;
};

#endif
