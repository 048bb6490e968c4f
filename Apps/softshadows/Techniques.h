// SPDX-License-Identifier: BSD-3-Clause
// Techniques as the command line names them: a name, a quality, and parameters.

#ifndef Techniques_h
#define Techniques_h

#include "vtkShadowPass.h"
#include "vtkSmartPointer.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

/** One --set: NAME=VALUE, or TECHNIQUE:NAME=VALUE. */
struct TechniqueSetting
{
  std::string Technique; // empty: whichever has the parameter
  std::string Name;
  std::string Value;

  /** None for text of another form. */
  static std::optional<TechniqueSetting> Parse(const std::string& text);
};

/** What is said about techniques, the same for one and for many. */
struct TechniqueOptions
{
  std::string Quality;
  std::vector<TechniqueSetting> Settings;
  /** Facets cast and receive as they are, where it is not set otherwise: what errors are measured of. */
  bool Measured = false;

  /** The options --quality and --set. */
  void Declare(CLI::App& command);

  /**
   * A technique with its parameters set. Failure for an unknown technique, or a value that it cannot
   * take. Without a technique before its name, a parameter must be one of this technique's where
   * strict; else it is passed over where the technique lacks it.
   */
  vtkSmartPointer<vtkShadowPass> Create(const std::string& technique, bool strict) const;

  /** The technique that is taken where none is named; its own settings go before the user's. */
  std::string TakeDefault(bool studio);

  /** Failure for a setting that none of these techniques would use. */
  void CheckSettings(const std::vector<std::string>& techniques) const;
};

namespace Techniques
{
/** All names, sorted. */
std::vector<std::string> GetNames();

/** What vtkShadowTechniques::Describe says; Failure for an unknown one. */
nlohmann::ordered_json Describe(const std::string& technique);

/** Whether a technique, as described, has a parameter. */
bool HasParameter(const nlohmann::ordered_json& description, const std::string& parameter);

/** A preset by its name, "" for none; Failure for an unknown one. */
void SetQuality(vtkShadowPass* pass, const std::string& quality);

/** All parameters of a pass and their values. */
nlohmann::ordered_json GetParameters(vtkShadowPass* pass);

/** How many samples of a light a pass takes: its parameter "samples"; 1 where it is hard, else 64. */
int GetLightSamples(vtkShadowPass* pass);

/** Why a pass cannot draw a window under a light of that shape, or "". */
std::string FindUnsupported(
  vtkShadowPass* pass, vtkRenderWindow* window, const std::string& lightShape);
}

#endif
