// SPDX-License-Identifier: BSD-3-Clause
#include "BenchMeasure.h"

#include "BenchStage.h"
#include "Errors.h"
#include "Interruption.h"
#include "Progress.h"
#include "References.h"
#include "Statistics.h"
#include "VTKShadows.h"

#include "vtkAreaLight.h"
#include "vtkFloatArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPictureMetrics.h"
#include "vtkPointData.h"
#include "vtkVisibilityMetrics.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>

namespace
{
using Json = nlohmann::ordered_json;
using Image = vtkSmartPointer<vtkImageData>;
using Clock = std::chrono::steady_clock;

/** Fewer frames than these have no median worth the name: an entry gets them before others get more. */
constexpr std::size_t LeastFrames = 3;

/** Where no pixel lies in a penumbra there is no error in it. */
Json ParseErrors(vtkVisibilityMetrics* metrics)
{
  Json json = Json::parse(metrics->GetJSON());
  if (json["penumbra"]["pixels"] == 0)
  {
    for (const char* name : { "rmse", "bias", "p99", "maximum", "weighted_rmse" })
    {
      json["penumbra"][name] = nullptr;
    }
  }
  return json;
}

double SecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/** Milliseconds of the frames of one kind, and what was added to the unshadowed frame of that turn. */
struct Times
{
  std::vector<double> Whole;
  std::vector<double> Added;

  void Add(double whole, double unshadowed)
  {
    this->Whole.push_back(whole);
    this->Added.push_back(whole - unshadowed);
  }

  static Json Describe(const std::vector<double>& values)
  {
    return { { "median", Statistics::GetMedian(values) },
      { "lower", Statistics::GetQuantile(values, 0.25) },
      { "upper", Statistics::GetQuantile(values, 0.75) } };
  }

  Json GetJSON(const Times& unshadowed) const
  {
    Json json = Describe(this->Whole);
    json["frames"] = this->Whole.size();
    json["added"] = Describe(this->Added);
    json["ratio"] = static_cast<double>(json["median"]) / Statistics::GetMedian(unshadowed.Whole);
    return json;
  }
};

/** An entry at work. */
struct Contestant
{
  const BenchEntry* Entry = nullptr;
  vtkSmartPointer<vtkShadowPass> Pass; // none: no shadows, or VTK's own
  std::unique_ptr<VTKShadows> VTK;
  std::string Note; // why it is not measured
  Json Error;
  Json Picture;
  Json Bytes;
  std::vector<double> Megarays; // a second, of a frame each
  Image Frame;
  Image Difference;
  Times Static;  // the camera moved
  Times Dynamic; // the lights moved
  int Turns = 0;
  double Used = 0.0; // seconds of timing
};
}

class BenchMeasure::Internals
{
public:
  Internals(const BenchPlan& plan, const BenchCase& one);

  void Enter(Contestant& contestant);
  void Leave(Contestant& contestant);
  void DrawReference();
  void MeasureError(Contestant& contestant);
  void MeasureErrors(double seconds, RemainingTime& remaining);
  void ReadStatistics(Contestant& contestant);
  void Compare(Contestant& contestant, vtkImageData* visibility);
  void TimeUnshadowed();
  void Time(Contestant& contestant);
  void TimeAll(double seconds, RemainingTime& remaining);
  bool Needs(const Contestant& contestant) const;
  Json GetJSON(const Contestant& contestant) const;

  const BenchPlan& Plan;
  const BenchCase& Case;
  BenchStage Stage;
  std::vector<Contestant> Contestants; // the first draws no shadows
  Reference Truth;                     // the mean of two references
  Json Noise;
  Json SceneJSON;                // before anything has moved
  double UnshadowedStatic = 0.0; // milliseconds, in this turn
  double UnshadowedDynamic = 0.0;
};

