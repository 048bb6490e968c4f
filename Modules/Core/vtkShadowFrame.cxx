#include "vtkShadowFrame.h"

#include "vtkShadowCasters.h"

#include <glm/geometric.hpp>
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

//------------------------------------------------------------------------------
double vtkShadowFrame::GetRounding() const
{
  const double distance = glm::length(glm::dvec3(this->VCToWC[3]));
  return (distance + this->Casters->GetSize()) / 65536.0 + this->LeastRounding;
}
