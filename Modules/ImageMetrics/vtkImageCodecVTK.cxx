// SPDX-License-Identifier: BSD-3-Clause
// Image files through VTK: PNG, BMP, TIFF, and EXR without compression.
#include "vtkImageCodec.h"

#include "vtkBMPWriter.h"
#include "vtkFloatArray.h"
#include "vtkImageMetricsPrivate.h"
#include "vtkImageReader2.h"
#include "vtkImageReader2Factory.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPlainEXR.h"
#include "vtkTIFFWriter.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include <unistd.h>

namespace
{
namespace fs = std::filesystem;
using namespace vtkImageMetricsPrivate;

//------------------------------------------------------------------------------
std::string Extension(const std::string& path)
{
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

//------------------------------------------------------------------------------
std::vector<unsigned char> Content(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

//------------------------------------------------------------------------------
// Whole numbers of more than 8 bits as parts of the largest.
vtkSmartPointer<vtkFloatArray> ToFloat(vtkDataArray* pixels)
{
  vtkNew<vtkFloatArray> floats;
  floats->DeepCopy(pixels);
  if (pixels->GetDataType() == VTK_UNSIGNED_SHORT)
  {
    const float most = std::numeric_limits<unsigned short>::max();
    float* values = floats->GetPointer(0);
    std::for_each(
      values, values + floats->GetNumberOfValues(), [most](float& value) { value /= most; });
  }
  return floats;
}

//------------------------------------------------------------------------------
// A writer that can write only files.
std::string EncodeByFile(
  vtkImageWriter* writer, vtkImageData* image, std::vector<unsigned char>& encoded)
{
  std::string path = (fs::temp_directory_path() / "softshadows-XXXXXX").string();
  const int file = mkstemp(path.data());
  if (file < 0)
  {
    return "there is no temporary file";
  }
  writer->SetInputData(image);
  writer->SetFileName(path.c_str());
  writer->Write();
  encoded = Content(path);
  std::error_code ignored;
  fs::remove(path, ignored);
  ::close(file);
  return writer->GetErrorCode() || encoded.empty() ? "it could not be encoded" : "";
}
}

//------------------------------------------------------------------------------
std::string vtkImageCodec::Read(const std::string& path, vtkImageData* image)
{
  if (vtkPlainEXR::IsOne(path))
  {
    return vtkPlainEXR::Decode(Content(path), image);
  }
  vtkSmartPointer<vtkImageReader2> reader;
  reader.TakeReference(vtkImageReader2Factory::CreateImageReader2(path.c_str()));
  if (!reader)
  {
    return "its format is unknown (built without OpenImageIO)";
  }
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData* read = reader->GetOutput();
  vtkDataArray* pixels = read->GetPointData()->GetScalars();
  if (reader->GetErrorCode() || !pixels || pixels->GetNumberOfTuples() == 0)
  {
    return "it could not be decoded";
  }
  if (read->GetDimensions()[2] != 1)
  {
    return "it is a volume";
  }
  if (pixels->GetNumberOfComponents() > 4)
  {
    return "it has " + std::to_string(pixels->GetNumberOfComponents()) + " channels, not 1 to 4";
  }
  vtkSmartPointer<vtkDataArray> values = pixels;
  if (pixels->GetDataType() != VTK_UNSIGNED_CHAR)
  {
    values = ToFloat(pixels);
  }
  values->SetName("ImageScalars");
  image->Initialize();
  image->SetDimensions(read->GetDimensions());
  image->GetPointData()->SetScalars(values);
  return "";
}

//------------------------------------------------------------------------------
std::string vtkImageCodec::Encode(const std::string& name, vtkImageData* image,
  const std::string& software, std::vector<unsigned char>& encoded)
{
  const std::string extension = Extension(name);
  if (extension == ".exr")
  {
    encoded = vtkPlainEXR::Encode(image, software);
    return "";
  }
  const bool tiff = extension == ".tif" || extension == ".tiff";
  vtkDataArray* pixels = image->GetPointData()->GetScalars();
  vtkNew<vtkImageData> bytes;
  bytes->ShallowCopy(image);
  if (vtkFloatArray* floats = tiff ? nullptr : vtkFloatArray::SafeDownCast(pixels))
  {
    vtkNew<vtkUnsignedCharArray> rounded;
    rounded->SetNumberOfComponents(floats->GetNumberOfComponents());
    rounded->SetNumberOfTuples(floats->GetNumberOfTuples());
    const float* values = floats->GetPointer(0);
    std::transform(values, values + floats->GetNumberOfValues(), rounded->GetPointer(0),
      [](float value) { return ToByte(value); });
    bytes->GetPointData()->SetScalars(rounded);
  }
  if (extension == ".png")
  {
    vtkNew<vtkPNGWriter> writer;
    if (!software.empty())
    {
      writer->AddText("Software", software.c_str());
    }
    return EncodeByFile(writer, bytes, encoded);
  }
  if (extension == ".bmp")
  {
    if (pixels->GetNumberOfComponents() == 4)
    {
      return "the format bmp cannot store 4 components";
    }
    vtkNew<vtkBMPWriter> writer;
    return EncodeByFile(writer, bytes, encoded);
  }
  if (tiff)
  {
    vtkNew<vtkTIFFWriter> writer;
    return EncodeByFile(writer, bytes, encoded);
  }
  return "its extension names no format that can be written: png, exr, tif or bmp (built without "
         "OpenImageIO)";
}
