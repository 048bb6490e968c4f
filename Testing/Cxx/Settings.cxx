// SPDX-License-Identifier: BSD-3-Clause
// What a program sets and asks: parameters in every locale, a visibility of each light, the registry
// of techniques, and that all of it is answered.

#include "ShadowStage.h"
#include "ShadowTest.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkShadowSettings.h"
#include "vtkShadowTechnique.h"
#include "vtkShadowTechniques.h"
#include "vtkShadowVTKVersion.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <unistd.h>
#include <utility>

namespace
{
using ShadowTest::Message;

/**
 * Numbers have a decimal comma while it lives, those of C and those of C++: as in a Qt program of a
 * German user. The locale is made for it, for a machine need not have one.
 */
class DecimalComma
{
public:
  DecimalComma()
  {
    namespace fs = std::filesystem;
    this->Folder = fs::temp_directory_path() / ("softshadows-locale-" + std::to_string(getpid()));
    fs::create_directories(this->Folder);
    const std::string make =
      "localedef -i de_DE -f UTF-8 '" + (this->Folder / "de_DE.UTF-8").string() + "'";
    ShadowTest::CheckEqual(std::system(make.c_str()), 0.0, make);
    setenv("LOCPATH", this->Folder.c_str(), 1);
    ShadowTest::Check(std::setlocale(LC_ALL, "de_DE.UTF-8"), "no locale with a decimal comma");
    ShadowTest::CheckEqual(std::strtod("0.16", nullptr), 0.0, "0.16 as strtod reads it now");
    struct Comma : std::numpunct<char>
    {
      char do_decimal_point() const override { return ','; }
      char do_thousands_sep() const override { return '.'; }
      std::string do_grouping() const override { return "\3"; }
    };
    this->Before = std::locale::global(std::locale(std::locale::classic(), new Comma));
    // Without a name it leaves C's own as it is.
    std::setlocale(LC_ALL, "de_DE.UTF-8");
  }
  ~DecimalComma()
  {
    std::locale::global(this->Before);
    std::setlocale(LC_ALL, "C");
    std::filesystem::remove_all(this->Folder);
  }
  DecimalComma(const DecimalComma&) = delete;
  void operator=(const DecimalComma&) = delete;

private:
  std::filesystem::path Folder;
  std::locale Before;
};

Visibility Show(const std::string& technique, const Parameters& parameters = {})
{
  return RenderVisibility(technique, parameters,
    [&](ShadowStage& stage)
    {
      stage.AddThings();
      stage.AddLight(
        ShadowStage::Supports(technique, LightKind::Sphere) ? LightKind::Sphere : LightKind::Point);
    });
}

std::size_t CountPenumbra(const Visibility& visibility)
{
  return std::count_if(
    visibility.V.begin(), visibility.V.end(), [](float v) { return v > 0.02f && v < 0.98f; });
}

/** A technique of the test's own, which reads parameters and draws nothing. */
class Probe : public vtkShadowTechnique
{
public:
  using vtkShadowTechnique::vtkShadowTechnique;
  bool UpdateLightData(vtkShadowFrame&) override
  {
    return this->Settings.GetReal("widht") > 0.0; // which it has not declared
  }
  void Release(vtkOpenGLRenderWindow*) override {}
};

/** Registers as a library does that is loaded later. */
const vtkShadowDeclaration& RegisterProbe(const std::string& name)
{
  vtkShadowDeclaration declaration;
  declaration.Name = name;
  declaration.SetClasses<Probe, vtkShadowPass>("vtkShadowPass");
  declaration.Parameters = { vtkShadowParameter::Real("width", 0.16, 0, 4, ""),
    vtkShadowParameter::Integer("samples", 64, 1, 1024, ""),
    vtkShadowParameter::Boolean("fine", true, "") };
  const vtkShadowTechniqueRegistration registration(declaration);
  return *vtkShadowTechniqueRegistration::Find(name);
}

/** Two lights from either side, and a third that is off. */
std::array<vtkLight*, 3> AddLights(ShadowStage& stage)
{
  std::array<vtkLight*, 3> lights = { stage.AddPlainLight(true, { -2.5, -2.0, 5.5 }),
    stage.AddPlainLight(true, { 3.0, -1.0, 4.5 }), stage.AddPlainLight(true, { 0.0, 3.0, 4.5 }) };
  lights[2]->SwitchOff();
  return lights;
}

const float* GetValues(vtkImageData* image)
{
  return static_cast<const float*>(
    image->GetPointData()->GetArray("Visibility")->GetVoidPointer(0));
}

std::vector<float> CopyValues(vtkImageData* image)
{
  const float* first = GetValues(image);
  return std::vector<float>(first, first + image->GetNumberOfPoints());
}
}