//------------------------------------------------------------------------------
BenchMeasure::Internals::Internals(const BenchPlan& plan, const BenchCase& one)
  : Plan(plan)
  , Case(one)
  , Stage(one)
  , Contestants(plan.Entries.size())
  , SceneJSON(Stage.GetScene().GetJSON())
{
  for (std::size_t i = 0; i < plan.Entries.size(); ++i)
  {
    Contestant& contestant = this->Contestants[i];
    contestant.Entry = &plan.Entries[i];
    if (contestant.Entry->Technique == BenchPlans::VTKPeer)
    {
      contestant.VTK =
        std::make_unique<VTKShadows>(BenchPlans::GetVTKResolution(one, plan.Entries[i]));
      contestant.Note = VTKShadows::FindUnsupported(this->Stage.GetLights().front());
    }
    else if (contestant.Entry->Kind != BenchEntry::Role::None)
    {
      contestant.Pass = BenchPlans::MakePass(one, plan.Entries[i]);
      contestant.Note = Techniques::FindUnsupported(contestant.Pass,
        this->Stage.GetWindow().GetOpenWindow(), GetShapeName(this->Stage.GetLights().front()));
    }
  }
}

//------------------------------------------------------------------------------
void BenchMeasure::Internals::Enter(Contestant& contestant)
{
  vtkRenderer* renderer = this->Stage.GetWindow().GetRenderer();
  if (contestant.VTK)
  {
    contestant.VTK->Enter(renderer, this->Stage.GetLights());
  }
  else
  {
    renderer->SetPass(contestant.Pass);
  }
}

//------------------------------------------------------------------------------
void BenchMeasure::Internals::Leave(Contestant& contestant)
{
  if (contestant.VTK)
  {
    contestant.VTK->Leave(this->Stage.GetWindow().GetRenderer());
  }
}

//------------------------------------------------------------------------------
// Two references of different seeds: their mean is the truth, and half of how they differ its noise. Rays
// that are measured have another seed, 0.
void BenchMeasure::Internals::DrawReference()
{
  const auto pass = References::MakePass(this->Case.ReferenceSamples);
  pass->SetParameter("seed", "1");
  vtkAreaLight* light = this->Stage.GetLights().front();
  this->Truth = References::Draw(this->Stage.GetWindow(), pass, light);
  if (Interruption::IsAsked())
  {
    return;
  }
  pass->SetParameter("seed", "2");
  const Reference second = References::Draw(this->Stage.GetWindow(), pass, light);
  this->Truth.Milliseconds += second.Milliseconds;

  auto* mean =
    vtkFloatArray::SafeDownCast(this->Truth.Visibility->GetPointData()->GetArray("Visibility"));
  auto* other =
    vtkFloatArray::SafeDownCast(second.Visibility->GetPointData()->GetArray("Visibility"));
  for (vtkIdType i = 0; i < mean->GetNumberOfValues(); ++i)
  {
    mean->SetValue(i, 0.5f * (mean->GetValue(i) + other->GetValue(i)));
  }
  vtkNew<vtkVisibilityMetrics> noise;
  noise->SetImage(second.Visibility);
  noise->SetReference(this->Truth.Visibility);
  noise->Update();
  Messages::Check("reference");
  this->Noise = ParseErrors(noise);
}

//------------------------------------------------------------------------------
// Half of the time at most: the other half is for the times.
void BenchMeasure::Internals::MeasureErrors(double seconds, RemainingTime& remaining)
{
  const auto start = Clock::now();
  for (Contestant& contestant : this->Contestants)
  {
    if (Interruption::IsAsked() || SecondsSince(start) > 0.5 * seconds)
    {
      return;
    }
    if (contestant.Note.empty())
    {
      this->MeasureError(contestant);
    }
    remaining.Show(seconds - SecondsSince(start));
  }
}

//------------------------------------------------------------------------------
void BenchMeasure::Internals::MeasureError(Contestant& contestant)
{
  OffscreenWindow& window = this->Stage.GetWindow();
  try
  {
    this->Enter(contestant);
    window.Render();
    contestant.Frame = References::Copy(window.Grab());
    this->ReadStatistics(contestant);
    vtkImageData* right = this->Truth.Visibility;
    this->Compare(contestant, contestant.VTK ? contestant.VTK->GetVisibility(window, right)
                                             : References::GetVisibility(contestant.Pass,
                                                 this->Stage.GetLights().front(), right));
  }
  catch (const Failure& failure)
  {
    contestant.Note = failure.what();
  }
  this->Leave(contestant);
}

