// SPDX-License-Identifier: BSD-3-Clause
#include "ReaderGuard.h"

#include <cstring>
#include <iterator>
#include <unistd.h>

namespace
{
int realError = -1;
char message[4096];

// Only what may be called in a signal handler.
void ReportCrash(int)
{
  const ssize_t written = write(realError, message, std::strlen(message));
  static_cast<void>(written); // there is nobody left to tell
  _exit(1);
}
}

//------------------------------------------------------------------------------
ReaderGuard::ReaderGuard(const std::string& path)
{
  std::snprintf(message, sizeof(message),
    "softshadows: error: cannot read \"%.3000s\": it is damaged; its reader crashed.\n",
    path.c_str());
  std::fflush(stderr);
  realError = dup(STDERR_FILENO);
  this->Kept = std::tmpfile();
  if (this->Kept)
  {
    dup2(fileno(this->Kept), STDERR_FILENO);
  }
  for (std::size_t i = 0; i < std::size(Signals); ++i)
  {
    struct sigaction action = {};
    action.sa_handler = ReportCrash;
    sigaction(Signals[i], &action, &this->Old[i]);
  }
}

//------------------------------------------------------------------------------
ReaderGuard::~ReaderGuard()
{
  for (std::size_t i = 0; i < std::size(Signals); ++i)
  {
    sigaction(Signals[i], &this->Old[i], nullptr);
  }
  std::fflush(stderr);
  dup2(realError, STDERR_FILENO);
  close(realError);
  if (this->Kept)
  {
    std::fclose(this->Kept);
  }
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
