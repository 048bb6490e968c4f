// SPDX-License-Identifier: BSD-3-Clause
// Image files through OpenImageIO.
#include "vtkImageCodec.h"

#include "vtkFloatArray.h"
#include "vtkImageMetricsPrivate.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>

namespace
{
using namespace vtkImageMetricsPrivate;

//------------------------------------------------------------------------------
// The file's own words for what went wrong. Both sources are emptied: OpenImageIO prints what
// nobody asked for when the program ends.
template <typename File>
std::string Reason(const std::unique_ptr<File>& file)
{
  std::string reason = file ? file->geterror() : std::string();
  const std::string general = OIIO::geterror();
  reason = reason.empty() ? general : reason;
  reason.erase(reason.find_last_not_of(" \n\r.") + 1); // the caller ends the sentence
  return reason.empty() ? "OpenImageIO gives no reason" : reason;
}

//------------------------------------------------------------------------------
// Rows of a picture, turned upside down and converted value by value.
template <typename From, typename To, typename Convert>
void FlipRows(const From* from, To* to, const int size[2], int components, Convert convert)
{
  const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(size[0]) * components;
  for (int y = 0; y < size[1]; ++y)
  {
    const From* source = from + (size[1] - 1 - y) * row;
    std::transform(source, source + row, to + y * row, convert);
  }
}

//------------------------------------------------------------------------------
// False when the file could not be read, the image is then as it was.
template <typename Array, typename Value>
bool ReadPixels(OIIO::ImageInput& input, OIIO::TypeDesc type, vtkImageData* image)
{
  const OIIO::ImageSpec& spec = input.spec();
  std::vector<Value> rows(static_cast<std::size_t>(spec.image_pixels()) * spec.nchannels);
  if (!input.read_image(0, 0, 0, spec.nchannels, type, rows.data()))
  {
    return false;
  }
  const int size[2] = { spec.width, spec.height };
  vtkSmartPointer<Array> pixels = vtkSmartPointer<Array>::New();
  pixels->SetName("ImageScalars");
  pixels->SetNumberOfComponents(spec.nchannels);
  pixels->SetNumberOfTuples(static_cast<vtkIdType>(spec.width) * spec.height);
  FlipRows(rows.data(), pixels->GetPointer(0), size, spec.nchannels, [](Value v) { return v; });

  image->Initialize();
  image->SetOrigin(0.0, 0.0, 0.0);
  image->SetSpacing(1.0, 1.0, 1.0);
  image->SetDimensions(spec.width, spec.height, 1);
  image->GetPointData()->SetScalars(pixels);
  return true;
}

//------------------------------------------------------------------------------
// Write rows to an opened file: bytes where the file holds bytes, else float.
template <typename Value>
bool WritePixels(OIIO::ImageOutput& output, const Value* values)
{
  const OIIO::ImageSpec& spec = output.spec();
  const int size[2] = { spec.width, spec.height };
  const std::size_t count = static_cast<std::size_t>(spec.image_pixels()) * spec.nchannels;
  if (spec.format == OIIO::TypeDesc::UINT8)
  {
    std::vector<unsigned char> rows(count);
    FlipRows(values, rows.data(), size, spec.nchannels, [](Value v) { return ToByte(v); });
    return output.write_image(OIIO::TypeDesc::UINT8, rows.data());
  }
  const float scale = std::is_same<Value, unsigned char>::value ? 255.0f : 1.0f;
  std::vector<float> rows(count);
  FlipRows(values, rows.data(), size, spec.nchannels, [scale](Value v) { return v / scale; });
  return output.write_image(OIIO::TypeDesc::FLOAT, rows.data());
}

//------------------------------------------------------------------------------
OIIO::ImageSpec Describe(
  const int size[2], int components, OIIO::TypeDesc type, const std::string& software)
{
  OIIO::ImageSpec spec(size[0], size[1], components, type);
  if (components == 1)
  {
    spec.channelnames = { "Y" };
  }
  spec.attribute("oiio:UnassociatedAlpha", 1); // colours as they are, not divided by alpha
  if (!software.empty())
  {
    spec.attribute("Software", software);
  }
  return spec;
}
}

//------------------------------------------------------------------------------
std::string vtkImageCodec::Read(const std::string& path, vtkImageData* image)
{
  OIIO::ImageSpec hints;
  hints.attribute("oiio:UnassociatedAlpha", 1); // colours as stored, not multiplied by alpha
  std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path, &hints);
  if (!input)
  {
    return Reason(input);
  }
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.deep || spec.depth > 1)
  {
    return spec.deep ? "it is a deep image" : "it is a volume";
  }
  if (spec.nchannels < 1 || spec.nchannels > 4)
  {
    return "it has " + std::to_string(spec.nchannels) + " channels, not 1 to 4";
  }
  const bool bytes = spec.format == OIIO::TypeDesc::UINT8;
  const bool read =
    bytes ? ReadPixels<vtkUnsignedCharArray, unsigned char>(*input, OIIO::TypeDesc::UINT8, image)
          : ReadPixels<vtkFloatArray, float>(*input, OIIO::TypeDesc::FLOAT, image);
  return read ? "" : Reason(input);
}

//------------------------------------------------------------------------------
std::string vtkImageCodec::Encode(const std::string& name, vtkImageData* image,
  const std::string& software, std::vector<unsigned char>& encoded)
{
  vtkDataArray* pixels = image->GetPointData()->GetScalars();
  vtkFloatArray* floats = vtkFloatArray::SafeDownCast(pixels);
  vtkUnsignedCharArray* bytes = vtkUnsignedCharArray::SafeDownCast(pixels);
  const int components = pixels->GetNumberOfComponents();
  std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(name);
  if (!output)
  {
    return Reason(output);
  }
  const std::string format = output->format_name();
  if (!output->supports("ioproxy"))
  {
    return "the format " + format + " can be read only";
  }
  if ((components == 4 && !output->supports("alpha")) || (components == 1 && format == "dpx"))
  {
    // Checked here, since these drop the alpha in silence, or end the program.
    return "the format " + format + " cannot store " + std::to_string(components) + " components";
  }
  // EXR would otherwise store bytes as half floats.
  const OIIO::TypeDesc type =
    floats || format == "openexr" ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
  const OIIO::ImageSpec spec = Describe(image->GetDimensions(), components, type, software);

  // Into memory, because not every format notices a full disk.
  OIIO::Filesystem::IOVecOutput memory(encoded);
  bool done = output->set_ioproxy(&memory) && output->open(name, spec);
  if (done)
  {
    done = floats ? WritePixels(*output, floats->GetPointer(0))
                  : WritePixels(*output, bytes->GetPointer(0));
  }
  std::string failure = done ? "" : Reason(output);
  if (!output->close() && failure.empty())
  {
    failure = Reason(output);
  }
  output.reset();
  OIIO::geterror();
  return failure;
}
