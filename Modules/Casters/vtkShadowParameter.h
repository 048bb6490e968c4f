// SPDX-License-Identifier: BSD-3-Clause
// A parameter of a technique: its declaration, and what a text says as its value.

#ifndef vtkShadowParameter_h
#define vtkShadowParameter_h

#include "vtkSoftShadowsCastersModule.h" // For export macro

#include <optional>
#include <string>
#include <vector>

/** A parameter's value, read once, when it is set. */
struct vtkShadowValue
{
  std::string Text;    // as it was set; a whole number or a boolean in its plain form
  double Number = 0.0; // 1 for on
};

/**
 * What vtkShadowPass::SetParameter understands. Made by the function of its type, and what else it has
 * by those that follow:
 *
 *   vtkShadowParameter::Integer("samples", 64, 1, 1024, "Rays to each light").In("rays").At({ 4, 64, 64, 256 })
 */
struct VTKSOFTSHADOWSCASTERS_EXPORT vtkShadowParameter
{
  enum class Type
  {
    Integer,
    Real,
    Boolean, // "on" or "off"
    Choice
  };

  std::string Name;
  Type ValueType = Type::Integer;
  std::string Default;
  double Minimum = 0.0; // inclusive, for Integer and Real
  double Maximum = 0.0; // inclusive
  std::vector<std::string> Choices;
  std::string Unit;
  std::string Meaning;
  /** How a picture is shaded: no light data depends on it. */
  bool OfShading = false;
  /** Values at quality low, medium, high, reference; empty where quality does not matter. */
  std::vector<std::string> Presets;
  /** Value at quality preview; empty where it is that of low. */
  std::string Preview;

  ///@{ Of a default; from a least to a greatest value, or one of some choices.
  static vtkShadowParameter Integer(
    const std::string& name, int value, int minimum, int maximum, const std::string& meaning);
  static vtkShadowParameter Real(const std::string& name, double value, double minimum,
    double maximum, const std::string& meaning);
  static vtkShadowParameter Boolean(
    const std::string& name, bool value, const std::string& meaning);
  static vtkShadowParameter Choice(const std::string& name, const std::string& value,
    const std::vector<std::string>& choices, const std::string& meaning);
  ///@}
  /** Its unit. */
  vtkShadowParameter& In(const std::string& unit);
  /** Its values at quality low, medium, high and reference. */
  vtkShadowParameter& At(const std::vector<double>& presets);
  /** Its value at quality preview, where that is less than low. */
  vtkShadowParameter& AtPreview(double preview);
  std::string GetPreview() const
  {
    return this->Preview.empty() ? this->Presets[0] : this->Preview;
  }

  /** Those that all techniques have. */
  static const std::vector<vtkShadowParameter>& GetCommon();

  /** What a text says, in any locale; nothing if it cannot be a value. */
  std::optional<vtkShadowValue> Read(const std::string& text) const;
  /** What values there are, for messages: "a number from 0 to 4". */
  std::string DescribeRange() const;
};

#endif