//------------------------------------------------------------------------------
void BenchMeasure::Internals::ReadStatistics(Contestant& contestant)
{
  if (contestant.Pass)
  {
    const Json statistics = Json::parse(contestant.Pass->GetStatistics());
    contestant.Bytes = contestant.Bytes.is_null() ? statistics["bytes"] : contestant.Bytes;
    const Json& counts = statistics["counts"];
    if (counts.contains("megaraysPerSecond"))
    {
      contestant.Megarays.push_back(counts["megaraysPerSecond"]);
    }
  }
}

//------------------------------------------------------------------------------
void BenchMeasure::Internals::Compare(Contestant& contestant, vtkImageData* visibility)
{
  vtkNew<vtkVisibilityMetrics> errors;
  errors->SetImage(visibility);
  errors->SetReference(this->Truth.Visibility);
  errors->Update();
  vtkNew<vtkPictureMetrics> picture;
  picture->SetImage(contestant.Frame);
  picture->SetReference(this->Truth.Frame);
  picture->Update();
  Messages::Check(contestant.Entry->GetId());
  contestant.Error = ParseErrors(errors);
  contestant.Picture = Json::parse(picture->GetJSON());
  contestant.Difference = References::Copy(errors->GetDifferenceImage());
}

//------------------------------------------------------------------------------
bool BenchMeasure::Internals::Needs(const Contestant& contestant) const
{
  return contestant.Note.empty() &&
         contestant.Static.Whole.size() < static_cast<std::size_t>(this->Plan.Frames);
}

//------------------------------------------------------------------------------
// It is what others are compared with in each turn: the median of a few.
void BenchMeasure::Internals::TimeUnshadowed()
{
  OffscreenWindow& window = this->Stage.GetWindow();
  window.GetRenderer()->SetPass(nullptr);
  window.Render();
  std::vector<double> still;
  std::vector<double> moving;
  for (int i = 0; i < 3; ++i)
  {
    this->Stage.MoveCamera();
    still.push_back(window.Render());
    this->Stage.MoveLights();
    moving.push_back(window.Render());
  }
  this->UnshadowedStatic = Statistics::GetMedian(still);
  this->UnshadowedDynamic = Statistics::GetMedian(moving);
  Contestant& none = this->Contestants.front();
  for (std::size_t i = 0; i < still.size(); ++i)
  {
    none.Static.Add(still[i], this->UnshadowedStatic);
    none.Dynamic.Add(moving[i], this->UnshadowedDynamic);
  }
  ++none.Turns;
}

//------------------------------------------------------------------------------
// A pass that is put back makes all of its data anew: that frame is not timed, and the more it takes, the
// more frames follow it.
void BenchMeasure::Internals::Time(Contestant& contestant)
{
  constexpr int mostFrames = 3;
  const auto start = Clock::now();
  OffscreenWindow& window = this->Stage.GetWindow();
  try
  {
    this->Enter(contestant);
    const double settled = window.Render();
    this->ReadStatistics(contestant);
    double timed = 0.0;
    for (int i = 0; i < mostFrames && timed <= settled && this->Needs(contestant); ++i)
    {
      this->Stage.MoveCamera();
      const double still = window.Render();
      this->Stage.MoveLights();
      if (contestant.VTK)
      {
        contestant.VTK->Follow();
      }
      const double moving = window.Render();
      contestant.Static.Add(still, this->UnshadowedStatic);
      contestant.Dynamic.Add(moving, this->UnshadowedDynamic);
      timed += still + moving;
    }
  }
  catch (const Failure& failure)
  {
    contestant.Note = failure.what();
  }
  this->Leave(contestant);
  ++contestant.Turns;
  contestant.Used += SecondsSince(start);
}

