// SPDX-License-Identifier: BSD-3-Clause
// What a pass has to say to the user, each thing once.

#ifndef vtkShadowMessages_h
#define vtkShadowMessages_h

#include "vtkSoftShadowsDrawingModule.h" // For export macro

#include <set>
#include <string>

class vtkObject;

class VTKSOFTSHADOWSDRAWING_EXPORT vtkShadowMessages
{
public:
  /** They come from an object, which outlives this. */
  explicit vtkShadowMessages(vtkObject* source)
    : Source(source)
  {
  }

  /** What every message begins with. Another one lets all be said again. */
  void SetPrefix(const std::string& prefix);
  ///@{ Say something by VTK's macros, once until Forget.
  void Warn(const std::string& text);
  void Error(const std::string& text);
  ///@}
  void Forget() { this->Said.clear(); }

private:
  vtkObject* Source;
  std::string Prefix;
  std::set<std::string> Said;
};

#endif
