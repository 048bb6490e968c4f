// SPDX-License-Identifier: BSD-3-Clause
#include "ObjFile.h"

#include "Errors.h"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace
{
const char* const Blanks = " \t\r\v\f";

// What stands behind the keyword of a line, or null where the line has another.
const char* FindRest(const std::string& line, const char* keyword)
{
  const char* text = line.c_str() + std::strspn(line.c_str(), Blanks);
  const std::size_t length = std::strlen(keyword);
  const bool found = std::strncmp(text, keyword, length) == 0 && text[length] != '\0' &&
                     std::strchr(Blanks, text[length]);
  return found ? text + length : nullptr;
}

//------------------------------------------------------------------------------
// Whether a line is a point whose three coordinates are not all finite numbers.
bool IsBadPoint(const std::string& line)
{
  const char* text = FindRest(line, "v");
  for (int i = 0; text && i < 3; ++i)
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

//------------------------------------------------------------------------------
/** A corner of a face: "point", "point/texture", "point//normal" or "point/texture/normal". */
struct Corner
{
  std::string Point;
  std::string Texture;
  std::string Normal;
};

// Take the next corner of a face from the text.
bool TakeCorner(const char*& text, Corner& corner)
{
  text += std::strspn(text, Blanks);
  const std::size_t length = std::strcspn(text, Blanks);
  const std::string word(text, length);
  text += length;
  const std::size_t first = word.find('/');
  const std::size_t second = first == std::string::npos ? first : word.find('/', first + 1);
  corner.Point = word.substr(0, first);
  corner.Texture = first == std::string::npos ? "" : word.substr(first + 1, second - first - 1);
  corner.Normal = second == std::string::npos ? "" : word.substr(second + 1);
  return length > 0;
}

// A line, together with those that it is continued on.
bool ReadLine(std::istream& file, std::string& line)
{
  if (!std::getline(file, line))
  {
    return false;
  }
  for (std::string next; !line.empty() && line.back() == '\\' && std::getline(file, next);)
  {
    line.back() = ' ';
    line += next;
  }
  return true;
}

//------------------------------------------------------------------------------
/** What there is of the kinds of data, and whether all corners have it. */
struct Content
{
  bool BadPoints = false;
  bool Normals = false; // "vn" lines
  bool Textures = false;
  bool AllNormals = true; // each corner refers to one
  bool AllTextures = true;

  bool HasMixedNormals() const { return this->Normals && !this->AllNormals; }
  bool MustBeCopied() const
  {
    return this->BadPoints || this->HasMixedNormals() || (this->Textures && !this->AllTextures);
  }
};

Content Scan(std::istream& file)
{
  Content content;
  for (std::string line; ReadLine(file, line);)
  {
    content.Normals = content.Normals || FindRest(line, "vn");
    content.Textures = content.Textures || FindRest(line, "vt");
    content.BadPoints = content.BadPoints || IsBadPoint(line);
    const char* face = FindRest(line, "f");
    for (Corner corner; face && TakeCorner(face, corner);)
    {
      content.AllNormals = content.AllNormals && !corner.Normal.empty();
      content.AllTextures = content.AllTextures && !corner.Texture.empty();
    }
  }
  return content;
}

//------------------------------------------------------------------------------
// The line as the copy has it.
std::string Mend(const std::string& line, bool withNormals)
{
  if (FindRest(line, "vt") || (!withNormals && FindRest(line, "vn")))
  {
    return "";
  }
  if (IsBadPoint(line))
  {
    return "v 1e300 1e300 1e300";
  }
  const char* text = FindRest(line, "f");
  if (!text)
  {
    return line;
  }
  std::string face = "f";
  for (Corner corner; TakeCorner(text, corner);)
  {
    face += " " + corner.Point + (withNormals ? "//" + corner.Normal : "");
  }
  return face;
}
}

//------------------------------------------------------------------------------
ObjFile::ObjFile(const std::string& path)
  : Path(path)
{
  std::ifstream file(path);
  const Content content = Scan(file);
  if (!content.MustBeCopied())
  {
    return;
  }
  const bool withNormals = content.Normals && content.AllNormals;
  this->Copy.reset(std::tmpfile());
  bool written = this->Copy != nullptr;
  file.clear();
  file.seekg(0);
  for (std::string line; written && ReadLine(file, line);)
  {
    written = std::fprintf(this->Copy.get(), "%s\n", Mend(line, withNormals).c_str()) >= 0;
  }
  if (!written || std::fflush(this->Copy.get()) != 0)
  {
    throw Failure(
      "cannot read \"" + path + "\": the temporary file that it needs cannot be written.");
  }
  std::rewind(this->Copy.get());
  this->Path = "/dev/fd/" + std::to_string(fileno(this->Copy.get()));
}
