// SPDX-License-Identifier: BSD-3-Clause
// Only the choice, and what is drawn without an extension, were run: the software rasterizer has
// neither of them.
#include "vtkVirtualConservative.h"

#include "vtkShadowOpenGL.h"

#include <cstring>

namespace
{
// Loaders need not know these extensions.
constexpr unsigned int ConservativeNV = 0x9346;
constexpr unsigned int ConservativeINTEL = 0x83FE;
}

//------------------------------------------------------------------------------
unsigned int vtkVirtualConservative::Choose(const std::function<bool(const char*)>& has)
{
  if (has("GL_NV_conservative_raster"))
  {
    return ConservativeNV;
  }
  return has("GL_INTEL_conservative_rasterization") ? ConservativeINTEL : 0;
}

//------------------------------------------------------------------------------
unsigned int vtkVirtualConservative::Choose()
{
  return Choose(
    [](const char* name)
    {
      GLint count = 0;
      glGetIntegerv(GL_NUM_EXTENSIONS, &count);
      for (GLint i = 0; i < count; ++i)
      {
        const auto* one = reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, i));
        if (one && std::strcmp(one, name) == 0)
        {
          return true;
        }
      }
      return false;
    });
}

//------------------------------------------------------------------------------
vtkVirtualConservative::vtkVirtualConservative(unsigned int capability)
  : Capability(capability)
{
  if (this->Capability != 0)
  {
    glEnable(this->Capability);
  }
}

//------------------------------------------------------------------------------
vtkVirtualConservative::~vtkVirtualConservative()
{
  if (this->Capability != 0)
  {
    glDisable(this->Capability);
  }
}
