// SPDX-License-Identifier: BSD-3-Clause
#include "BenchResults.h"

#include "BenchAnalysis.h"
#include "BenchLibraries.h"
#include "BenchMeasure.h"
#include "Errors.h"

#include "vtkDelimitedTextWriter.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <vtksys/SystemInformation.hxx>

#include <cstdio>
#include <ctime>
#include <memory>

namespace
{
constexpr int FormatVersion = 1;

std::string GetDate()
{
  const std::time_t now = std::time(nullptr);
  std::tm utc = {};
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof(text), "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

nlohmann::ordered_json DescribeMachine()
{
  vtksys::SystemInformation system;
  system.RunCPUCheck();
  system.RunOSCheck();
  system.RunMemoryCheck();
  return { { "processor", std::string(system.GetModelName()) },
    { "cores", system.GetNumberOfLogicalCPU() },
    { "memory_bytes", 1048576.0 * static_cast<double>(system.GetTotalPhysicalMemory()) },
    { "system", std::string(system.GetOSName()) + " " + system.GetOSRelease() + " " +
                  system.GetOSPlatform() } };
}

nlohmann::ordered_json DescribeLibraries()
{
  nlohmann::ordered_json json;
  for (const auto& library : BenchLibraries)
  {
    if (*library.second)
    {
      json[library.first] = library.second;
    }
  }
  return json;
}

/** A column of results.csv: its name, and where an entry has its figure. */
struct Column
{
  const char* Name;
  const char* Pointer;
};

constexpr Column Columns[] = { { "technique", "/technique" }, { "kind", "/kind" },
  { "entry", "/id" }, { "rmse", "/error/rmse" }, { "bias", "/error/bias" }, { "p99", "/error/p99" },
  { "maximum", "/error/maximum" }, { "penumbra_rmse", "/error/penumbra/rmse" },
  { "penumbra_bias", "/error/penumbra/bias" }, { "penumbra_p99", "/error/penumbra/p99" },
  { "penumbra_maximum", "/error/penumbra/maximum" }, { "weighted_rmse", "/error/weighted_rmse" },
  { "penumbra_weighted_rmse", "/error/penumbra/weighted_rmse" },
  { "correctness_percent", "/picture/correctness_percent" }, { "psnr_db", "/picture/psnr_db" },
  { "static_ms", "/time/static/median" }, { "static_added_ms", "/time/static/added/median" },
  { "static_added_lower_ms", "/time/static/added/lower" },
  { "static_added_upper_ms", "/time/static/added/upper" }, { "static_ratio", "/time/static/ratio" },
  { "static_frames", "/time/static/frames" }, { "dynamic_ms", "/time/dynamic/median" },
  { "dynamic_added_ms", "/time/dynamic/added/median" },
  { "dynamic_added_lower_ms", "/time/dynamic/added/lower" },
  { "dynamic_added_upper_ms", "/time/dynamic/added/upper" },
  { "dynamic_ratio", "/time/dynamic/ratio" }, { "build_ms", "/time/build_milliseconds" },
  { "bytes", "/bytes" }, { "megarays_per_second", "/megarays_per_second" },
  { "skipped", "/skipped" } };

std::string GetCell(const nlohmann::ordered_json& entry, const char* pointer)
{
  const nlohmann::ordered_json::json_pointer place(pointer);
  if (!entry.contains(place) || entry[place].is_null())
  {
    return "";
  }
  return entry[place].is_string() ? entry[place].get<std::string>() : entry[place].dump();
}

// VTK's writer puts quotes around a cell, and leaves those within as they are.
std::string Quote(std::string cell)
{
  for (std::size_t at = cell.find('"'); at != std::string::npos; at = cell.find('"', at + 2))
  {
    cell.insert(at, 1, '"');
  }
  return cell;
}

//------------------------------------------------------------------------------
std::string WriteCSV(const nlohmann::ordered_json& results)
{
  vtkNew<vtkTable> table;
  const auto addColumn = [&table](const char* name)
  {
    vtkNew<vtkStringArray> column;
    column->SetName(name);
    table->AddColumn(column);
    return column.Get();
  };
  vtkStringArray* cases = addColumn("case");
  for (const Column& column : Columns)
  {
    addColumn(column.Name);
  }
  for (const auto& one : results["cases"])
  {
    for (const auto& entry : one["entries"])
    {
      cases->InsertNextValue(Quote(one["id"].get<std::string>()));
      for (const Column& column : Columns)
      {
        vtkStringArray::SafeDownCast(table->GetColumnByName(column.Name))
          ->InsertNextValue(Quote(GetCell(entry, column.Pointer)));
      }
    }
  }
  vtkNew<vtkDelimitedTextWriter> writer;
  writer->SetInputData(table);
  writer->SetWriteToOutputString(true);
  writer->Write();
  const std::unique_ptr<char[]> text(writer->RegisterAndGetOutputString());
  return text.get();
}
}

//------------------------------------------------------------------------------
BenchResults::BenchResults(const BenchPlan& plan, const std::string& command)
  : Plan(plan)
{
  this->Json = { { "format", { { "name", "softshadows-results" }, { "version", FormatVersion } } },
    { "suite", plan.Name }, { "title", plan.Title }, { "about", plan.About }, { "complete", true },
    { "date", GetDate() }, { "command", command }, { "machine", DescribeMachine() },
    { "gl", nullptr }, { "libraries", DescribeLibraries() },
    { "seeds", { { "reference", { 1, 2 } },
                 { "techniques", "ray-traced 0; others none, patterns depend on pixels alone" } } },
    { "budget_seconds", plan.GetBudget() }, { "frames_wanted", plan.Frames },
    { "failures", nlohmann::ordered_json::array() }, { "published", plan.Published },
    { "cases", nlohmann::ordered_json::array() }, { "scaling", nlohmann::ordered_json::array() } };
}

//------------------------------------------------------------------------------
void BenchResults::Add(const BenchMeasure& measure)
{
  nlohmann::ordered_json one = measure.GetJSON();
  BenchAnalysis::AddToCase(one, this->Plan);
  this->Json["cases"].push_back(one);
  this->Json["scaling"] = BenchAnalysis::GetScaling(this->Json["cases"]);
  this->Json["gl"] = measure.GetGL();
  if (!measure.IsComplete())
  {
    this->SetIncomplete();
  }
  const auto pictures = measure.GetPictures();
  this->Pictures.insert(this->Pictures.end(), pictures.begin(), pictures.end());
}

//------------------------------------------------------------------------------
void BenchResults::AddFailure(const std::string& id, const std::string& reason)
{
  this->Json["failures"].push_back({ { "case", id }, { "reason", reason } });
  this->SetIncomplete();
}

//------------------------------------------------------------------------------
std::string BenchResults::GetFailure() const
{
  const auto& failures = this->Json["failures"];
  return failures.empty() ? ""
                          : failures.front()["case"].get<std::string>() + ": " +
                              failures.front()["reason"].get<std::string>();
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::string>> BenchResults::GetFiles() const
{
  // Names of files need not be UTF-8.
  const std::string text =
    this->Json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  const auto results = nlohmann::ordered_json::parse(text);
  return { { FileNames[0], text + "\n" }, { FileNames[1], WriteCSV(results) },
    { FileNames[2], MakeBenchReport(results, this->Pictures) } };
}

//------------------------------------------------------------------------------
void BenchResults::PrintTable() const
{
  const auto& one = this->Json["cases"].back();
  const std::string noise = GetCell(one, "/reference/noise/rmse");
  std::printf("%s: %s triangles, %sx%s, %s\n",
    Messages::GetPrintable(one["id"].get<std::string>()).c_str(),
    one["scene"]["triangles"].dump().c_str(), one["size"][0].dump().c_str(),
    one["size"][1].dump().c_str(),
    noise.empty() ? "errors are not measured"
                  : ("the reference's noise " + noise.substr(0, 6)).c_str());
  std::printf("%-34s %9s %9s %9s %11s %12s %7s\n", "", "RMSE", "penumbra", "x N.L", "static, ms",
    "dynamic, ms", "frames");
  const auto number =
    [](const nlohmann::ordered_json& entry, const char* pointer, const char* format)
  {
    const std::string cell = GetCell(entry, pointer);
    char text[32] = "-";
    if (!cell.empty())
    {
      std::snprintf(text, sizeof(text), format, std::stod(cell));
    }
    return std::string(text);
  };
  for (const auto& entry : one["entries"])
  {
    std::printf("%-34s ", Messages::GetPrintable(entry["id"].get<std::string>()).c_str());
    if (entry.contains("skipped"))
    {
      std::printf("not measured: %s\n", entry["skipped"].get<std::string>().c_str());
      continue;
    }
    std::printf("%9s %9s %9s %11s %12s %7s\n", number(entry, "/error/rmse", "%.4f").c_str(),
      number(entry, "/error/penumbra/rmse", "%.4f").c_str(),
      number(entry, "/error/penumbra/weighted_rmse", "%.4f").c_str(),
      number(entry, "/time/static/added/median", "%.1f").c_str(),
      number(entry, "/time/dynamic/added/median", "%.1f").c_str(),
      number(entry, "/time/static/frames", "%.0f").c_str());
  }
  std::fflush(stdout);
}
