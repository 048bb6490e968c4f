// SPDX-License-Identifier: BSD-3-Clause
// What is probably not meant of a frame's lights, in a user's words.

#ifndef vtkShadowAdvice_h
#define vtkShadowAdvice_h

#include <string>

struct vtkShadowDeclaration;
struct vtkShadowFrame;

namespace vtkShadowAdvice
{
/** The first thing that holds of the lights and casters that were gathered; empty where none does. */
std::string Find(const vtkShadowFrame& frame, const vtkShadowDeclaration& declaration);
/** An assumption of a filter that does not hold, by what the technique counted; empty where all do. */
std::string FindBroken(const vtkShadowFrame& frame);
}

#endif