//------------------------------------------------------------------------------
SHADOW_TEST(Settings, DecimalComma, Each)
{
  const bool wide = ShadowStage::HasParameter(technique, "width");
  const Parameters narrow = { { "width", "0.07" } };
  const Visibility byDefault = Show(technique);
  const Visibility set = wide ? Show(technique, narrow) : byDefault;
  const std::string described = vtkShadowTechniques::Describe(technique);

  const DecimalComma comma;
  const Visibility visibility = Show(technique);
  ShadowTest::CheckEqual(static_cast<double>(CountPenumbra(visibility)),
    static_cast<double>(CountPenumbra(byDefault)), "pixels in penumbra");
  ShadowTest::Check(Same(visibility, byDefault), "V is another one");
  ShadowTest::Check(
    !wide || Same(Show(technique, narrow), set), "V of a width that is set is another one");
  ShadowTest::Check(
    vtkShadowTechniques::Describe(technique) == described, "the technique is described otherwise");
  ShadowStage stage;
  vtkShadowPass* pass = stage.SetPass(technique);
  if (ShadowStage::HasParameter(technique, "resolution"))
  {
    pass->SetParameter("resolution", "99999");
    ShadowTest::CheckOneMessage(Message::Error, { "0 to 16384" }, "range of the resolution");
  }
  if (wide)
  {
    ShadowTest::Check(!pass->SetParameter("width", "0,16"), "0,16 was taken");
    ShadowTest::CheckOneMessage(Message::Error, { "0,16", "0 to 4" }, "0,16");
  }
  // As JSON it is read by whoever asks.
  stage.GetStatistics();
}

//------------------------------------------------------------------------------
SHADOW_TEST(Settings, PlainForm, Once)
{
  const vtkShadowDeclaration& declaration = RegisterProbe("probe");
  const auto pass = vtkSmartPointer<vtkShadowPass>::Take(vtkShadowTechniques::Create("probe"));
  vtkShadowSettings settings(declaration); // what a technique reads
  for (const char* text : { "32", "32.0", "+32", "3.2e1", "0032" })
  {
    pass->SetParameter("samples", "64");
    ShadowTest::Check(pass->SetParameter("samples", text), std::string("refused: ") + text);
    ShadowTest::Check(pass->GetParameter("samples") == "32", std::string("not 32: ") + text);
    ShadowTest::Check(settings.Set("samples", text).empty(), text);
    ShadowTest::CheckEqual(settings.GetInteger("samples"), 32.0, text);
    const vtkMTimeType before = pass->GetMTime();
    pass->SetParameter("samples", "32");
    ShadowTest::Check(pass->GetMTime() == before, std::string("32 is not the same as ") + text);
  }
  for (const char* text : { "0.5", ".5", "+0.50", "5e-1" })
  {
    ShadowTest::Check(pass->SetParameter("width", text), std::string("refused: ") + text);
    ShadowTest::Check(pass->GetParameter("width") == text, std::string("not as set: ") + text);
    ShadowTest::Check(settings.Set("width", text).empty(), text);
    ShadowTest::CheckEqual(settings.GetReal("width"), 0.5, text);
    const vtkMTimeType before = pass->GetMTime();
    pass->SetParameter("width", "0.5");
    ShadowTest::Check(pass->GetMTime() == before, std::string("0.5 is not the same as ") + text);
  }
  pass->SetParameter("width", "-0");
  settings.Set("width", "-0");
  for (const char* text :
    { "", " 1", "1 ", "1,0", "0x1", "+-1", "--1", "+", "1e400", "nan", "inf", "1.0.0", "1f" })
  {
    ShadowTest::Check(!pass->SetParameter("width", text), std::string("taken: '") + text + "'");
    ShadowTest::CheckOneMessage(Message::Error, { "width", "a number from 0 to 4" }, text);
    ShadowTest::Check(!settings.Set("width", text).empty(), text);
    ShadowTest::CheckEqual(settings.GetReal("width"), 0.0, std::string("width after ") + text);
  }
  for (const auto& value : { std::pair<const char*, bool>("on", true), { "off", false },
         { "true", true }, { "false", false }, { "1", true }, { "0", false } })
  {
    pass->SetParameter("fine", value.first);
    settings.Set("fine", value.first);
    ShadowTest::Check(pass->GetParameter("fine") == (value.second ? "on" : "off"), value.first);
    ShadowTest::Check(settings.GetBoolean("fine") == value.second, value.first);
  }
}

