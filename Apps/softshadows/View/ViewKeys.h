// SPDX-License-Identifier: BSD-3-Clause
// What keys and the mouse do in the viewer: one table, from which the viewer acts, its help and the
// documentation are made.

#ifndef ViewKeys_h
#define ViewKeys_h

#include <string>
#include <vector>

class Viewer;

struct ViewKey
{
  enum class Shift
  {
    Any,
    Without,
    With
  };

  const char* Shown;             // to the user
  const char* Meaning;           // empty for a further key of the row above
  std::vector<std::string> Keys; // as X names them, letters small; none for the mouse
  void (Viewer::*Action)(int) = nullptr;
  int Amount = 0;
  Shift WithShift = Shift::Any;
};

namespace ViewKeys
{
const std::vector<ViewKey>& GetAll();

/** What a key does; nullptr for one that does nothing. */
const ViewKey* Find(const std::string& key, bool shift);

/** Two columns of text. */
std::string GetHelp();
}

#endif
