// SPDX-License-Identifier: BSD-3-Clause
// softshadows compare (MODEL... | --scene NAME).

#include "Compare.h"

#include "Errors.h"
#include "Models.h"
#include "OffscreenWindow.h"
#include "Outputs.h"
#include "Progress.h"
#include "References.h"
#include "StandardOutput.h"
#include "Statistics.h"
#include "Values.h"

#include "vtkAreaLight.h"
#include "vtkPictureMetrics.h"
#include "vtkVisibilityMetrics.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

namespace
{
using Json = nlohmann::ordered_json;
using Image = vtkSmartPointer<vtkImageData>;

/** A line of the table: a technique, or no shadows at all. */
struct Row
{
  std::string Name;
  vtkSmartPointer<vtkShadowPass> Pass; // none: no shadows
  std::string Note;                    // why it was not measured
  vtkNew<vtkVisibilityMetrics> Visibility;
  vtkNew<vtkPictureMetrics> Picture;
  Image Frame;
  std::vector<double> Times;
  unsigned long long Bytes = 0;
};
using Rows = std::vector<std::unique_ptr<Row>>;

//------------------------------------------------------------------------------
std::vector<std::string> GetTechniques(const CompareOptions& options)
{
  std::vector<std::string> names;
  if (options.Techniques.empty())
  {
    names = Techniques::GetNames();
    std::stable_partition(names.begin(), names.end(),
      [](const std::string& name) { return Techniques::Describe(name).value("hard", false); });
    return names;
  }
  for (const std::string& name : Values::Split(options.Techniques))
  {
    Techniques::Describe(name); // a failure where there is none
    if (std::find(names.begin(), names.end(), name) == names.end())
    {
      names.push_back(name);
    }
  }
  return names;
}

//------------------------------------------------------------------------------
// A first row without shadows, then the techniques.
Rows MakeRows(const CompareOptions& options)
{
  const auto names = GetTechniques(options);
  options.Parameters.CheckSettings(names);
  Rows rows;
  rows.push_back(std::make_unique<Row>());
  rows.back()->Name = "none";
  for (const std::string& name : names)
  {
    rows.push_back(std::make_unique<Row>());
    rows.back()->Name = name;
    TechniqueOptions parameters = options.Parameters;
    parameters.Measured = true;
    rows.back()->Pass = parameters.Create(name, false);
  }
  return rows;
}

//------------------------------------------------------------------------------
void Measure(Row& row, OffscreenWindow& window, vtkAreaLight* light, const Reference& reference)
{
  window.GetRenderer()->SetPass(row.Pass);
  window.Render();
  while (row.Pass && !row.Pass->IsFinished())
  {
    window.Render(); // frames add up
  }
  const Image visibility = References::GetVisibility(row.Pass, light, reference.Visibility);
  row.Frame = window.Grab();
  row.Visibility->SetImage(visibility);
  row.Visibility->SetReference(reference.Visibility);
  row.Visibility->Update();
  Messages::Check(row.Name);
  row.Picture->SetImage(row.Frame);
  row.Picture->SetReference(reference.Frame);
  row.Picture->Update();
  Messages::Check(row.Name);
  if (row.Pass)
  {
    row.Bytes = Json::parse(row.Pass->GetStatistics())["bytes"]["total"];
  }
}

//------------------------------------------------------------------------------
// Turn about, so that what else the machine does falls on all alike. A pass that is put back builds
// its light data anew: that frame is not timed, the next one is.
void Time(Rows& rows, OffscreenWindow& window, int frames)
{
  const auto measured = static_cast<unsigned long>(
    std::count_if(rows.begin(), rows.end(), [](const auto& row) { return row->Note.empty(); }));
  Progress progress("times, " + std::to_string(frames) + " frames", measured * frames);
  for (int frame = 0; frame < frames; ++frame)
  {
    for (auto& row : rows)
    {
      if (row->Note.empty())
      {
        window.GetRenderer()->SetPass(row->Pass);
        window.Render();
        row->Times.push_back(window.Render());
        progress.Advance();
      }
    }
  }
}

//------------------------------------------------------------------------------
// After everything else: the difference images belong to the metrics.
void Stage(
  const CompareOptions& options, const Rows& rows, const Reference& reference, Outputs& outputs)
{
  const std::string folder = options.Output + "/";
  outputs.StagePicture(folder + "reference.png", reference.Frame);
  for (const auto& row : rows)
  {
    if (row->Note.empty())
    {
      outputs.StagePicture(folder + row->Name + ".png", row->Frame);
      outputs.StagePicture(
        folder + row->Name + "-difference.png", row->Visibility->GetDifferenceImage());
    }
  }
}

//------------------------------------------------------------------------------
Json GetJSON(
  const CompareOptions& options, const Rows& rows, const Reference& reference, const Scene& scene)
{
  const double plain = Statistics::GetMedian(rows.front()->Times);
  Json json = { { "scene", scene.GetJSON() }, { "size", options.Scene.Size },
    { "frames", options.Frames },
    { "reference", { { "technique", ReferenceTechnique }, { "samples", options.ReferenceSamples },
                     { "milliseconds", reference.Milliseconds } } },
    { "unshadowed_milliseconds", plain }, { "techniques", Json::array() } };
  for (const auto& row : rows)
  {
    Json one = { { "technique", row->Name } };
    if (row->Pass)
    {
      one["parameters"] = Techniques::GetParameters(row->Pass);
    }
    if (row->Note.empty())
    {
      const double time = Statistics::GetMedian(row->Times);
      one["visibility"] = Json::parse(row->Visibility->GetJSON());
      one["picture"] = Json::parse(row->Picture->GetJSON());
      one["milliseconds"] = time;
      one["added_milliseconds"] = time - plain;
      one["ratio"] = time / plain;
      one["bytes"] = row->Bytes;
    }
    else
    {
      one["skipped"] = row->Note;
    }
    json["techniques"].push_back(one);
  }
  return json;
}

//------------------------------------------------------------------------------
void PrintTable(
  const CompareOptions& options, const Rows& rows, const Reference& reference, const Scene& scene)
{
  const double plain = Statistics::GetMedian(rows.front()->Times);
  std::printf("%s: %lld triangles, %s light, %dx%d; reference: %d rays a pixel, %.0f ms; "
              "unshadowed frame %.1f ms\n",
    Messages::GetPrintable(scene.Name).c_str(), static_cast<long long>(scene.Triangles),
    GetShapeName(scene.Light).c_str(), options.Scene.Size[0], options.Scene.Size[1],
    options.ReferenceSamples, reference.Milliseconds, plain);
  std::printf("%-20s %8s %8s %8s %8s %8s %8s %9s %8s %10s %9s\n", "technique", "RMSE", "penumbra",
    "x N.L", "bias", "P99", "max", "correct%", "PSNR", "added ms", "MiB");
  for (const auto& row : rows)
  {
    if (!row->Note.empty())
    {
      std::printf("%-20s not measured: %s\n", row->Name.c_str(), row->Note.c_str());
      continue;
    }
    const auto& errors = row->Visibility;
    std::printf("%-20s %8.4f %8.4f %8.4f %+8.4f %8.4f %8.4f %9.2f %8.2f %10.1f %9.2f\n",
      row->Name.c_str(), errors->GetRMSE(), errors->GetPenumbraRMSE(),
      errors->GetPenumbraWeightedRMSE(), errors->GetBias(), errors->GetP99(), errors->GetMaximum(),
      row->Picture->GetCorrectness(), row->Picture->GetPSNR(),
      Statistics::GetMedian(row->Times) - plain,
      static_cast<double>(row->Bytes) / (1024.0 * 1024.0));
  }
}
}

