// SPDX-License-Identifier: BSD-3-Clause
// What a benchmark measures: cases (scenes as they are drawn) and entries (ways to draw their shadows).
// A suite is such a plan as data: suites/NAME.json, described by suites/suite.schema.json.

#ifndef BenchPlan_h
#define BenchPlan_h

#include "ExtremePlan.h"
#include "SceneOptions.h"
#include "Techniques.h"

#include <nlohmann/json.hpp>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

struct BenchCase
{
  std::string Id; // unique in the plan
  SceneOptions Scene;
  double LightScale = 1.0; // times the size that the scene's light has
  int Lights = 1;          // on a ring about the target, the scene's light among them
  struct View
  {
    std::array<double, 3> Position;
    std::array<double, 3> Focus;
  };
  std::optional<View> Camera;
  TechniqueOptions Settings;   // of techniques, where an entry does not set them itself
  double Budget = 100.0;       // seconds
  int ReferenceSamples = 1024; // rays a pixel; 0: errors are not measured
  std::string Axis;            // of "scaling": what this case varies
  std::string Published;       // key of the entries' published figures

  /** Where the case lies on its axis. */
  double GetValue(const ::Scene& built) const;
  /** Failure for a case that lies nowhere on it. */
  void CheckAxis() const;
};

struct BenchEntry
{
  enum class Role
  {
    None, // no shadows
    Technique,
    Peer // what techniques are measured beside
  };
  using Setting = std::vector<std::pair<std::string, std::string>>; // names and values

  Role Kind = Role::None;
  std::string Technique; // or VTKPeer
  Setting Values;
  std::string Label;
  nlohmann::ordered_json Published; // figures of a paper; null: none

  /** Unique in the plan: the technique and what is set. */
  std::string GetId() const;
};

struct BenchPlan
{
  std::string Name;
  std::string Title;
  std::string About;
  std::vector<BenchCase> Cases;
  bool CasesFromSuite = true;        // not from the command line
  BenchCase Default;                 // what a scene of the user's own takes from the plan
  std::vector<BenchEntry> Entries;   // the first draws no shadows
  std::vector<ExtremeCase> Extremes; // instead of cases: what is swept to its limits
  int Frames = 15;                   // wanted for each median
  nlohmann::ordered_json Published;

  /** Seconds of all cases. */
  double GetBudget() const;
};

namespace BenchPlans
{
/** vtkShadowMapPass, VTK's own shadows, which is no technique of this toolkit. */
extern const char* const VTKPeer;

/** The built-in suites, by name. */
std::vector<std::string> GetSuites();

/**
 * A built-in suite, or a file of that form; WrongUsage where there is none, Failure that names the file
 * and the field for what is wrong with it.
 */
BenchPlan Load(const std::string& nameOrFile);

/** Keep these techniques' entries alone; one that has none is added as it is by default. */
void Select(BenchPlan& plan, const std::vector<std::string>& techniques);

/**
 * One --sweep: [TECHNIQUE:]NAME=V1,V2... The entries of each technique that has the parameter become
 * one each value. Several sweeps of one technique multiply. WrongUsage or Failure for what cannot be.
 */
void Sweep(BenchPlan& plan, const std::vector<std::string>& sweeps);

/** An entry's pass, as a case wants it; Failure for a value that it cannot take. */
vtkSmartPointer<vtkShadowPass> MakePass(const BenchCase& one, const BenchEntry& entry);

/** Texels of a side of the map of VTK's own pass. */
int GetVTKResolution(const BenchCase& one, const BenchEntry& entry);

/** Failure for what will not work in any of the cases: before the first is measured. */
void Check(const BenchPlan& plan);
}

#endif
