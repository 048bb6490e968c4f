// SPDX-License-Identifier: BSD-3-Clause
// A picture of the viewer's window, written with what it takes to draw it again.

#ifndef ViewSnapshot_h
#define ViewSnapshot_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <nlohmann/json.hpp>

#include <string>

class vtkRenderWindow;

namespace ViewSnapshot
{
/** What the window shows, unsigned char RGB. */
vtkSmartPointer<vtkImageData> Grab(vtkRenderWindow* window);

/**
 * Write NAME.png, NAME-visibility.exr (if there is one) and NAME.json into the working directory, under
 * a name that none of them has yet: softshadows-001 and so on. Gives the name.
 */
std::string Write(
  vtkImageData* picture, vtkImageData* visibility, const nlohmann::ordered_json& settings);
}

#endif