//------------------------------------------------------------------------------
// In turns, so that what else the machine does falls on all alike. A slow entry is passed over while it
// has had more time than the others that still need some.
void BenchMeasure::Internals::TimeAll(double seconds, RemainingTime& remaining)
{
  const auto start = Clock::now();
  for (bool left = true; left;)
  {
    left = false;
    this->TimeUnshadowed();
    double used = 0.0;
    int needing = 0;
    for (std::size_t i = 1; i < this->Contestants.size(); ++i)
    {
      if (this->Needs(this->Contestants[i]))
      {
        used += this->Contestants[i].Used;
        ++needing;
      }
    }
    const double mean = needing > 0 ? used / needing : 0.0;
    for (std::size_t i = 1; i < this->Contestants.size(); ++i)
    {
      Contestant& contestant = this->Contestants[i];
      if (!this->Needs(contestant) ||
          (contestant.Static.Whole.size() >= LeastFrames && contestant.Used > mean))
      {
        continue;
      }
      if (SecondsSince(start) > seconds || Interruption::IsAsked())
      {
        return;
      }
      this->Time(contestant);
      remaining.Show(seconds - SecondsSince(start));
      left = true;
    }
  }
}

//------------------------------------------------------------------------------
Json BenchMeasure::Internals::GetJSON(const Contestant& contestant) const
{
  const BenchEntry& entry = *contestant.Entry;
  static const char* const kinds[] = { "none", "technique", "peer" };
  Json json = { { "id", entry.GetId() } };
  if (!entry.Label.empty())
  {
    json["label"] = entry.Label;
  }
  json["technique"] = entry.Kind == BenchEntry::Role::None ? "none" : entry.Technique;
  json["kind"] = kinds[static_cast<int>(entry.Kind)];
  json["setting"] = Json::object();
  for (const auto& value : entry.Values)
  {
    json["setting"][value.first] = value.second;
  }
  json["parameters"] =
    contestant.Pass ? Techniques::GetParameters(contestant.Pass) : json["setting"];
  if (!contestant.Note.empty())
  {
    json["skipped"] = contestant.Note;
    return json;
  }
  if (contestant.Static.Whole.empty() && contestant.Error.is_null())
  {
    json["skipped"] = Interruption::IsAsked() ? "interrupted before it was measured"
                                              : "the time was over before it was measured";
    return json;
  }
  json["error"] = contestant.Error;
  json["picture"] = contestant.Picture;
  json["time"] = nullptr;
  if (!contestant.Static.Whole.empty())
  {
    const Contestant& none = this->Contestants.front();
    json["time"] = { { "static", contestant.Static.GetJSON(none.Static) },
      { "dynamic", contestant.Dynamic.GetJSON(none.Dynamic) }, { "turns", contestant.Turns },
      { "build_milliseconds", Statistics::GetMedian(contestant.Dynamic.Added) -
                                Statistics::GetMedian(contestant.Static.Added) } };
  }
  json["bytes"] = nullptr;
  if (!contestant.Bytes.is_null())
  {
    json["bytes"] = contestant.Bytes["total"];
    json["bytes_by_name"] = contestant.Bytes;
    json["bytes_by_name"].erase("total");
  }
  json["megarays_per_second"] = nullptr;
  if (!contestant.Megarays.empty())
  {
    json["megarays_per_second"] = Statistics::GetMedian(contestant.Megarays);
  }
  return json;
}

//------------------------------------------------------------------------------
BenchMeasure::BenchMeasure(const BenchPlan& plan, const BenchCase& one)
  : Internal(std::make_unique<Internals>(plan, one))
{
}

//------------------------------------------------------------------------------
BenchMeasure::~BenchMeasure() = default;

//------------------------------------------------------------------------------
void BenchMeasure::Run(double seconds, double later, const std::string& title)
{
  Internals& my = *this->Internal;
  const auto start = Clock::now();
  if (my.Case.ReferenceSamples > 0)
  {
    my.DrawReference();
  }
  RemainingTime remaining(title, later);
  if (my.Truth.Visibility && !Interruption::IsAsked())
  {
    my.MeasureErrors(seconds - SecondsSince(start), remaining);
  }
  if (!Interruption::IsAsked())
  {
    my.TimeAll(seconds - SecondsSince(start), remaining);
  }
  my.Stage.GetWindow().GetRenderer()->SetPass(nullptr);
}

