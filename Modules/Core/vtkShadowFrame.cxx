#include "vtkShadowFrame.h"

#include "vtkShadowCasters.h"

#include <glm/gtc/matrix_transform.hpp>

//------------------------------------------------------------------------------
glm::dmat4 vtkShadowFrame::GetWCToVC() const
{
  return glm::inverse(this->VCToWC);
}

//------------------------------------------------------------------------------
glm::dmat4 vtkShadowFrame::GetWorldToVC() const
{
  return glm::translate(this->GetWCToVC(), -this->Casters->GetOrigin());
}
