// SPDX-License-Identifier: BSD-3-Clause
// What differs between the VTK versions, 9.1 to 9.7: sources include this in the place of what was
// renamed or moved. Run were 9.1 (Debian) and 9.5.0 (the wheel); of the others the sources were
// compiled, no more.
//
//   since  what changed                                  how it is handled
//   9.3    VTK's classes may lie in a namespace of        not supported: our headers declare them
//          VTK_ABI_NAMESPACE_NAME, by default in none     forward outside of one
//   9.3    vtkCompositePolyDataMapper has the blocks'    vtkShadowCompositeMapper is that which
//          attributes; ...Mapper2 is gone in 9.5          has them
//   9.4    glad in the place of glew: vtk_glad.h, other   vtkShadowOpenGL.h has VTK_SHADOW_HAS_GL
//          names of what a context has
//   9.4    modules VTK::glew and VTK::opengl are gone     neither is named: what there is comes
//                                                         with VTK::RenderingOpenGL2
//   9.4    functions of OpenGL 1.1 are pointers too       only Testing/Cxx/BadInputGPU.cxx minds
//   9.4    vtkVector.h holds the operators, and           included here
//          vtkVectorOperators.h is gone in 9.6
//   9.4    the window is chosen at run time: X, EGL      Python's warning for want of a display
//                                                         is for older ones
//   9.5    nothing is made of a module without classes   Drawing says EXCLUDE_WRAP
//          to wrap, but what depends on it imports it
//   9.5    the component WrapPython is never found        CMake asks for it as an optional one
//   9.7    a module's target is named after its library   CMake names modules by their aliases
//
// The text of VTK's shaders that vtkShadowInjection.cxx relies on is the same in all of them.

#ifndef vtkShadowVTKVersion_h
#define vtkShadowVTKVersion_h

#include "vtkVersionMacros.h"

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
#include "vtkCompositePolyDataMapper.h"
using vtkShadowCompositeMapper = vtkCompositePolyDataMapper;
#else
#include "vtkCompositePolyDataMapper2.h"
using vtkShadowCompositeMapper = vtkCompositePolyDataMapper2;
#endif

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
#include "vtkVector.h"
#else
#include "vtkVectorOperators.h"
#endif

#if defined(VTK_HAS_ABI_NAMESPACE) && VTK_HAS_ABI_NAMESPACE
#error "VTK was built with VTK_ABI_NAMESPACE_NAME, which is not supported"
#endif

#endif