//------------------------------------------------------------------------------
// A technique that asks for a parameter that it has not declared, or of another type, gets no value.
SHADOW_TEST(Settings, UndeclaredParameter, Once)
{
  const vtkShadowSettings settings(RegisterProbe("probe"));
  const auto refuses = [](const std::function<void()>& read, const std::string& what,
                         const std::vector<std::string>& words)
  {
    try
    {
      read();
      ShadowTest::Check(false, what + " gives a value");
    }
    catch (const std::logic_error& error)
    {
      for (const auto& word : words)
      {
        ShadowTest::Check(std::string(error.what()).find(word) != std::string::npos,
          what + " does not say '" + word + "': " + error.what());
      }
    }
  };
  const std::vector<std::string> words = { "probe", "widht", "width", "samples" };
  refuses([&] { settings.GetReal("widht"); }, "GetReal", words);
  refuses([&] { settings.GetInteger("widht"); }, "GetInteger", words);
  refuses([&] { settings.GetBoolean("widht"); }, "GetBoolean", words);
  refuses([&] { settings.GetChoice("widht"); }, "GetChoice", words);
  refuses([&] { settings.GetInteger("width"); }, "GetInteger of a real", { "width", "type" });

  // The frame is drawn, without shadows, and the program told why, once.
  ShadowStage stage;
  stage.AddThings();
  stage.AddLight(LightKind::Point);
  stage.Render();
  const Picture without = stage.GetPicture();
  stage.Pass.TakeReference(vtkShadowTechniques::Create("probe"));
  stage.Renderer->SetPass(stage.Pass);
  stage.Render();
  ShadowTest::CheckOneMessage(Message::Error, words, "a technique that misspells");
  ShadowTest::Check(
    stage.GetPicture().RGB == without.RGB, "the picture is another one than without");
  stage.Render();
  ShadowTest::CheckNoMessage("the second frame");
}

//------------------------------------------------------------------------------
// A family that is loaded later moves nothing that passes and programs hold.
SHADOW_TEST(Settings, LaterTechniques, Once)
{
  const auto pass = vtkSmartPointer<vtkShadowPass>::Take(
    vtkShadowTechniques::Create(vtkShadowTechniques::GetName(0)));
  const std::string own = pass->GetTechnique();
  const vtkShadowDeclaration* declared = vtkShadowTechniqueRegistration::Find(own);
  const char* first = vtkShadowTechniques::GetName(0);
  const int count = vtkShadowTechniques::GetNumberOfTechniques();
  for (int i = 0; i < 100; ++i)
  {
    RegisterProbe("a-probe-" + std::to_string(i)); // before all others
    RegisterProbe("probe-" + std::to_string(i));
  }
  ShadowTest::CheckEqual(vtkShadowTechniques::GetNumberOfTechniques(), count + 200.0, "techniques");
  ShadowTest::Check(vtkShadowTechniqueRegistration::Find(own) == declared, "moved");
  ShadowTest::Check(vtkShadowTechniques::GetName(100) == first, "its name moved");
  ShadowTest::Check(first == own, "a name that was given is another one now");
  ShadowTest::Check(pass->GetTechnique() == own, "the pass's technique is another one now");
  ShadowTest::Check(
    std::string(vtkShadowTechniques::GetName(0)) == "a-probe-0", "names are not sorted");
  // Twice the same is the first.
  RegisterProbe(own);
  ShadowTest::Check(declared->ClassName == pass->GetClassName(), "a technique was replaced");
  ShadowTest::CheckEqual(
    vtkShadowTechniques::GetNumberOfTechniques(), count + 200.0, "techniques after all");
}

//------------------------------------------------------------------------------
SHADOW_TEST(Settings, VisibilityOfEachLight, Each)
{
  ShadowStage stage;
  stage.AddThings();
  const auto lights = AddLights(stage);
  vtkShadowPass* pass = stage.SetPass(technique);
  stage.Render();
  vtkImageData* images[3];
  for (int i = 0; i < 3; ++i)
  {
    images[i] = pass->GetVisibility(i);
  }
  ShadowTest::Check(images[0] != images[1] && images[1] != images[2] && images[0] != images[2],
    "one image for several lights");
  std::vector<float> values[3];
  for (int i = 0; i < 3; ++i)
  {
    values[i] = CopyValues(images[i]);
  }
  ShadowTest::Check(values[0] != values[1], "two lights have the same V");
  ShadowTest::CheckEqual(
    *std::min_element(values[2].begin(), values[2].end()), 1.0, "V of the light that is off");
  for (int i = 0; i < 3; ++i)
  {
    // Another of the same light, while the first is held.
    const vtkSmartPointer<vtkImageData> held = images[i];
    vtkImageData* again = pass->GetVisibility(lights[i]);
    ShadowTest::Check(again != held, "the same image twice");
    ShadowTest::Check(CopyValues(again) == values[i], "by light it is not as by number");
    images[i] = again;
  }
  // What one holds is not what a later frame shows.
  const vtkSmartPointer<vtkImageData> held = images[0];
  lights[0]->SetPosition(2.0, 3.0, 5.0);
  stage.Render();
  ShadowTest::Check(CopyValues(pass->GetVisibility(0)) != values[0], "the light did not move");
  ShadowTest::Check(CopyValues(held) == values[0], "an image of an earlier frame changed");
  ShadowTest::Check(CopyValues(images[1]) == values[1], "another light's image changed");
}

