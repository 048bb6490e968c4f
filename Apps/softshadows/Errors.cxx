// SPDX-License-Identifier: BSD-3-Clause
#include "Errors.h"

#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <algorithm>
#include <cstdio>
#include <mutex>
#include <regex>
#include <set>
#include <vector>

namespace
{
struct Store
{
  std::mutex Mutex; // filters report from their threads, too
  std::vector<std::string> Errors;
  std::set<std::string> Known;
  std::vector<std::string> Pending;
  std::size_t More = 0; // that are not kept
  std::string About;
};

constexpr std::size_t MostKept = 20;

Store& GetStore()
{
  static Store& store = *new Store; // outlives whatever reports while the program ends
  return store;
}

void Keep(const std::string& line)
{
  Store& store = GetStore();
  const std::lock_guard<std::mutex> lock(store.Mutex);
  if (store.Known.count(line) > 0)
  {
    return;
  }
  if (store.Pending.size() >= MostKept)
  {
    ++store.More;
    return;
  }
  store.Known.insert(line);
  store.Pending.push_back(line);
}

/** The text of a VTK message, without file, line, class and address, on one line. */
std::string Plain(const char* text)
{
  static const std::regex place("^(ERROR|Warning|Generic Warning|Debug): In [^\n]*\n");
  static const std::regex speaker("^((vtk\\w+ \\(\\w+\\)|vtk\\w+|\\(nullptr\\)): )+");
  static const std::regex silent("^Algorithm vtk\\w+ ?\\(0x[0-9a-f]+\\) returned failure[^]*");
  static const std::regex space("\\s+");
  std::string plain(text ? text : "");
  // std::regex calls itself for each letter.
  plain.resize(std::min<std::size_t>(plain.size(), 4000));
  plain = std::regex_replace(plain, place, "");
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
    if (std::string(text ? text : "").find("vtkXOpenGLRenderWindow") != std::string::npos &&
        error.find("Aborting") != std::string::npos)
    {
      throw Failure(error); // VTK's X window calls abort() next, and nothing would be cleaned up
    }
    Store& store = GetStore();
    const std::lock_guard<std::mutex> lock(store.Mutex);
    if (store.Errors.size() < MostKept)
    {
      store.Errors.push_back(error);
    }
  }
  void DisplayWarningText(const char* text) override { this->Warn(text); }
  void DisplayGenericWarningText(const char* text) override { this->Warn(text); }
  void DisplayDebugText(const char*) override {}

protected:
  void Warn(const char* text)
  {
    const std::string warning = Plain(text);
    if (warning.rfind("Error reading", 0) == 0)
    {
      // Files cut short: VTK goes on with memory that it has not filled.
      this->DisplayErrorText(text);
      return;
    }
    std::string about;
    {
      Store& store = GetStore();
      const std::lock_guard<std::mutex> lock(store.Mutex);
      about = store.About.empty() ? "" : store.About + ": ";
    }
    Messages::Warn(about + warning);
  }

  MessageWindow() = default;
};
vtkStandardNewMacro(MessageWindow);
}

namespace Messages
{
//------------------------------------------------------------------------------
std::string GetPrintable(const std::string& text)
{
  // Control characters of Unicode, too: U+0080 to U+009F are C2 80 to C2 9F in UTF-8.
  std::string printable;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : '\0');
    const bool wide = byte == 0xc2 && next >= 0x80 && next <= 0x9f;
    if (byte >= 0x20 && byte != 0x7f && !wide)
    {
      printable += text[i];
      continue;
    }
    char code[8];
    std::snprintf(code, sizeof(code), "\\x%02x", wide ? next : byte);
    printable += code;
    i += wide ? 1 : 0;
  }
  return printable;
}

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
  std::fprintf(stderr, "softshadows: error: %s%s\n", GetPrintable(text).c_str(), ends ? "" : ".");
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
  for (const std::string& line : store.Pending)
  {
    std::fprintf(stderr, "%s\n", GetPrintable(line).c_str());
  }
  if (store.More > 0)
  {
    std::fprintf(stderr, "softshadows: warning: %zu more like these.\n", store.More);
  }
  store.Pending.clear();
  store.More = 0;
}

//------------------------------------------------------------------------------
std::string TakeWarnings()
{
  Store& store = GetStore();
  const std::lock_guard<std::mutex> lock(store.Mutex);
  std::string text;
  for (const std::string& line : store.Pending)
  {
    store.Known.erase(line);
    text += (text.empty() ? "" : " ") + line.substr(line.find(": ", line.find(": ") + 1) + 2);
  }
  store.Pending.clear();
  store.More = 0;
  return text;
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
About::About(const std::string& what)
{
  Store& store = GetStore();
  const std::lock_guard<std::mutex> lock(store.Mutex);
  store.About = what;
}

//------------------------------------------------------------------------------
About::~About()
{
  Store& store = GetStore();
  const std::lock_guard<std::mutex> lock(store.Mutex);
  store.About.clear();
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
