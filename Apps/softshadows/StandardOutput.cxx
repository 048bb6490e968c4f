// SPDX-License-Identifier: BSD-3-Clause
#include "StandardOutput.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <iostream>
#include <unistd.h>

namespace
{
int failure = 0; // errno of what could not be printed
}

namespace StandardOutput
{
//------------------------------------------------------------------------------
void Reserve()
{
  for (const int stream : { STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO })
  {
    if (fcntl(stream, F_GETFD) == -1)
    {
      // The other way round, so that using it is still an error. open() takes the lowest number.
      const int opened = open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
      static_cast<void>(opened);
    }
  }
}

//------------------------------------------------------------------------------
std::string GetText(const nlohmann::ordered_json& json)
{
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

//------------------------------------------------------------------------------
void Print(const nlohmann::ordered_json& json)
{
  const std::string text = GetText(json);
  errno = 0;
  const bool printed =
    std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  failure = printed ? failure : errno;
}

//------------------------------------------------------------------------------
std::string Finish()
{
  errno = 0;
  std::cout.flush();
  const bool flushed = std::fflush(stdout) == 0;
  const int reason = errno != 0 ? errno : failure;
  if (flushed && std::cout && !std::ferror(stdout))
  {
    return "";
  }
  return reason != 0 ? std::strerror(reason) : "not all of it was taken";
}
}
