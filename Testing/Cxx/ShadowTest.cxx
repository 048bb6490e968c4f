// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowTest.h"

#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkShadowDeclaration.h"
#include "vtkShadowPass.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <iostream>
#include <map>
#include <thread>

namespace
{
std::map<std::string, ShadowTest::Function>& GetTests()
{
  static std::map<std::string, ShadowTest::Function> tests;
  return tests;
}

int Failures = 0;
std::string Prefix = "ERROR: ";
std::vector<ShadowTest::Message> Messages;

/** Collects what VTK says. */
class Collector : public vtkOutputWindow
{
public:
  static Collector* New();
  vtkTypeMacro(Collector, vtkOutputWindow);

  void DisplayText(const char* text) override { std::cout << text; }
  void DisplayErrorText(const char* text) override
  {
    ShadowTest::AddMessage(ShadowTest::Message::Error, text);
  }
  void DisplayWarningText(const char* text) override
  {
    ShadowTest::AddMessage(ShadowTest::Message::Warning, text);
  }
  void DisplayGenericWarningText(const char* text) override
  {
    // VTK 9.1 calls what it has deprecated itself, where a level-of-detail actor copies its mapper.
    if (!std::strstr(text, "was deprecated for VTK"))
    {
      ShadowTest::AddMessage(ShadowTest::Message::Warning, text);
    }
  }
};
vtkStandardNewMacro(Collector);

/**
 * Xvfb resets itself when its last client goes, and refuses the next one meanwhile: VTK then aborts.
 * So there is one client more, from when the server takes it to the end. Nothing where there is no X.
 */
void KeepDisplay()
{
  using Open = void* (*)(const char*);
  const auto open = reinterpret_cast<Open>(dlsym(RTLD_DEFAULT, "XOpenDisplay"));
  for (int i = 0; open && std::getenv("DISPLAY") && i < 100 && !open(nullptr); ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

void Fail(const std::string& text)
{
  ++Failures;
  std::cout << Prefix << text << std::endl;
}

bool CheckFigure(
  bool holds, double value, const char* relation, double bound, const std::string& what)
{
  std::cout << (holds ? std::string("  ") : Prefix) << what << ": " << value << " (" << relation
            << " " << bound << ")" << std::endl;
  Failures += holds ? 0 : 1;
  return holds;
}

std::string Describe(const std::vector<ShadowTest::Message>& messages)
{
  static const char* const kinds[] = { "error", "warning", "OpenGL" };
  std::string text;
  for (const auto& message : messages)
  {
    text += std::string("\n    ") + kinds[message.Source] + ": " + message.Text;
  }
  return text.empty() ? " none" : text;
}
}

//------------------------------------------------------------------------------
ShadowTest::Registration::Registration(const char* name, Function function)
{
  GetTests()[name] = function;
}

//------------------------------------------------------------------------------
bool ShadowTest::Check(bool holds, const std::string& what)
{
  if (!holds)
  {
    Fail(what);
  }
  return holds;
}

//------------------------------------------------------------------------------
bool ShadowTest::CheckAtMost(double value, double bound, const std::string& what)
{
  return CheckFigure(value <= bound, value, "at most", bound, what);
}

//------------------------------------------------------------------------------
bool ShadowTest::CheckAtLeast(double value, double bound, const std::string& what)
{
  return CheckFigure(value >= bound, value, "at least", bound, what);
}

//------------------------------------------------------------------------------
bool ShadowTest::CheckEqual(double value, double expected, const std::string& what)
{
  return CheckFigure(value == expected, value, "exactly", expected, what);
}

//------------------------------------------------------------------------------
std::vector<ShadowTest::Message> ShadowTest::TakeMessages()
{
  std::vector<Message> taken;
  taken.swap(Messages);
  return taken;
}

//------------------------------------------------------------------------------
void ShadowTest::AddMessage(Message::Kind source, const std::string& text)
{
  // At once, for those that come before a crash; not in words that ctest takes for a failure.
  const std::string prefix = "ERROR: ";
  std::cout << "  said: " << (text.compare(0, prefix.size(), prefix) == 0 ? text.substr(7) : text)
            << std::endl;
  Messages.push_back({ source, text });
}

//------------------------------------------------------------------------------
bool ShadowTest::CheckOneMessage(
  Message::Kind source, const std::vector<std::string>& words, const std::string& what)
{
  const auto messages = ShadowTest::TakeMessages();
  const bool holds =
    messages.size() == 1 && messages[0].Source == source &&
    std::all_of(words.begin(), words.end(),
      [&](const std::string& word) { return messages[0].Text.find(word) != std::string::npos; });
  return ShadowTest::Check(
    holds, what + ": not the one message expected, but" + Describe(messages));
}

//------------------------------------------------------------------------------
bool ShadowTest::CheckNoMessage(const std::string& what)
{
  const auto messages = ShadowTest::TakeMessages();
  return ShadowTest::Check(messages.empty(), what + ": unexpected messages:" + Describe(messages));
}

//------------------------------------------------------------------------------
void ShadowTest::ExpectFailures()
{
  Prefix = "expected: ";
}

//------------------------------------------------------------------------------
int ShadowTest::TakeFailures()
{
  const int failures = Failures;
  Failures = 0;
  Prefix = "ERROR: ";
  return failures;
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  const auto found = argc > 1 ? GetTests().find(argv[1]) : GetTests().end();
  if (found == GetTests().end() || argc > 3)
  {
    std::cerr << "Usage: softshadowsTests NAME [TECHNIQUE]\n";
    for (const auto& test : GetTests())
    {
      std::cerr << "  " << test.first << "\n";
    }
    return 2;
  }
  const std::string technique = argc > 2 ? argv[2] : "";
  if (!technique.empty() && !vtkShadowTechniqueRegistration::Find(technique))
  {
    std::cerr << "There is no technique '" << technique << "'.\n";
    return 2;
  }
  // Messages are collected; the logger would print them a second time.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<Collector> collector;
  vtkOutputWindow::SetInstance(collector);
  KeepDisplay();
  vtkShadowPass::SetAdvice(false); // lights here are as they are meant
  found->second(technique);
  ShadowTest::CheckNoMessage("at the end");
  vtkOutputWindow::SetInstance(nullptr);
  std::cout << (Failures ? "failed" : "passed") << std::endl;
  return Failures ? 1 : 0;
}
