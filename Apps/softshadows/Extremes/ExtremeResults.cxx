// SPDX-License-Identifier: BSD-3-Clause
#include "ExtremeResults.h"

#include "Errors.h"

#include <algorithm>
#include <cstdio>
#include <sstream>

namespace
{
using Table = nlohmann::ordered_json;

constexpr const char* Figures[] = { "change", "growth", "wrong", "bias", "motion" };

Table GetBounds(const ExtremeCase& one)
{
  Table bounds = Table::object();
  const std::optional<double> values[] = { one.Change, one.Growth, one.Wrong, one.Bias,
    one.Motion };
  for (std::size_t i = 0; i < std::size(Figures); ++i)
  {
    if (values[i])
    {
      bounds[Figures[i]] = *values[i];
    }
  }
  return bounds;
}

// The value that is furthest beyond its bounds, or nearest to them.
Table FindWorst(const Table& values, const Table& bounds)
{
  Table worst;
  double most = -1e9;
  for (const Table& cell : values)
  {
    double share = cell["status"] == "failed" ? 1e6 : cell["status"] == "told" ? -1e6 : 0.0;
    for (const auto& bound : bounds.items())
    {
      if (cell.contains(bound.key()) && share >= 0.0)
      {
        const double value = cell[bound.key()];
        share = std::max(share, share + value / std::max(1e-9, bound.value().get<double>()));
      }
    }
    if (share > most)
    {
      most = share;
      worst = cell;
    }
  }
  return worst;
}

std::string GetCell(const Table& cell, const char* name)
{
  return cell.contains(name) ? cell[name].dump() : "";
}
}

//------------------------------------------------------------------------------
ExtremeResults::ExtremeResults(const BenchPlan& plan, const std::string& command)
{
  this->Json = { { "format", { { "name", "softshadows-extremes" }, { "version", 1 } } },
    { "suite", plan.Name }, { "title", plan.Title }, { "about", plan.About }, { "complete", true },
    { "command", command }, { "size", plan.Default.Scene.Size },
    { "reference", plan.Default.ReferenceSamples }, { "failures", Table::array() },
    { "cases", Table::array() } };
}

//------------------------------------------------------------------------------
void ExtremeResults::Add(const ExtremeCase& one, const Table& techniques)
{
  const Table bounds = GetBounds(one);
  Table added = { { "name", one.Name }, { "about", one.About },
    { "ordinary", one.Ordinary.GetText() }, { "bounds", bounds }, { "techniques", techniques } };
  std::printf("%s: %zu values, ordinary %s, bounds %s\n", one.Name.c_str(), one.Values.size(),
    one.Ordinary.GetText().c_str(), bounds.dump().c_str());
  for (auto& technique : added["techniques"].items())
  {
    Table& found = technique.value();
    const auto count = [values = found["values"]](const char* status)
    {
      return std::count_if(values.begin(), values.end(),
        [status](const Table& cell) { return cell["status"] == status; });
    };
    found["failed"] = count("failed");
    found["told"] = count("told");
    const Table worst = FindWorst(found["values"], bounds);
    found["worst"] = worst;
    std::string text;
    for (const char* figure : Figures)
    {
      const std::string cell = bounds.contains(figure) ? GetCell(found["worst"], figure) : "";
      text += cell.empty() ? "" : std::string(figure) + " " + cell + "  ";
    }
    std::printf("  %-20s ordinary %-8s %s at %s%s %s\n", technique.key().c_str(),
      found["ordinary"].dump().c_str(), text.c_str(), found["worst"].value("at", "-").c_str(),
      found["failed"] > 0 ? (" FAILED " + found["failed"].dump()).c_str()
      : found["told"] > 0 ? " told"
                          : "",
      Messages::GetPrintable(found["worst"].value("note", "")).c_str());
  }
  std::fflush(stdout);
  this->Json["cases"].push_back(added);
}

//------------------------------------------------------------------------------
void ExtremeResults::AddFailure(const std::string& name, const std::string& reason)
{
  this->Json["failures"].push_back({ { "case", name }, { "reason", reason } });
  this->SetIncomplete();
}

//------------------------------------------------------------------------------
std::string ExtremeResults::GetFailure() const
{
  if (!this->Json["failures"].empty())
  {
    const Table& first = this->Json["failures"].front();
    return first["case"].get<std::string>() + ": " + first["reason"].get<std::string>();
  }
  int failed = 0;
  std::string first;
  for (const Table& one : this->Json["cases"])
  {
    for (const auto& technique : one["techniques"].items())
    {
      for (const Table& cell : technique.value()["values"])
      {
        if (cell["status"] == "failed" && failed++ == 0)
        {
          first = technique.key() + " in case \"" + one["name"].get<std::string>() + "\" at " +
                  cell["at"].get<std::string>();
        }
      }
    }
  }
  return failed == 0 ? ""
                     : first + " is out of bounds" +
                         (failed == 1 ? "." : ", and " + std::to_string(failed - 1) + " more.");
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::string>> ExtremeResults::GetFiles() const
{
  std::ostringstream csv;
  csv << "case,technique,at,status,error";
  for (const char* figure : Figures)
  {
    csv << "," << figure;
  }
  csv << "\n";
  for (const Table& one : this->Json["cases"])
  {
    for (const auto& technique : one["techniques"].items())
    {
      for (const Table& cell : technique.value()["values"])
      {
        csv << one["name"].get<std::string>() << ",\"" << technique.key() << "\","
            << cell["at"].get<std::string>() << "," << cell["status"].get<std::string>() << ","
            << GetCell(cell, "error");
        for (const char* figure : Figures)
        {
          csv << "," << GetCell(cell, figure);
        }
        csv << "\n";
      }
    }
  }
  return { { "results.json",
             this->Json.dump(1, ' ', false, Table::error_handler_t::replace) + "\n" },
    { "results.csv", csv.str() } };
}
