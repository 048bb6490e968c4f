// SPDX-License-Identifier: BSD-3-Clause
#include "Outputs.h"

#include "Errors.h"

#include "vtkImageData.h"
#include "vtkImageFile.h"
#include "vtkNew.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace fs = std::filesystem;

namespace
{
constexpr std::array<int, 3> signals = { SIGINT, SIGTERM, SIGHUP };
volatile std::sig_atomic_t pendingSignal = 0;

void Defer(int number)
{
  pendingSignal = number;
}

std::string CannotWrite(const std::string& name, const std::string& reason)
{
  return "cannot write \"" + name + "\": " + reason + ".";
}

/** Where a file or folder really goes: a link keeps pointing to what it points to. */
fs::path Resolve(const std::string& name)
{
  std::error_code failed;
  const fs::path path = fs::weakly_canonical(fs::absolute(name, failed), failed);
  return failed ? fs::path(name) : path;
}

/** Whether a name leads to where standard output or standard error goes, such as /dev/stdout. */
bool IsStandardStream(const std::string& name)
{
  struct stat there;
  const bool exists = stat(name.c_str(), &there) == 0;
  const auto goesThere = [&there](int descriptor)
  {
    struct stat stream;
    return fstat(descriptor, &stream) == 0 && stream.st_dev == there.st_dev &&
           stream.st_ino == there.st_ino;
  };
  return exists && (goesThere(STDOUT_FILENO) || goesThere(STDERR_FILENO));
}

void CheckFolder(const std::string& name, const fs::path& folder)
{
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored))
  {
    throw Failure(CannotWrite(name, "there is no folder \"" + folder.string() + "\""));
  }
  if (access(folder.c_str(), W_OK | X_OK) != 0)
  {
    throw Failure(
      CannotWrite(name, "the folder \"" + folder.string() + "\": " + std::strerror(errno)));
  }
}

void WriteText(const fs::path& temporary, const std::string& name, const std::string& text)
{
  errno = 0;
  std::ofstream file(temporary, std::ios::binary);
  file << text;
  file.close();
  if (!file)
  {
    throw Failure(CannotWrite(name, errno ? std::strerror(errno) : "it could not be completed"));
  }
}

// Some file systems tell only then that there is no room.
void BringToDisk(const fs::path& temporary, const std::string& name)
{
  const int file = open(temporary.c_str(), O_RDONLY | O_CLOEXEC);
  const bool failed = file == -1 || (fsync(file) != 0 && errno != EINVAL && errno != ENOSYS);
  const int reason = errno;
  if (file != -1)
  {
    close(file);
  }
  if (failed)
  {
    throw Failure(CannotWrite(name, std::strerror(reason)));
  }
}
}

//------------------------------------------------------------------------------
/** Lets the signals that would end the command wait while there are temporary files. */
class Outputs::SignalGuard
{
public:
  SignalGuard()
  {
    pendingSignal = 0;
    for (std::size_t i = 0; i < signals.size(); ++i)
    {
      struct sigaction action = {};
      action.sa_handler = Defer;
      action.sa_flags = SA_RESTART;
      sigaction(signals[i], nullptr, &this->Old[i]);
      if (this->Old[i].sa_handler != SIG_IGN)
      {
        sigaction(signals[i], &action, nullptr);
      }
    }
  }
  ~SignalGuard()
  {
    for (std::size_t i = 0; i < signals.size(); ++i)
    {
      sigaction(signals[i], &this->Old[i], nullptr);
    }
    if (pendingSignal != 0)
    {
      std::raise(pendingSignal);
    }
  }
  SignalGuard(const SignalGuard&) = delete;
  void operator=(const SignalGuard&) = delete;

private:
  struct sigaction Old[signals.size()];
};

//------------------------------------------------------------------------------
Outputs::Outputs(std::vector<std::string> inputs)
  : Inputs(std::move(inputs))
{
}

//------------------------------------------------------------------------------
Outputs::~Outputs()
{
  std::error_code ignored;
  for (const Staged& file : this->Files)
  {
    fs::remove(file.Temporary, ignored);
  }
  for (auto folder = this->MadeFolders.rbegin(); folder != this->MadeFolders.rend(); ++folder)
  {
    fs::remove(*folder, ignored);
  }
}

//------------------------------------------------------------------------------
void Outputs::Guard()
{
  if (!this->Signals)
  {
    this->Signals = std::make_unique<SignalGuard>();
  }
}

//------------------------------------------------------------------------------
void Outputs::MakeFolder(const fs::path& folder)
{
  std::error_code failed;
  if (fs::is_directory(folder, failed))
  {
    return;
  }
  if (folder.has_parent_path() && folder.parent_path() != folder)
  {
    this->MakeFolder(folder.parent_path());
  }
  if (fs::create_directory(folder, failed))
  {
    this->MadeFolders.push_back(folder);
  }
}

//------------------------------------------------------------------------------
fs::path Outputs::GetTemporary(const fs::path& final)
{
  return final.parent_path() / (".softshadows-" + std::to_string(getpid()) + "-" +
                                 std::to_string(++this->Counter) + final.extension().string());
}

