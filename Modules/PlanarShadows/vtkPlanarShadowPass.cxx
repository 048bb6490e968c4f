// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPlanarShadowPass.h"

#include "vtkObjectFactory.h"
#include "vtkPlanarShadowTechnique.h"
#include "vtkShadowPlanes.h"

vtkStandardNewMacro(vtkPlanarShadowPass);

//------------------------------------------------------------------------------
vtkPlanarShadowPass::vtkPlanarShadowPass()
  : Planes(new vtkShadowPlanes)
{
  this->SetTechnique("planar-hard");
}

//------------------------------------------------------------------------------
vtkPlanarShadowPass::~vtkPlanarShadowPass() = default;

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::PrepareTechnique(vtkShadowTechnique& technique)
{
  if (auto* planar = dynamic_cast<vtkPlanarShadowTechnique*>(&technique))
  {
    planar->SetGivenPlanes(*this->Planes);
  }
}

//------------------------------------------------------------------------------
bool vtkPlanarShadowPass::AddPlane(double ox, double oy, double oz, double nx, double ny, double nz)
{
  if (!this->Planes->Add({ ox, oy, oz }, { nx, ny, nz }))
  {
    vtkErrorMacro("AddPlane: point (" << ox << ", " << oy << ", " << oz << ") and normal (" << nx
                                      << ", " << ny << ", " << nz
                                      << ") are no plane: they must be finite, and the normal not "
                                         "zero. It is left out.");
    return false;
  }
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::RemoveAllPlanes()
{
  this->Planes->RemoveAll();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkPlanarShadowPass::GetNumberOfPlanes()
{
  return this->Planes->GetNumberOfGiven();
}

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::CopySettings(vtkShadowPass* other)
{
  this->Superclass::CopySettings(other);
  if (auto* planar = vtkPlanarShadowPass::SafeDownCast(other))
  {
    this->Planes->SetGiven(*planar->Planes);
  }
}

//------------------------------------------------------------------------------
void vtkPlanarShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfPlanes: " << this->GetNumberOfPlanes() << "\n";
}
