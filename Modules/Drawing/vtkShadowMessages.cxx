// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowMessages.h"

#include "vtkObject.h"

//------------------------------------------------------------------------------
void vtkShadowMessages::SetPrefix(const std::string& prefix)
{
  this->Prefix = prefix;
  this->Forget();
}

//------------------------------------------------------------------------------
void vtkShadowMessages::Warn(const std::string& text)
{
  if (this->Said.insert(text).second)
  {
    vtkWarningWithObjectMacro(this->Source, << this->Prefix << ": " << text);
  }
}

//------------------------------------------------------------------------------
void vtkShadowMessages::Error(const std::string& text)
{
  if (this->Said.insert(text).second)
  {
    vtkErrorWithObjectMacro(this->Source, << this->Prefix << ": " << text);
  }
}