//------------------------------------------------------------------------------
bool BenchMeasure::IsComplete() const
{
  const Internals& my = *this->Internal;
  return std::none_of(my.Contestants.begin() + 1, my.Contestants.end(),
    [](const Contestant& contestant)
    { return contestant.Note.empty() && contestant.Static.Whole.empty(); });
}

//------------------------------------------------------------------------------
Json BenchMeasure::GetJSON() const
{
  const Internals& my = *this->Internal;
  Json json = { { "id", my.Case.Id } };
  if (!my.Case.Axis.empty())
  {
    json["axis"] = my.Case.Axis;
    json["value"] = my.Case.GetValue(my.Stage.GetScene());
  }
  if (!my.Case.Published.empty())
  {
    json["published"] = my.Case.Published;
  }
  json["scene"] = my.SceneJSON;
  json["scene"]["lights"] = my.Stage.GetLights().size();
  json["size"] = my.Case.Scene.Size;
  json["samples_per_pixel"] = my.Case.Scene.SamplesPerPixel;
  json["reference"] = nullptr;
  if (!my.Noise.is_null())
  {
    json["reference"] = { { "technique", ReferenceTechnique },
      { "samples", my.Case.ReferenceSamples }, { "milliseconds", my.Truth.Milliseconds },
      { "receiver_pixels", my.Noise["receiver_pixels"] },
      { "penumbra_pixels", my.Noise["penumbra"]["pixels"] },
      { "noise",
        { { "rmse", my.Noise["rmse"] }, { "penumbra_rmse", my.Noise["penumbra"]["rmse"] } } } };
  }
  json["entries"] = Json::array();
  for (const Contestant& contestant : my.Contestants)
  {
    json["entries"].push_back(my.GetJSON(contestant));
  }
  return json;
}

//------------------------------------------------------------------------------
std::vector<BenchPicture> BenchMeasure::GetPictures() const
{
  const Internals& my = *this->Internal;
  std::vector<const Contestant*> best; // of each technique, in the entries' order
  for (const Contestant& contestant : my.Contestants)
  {
    if (!contestant.Difference)
    {
      continue;
    }
    const auto known = std::find_if(best.begin(), best.end(),
      [&contestant](const Contestant* one)
      { return one->Entry->Technique == contestant.Entry->Technique; });
    const auto error = [](const Contestant& one)
    {
      const Json& inPenumbra = one.Error["penumbra"]["rmse"];
      return (inPenumbra.is_null() ? one.Error["rmse"] : inPenumbra).get<double>();
    };
    if (known == best.end())
    {
      best.push_back(&contestant);
    }
    else if (error(contestant) < error(**known))
    {
      *known = &contestant;
    }
  }
  std::vector<BenchPicture> pictures;
  if (my.Truth.Frame)
  {
    pictures.push_back({ my.Case.Id, "reference", my.Truth.Frame, nullptr });
  }
  for (const Contestant* one : best)
  {
    pictures.push_back({ my.Case.Id, one->Entry->GetId(), one->Frame, one->Difference });
  }
  return pictures;
}

//------------------------------------------------------------------------------
Json BenchMeasure::GetGL() const
{
  auto* window =
    vtkOpenGLRenderWindow::SafeDownCast(this->Internal->Stage.GetWindow().GetOpenWindow());
  Json json;
  std::istringstream lines(window->ReportCapabilities());
  for (std::string line; std::getline(lines, line);)
  {
    for (const char* what : { "vendor", "renderer", "version" })
    {
      const std::string start = std::string("OpenGL ") + what + " string:";
      if (line.rfind(start, 0) == 0)
      {
        json[what] = line.substr(line.find_first_not_of(' ', start.size()));
      }
    }
  }
  return json;
}
