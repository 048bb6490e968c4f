// SPDX-License-Identifier: BSD-3-Clause
#include "BenchReport.h"

#include "BenchCurves.h"
#include "BenchPictures.h"
#include "BenchReportTemplate.h"
#include "BenchTables.h"
#include "Errors.h"

#include <kainjow/mustache.hpp>

#include <algorithm>
#include <memory>

using namespace BenchFigures;

namespace
{
namespace Mustache = kainjow::mustache;

constexpr int pictureWidth = 320;

//------------------------------------------------------------------------------
/** Empty text and null become false, so that sections of the template can ask for them. */
Mustache::data Convert(const Json& value)
{
  if (value.is_object())
  {
    Mustache::data converted(Mustache::data::type::object);
    for (const auto& item : value.items())
    {
      converted.set(item.key(), Convert(item.value()));
    }
    return converted;
  }
  if (value.is_array())
  {
    Mustache::data converted(Mustache::data::type::list);
    for (const Json& item : value)
    {
      converted.push_back(Convert(item));
    }
    return converted;
  }
  if (value.is_boolean())
  {
    return value.get<bool>();
  }
  const std::string text = value.is_string() ? value.get<std::string>()
                           : value.is_null() ? ""
                                             : value.dump();
  return text.empty() ? Mustache::data(false) : Mustache::data(text);
}

//------------------------------------------------------------------------------
std::string Join(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

//------------------------------------------------------------------------------
/** An object's members in a line, "vtk 9.1.0, embree 3.13.5". */
std::string JoinMembers(const Json& object, const std::string& between)
{
  std::vector<std::string> words;
  if (object.is_object())
  {
    for (const auto& item : object.items())
    {
      words.push_back(item.key() + between + FindText(object, { item.key() }));
    }
  }
  return Join(words);
}

//------------------------------------------------------------------------------
std::string JoinSize(const Json& size)
{
  const bool isPair = size.is_array() && size.size() == 2;
  return isPair ? size[0].dump() + " \u00d7 " + size[1].dump() : "";
}

//------------------------------------------------------------------------------
std::string DescribeScene(const Json& oneCase)
{
  const Json& scene = Find(oneCase, { "scene" });
  const Json& light = Find(scene, { "light" });
  std::vector<std::string> words;
  const auto add = [&words](
                     const std::string& before, const std::string& value, const std::string& after)
  {
    if (!value.empty())
    {
      words.push_back(before + value + after);
    }
  };
  add("", FindText(scene, { "name" }), "");
  add("", WriteCount(FindNumber(scene, { "triangles" })), " triangles");
  const Number lights = FindNumber(scene, { "lights" });
  add("", lights && *lights > 1.0 ? WriteCount(lights) : "", " lights");
  std::string size;
  for (const char* key : { "radius", "width", "height", "angle_degrees" })
  {
    const std::string value = WriteShort(FindNumber(light, { key }));
    size += value.empty() ? "" : std::string(" ") + key + " " + value;
  }
  add("", FindText(light, { "shape" }), " light" + (size.empty() ? "" : "," + size));
  add("", JoinSize(Find(oneCase, { "size" })), " pixels");
  const Number samples = FindNumber(oneCase, { "samples_per_pixel" });
  add("", samples && *samples > 0.0 ? WriteCount(samples) : "", " samples a pixel");
  return Join(words);
}

//------------------------------------------------------------------------------
Json GetReference(const Json& oneCase)
{
  const Json& reference = Find(oneCase, { "reference" });
  if (!reference.is_object())
  {
    return nullptr;
  }
  const Number penumbraNoise = GetNoise(oneCase, "penumbra");
  const Number noise = GetNoise(oneCase, "all");
  return { { "reference_technique", FindText(reference, { "technique" }) },
    { "samples", WriteCount(FindNumber(reference, { "samples" })) },
    { "reference_ms", WriteMilliseconds(FindNumber(reference, { "milliseconds" })) },
    { "receivers", WriteCount(FindNumber(reference, { "receiver_pixels" })) },
    { "penumbra_pixels", WriteCount(FindNumber(reference, { "penumbra_pixels" })) },
    { "noise", WriteError(noise) }, { "penumbra_noise", WriteError(penumbraNoise) } };
}

//------------------------------------------------------------------------------
/** Draws charts when there is the first to draw: without any, no display is needed. */
class LazyPainter
{
public:
  Json Draw(const CurveChart& chart, const std::string& caption)
  {
    if (chart.Shown.empty())
    {
      return nullptr;
    }
    if (!this->Drawer)
    {
      this->Drawer = std::make_unique<ChartPainter>();
    }
    return { { "caption", caption }, { "png", this->Drawer->Draw(chart.Content) },
      { "left_out", Join(chart.LeftOut) } };
  }

private:
  std::unique_ptr<ChartPainter> Drawer;
};

//------------------------------------------------------------------------------
/** What a row of charts shows, and their legend. */
struct Charts
{
  Json Drawn = Json::array();
  std::vector<CurveStyles::Key> Shown;
  bool HasFront = false;
  bool HasNoise = false;

  void Add(LazyPainter& painter, const CurveChart& chart, const std::string& caption)
  {
    Json drawn = painter.Draw(chart, caption);
    if (!drawn.is_null())
    {
      this->Drawn.push_back(std::move(drawn));
      this->Shown.insert(this->Shown.end(), chart.Shown.begin(), chart.Shown.end());
      this->HasFront = this->HasFront || chart.Content.Curves.size() > chart.Shown.size();
      this->HasNoise = this->HasNoise || chart.Content.Floor > 0.0;
    }
  }
  Json Get(const CurveStyles& styles) const
  {
    return { { "has_charts", !this->Drawn.empty() }, { "charts", this->Drawn },
      { "legend", styles.GetLegend(this->Shown) }, { "has_front", this->HasFront },
      { "has_noise", this->HasNoise } };
  }
};

//------------------------------------------------------------------------------
Json GetPictures(const Json& oneCase, const std::vector<BenchPicture>& pictures)
{
  Json figures = Json::array();
  for (const BenchPicture& one : pictures)
  {
    if (one.Case == FindText(oneCase, { "id" }) && (one.Picture || one.Difference))
    {
      const Json& entry = FindEntry(oneCase, one.Entry);
      const auto shrink = [](vtkImageData* image)
      { return BenchPictures::Shrink(image, pictureWidth); };
      figures.push_back({ { "name", GetName(oneCase, one.Entry) },
        { "jpeg", one.Picture ? BenchPictures::EncodeJPEG(shrink(one.Picture)) : "" },
        { "png", one.Difference ? BenchPictures::EncodePNG(shrink(one.Difference)) : "" },
        { "error", WriteError(GetError(entry, "penumbra")) } });
    }
  }
  return figures;
}

//------------------------------------------------------------------------------
void SetRows(Json& page, const std::string& name, Json rows)
{
  page["has_" + name] = !rows.empty();
  page[name] = std::move(rows);
}

//------------------------------------------------------------------------------
Json GetCase(const Json& results, const Json& oneCase, const std::vector<BenchPicture>& pictures,
  const CurveStyles& styles, LazyPainter& painter)
{
  Charts charts;
  for (const std::string time : { "static", "dynamic" })
  {
    for (const std::string pixels : { "penumbra", "all" })
    {
      charts.Add(painter, BenchCurves::MakeErrorChart(oneCase, pixels, time, styles),
        "Error over " + std::string(pixels == "all" ? "all receivers" : "the penumbra") +
          " against added time; the " + DescribeTime(time) + ".");
    }
  }
  Json page = { { "id", FindText(oneCase, { "id" }) }, { "scene", DescribeScene(oneCase) },
    { "reference", GetReference(oneCase) }, { "advice", BenchTables::Recommend(oneCase) },
    { "published_for", FindText(oneCase, { "published" }) } };
  page.update(charts.Get(styles));
  SetRows(page, "under_error", BenchTables::GetUnderError(oneCase));
  SetRows(page, "under_time", BenchTables::GetUnderTime(oneCase));
  SetRows(page, "entries",
    BenchTables::GetEntries(oneCase, FindNumber(results, { "frames_wanted" }).value_or(0.0)));
  page["any_few"] = std::any_of(page["entries"].begin(), page["entries"].end(),
    [](const Json& row) { return row["static"]["few"] != "" || row["dynamic"]["few"] != ""; });
  SetRows(page, "equal_error", BenchTables::GetEqualError(oneCase));
  SetRows(page, "equal_time", BenchTables::GetEqualTime(oneCase));
  SetRows(page, "pictures", GetPictures(oneCase, pictures));
  SetRows(page, "published", BenchTables::GetPublished(oneCase));
  const bool graded = Find(oneCase, { "reference" }).is_object();
  page["graded"] = graded;
  page["columns"] = graded ? 14 : 7;
  page["has_advice"] =
    page["advice"] != "" || page["has_under_error"] == true || page["has_under_time"] == true;
  return page;
}

//------------------------------------------------------------------------------
Json GetScaling(const Json& results, const CurveStyles& styles, LazyPainter& painter)
{
  const Json& scaling = FindList(results, { "scaling" });
  if (scaling.empty())
  {
    return nullptr;
  }
  Charts charts;
  for (const std::string& axis : FindTexts(scaling, "axis"))
  {
    for (const std::string time : { "static", "dynamic" })
    {
      charts.Add(painter, BenchCurves::MakeScalingChart(scaling, axis, time, styles),
        "Added time against " + axis + "; the " + DescribeTime(time) + ".");
    }
  }
  Json page = charts.Get(styles);
  page.update(BenchTables::GetExponents(scaling));
  return page;
}

//------------------------------------------------------------------------------
/** What the measurement rests on, for the table at the end. */
Json GetFacts(const Json& results)
{
  Json facts = Json::array();
  const auto add = [&facts](const std::string& name, const std::string& value)
  {
    if (!value.empty())
    {
      facts.push_back({ { "name", name }, { "value", value } });
    }
  };
  const Json& machine = Find(results, { "machine" });
  const Json& gl = Find(results, { "gl" });
  add("processor", FindText(machine, { "processor" }));
  add("cores", WriteCount(FindNumber(machine, { "cores" })));
  add("memory", WriteBytes(FindNumber(machine, { "memory_bytes" })));
  add("system", FindText(machine, { "system" }));
  add("OpenGL", JoinMembers(gl, " "));
  add("libraries", JoinMembers(Find(results, { "libraries" }), " "));
  add("seeds", JoinMembers(Find(results, { "seeds" }), " "));
  add("suite", FindText(results, { "suite" }));
  add("date", FindText(results, { "date" }));
  add("command", FindText(results, { "command" }));
  return facts;
}

//------------------------------------------------------------------------------
Json GetPage(const Json& results, const std::vector<BenchPicture>& pictures)
{
  const CurveStyles styles(results);
  LazyPainter painter;
  Json cases = Json::array();
  for (const Json& oneCase : FindList(results, { "cases" }))
  {
    cases.push_back(GetCase(results, oneCase, pictures, styles, painter));
    cases.back()["number"] = cases.size();
  }
  const std::string title = FindText(results, { "title" });
  const Json& machine = Find(results, { "machine" });
  Json page = { { "title", title.empty() ? "Results of softshadows bench" : title },
    { "about", FindText(results, { "about" }) }, { "date", FindText(results, { "date" }) },
    { "processor", FindText(machine, { "processor" }) },
    { "cores", WriteCount(FindNumber(machine, { "cores" })) },
    { "memory", WriteBytes(FindNumber(machine, { "memory_bytes" })) },
    { "system", FindText(machine, { "system" }) },
    { "renderer", FindText(results, { "gl", "renderer" }) },
    { "interrupted", Find(results, { "complete" }) == false }, { "no_cases", cases.empty() },
    { "cases", cases }, { "scaling", GetScaling(results, styles, painter) },
    { "frames", WriteCount(FindNumber(results, { "frames_wanted" })) },
    { "budget", WriteShort(FindNumber(results, { "budget_seconds" })) },
    { "source", FindText(results, { "published", "source" }) } };
  SetRows(page, "facts", GetFacts(results));
  SetRows(page, "failures", FindList(results, { "failures" }));
  return page;
}
}

//------------------------------------------------------------------------------
std::string MakeBenchReport(const Json& results, const std::vector<BenchPicture>& pictures)
{
  Mustache::mustache page(BenchReportTemplate);
  if (!page.is_valid())
  {
    throw Failure("the report's template: " + page.error_message());
  }
  return page.render(Convert(GetPage(results, pictures)));
}