//------------------------------------------------------------------------------
SHADOW_TEST(Settings, LightThatIsNotThere, Each)
{
  ShadowStage stage;
  stage.AddThings();
  AddLights(stage);
  vtkShadowPass* pass = stage.SetPass(technique);
  stage.Render();
  for (const int light : { -1, 3, 7 })
  {
    ShadowTest::Check(pass->GetVisibility(light) == nullptr, "V of light " + std::to_string(light));
    ShadowTest::CheckOneMessage(Message::Error,
      { "GetVisibility", std::to_string(light), "0 to 2" }, "light " + std::to_string(light));
  }
  vtkNew<vtkLight> stranger;
  for (vtkLight* light : { static_cast<vtkLight*>(stranger), static_cast<vtkLight*>(nullptr) })
  {
    ShadowTest::Check(pass->GetVisibility(light) == nullptr, "V of a stranger");
    ShadowTest::CheckOneMessage(Message::Error, { "GetVisibility", "has 3" }, "a stranger");
  }
  stage.Renderer->RemoveAllLights();
  stage.Renderer->AutomaticLightCreationOff();
  stage.Render();
  const auto values = CopyValues(pass->GetVisibility(0));
  ShadowTest::CheckEqual(
    *std::min_element(values.begin(), values.end()), 1.0, "V where nothing is lit");
  ShadowTest::Check(pass->GetVisibility(1) == nullptr, "V without lights");
  ShadowTest::CheckOneMessage(Message::Error, { "GetVisibility", "none" }, "without lights");
}

//------------------------------------------------------------------------------
// Planar techniques say once that nothing receives, until a plane is given.
SHADOW_TEST(Settings, NoPlane, Each)
{
  if (!ShadowStage::Describe(technique).Traits.PlanarReceivers)
  {
    return;
  }
  ShadowStage stage;
  stage.AddBox({ 0.0, 0.0, 0.5 }, { 2.0, 2.0, 1.0 });
  stage.AddSphere({ 0.0, 0.0, 2.0 }, 0.5);
  stage.AddLight(LightKind::Point);
  stage.LookAt({ 3.5, -6.5, 4.5 }, { 0.0, 0.0, 0.5 });
  stage.SetPass(technique);
  stage.Render();
  stage.Render();
  ShadowTest::CheckOneMessage(Message::Warning, { technique, "AddPlane" }, "no plane");
  ShadowTest::CheckEqual(stage.Count("planes"), 0.0, "planes");
}

//------------------------------------------------------------------------------
// A map or layer has room for casters at every resolution that can be set.
SHADOW_TEST(Settings, SmallResolution, Each)
{
  if (!ShadowStage::HasParameter(technique, "resolution"))
  {
    return;
  }
  const auto mean = [](const Visibility& v)
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < v.V.size(); ++i)
    {
      sum += v.Mask[i] ? 1.0 - v.V[i] : 0.0;
    }
    return sum / static_cast<double>(v.GetNumberOfReceivers());
  };
  const double dark = mean(Show(technique, { { "resolution", "512" } }));
  for (const char* resolution : { "1", "2", "3", "4", "7", "8", "15", "16" })
  {
    const double share = mean(Show(technique, { { "resolution", resolution } }));
    ShadowTest::CheckAtLeast(share / dark, 0.8, std::string("shadow at resolution ") + resolution);
    ShadowTest::CheckAtMost(share / dark, 1.25, std::string("shadow at resolution ") + resolution);
  }
}

//------------------------------------------------------------------------------
// Whose backend of threads it is: the program's, at any time, though rays take all cores.
SHADOW_TEST(Settings, ThreadsOfTheProgram, Each)
{
  vtkSMPTools::SetBackend("Sequential");
  std::atomic<bool> over{ false };
  std::atomic<int> others{ 0 };
  std::thread watch(
    [&]()
    {
      while (!over)
      {
        others += std::string(vtkSMPTools::GetBackend()) == "Sequential" ? 0 : 1;
      }
    });
  Show(technique, { { "samples", "256" } });
  over = true;
  watch.join();
  ShadowTest::CheckEqual(others, 0.0, "times that the backend was another one");
}
