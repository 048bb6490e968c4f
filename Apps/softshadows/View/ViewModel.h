// SPDX-License-Identifier: BSD-3-Clause
// One side of the viewer's window: which technique is shown, how it is set, and what of it.

#ifndef ViewModel_h
#define ViewModel_h

#include "Techniques.h"

#include <map>
#include <string>
#include <vector>

class ViewModel
{
public:
  /** Failure for a technique or an option that cannot be. */
  ViewModel(const TechniqueOptions& options, const std::string& technique);

  ///@{
  /** A technique's name, or "none"; each is kept as it was set. */
  const std::string& GetTechnique() const { return this->Technique; }
  void SetTechnique(const std::string& name);
  void StepTechnique(int step);
  static std::vector<std::string> GetTechniques();
  ///@}

  /** Of the technique; nullptr for none. */
  vtkShadowPass* GetPass() const { return this->Pass; }

  /** A preset: preview, low, medium, high, reference. */
  void SetQuality(const std::string& quality);
  static const std::vector<std::string>& GetQualities();

  ///@{
  /** The technique's parameters, as its declaration has them; one of them is chosen. */
  const nlohmann::ordered_json& GetParameters() const { return this->Parameters; }
  std::size_t GetChosen() const { return this->Chosen; }
  void Choose(int step);
  /** The next or the previous value of the one that is chosen. */
  void Change(int step);
  bool Has(const std::string& parameter) const;
  std::string GetValue(const std::string& parameter) const;
  void SetValue(const std::string& parameter, const std::string& value);
  ///@}

  ///@{
  /** Debug views, "none" first. */
  std::vector<std::string> GetDebugViews() const;
  std::string GetDebugView() const;
  void SetDebugView(const std::string& view);
  void StepDebugView(int step);
  ///@}

  ///@{
  /**
   * Draw for less for a while: with what the next lower quality gives each parameter that is not less
   * already. False where there is no lower one.
   */
  bool Lower();
  /** As it was set; false where it is. */
  bool Restore();
  bool IsLowered() const { return this->Steps > 0; }
  ///@}

  /** The options of the command that set it so. */
  std::vector<std::string> GetOptions() const;

private:
  void SetAll(const std::map<std::string, std::string>& values);

  TechniqueOptions Options;
  std::string Technique;
  std::map<std::string, vtkSmartPointer<vtkShadowPass>> Passes;
  vtkShadowPass* Pass = nullptr;
  nlohmann::ordered_json Parameters;
  std::size_t Chosen = 0;
  int Steps = 0;
  std::map<std::string, std::string> Before; // values, while it is lowered
};

#endif
