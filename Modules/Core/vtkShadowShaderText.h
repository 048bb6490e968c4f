// SPDX-License-Identifier: BSD-3-Clause
// What is where in the text of a fragment shader that VTK and its user wrote: as much of GLSL's
// grammar as it takes to find main(), its statements, and what a name stands for.

#ifndef vtkShadowShaderText_h
#define vtkShadowShaderText_h

#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

class vtkShadowShaderText
{
public:
  /** Of positions in the text: none. */
  static constexpr std::size_t None = std::string::npos;

  explicit vtkShadowShaderText(const std::string& source);

  /** Right after main's opening brace, and its closing one. None without just one main(). */
  std::size_t GetMainBegin() const { return this->MainBegin; }
  std::size_t GetMainEnd() const { return this->MainEnd; }
  /** Where main()'s definition begins. */
  std::size_t GetMainHead() const { return this->MainHead; }
  /** Whether a place is among main's own statements, or outside all functions; under no #if. */
  bool IsInMain(std::size_t position) const;
  bool IsGlobal(std::size_t position) const;

  /** The last place up to here, or the first from here on, between main's own statements. */
  std::size_t GetPlaceBefore(std::size_t position) const;
  std::size_t GetPlaceAfter(std::size_t position) const;

  /**
   * Where `vec4 name` is declared last before `end`, outside all functions or among main's own
   * statements: the place after it, at which it can be used. None where it is not.
   */
  std::size_t GetDeclaration(
    const std::string& type, const std::string& name, std::size_t end = None) const;
  /** The place after the last declaration of a uniform. */
  std::size_t GetUniform(const std::string& type, const std::string& name) const;

  /** Names that are meant, and those of macros and functions that use one of them. */
  std::set<std::string> GetNamesFor(const std::function<bool(const std::string&)>& isMeant) const;
  /** Where one of these stands first in main, or a name last. */
  std::size_t GetFirst(const std::set<std::string>& names) const;
  std::size_t GetLast(const std::string& name) const;
  /** Whether a member or the whole of a variable is assigned to after this place. */
  bool IsAssigned(const std::string& name, std::size_t begin) const;
  bool IsMacro(const std::string& name) const { return this->Macros.count(name) != 0; }
  /** All names in code, macros included; comments left out. */
  const std::set<std::string>& GetNames() const { return this->Names; }

private:
  struct Token
  {
    std::string Text;
    std::size_t Begin;
    std::size_t End;
    int Depth; // of braces, before an opening one and after a closing one
    int Parentheses;
    int Condition; // number of #if around it
  };
  /** Comments and directives turned to blanks; macros and conditions are kept. */
  std::string ReadDirectives(const std::string& source);
  void ReadTokens(const std::string& code);
  void ReadFunctions();
  int GetCondition(std::size_t position) const;
  /** Index of the first token that begins at a position or later. */
  std::size_t FindToken(std::size_t position) const;
  bool IsPlace(std::size_t token) const;

  std::vector<Token> Tokens;
  std::map<std::size_t, int> Conditions;                  // how many #if are open from here on
  std::map<std::string, std::set<std::string>> Macros;    // what their bodies name
  std::map<std::string, std::set<std::string>> Functions; // but main
  std::set<std::string> Names;
  std::size_t MainHead = None;
  std::size_t MainBegin = None;
  std::size_t MainEnd = None;
};

#endif
