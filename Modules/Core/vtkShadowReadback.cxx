// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowReadback.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkShadowFrame.h"
#include "vtkShadowScreen.h"
#include "vtkUnsignedCharArray.h"

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
      const auto values = buffer.ReadTarget(frame.Window, static_cast<int>(part));
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
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->GetPointData()->SetScalars(visibility);
  image->GetPointData()->AddArray(mask);
  for (auto kept = this->Images.begin(); kept != this->Images.end();)
  {
    const bool gone = std::find(lights.begin(), lights.end(), kept->first) == lights.end();
    kept = gone ? this->Images.erase(kept) : std::next(kept);
  }
  this->Images[light] = image;
  return image;
}
