// SPDX-License-Identifier: BSD-3-Clause
#include "Errors.h"

#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <regex>
#include <vector>

namespace
{
struct Store
{
  std::mutex Mutex; // filters report from their threads, too
  std::vector<std::string> Errors;
  std::vector<std::string> Kept;
  std::size_t Shown = 0;
};

Store& GetStore()
{
  static Store& store = *new Store; // outlives whatever reports while the program ends
  return store;
}

void Keep(const std::string& line)
{
  Store& store = GetStore();
  const std::lock_guard<std::mutex> lock(store.Mutex);
  if (std::find(store.Kept.begin(), store.Kept.end(), line) == store.Kept.end())
  {
    store.Kept.push_back(line);
  }
}

/** The text of a VTK message, without file, line, class and address, on one line. */
std::string Plain(const char* text)
{
  static const std::regex place("^(ERROR|Warning|Generic Warning|Debug): In [^\n]*\n");
  static const std::regex speaker("^((vtk\\w+ \\(\\w+\\)|vtk\\w+|\\(nullptr\\)): )+");
  static const std::regex silent("^Algorithm vtk\\w+ ?\\(0x[0-9a-f]+\\) returned failure[^]*");
  static const std::regex space("\\s+");
  std::string plain = std::regex_replace(std::string(text ? text : ""), place, "");
  plain = std::regex_replace(plain, speaker, "");
  // What a reader says that does not know its own file.
  plain = std::regex_replace(plain, silent, "it is damaged, or of another kind than its name says");
  // A shader that fails brings its whole source along.
  constexpr std::size_t longest = 600;
  if (plain.size() > longest)
  {
    plain = plain.substr(0, longest) + " ...";
  }
  plain = std::regex_replace(plain, space, " ");
  plain.erase(plain.find_last_not_of(" .") + 1);
  return plain.empty() ? "VTK reports an error without a reason" : plain;
}

/** Receives VTK's messages. */
class MessageWindow : public vtkOutputWindow
{
public:
  static MessageWindow* New();
  vtkTypeMacro(MessageWindow, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayErrorText(const char* text) override
  {
    const std::string error = Plain(text);
    if (error.find("Aborting") != std::string::npos)
    {
      // VTK's X window calls abort() next; nobody would ever see why.
      Messages::PrintError(error);
      std::_Exit(1);
    }
    Store& store = GetStore();
    const std::lock_guard<std::mutex> lock(store.Mutex);
    store.Errors.push_back(error);
  }
  void DisplayWarningText(const char* text) override { Messages::Warn(Plain(text)); }
  void DisplayGenericWarningText(const char* text) override { Messages::Warn(Plain(text)); }
  void DisplayDebugText(const char*) override {}

protected:
  MessageWindow() = default;
};
vtkStandardNewMacro(MessageWindow);
}

namespace Messages
{
//------------------------------------------------------------------------------
void Install()
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<MessageWindow> window;
  vtkOutputWindow::SetInstance(window);
}

//------------------------------------------------------------------------------
void PrintError(const std::string& text)
{
  // VTK's sentences have lost their full stops.
  const bool ends = !text.empty() && text.find_last_of(".?!") == text.size() - 1;
  std::fprintf(stderr, "softshadows: error: %s%s\n", text.c_str(), ends ? "" : ".");
}

//------------------------------------------------------------------------------
void Warn(const std::string& text)
{
  Keep("softshadows: warning: " + text);
}

//------------------------------------------------------------------------------
void Note(const std::string& text)
{
  Keep("softshadows: note: " + text);
}

//------------------------------------------------------------------------------
void ShowWarnings()
{
  Store& store = GetStore();
  const std::lock_guard<std::mutex> lock(store.Mutex);
  for (; store.Shown < store.Kept.size(); ++store.Shown)
  {
    std::fprintf(stderr, "%s\n", store.Kept[store.Shown].c_str());
  }
}

//------------------------------------------------------------------------------
std::string TakeError()
{
  Store& store = GetStore();
  const std::lock_guard<std::mutex> lock(store.Mutex);
  const std::string first = store.Errors.empty() ? "" : store.Errors.front();
  store.Errors.clear();
  return first;
}

//------------------------------------------------------------------------------
void Check(const std::string& context)
{
  const std::string error = TakeError();
  if (!error.empty())
  {
    throw Failure(context.empty() ? error : context + ": " + error);
  }
}
}
