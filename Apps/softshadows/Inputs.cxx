// SPDX-License-Identifier: BSD-3-Clause
#include "Inputs.h"

#include "Errors.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace fs = std::filesystem;

namespace
{
std::string Quoted(const std::string& path)
{
  return "\"" + path + "\"";
}
}

namespace Inputs
{
//------------------------------------------------------------------------------
void Check(const std::string& path)
{
  std::error_code ignored;
  const fs::file_status there = fs::status(path, ignored);
  if (there.type() == fs::file_type::not_found)
  {
    throw Failure("there is no file " + Quoted(path) + ".");
  }
  if (fs::is_directory(there))
  {
    throw Failure(Quoted(path) + " is a folder, not a file.");
  }
  if (fs::exists(there) && !fs::is_regular_file(there))
  {
    throw Failure(
      "cannot read " + Quoted(path) + ": it is no regular file but a pipe or a device.");
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    throw Failure("cannot read " + Quoted(path) + ": " + std::strerror(errno) + ".");
  }
  if (file.peek() == std::ifstream::traits_type::eof())
  {
    throw Failure(Quoted(path) + " is empty.");
  }
}

//------------------------------------------------------------------------------
std::string ReadText(const std::string& path, unsigned long long most)
{
  Check(path);
  std::error_code failed;
  if (fs::file_size(path, failed) > most)
  {
    throw Failure(
      "cannot read " + Quoted(path) + ": it has more than " + std::to_string(most >> 20) + " MiB.");
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file || !text)
  {
    throw Failure("cannot read " + Quoted(path) + ": " +
                  (errno ? std::strerror(errno) : "it cannot be read to its end") + ".");
  }
  return text.str();
}
}
