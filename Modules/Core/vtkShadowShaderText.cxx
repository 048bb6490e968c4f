// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowShaderText.h"

#include <algorithm>
#include <cctype>
#include <iterator>

namespace
{
bool IsWord(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

bool IsName(const std::string& text)
{
  return IsWord(text[0]) && !std::isdigit(static_cast<unsigned char>(text[0]));
}

/** Comments turned to blanks; lines stay lines. */
std::string BlankComments(std::string source)
{
  for (std::size_t i = 0; i + 1 < source.size(); ++i)
  {
    if (source[i] != '/' || (source[i + 1] != '/' && source[i + 1] != '*'))
    {
      continue;
    }
    const bool line = source[i + 1] == '/';
    std::size_t end = line ? source.find('\n', i) : source.find("*/", i + 2);
    end = end == std::string::npos ? source.size() : end + (line ? 0 : 2);
    for (; i < end; ++i)
    {
      source[i] = source[i] == '\n' ? '\n' : ' ';
    }
    --i;
  }
  return source;
}

/** The words of a text. */
std::vector<std::string> GetWords(const std::string& text)
{
  std::vector<std::string> words;
  for (std::size_t i = 0; i < text.size();)
  {
    std::size_t end = i;
    while (end < text.size() && IsWord(text[end]))
    {
      ++end;
    }
    if (end > i)
    {
      words.push_back(text.substr(i, end - i));
    }
    i = end + 1;
  }
  return words;
}
}

//------------------------------------------------------------------------------
vtkShadowShaderText::vtkShadowShaderText(const std::string& source)
{
  this->ReadTokens(this->ReadDirectives(BlankComments(source)));
  this->ReadFunctions();
}

//------------------------------------------------------------------------------
std::string vtkShadowShaderText::ReadDirectives(const std::string& source)
{
  std::string code = source;
  int condition = 0;
  for (std::size_t begin = 0; begin < code.size();)
  {
    std::size_t end = std::min(code.find('\n', begin), code.size());
    const std::size_t first = code.find_first_not_of(" \t\r", begin);
    if (first < end && code[first] == '#')
    {
      while (end < code.size() && end > 0 && code[end - 1] == '\\')
      {
        end = std::min(code.find('\n', end + 1), code.size());
      }
      std::vector<std::string> words = GetWords(code.substr(first, end - first));
      const std::string directive = words.empty() ? "" : words[0];
      condition += directive == "if" || directive == "ifdef" || directive == "ifndef";
      condition -= directive == "endif";
      if (directive == "endif")
      {
        this->Conditions[end] = condition;
      }
      else
      {
        this->Conditions[begin] = condition;
      }
      if ((directive == "define" || directive == "undef") && words.size() > 1)
      {
        this->Macros[words[1]].insert(words.begin() + 2, words.end());
        this->Names.insert(words.begin() + 1, words.end());
      }
      std::replace_if(
        code.begin() + begin, code.begin() + end, [](char c) { return c != '\n'; }, ' ');
    }
    begin = end + 1;
  }
  return code;
}

//------------------------------------------------------------------------------
void vtkShadowShaderText::ReadTokens(const std::string& code)
{
  int depth = 0;
  int parentheses = 0;
  for (std::size_t i = 0; i < code.size();)
  {
    if (std::isspace(static_cast<unsigned char>(code[i])))
    {
      ++i;
      continue;
    }
    std::size_t end = i + 1;
    while (IsWord(code[i]) && end < code.size() && IsWord(code[end]))
    {
      ++end;
    }
    depth -= code[i] == '}';
    parentheses -= code[i] == ')';
    this->Tokens.push_back(
      { code.substr(i, end - i), i, end, depth, parentheses, this->GetCondition(i) });
    depth += code[i] == '{';
    parentheses += code[i] == '(';
    if (IsName(this->Tokens.back().Text))
    {
      this->Names.insert(this->Tokens.back().Text);
    }
    i = end;
  }
}

//------------------------------------------------------------------------------
void vtkShadowShaderText::ReadFunctions()
{
  // A name, parentheses and a brace, outside all braces.
  int mains = 0;
  for (std::size_t open = 1; open < this->Tokens.size(); ++open)
  {
    if (this->Tokens[open].Text != "{" || this->Tokens[open].Depth != 0 ||
        this->Tokens[open - 1].Text != ")")
    {
      continue;
    }
    std::size_t name = open - 1;
    while (name > 0 && !(this->Tokens[name].Text == "(" && this->Tokens[name].Parentheses == 0))
    {
      --name;
    }
    std::size_t close = open + 1;
    while (close < this->Tokens.size() && this->Tokens[close].Depth != 0)
    {
      ++close;
    }
    if (name < 2 || close == this->Tokens.size())
    {
      break;
    }
    --name;
    if (this->Tokens[name].Text == "main")
    {
      ++mains;
      this->MainHead = this->Tokens[name - 1].Begin;
      this->MainBegin = this->Tokens[open].End;
      this->MainEnd = this->Tokens[close].Begin;
    }
    else
    {
      auto& body = this->Functions[this->Tokens[name].Text];
      for (std::size_t i = open; i < close; ++i)
      {
        body.insert(this->Tokens[i].Text);
      }
    }
    open = close;
  }
  if (mains != 1 || this->GetCondition(this->MainHead) != 0)
  {
    this->MainHead = this->MainBegin = this->MainEnd = None;
  }
}

//------------------------------------------------------------------------------
int vtkShadowShaderText::GetCondition(std::size_t position) const
{
  auto after = this->Conditions.upper_bound(position);
  return after == this->Conditions.begin() ? 0 : std::prev(after)->second;
}

//------------------------------------------------------------------------------
std::size_t vtkShadowShaderText::FindToken(std::size_t position) const
{
  return std::lower_bound(this->Tokens.begin(), this->Tokens.end(), position,
           [](const Token& token, std::size_t p) { return token.Begin < p; }) -
         this->Tokens.begin();
}

//------------------------------------------------------------------------------
bool vtkShadowShaderText::IsInMain(std::size_t position) const
{
  if (position == None || position < this->MainBegin || position > this->MainEnd)
  {
    return false;
  }
  const Token& next = this->Tokens[this->FindToken(position)]; // main's end, if nothing else
  const int depth = next.Depth + (next.Text == "}");
  return depth == 1 && next.Parentheses == 0 && this->GetCondition(position) == 0;
}

//------------------------------------------------------------------------------
bool vtkShadowShaderText::IsGlobal(std::size_t position) const
{
  const std::size_t next = position == None ? this->Tokens.size() : this->FindToken(position);
  return next < this->Tokens.size() && this->Tokens[next].Depth == 0 &&
         this->Tokens[next].Text != "}" && this->Tokens[next].Parentheses == 0 &&
         this->GetCondition(position) == 0;
}

//------------------------------------------------------------------------------
// Right before this token: nothing that belongs together is torn apart there.
bool vtkShadowShaderText::IsPlace(std::size_t token) const
{
  const Token& before = this->Tokens[token - 1];
  const Token& next = this->Tokens[token];
  static const std::set<std::string> goesOn = { "else", "while", ";", ",", ")", "." };
  const bool ended = before.Text == ";" || before.Text == "}" || before.End == this->MainBegin;
  return ended && goesOn.count(next.Text) == 0 && this->IsInMain(before.End) &&
         before.Condition == 0 && next.Condition == 0;
}

//------------------------------------------------------------------------------
std::size_t vtkShadowShaderText::GetPlaceBefore(std::size_t position) const
{
  for (std::size_t i = this->FindToken(position); i > 0; --i)
  {
    if (i < this->Tokens.size() && this->IsPlace(i))
    {
      return this->Tokens[i - 1].End;
    }
  }
  return None;
}

//------------------------------------------------------------------------------
std::size_t vtkShadowShaderText::GetPlaceAfter(std::size_t position) const
{
  for (std::size_t i = std::max<std::size_t>(1, this->FindToken(position)); i < this->Tokens.size();
       ++i)
  {
    if (this->IsPlace(i) && this->Tokens[i - 1].End >= position)
    {
      return this->Tokens[i - 1].End;
    }
  }
  return None;
}

//------------------------------------------------------------------------------
std::size_t vtkShadowShaderText::GetDeclaration(
  const std::string& type, const std::string& name, std::size_t end) const
{
  std::size_t place = None;
  for (std::size_t i = 1; i < this->Tokens.size() && this->Tokens[i].Begin < end; ++i)
  {
    const Token& token = this->Tokens[i];
    if (token.Text != name || this->Tokens[i - 1].Text != type || token.Parentheses != 0)
    {
      continue;
    }
    if (token.Depth == 0 && token.Begin < this->MainBegin && token.Condition == 0)
    {
      place = this->GetPlaceAfter(this->MainBegin);
    }
    else if (this->IsInMain(token.Begin))
    {
      while (i < this->Tokens.size() && this->Tokens[i].Text != ";")
      {
        ++i;
      }
      place = i < this->Tokens.size() ? this->GetPlaceAfter(this->Tokens[i].End) : None;
    }
  }
  return place != None && place <= end ? place : None;
}

//------------------------------------------------------------------------------
std::size_t vtkShadowShaderText::GetUniform(const std::string& type, const std::string& name) const
{
  std::size_t place = None;
  bool uniform = false;
  bool typed = false;
  bool named = false;
  for (const Token& token : this->Tokens)
  {
    const bool ends = token.Text == ";" || token.Text == "{" || token.Text == "}";
    if (ends && token.Text == ";" && named)
    {
      place = token.End;
    }
    uniform = !ends && (uniform || (token.Text == "uniform" && token.Depth == 0));
    typed = !ends && (typed || (uniform && token.Text == type));
    named = !ends && (named || (typed && token.Text == name)) && token.Text != "[";
  }
  return place;
}

//------------------------------------------------------------------------------
std::set<std::string> vtkShadowShaderText::GetNamesFor(
  const std::function<bool(const std::string&)>& isMeant) const
{
  std::set<std::string> names;
  std::copy_if(this->Names.begin(), this->Names.end(), std::inserter(names, names.end()), isMeant);
  for (bool found = !names.empty(); found;)
  {
    found = false;
    for (const auto* definitions : { &this->Macros, &this->Functions })
    {
      for (const auto& definition : *definitions)
      {
        if (std::any_of(definition.second.begin(), definition.second.end(),
              [&names](const std::string& name) { return names.count(name) != 0; }))
        {
          found = names.insert(definition.first).second || found;
        }
      }
    }
  }
  return names;
}

//------------------------------------------------------------------------------
std::size_t vtkShadowShaderText::GetFirst(const std::set<std::string>& names) const
{
  for (std::size_t i = this->FindToken(this->MainBegin);
       i < this->Tokens.size() && this->Tokens[i].Begin < this->MainEnd; ++i)
  {
    if (names.count(this->Tokens[i].Text) != 0)
    {
      return this->Tokens[i].Begin;
    }
  }
  return None;
}

//------------------------------------------------------------------------------
std::size_t vtkShadowShaderText::GetLast(const std::string& name) const
{
  std::size_t last = None;
  for (std::size_t i = this->FindToken(this->MainBegin);
       i < this->Tokens.size() && this->Tokens[i].Begin < this->MainEnd; ++i)
  {
    last = this->Tokens[i].Text == name ? this->Tokens[i].Begin : last;
  }
  return last;
}

//------------------------------------------------------------------------------
bool vtkShadowShaderText::IsAssigned(const std::string& name, std::size_t begin) const
{
  for (std::size_t i = this->FindToken(begin); i + 3 < this->Tokens.size(); ++i)
  {
    const std::size_t member = this->Tokens[i + 1].Text == "." ? 2 : 0;
    if (this->Tokens[i].Text == name && this->Tokens[i + member + 1].Text == "=" &&
        this->Tokens[i + member + 2].Text != "=")
    {
      return true;
    }
  }
  return false;
}