//------------------------------------------------------------------------------
void CompareTechniques(const CompareOptions& options)
{
  Rows rows = JudgeUsage(
    [&options]
    {
      options.Scene.Check();
      return MakeRows(options);
    });
  const auto referencePass = References::MakePass(options.ReferenceSamples);
  Outputs outputs(Models::GetFiles(options.Scene.Models));
  if (!options.Output.empty())
  {
    outputs.PlanFolder(options.Output);
  }

  OffscreenWindow window(options.Scene.Size.data(), options.Scene.SamplesPerPixel);
  const Scene scene = options.Scene.Build(window.GetRenderer());
  Messages::ShowWarnings();
  const Reference reference = References::Draw(window, referencePass, scene.Light);
  for (auto& row : rows)
  {
    if (row->Pass)
    {
      for (vtkAreaLight* light : scene.Lights)
      {
        row->Note = row->Note.empty() ? Techniques::FindUnsupported(
                                          row->Pass, window.GetOpenWindow(), GetShapeName(light))
                                      : row->Note;
      }
    }
    if (row->Note.empty())
    {
      Measure(*row, window, scene.Light, reference);
    }
  }
  Time(rows, window, options.Frames);
  window.GetRenderer()->SetPass(nullptr);
  if (!options.Output.empty())
  {
    Stage(options, rows, reference, outputs);
    outputs.Commit();
  }

  Messages::ShowWarnings();
  if (options.AsJson)
  {
    StandardOutput::Print(GetJSON(options, rows, reference, scene));
    return;
  }
  PrintTable(options, rows, reference, scene);
}
