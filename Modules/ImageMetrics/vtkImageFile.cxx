// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImageFile.h"

#include "vtkFloatArray.h"
#include "vtkImageCodec.h"
#include "vtkImageMetricsPrivate.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <cerrno>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <random>
#include <system_error>
#include <vector>

vtkStandardNewMacro(vtkImageFile);

namespace
{
namespace fs = std::filesystem;
using namespace vtkImageMetricsPrivate;

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
  return vtkImageCodec::Read(path, image);
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
  std::random_device random;
  const std::string unique = ".softshadows-" + std::to_string(random()) + std::to_string(random());
  const TemporaryFile temporary{ folder / (unique + path.extension().string()) };
  errno = 0;
  std::FILE* file = std::fopen(temporary.Path.c_str(), "wb");
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
  vtkNew<vtkImageData> plain;
  plain->SetDimensions(image->GetDimensions());
  plain->GetPointData()->SetScalars(floats ? static_cast<vtkDataArray*>(floats) : bytes);
  // Encoded in memory and then written here, so that a failure leaves nothing.
  std::vector<unsigned char> encoded;
  failure = vtkImageCodec::Encode(name, plain, software, encoded);
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
