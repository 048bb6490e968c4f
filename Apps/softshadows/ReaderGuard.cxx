// SPDX-License-Identifier: BSD-3-Clause
#include "ReaderGuard.h"

#include "Errors.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <unistd.h>

namespace
{
int realError = -1;
char crashed[4096];
char endless[4096];

// Only what may be called in a signal handler.
void Report(int signal)
{
  const char* message = signal == SIGPROF ? endless : crashed;
  const ssize_t written = write(realError, message, std::strlen(message));
  static_cast<void>(written); // there is nobody left to tell
  _exit(1);
}

// Bytes of address space in use.
double GetUsedMemory()
{
  double pages = 0.0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}
}

//------------------------------------------------------------------------------
ReaderGuard::ReaderGuard(const std::string& path)
  : Stack(std::make_unique<char[]>(StackSize))
{
  const std::string name = Messages::GetPrintable(path);
  std::snprintf(crashed, sizeof(crashed),
    "softshadows: error: cannot read \"%.3000s\": it is damaged; its reader crashed.\n",
    name.c_str());
  std::snprintf(endless, sizeof(endless),
    "softshadows: error: cannot read \"%.3000s\": it is damaged; its reader came to no end.\n",
    name.c_str());
  std::fflush(stderr);
  realError = dup(STDERR_FILENO);
  this->Kept = std::tmpfile();
  if (this->Kept)
  {
    dup2(fileno(this->Kept), STDERR_FILENO);
  }
  stack_t stack = {};
  stack.ss_sp = this->Stack.get();
  stack.ss_size = StackSize;
  sigaltstack(&stack, &this->OldStack);
  for (std::size_t i = 0; i < std::size(Signals); ++i)
  {
    struct sigaction action = {};
    action.sa_handler = Report;
    action.sa_flags = SA_ONSTACK;
    sigaction(Signals[i], &action, &this->Old[i]);
  }
  std::error_code ignored;
  const auto size = std::filesystem::file_size(path, ignored);
  const double bytes = ignored ? 0.0 : static_cast<double>(size);
  this->LimitMemory(bytes);
  this->LimitTime(bytes);
}

//------------------------------------------------------------------------------
ReaderGuard::~ReaderGuard()
{
  setitimer(ITIMER_PROF, &this->OldTimer, nullptr);
  setrlimit(RLIMIT_AS, &this->OldMemory);
  for (std::size_t i = 0; i < std::size(Signals); ++i)
  {
    sigaction(Signals[i], &this->Old[i], nullptr);
  }
  sigaltstack(&this->OldStack, nullptr);
  std::fflush(stderr);
  dup2(realError, STDERR_FILENO);
  close(realError);
  if (this->Kept)
  {
    std::fclose(this->Kept);
  }
}

//------------------------------------------------------------------------------
// A file that is compressed well grows a thousandfold (the most that zlib can do); no machine has more
// than it has.
void ReaderGuard::LimitMemory(double fileSize)
{
  constexpr double least = 512.0 * 1024.0 * 1024.0;
  const double machine =
    static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  const double allowed =
    GetUsedMemory() + std::min(least + 1032.0 * fileSize, std::max(machine, least));
  getrlimit(RLIMIT_AS, &this->OldMemory);
  struct rlimit limit = this->OldMemory;
  limit.rlim_cur = static_cast<rlim_t>(std::min(allowed, static_cast<double>(limit.rlim_cur)));
  setrlimit(RLIMIT_AS, &limit);
}

//------------------------------------------------------------------------------
// Processor time, which a slow disk or a busy machine does not use up. The slowest readers of VTK take
// a fifth of a second for a MiB, compressed a few times that.
void ReaderGuard::LimitTime(double fileSize)
{
  constexpr double least = 5.0;                       // seconds
  constexpr double perByte = 5.0 / (1024.0 * 1024.0); // seconds
  const double allowed = std::min(least + perByte * fileSize, 1e6);
  struct itimerval timer = {};
  timer.it_value.tv_sec = static_cast<time_t>(allowed);
  setitimer(ITIMER_PROF, &timer, &this->OldTimer);
}

//------------------------------------------------------------------------------
std::string ReaderGuard::GetPrinted()
{
  std::fflush(stderr);
  char line[200] = "";
  if (this->Kept && std::fseek(this->Kept, 0, SEEK_SET) == 0 &&
      std::fgets(line, sizeof(line), this->Kept))
  {
    line[std::strcspn(line, "\r\n")] = '\0';
  }
  return line;
}