//------------------------------------------------------------------------------
// Where a file goes, unless something is there that must stay.
fs::path Outputs::GetPlace(const std::string& name) const
{
  std::error_code ignored;
  if (std::any_of(this->Inputs.begin(), this->Inputs.end(),
        [&](const std::string& input) { return fs::equivalent(name, input, ignored); }))
  {
    throw WrongUsage("\"" + name + "\" is an input, which would be overwritten.");
  }
  if (IsStandardStream(name))
  {
    throw Failure(CannotWrite(name, "what is printed goes there (--json prints the figures)"));
  }
  const fs::file_status there = fs::status(name, ignored);
  if (fs::exists(there) && !fs::is_regular_file(there))
  {
    throw Failure(
      CannotWrite(name, fs::is_directory(there) ? "it is a folder" : "it is no regular file"));
  }
  return Resolve(name);
}

//------------------------------------------------------------------------------
fs::path Outputs::PlanFile(const std::string& name)
{
  const fs::path path = this->GetPlace(name);
  std::error_code ignored;
  if (name.empty() || !path.has_filename())
  {
    throw Failure(CannotWrite(name, "it names no file"));
  }
  if (std::find(this->Planned.begin(), this->Planned.end(), path) != this->Planned.end())
  {
    throw WrongUsage("\"" + name + "\" is to be written twice.");
  }
  const fs::file_status there = fs::status(path, ignored);
  constexpr fs::perms writable =
    fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
  if (fs::exists(there) &&
      (access(path.c_str(), W_OK) != 0 || (there.permissions() & writable) == fs::perms::none))
  {
    throw Failure(CannotWrite(name, "the file is write-protected"));
  }
  CheckFolder(name, path.parent_path());
  this->Planned.push_back(path);
  return path;
}

//------------------------------------------------------------------------------
void Outputs::PlanPicture(const std::string& name, int components)
{
  // Only a trial tells all: the format, what it can hold, and the disk.
  const fs::path temporary = this->GetTemporary(this->PlanFile(name));
  vtkNew<vtkImageData> trial;
  trial->SetDimensions(1, 1, 1);
  trial->AllocateScalars(components == 1 ? VTK_FLOAT : VTK_UNSIGNED_CHAR, components);
  for (int i = 0; i < components; ++i)
  {
    trial->SetScalarComponentFromDouble(0, 0, 0, i, 0.0);
  }
  const SignalGuard guard;
  this->WritePicture(temporary, name, trial);
  std::error_code ignored;
  fs::remove(temporary, ignored);
}

//------------------------------------------------------------------------------
void Outputs::PlanText(const std::string& name)
{
  const fs::path temporary = this->GetTemporary(this->PlanFile(name));
  const SignalGuard guard;
  std::error_code ignored;
  try
  {
    WriteText(temporary, name, "");
  }
  catch (...)
  {
    fs::remove(temporary, ignored);
    throw;
  }
  fs::remove(temporary, ignored);
}

//------------------------------------------------------------------------------
void Outputs::PlanFolder(const std::string& name)
{
  fs::path path = Resolve(name);
  path = path.has_filename() ? path : path.parent_path(); // "new/" is "new"
  std::error_code ignored;
  if (fs::exists(path, ignored) && !fs::is_directory(path, ignored))
  {
    throw Failure(CannotWrite(name, "it is no folder"));
  }
  CheckFolder(name, fs::is_directory(path, ignored) ? path : path.parent_path());
}

//------------------------------------------------------------------------------
void Outputs::WritePicture(const fs::path& temporary, const std::string& name, vtkImageData* image)
{
  if (!vtkImageFile::Write(temporary.string(), image, "softshadows " SOFTSHADOWS_VERSION))
  {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    std::string reason = Messages::TakeError();
    const std::string cannot = "cannot write \"" + temporary.string() + "\": ";
    if (reason.rfind(cannot, 0) == 0)
    {
      reason = reason.substr(cannot.size());
    }
    if (reason.find("could not find a format writer") != std::string::npos)
    {
      reason = temporary.has_extension()
                 ? "no kind of picture has the extension \"" + temporary.extension().string() + "\""
                 : "its name has no extension that tells the kind of picture";
    }
    for (std::size_t at; (at = reason.find(temporary.string())) != std::string::npos;)
    {
      reason.replace(at, temporary.string().size(), name);
    }
    throw Failure(CannotWrite(name, reason));
  }
}

//------------------------------------------------------------------------------
void Outputs::StagePicture(const std::string& name, vtkImageData* image)
{
  this->Guard();
  const fs::path path = this->GetPlace(name);
  this->MakeFolder(path.parent_path());
  const fs::path temporary = this->GetTemporary(path);
  this->WritePicture(temporary, name, image);
  this->Files.push_back({ temporary, path, name });
  BringToDisk(temporary, name);
}

//------------------------------------------------------------------------------
void Outputs::StageText(const std::string& name, const std::string& text)
{
  this->Guard();
  const fs::path path = this->GetPlace(name);
  this->MakeFolder(path.parent_path());
  this->Files.push_back({ this->GetTemporary(path), path, name });
  WriteText(this->Files.back().Temporary, name, text);
  BringToDisk(this->Files.back().Temporary, name);
}

//------------------------------------------------------------------------------
void Outputs::Commit()
{
  if (!this->Files.empty() && pendingSignal != 0)
  {
    throw Failure("interrupted"); // the signal ends the command once the files are gone
  }
  while (!this->Files.empty())
  {
    const Staged& file = this->Files.back();
    std::error_code failed;
    fs::rename(file.Temporary, file.Final, failed);
    if (failed)
    {
      throw Failure(CannotWrite(file.Name, failed.message()));
    }
    this->Files.pop_back();
    this->MadeFolders.clear();
  }
  this->Signals.reset();
}
