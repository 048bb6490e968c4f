// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImageFile.h"

#include "vtkFloatArray.h"
#include "vtkImageMetricsPrivate.h"
#include "vtkObjectFactory.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <system_error>
#include <type_traits>
#include <vector>

vtkStandardNewMacro(vtkImageFile);

namespace
{
namespace fs = std::filesystem;
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
// Returns an empty string, or what went wrong.
std::string ReadFile(const std::string& path, vtkImageData* image)
{
  std::error_code ignored;
  if (!image)
  {
    return "there is no image to read into";
  }
  if (!fs::exists(path, ignored))
  {
    return "there is no such file";
  }
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
// Removes the file it names, unless that became the real one.
struct TemporaryFile
{
  fs::path Path;
  ~TemporaryFile()
  {
    std::error_code ignored;
    fs::remove(this->Path, ignored);
  }
};

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
// Why this name cannot be given to a file, or an empty string.
std::string CheckTarget(const fs::path& path, const fs::path& folder)
{
  std::error_code ignored;
  if (!path.has_filename())
  {
    return "it names no file";
  }
  if (!fs::is_directory(folder, ignored))
  {
    return "there is no folder \"" + folder.string() + "\"";
  }
  const fs::file_status there = fs::status(path, ignored);
  if (fs::exists(there) && !fs::is_regular_file(there))
  {
    return fs::is_directory(there) ? "it is a folder" : "it is no regular file";
  }
  const fs::perms writable =
    fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
  if (fs::exists(there) && (there.permissions() & writable) == fs::perms::none)
  {
    return "the file is write-protected";
  }
  return "";
}

//------------------------------------------------------------------------------
// Put a complete file in the place of path, or leave all as it was and return the reason.
std::string Replace(
  const fs::path& path, const fs::path& folder, const std::vector<unsigned char>& content)
{
  const std::string unique = OIIO::Filesystem::unique_path(".softshadows-%%%%%%%%%%%%");
  const TemporaryFile temporary{ folder / (unique + path.extension().string()) };
  errno = 0;
  std::FILE* file = OIIO::Filesystem::fopen(temporary.Path.string(), "wb");
  const bool written =
    file && std::fwrite(content.data(), 1, content.size(), file) == content.size();
  int error = written ? 0 : errno;
  if (file && std::fclose(file) != 0 && error == 0)
  {
    error = errno;
  }
  std::error_code code(error, std::generic_category());
  if (!code && written)
  {
    fs::rename(temporary.Path, path, code);
  }
  return code ? code.message() : written ? "" : "it could not be written completely";
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

//------------------------------------------------------------------------------
// Returns an empty string, or what went wrong.
std::string WriteFile(const std::string& name, vtkImageData* image, const std::string& software)
{
  vtkDataArray* pixels = nullptr;
  std::string failure = FindPixels(image, nullptr, pixels);
  if (!failure.empty())
  {
    return failure;
  }
  const int components = pixels->GetNumberOfComponents();
  if (components != 1 && components != 3 && components != 4)
  {
    return "the image has " + std::to_string(components) + " components, not 1, 3 or 4";
  }
  vtkSmartPointer<vtkFloatArray> floats = vtkFloatArray::SafeDownCast(pixels);
  vtkUnsignedCharArray* bytes = vtkUnsignedCharArray::SafeDownCast(pixels);
  if (pixels->GetDataType() == VTK_DOUBLE)
  {
    floats = vtkSmartPointer<vtkFloatArray>::New();
    floats->DeepCopy(pixels);
  }
  if (!floats && !bytes)
  {
    return std::string("the image holds ") + pixels->GetDataTypeAsString() +
           " values, not unsigned char, float or double";
  }

  const fs::path path(name);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  failure = CheckTarget(path, folder);
  if (!failure.empty())
  {
    return failure;
  }
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

  // Encoded in memory and then written here, because not every format notices a full disk.
  std::vector<unsigned char> encoded;
  OIIO::Filesystem::IOVecOutput memory(encoded);
  bool done = output->set_ioproxy(&memory) && output->open(name, spec);
  if (done)
  {
    done = floats ? WritePixels(*output, floats->GetPointer(0))
                  : WritePixels(*output, bytes->GetPointer(0));
  }
  failure = done ? "" : Reason(output);
  if (!output->close() && failure.empty())
  {
    failure = Reason(output);
  }
  output.reset();
  OIIO::geterror();
  return failure.empty() ? Replace(path, folder, encoded) : failure;
}

//------------------------------------------------------------------------------
// Nothing that the libraries throw (out of memory, paths that are no text) leaves this file.
template <typename Function>
std::string Guarded(Function function)
{
  try
  {
    return function();
  }
  catch (const std::exception& exception)
  {
    return exception.what();
  }
}
}

//------------------------------------------------------------------------------
vtkImageFile::vtkImageFile() = default;

//------------------------------------------------------------------------------
vtkImageFile::~vtkImageFile() = default;

//------------------------------------------------------------------------------
bool vtkImageFile::Read(const std::string& path, vtkImageData* image)
{
  const std::string failure = Guarded([&] { return ReadFile(path, image); });
  if (!failure.empty())
  {
    vtkErrorWithObjectMacro(
      nullptr, "vtkImageFile: cannot read \"" << path << "\": " << failure << ".");
  }
  return failure.empty();
}

//------------------------------------------------------------------------------
bool vtkImageFile::Write(const std::string& path, vtkImageData* image, const std::string& software)
{
  const std::string failure = Guarded([&] { return WriteFile(path, image, software); });
  if (!failure.empty())
  {
    vtkErrorWithObjectMacro(
      nullptr, "vtkImageFile: cannot write \"" << path << "\": " << failure << ".");
  }
  return failure.empty();
}

//------------------------------------------------------------------------------
void vtkImageFile::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
