// SPDX-License-Identifier: BSD-3-Clause
#include "ObjFile.h"

#include "Errors.h"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace
{
//------------------------------------------------------------------------------
// Whether a line is a point whose three coordinates are not all finite numbers.
bool IsBadPoint(const std::string& line)
{
  const char* text = line.c_str();
  text += std::strspn(text, " \t");
  if (text[0] != 'v' || (text[1] != ' ' && text[1] != '\t') || line.back() == '\\')
  {
    return false;
  }
  ++text;
  for (int i = 0; i < 3; ++i)
  {
    char* end = nullptr;
    const double value = std::strtod(text, &end);
    if (end == text || !std::isfinite(value))
    {
      return true;
    }
    text = end;
  }
  return false;
}
}

//------------------------------------------------------------------------------
ObjFile::ObjFile(const std::string& path)
  : Path(path)
{
  std::ifstream file(path);
  std::string line;
  bool bad = false;
  while (!bad && std::getline(file, line))
  {
    bad = IsBadPoint(line);
  }
  if (!bad)
  {
    return;
  }
  this->Copy.reset(std::tmpfile());
  bool written = this->Copy != nullptr;
  file.clear();
  file.seekg(0);
  while (written && std::getline(file, line))
  {
    line = IsBadPoint(line) ? "v 1e300 1e300 1e300" : line;
    written = std::fprintf(this->Copy.get(), "%s\n", line.c_str()) >= 0;
  }
  if (!written || std::fflush(this->Copy.get()) != 0)
  {
    throw Failure(
      "cannot read \"" + path + "\": the temporary file that it needs cannot be written.");
  }
  std::rewind(this->Copy.get());
  this->Path = "/dev/fd/" + std::to_string(fileno(this->Copy.get()));
}
