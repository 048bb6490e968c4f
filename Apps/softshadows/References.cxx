// SPDX-License-Identifier: BSD-3-Clause
#include "References.h"

#include "Errors.h"
#include "OffscreenWindow.h"
#include "Progress.h"
#include "Techniques.h"

#include "vtkAreaLight.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkShadowNumber.h"

#include <algorithm>
#include <string>

const char* const ReferenceTechnique = "ray-traced";

namespace References
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkShadowPass> MakePass(int samples)
{
  const auto known = Techniques::GetNames();
  if (std::find(known.begin(), known.end(), ReferenceTechnique) == known.end())
  {
    throw Failure(
      "this build has no reference to compare with: the technique ray-traced is missing "
      "(SOFTSHADOWS_RAY_TRACING).");
  }
  TechniqueOptions options;
  options.Measured = true;
  auto pass = options.Create(ReferenceTechnique, true);
  pass->SetParameter("samples", std::to_string(samples));
  Messages::Check("--reference-samples");
  return pass;
}

//------------------------------------------------------------------------------
Reference Draw(OffscreenWindow& window, vtkShadowPass* pass, vtkAreaLight* light)
{
  Reference reference;
  const std::string samples = pass->GetParameter("samples");
  window.GetRenderer()->SetPass(pass);
  double expected = 0.0;
  if (Progress::IsShown())
  {
    constexpr int few = 16;
    pass->SetParameter("samples", std::to_string(few));
    window.Render(); // sets all up
    expected = window.Render() / few * vtkShadowNumber::Parse(samples).value_or(0.0);
    pass->SetParameter("samples", samples);
  }
  {
    const ExpectedProgress progress("reference, " + samples + " rays a pixel", expected);
    reference.Milliseconds = window.Render();
  }
  reference.Visibility = GetVisibility(pass, light, nullptr);
  reference.Frame = window.Grab();
  return reference;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> Copy(vtkImageData* image)
{
  Messages::Check();
  auto copy = vtkSmartPointer<vtkImageData>::New();
  copy->DeepCopy(image);
  return copy;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> GetVisibility(
  vtkShadowPass* pass, vtkAreaLight* light, vtkImageData* like)
{
  if (pass)
  {
    return Copy(pass->GetVisibility(light));
  }
  auto all = Copy(like);
  vtkFloatArray::SafeDownCast(all->GetPointData()->GetArray("Visibility"))->FillValue(1.0f);
  return all;
}
}
