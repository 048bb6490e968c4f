// SPDX-License-Identifier: BSD-3-Clause
// OpenGL's functions and constants, as each VTK version has them: see vtkShadowVTKVersion.h.

#ifndef vtkShadowOpenGL_h
#define vtkShadowOpenGL_h

#include "vtkVersionMacros.h"

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
#include "vtk_glad.h"
/** Whether the context has it: VERSION_4_5, ARB_clip_control. */
#define VTK_SHADOW_HAS_GL(name) (GLAD_GL_##name != 0)
#else
#include "vtk_glew.h"
#define VTK_SHADOW_HAS_GL(name) (GLEW_##name != 0)
#endif

#endif
