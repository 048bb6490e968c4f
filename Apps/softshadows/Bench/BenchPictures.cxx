// SPDX-License-Identifier: BSD-3-Clause
#include "BenchPictures.h"

#include "Errors.h"

#include "vtkBase64Utilities.h"
#include "vtkImageData.h"
#include "vtkImageResize.h"
#include "vtkJPEGWriter.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace BenchPictures
{
namespace
{
std::string Encode(vtkUnsignedCharArray* file)
{
  Messages::Check("a picture of the report cannot be encoded");
  const auto bytes = static_cast<unsigned long>(file ? file->GetNumberOfValues() : 0);
  std::string text((bytes + 2) / 3 * 4, '\0');
  if (bytes > 0)
  {
    text.resize(vtkBase64Utilities::Encode(
      file->GetPointer(0), bytes, reinterpret_cast<unsigned char*>(text.data())));
  }
  return text;
}
}

//------------------------------------------------------------------------------
std::string EncodePNG(vtkImageData* picture)
{
  // Steps that nobody sees make the file a third as large.
  constexpr int step = 15;
  vtkNew<vtkImageData> coarse;
  coarse->DeepCopy(picture);
  auto* values = vtkUnsignedCharArray::SafeDownCast(coarse->GetPointData()->GetScalars());
  for (vtkIdType i = 0; values && i < values->GetNumberOfValues(); ++i)
  {
    values->SetValue(i, static_cast<unsigned char>((values->GetValue(i) + step / 2) / step * step));
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(coarse);
  writer->SetCompressionLevel(9);
  writer->WriteToMemoryOn();
  writer->Write();
  return Encode(writer->GetResult());
}

//------------------------------------------------------------------------------
std::string EncodeJPEG(vtkImageData* picture)
{
  vtkNew<vtkJPEGWriter> writer;
  writer->SetInputData(picture);
  writer->SetQuality(85);
  writer->WriteToMemoryOn();
  writer->Write();
  return Encode(writer->GetResult());
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> Shrink(vtkImageData* picture, int width)
{
  const int* size = picture->GetDimensions();
  if (size[0] <= width)
  {
    return picture;
  }
  const double height = static_cast<double>(size[1]) * width / size[0];
  vtkNew<vtkImageResize> resize;
  resize->SetInputData(picture);
  resize->SetOutputDimensions(width, std::max(1, static_cast<int>(std::lround(height))), 1);
  resize->Update();
  Messages::Check("a picture of the report cannot be made smaller");
  return resize->GetOutput();
}
}
