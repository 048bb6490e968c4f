// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowReadback.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkShadowFrame.h"
#include "vtkShadowScreen.h"
#include "vtkUnsignedCharArray.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <iterator>

//------------------------------------------------------------------------------
vtkImageData* vtkShadowReadback::Make(const vtkShadowFrame& frame, vtkShadowScreen& screen,
  const vtkLight* light, const std::vector<vtkLight*>& lights)
{
  vtkVisibilityBuffer& buffer = screen.Visibility;
  const int width = screen.Receivers.GetWidth();
  const int height = screen.Receivers.GetHeight();
  const int stored = buffer.GetComponents();
  const int components = stored == 1 ? 1 : 3;
  const vtkIdType pixels = static_cast<vtkIdType>(width) * height;

  vtkNew<vtkFloatArray> visibility;
  visibility->SetName("Visibility");
  visibility->SetNumberOfComponents(components);
  visibility->SetNumberOfTuples(pixels);
  visibility->Fill(1.0);
  for (std::size_t part = 0; part < frame.Parts.size(); ++part)
  {
    if (frame.Parts[part].Light.Light == light)
    {
      const float share = static_cast<float>(frame.Parts[part].Share);
      const auto values = buffer.ReadShown(frame.Window, static_cast<int>(part));
      float* sum = visibility->GetPointer(0);
      for (vtkIdType i = 0; i < pixels * components; ++i)
      {
        // Sums of weights come to 1 but for rounding.
        const float value = values[i / components * stored + i % components];
        sum[i] -= share * (1.0f - std::clamp(value, 0.0f, 1.0f));
      }
    }
  }
  vtkNew<vtkUnsignedCharArray> mask;
  mask->SetName("Receiver");
  mask->SetNumberOfTuples(pixels);
  const auto& receivers = screen.Receivers.Read(frame.Window);
  for (vtkIdType i = 0; i < pixels; ++i)
  {
    mask->SetValue(i, receivers[i].w != 0.0f);
  }
  vtkNew<vtkFloatArray> cosine;
  cosine->SetName("Cosine");
  cosine->SetNumberOfTuples(pixels);
  cosine->Fill(1.0);
  const auto part = std::find_if(frame.Parts.begin(), frame.Parts.end(),
    [light](const vtkShadowLightPart& one) { return one.Light.Light == light; });
  if (part != frame.Parts.end())
  {
    const bool directional = part->Light.IsDirectional();
    const glm::dvec3 place =
      frame.GetWorldToVC() * (directional ? glm::dvec4(-part->Light.Direction, 0.0)
                                          : glm::dvec4(part->Light.Position, 1.0));
    for (vtkIdType i = 0; i < pixels; ++i)
    {
      if (vtkShadowReceiver::IsOne(receivers[i]))
      {
        const glm::dvec3 towards = directional ? place : place - glm::dvec3(receivers[i]);
        const double away = glm::length(towards);
        const double along = glm::dot(vtkShadowReceiver::Unpack(receivers[i].w).Normal, towards);
        cosine->SetValue(i, static_cast<float>(away > 0.0 ? std::max(0.0, along / away) : 1.0));
      }
    }
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->GetPointData()->SetScalars(visibility);
  image->GetPointData()->AddArray(mask);
  image->GetPointData()->AddArray(cosine);
  for (auto kept = this->Images.begin(); kept != this->Images.end();)
  {
    const bool gone = std::find(lights.begin(), lights.end(), kept->first) == lights.end();
    kept = gone ? this->Images.erase(kept) : std::next(kept);
  }
  this->Images[light] = image;
  return image;
}
