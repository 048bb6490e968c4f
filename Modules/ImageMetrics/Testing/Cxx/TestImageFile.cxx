// SPDX-License-Identifier: BSD-3-Clause
// Round trips through every promised format, orientation against VTK's own PNG reader and writer,
// and failures that leave nothing behind.

#include "ImageMetricsTesting.h"

#include "vtkDoubleArray.h"
#include "vtkImageFile.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkTestUtilities.h"

#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>

#ifdef __linux__
#include <csignal>
#include <sys/resource.h>
#endif

namespace
{
namespace fs = std::filesystem;
using namespace ImageMetricsTesting;

fs::path Folder;

std::string File(const std::string& name)
{
  return (Folder / name).string();
}

std::size_t NumberOfFiles()
{
  const fs::directory_iterator files(Folder);
  return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

// All byte values, a different one in each place, of a picture that is not square; alpha 0 with
// colours that must survive.
std::vector<unsigned char> SomeBytes(int count)
{
  std::vector<unsigned char> values;
  for (int i = 0; i < count; ++i)
  {
    values.push_back(static_cast<unsigned char>(i * 37 + 11));
  }
  values[3] = 0;
  return values;
}

std::vector<float> SomeFloats(int count)
{
  std::vector<float> values;
  for (int i = 0; i < count; ++i)
  {
    values.push_back(static_cast<float>(i) / 7.0f - 1.0f);
  }
  values[1] = std::numeric_limits<float>::min();
  values[2] = 1e30f;
  return values;
}

bool HasSize(vtkImageData* image, int width, int height, int components)
{
  const int* size = image->GetDimensions();
  return size[0] == width && size[1] == height && size[2] == 1 &&
         image->GetNumberOfScalarComponents() == components;
}

void TestRoundTrips()
{
  const int width = 19;
  const int height = 14;
  for (int components : { 1, 3, 4 })
  {
    const std::vector<unsigned char> bytes = SomeBytes(width * height * components);
    const std::vector<float> floats = SomeFloats(width * height * components);
    const auto byteImage = NewImage(width, height, components, bytes);
    const auto floatImage = NewImage(width, height, components, floats);
    for (const char* name : { "bytes.png", "bytes.bmp", "bytes.tif", "bytes.TIFF" })
    {
      vtkNew<vtkImageData> back;
      CHECK(vtkImageFile::Write(File(name), byteImage));
      CHECK(vtkImageFile::Read(File(name), back));
      CHECK(HasSize(back, width, height, components));
      CHECK(GetValues<unsigned char>(back) == bytes);
    }
    for (const char* name : { "floats.exr", "floats.tif" })
    {
      vtkNew<vtkImageData> back;
      CHECK(vtkImageFile::Write(File(name), floatImage));
      CHECK(vtkImageFile::Read(File(name), back));
      CHECK(HasSize(back, width, height, components));
      CHECK(GetValues<float>(back) == floats);
    }
    // Bytes in a format that has none: exact all the same.
    vtkNew<vtkImageData> back;
    CHECK(vtkImageFile::Write(File("bytes.exr"), byteImage));
    CHECK(vtkImageFile::Read(File("bytes.exr"), back));
    std::vector<float> scaled;
    for (unsigned char value : bytes)
    {
      scaled.push_back(value / 255.0f);
    }
    CHECK(GetValues<float>(back) == scaled);
  }
}

void TestConversion()
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const std::vector<float> floats = { -1.0f, 0.0f, 0.5f, 1.0f, 7.0f, nan, infinity, 0.1f / 255.0f,
    0.6f / 255.0f };
  const std::vector<unsigned char> expected = { 0, 0, 128, 255, 255, 0, 255, 0, 1 };
  for (const char* name : { "clamped.png", "clamped.bmp" })
  {
    vtkNew<vtkImageData> back;
    CHECK(vtkImageFile::Write(File(name), NewImage(3, 3, 1, floats)));
    CHECK(vtkImageFile::Read(File(name), back));
    CHECK(GetValues<unsigned char>(back) == expected);
  }
  // What is not finite survives where floats do.
  vtkNew<vtkImageData> back;
  CHECK(vtkImageFile::Write(File("clamped.exr"), NewImage(3, 3, 1, floats)));
  CHECK(vtkImageFile::Read(File("clamped.exr"), back));
  const std::vector<float> values = GetValues<float>(back);
  CHECK(values.size() == 9 && std::isnan(values[5]) && values[6] == infinity);

  vtkNew<vtkImageData> doubles;
  doubles->SetDimensions(2, 1, 1);
  doubles->AllocateScalars(VTK_DOUBLE, 1);
  doubles->SetScalarComponentFromDouble(0, 0, 0, 0, 0.25);
  doubles->SetScalarComponentFromDouble(1, 0, 0, 0, 3.0);
  CHECK(vtkImageFile::Write(File("doubles.exr"), doubles));
  CHECK(vtkImageFile::Read(File("doubles.exr"), back));
  CHECK((GetValues<float>(back) == std::vector<float>{ 0.25f, 3.0f }));
}

// Our files, read by VTK; VTK's file, read by us.
void TestOrientation()
{
  std::vector<unsigned char> marked(5 * 4 * 3, 0);
  marked[0] = 200; // red, bottom left
  const auto image = NewImage(5, 4, 3, marked);
  CHECK(vtkImageFile::Write(File("marked.png"), image, "the tester"));
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(File("marked.png").c_str());
  reader->Update();
  CHECK(HasSize(reader->GetOutput(), 5, 4, 3));
  CHECK(reader->GetOutput()->GetScalarComponentAsDouble(0, 0, 0, 0) == 200.0);
  CHECK(GetValues<unsigned char>(reader->GetOutput()) == marked);
  bool signature = false;
  for (std::size_t i = 0; i < reader->GetNumberOfTextChunks(); ++i)
  {
    const int chunk = static_cast<int>(i);
    signature = signature || (std::string(reader->GetTextKey(chunk)) == "Software" &&
                               std::string(reader->GetTextValue(chunk)) == "the tester");
  }
  CHECK(signature);

  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(File("vtk.png").c_str());
  writer->SetInputData(image);
  writer->Write();
  vtkNew<vtkImageData> back;
  CHECK(vtkImageFile::Read(File("vtk.png"), back));
  CHECK(GetValues<unsigned char>(back) == marked);
}

// Fails with one error that names the file and the reason, and leaves the folder as it was.
void ExpectNotWritten(const std::string& path, vtkImageData* image, const std::string& reason)
{
  const std::size_t files = NumberOfFiles();
  bool written = true;
  const std::string errors = ErrorsOf([&] { written = vtkImageFile::Write(path, image); });
  CHECK(!written);
  CHECK(Count(errors, "ERROR:") == 1);
  if (!Contains(errors, path) || !Contains(errors, reason) || NumberOfFiles() != files)
  {
    std::cout << "writing \"" << path << "\", expected \"" << reason << "\", got " << errors;
    CHECK(!"the error names file and reason, and no file is left");
  }
}

void ExpectNotRead(const std::string& path, const std::string& reason)
{
  const auto image = NewImage<float>(1, 1, 1, { 0.5f });
  bool read = true;
  const std::string errors = ErrorsOf([&] { read = vtkImageFile::Read(path, image); });
  CHECK(!read);
  CHECK(Count(errors, "ERROR:") == 1);
  CHECK(Contains(errors, path) && Contains(errors, reason));
  CHECK(GetValues<float>(image) == std::vector<float>{ 0.5f });
}

void TestFailures()
{
  const auto image = NewImage(2, 2, 1, std::vector<float>{ 0.0f, 0.25f, 0.5f, 1.0f });
  const auto rgba = NewImage(2, 1, 4, SomeBytes(8));
  vtkNew<vtkImageData> empty;
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(2, 2, 1);
  vtkNew<vtkImageData> volume;
  volume->SetDimensions(2, 2, 2);
  volume->AllocateScalars(VTK_FLOAT, 1);
  vtkNew<vtkImageData> integers;
  integers->SetDimensions(2, 2, 1);
  integers->AllocateScalars(VTK_INT, 1);
  const auto shortOne = NewImage(2, 2, 1, std::vector<float>{ 0.0f, 0.25f, 0.5f });

  ExpectNotWritten(File("no.png"), nullptr, "there is no image");
  ExpectNotWritten(File("no.png"), empty, "empty");
  ExpectNotWritten(File("no.png"), bare, "no pixels");
  ExpectNotWritten(File("no.png"), volume, "volume of 2 slices");
  ExpectNotWritten(File("no.png"), integers, "int values");
  ExpectNotWritten(File("no.png"), shortOne, "3 pixels where 2 x 2");
  ExpectNotWritten(File("no.png"), NewImage(2, 1, 2, SomeBytes(4)), "2 components");
  ExpectNotWritten(File("no.unknown"), image, "format");
  ExpectNotWritten(File("no"), image, "format");
  ExpectNotWritten(File("no.jpg"), rgba, "cannot store 4 components");
  ExpectNotWritten(File("no.fits"), image, "read only");
  ExpectNotWritten(File("no.hdr"), image, "3-channel");
  ExpectNotWritten(File("missing/no.png"), image, "there is no folder");
  ExpectNotWritten(File("marked.png/no.png"), image, "there is no folder");
  ExpectNotWritten(Folder.string() + "/", image, "names no file");
  ExpectNotWritten("", image, "names no file");
#ifdef __linux__
  ExpectNotWritten("/proc/no.png", image, "\"/proc/no.png\": "); // nobody can, not even root
#endif
  fs::create_directory(Folder / "folder.png");
  ExpectNotWritten(File("folder.png"), image, "it is a folder");

  CHECK(vtkImageFile::Write(File("protected.png"), rgba));
  fs::permissions(Folder / "protected.png", fs::perms::owner_read);
  ExpectNotWritten(File("protected.png"), image, "write-protected");
  vtkNew<vtkImageData> back;
  CHECK(vtkImageFile::Read(File("protected.png"), back));
  CHECK(GetValues<unsigned char>(back) == SomeBytes(8));

  ExpectNotRead(File("missing.png"), "no such file");
  ExpectNotRead("", "no such file");
  std::ofstream(File("text.png")) << "this is no picture";
  ExpectNotRead(File("text.png"), "");
  std::ofstream(File("text.unknown")) << "this is no picture";
  ExpectNotRead(File("text.unknown"), "");
  bool read = true;
  CHECK(Contains(ErrorsOf([&] { read = vtkImageFile::Read(File("marked.png"), nullptr); }),
    "no image to read into"));
  CHECK(!read);

  // Half a file.
  CHECK(vtkImageFile::Write(File("half.exr"), NewImage(64, 64, 3, SomeFloats(64 * 64 * 3))));
  fs::resize_file(Folder / "half.exr", fs::file_size(Folder / "half.exr") / 2);
  ExpectNotRead(File("half.exr"), "");
}

// A disk that fills up: not every format of OpenImageIO notices by itself.
void TestFullDisk()
{
#ifdef __linux__
  rlimit before;
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = 100;
  const auto picture = NewImage(64, 64, 3, SomeFloats(64 * 64 * 3));
  for (const char* name : { "full.png", "full.bmp", "full.tif", "full.exr", "full.jpg" })
  {
    setrlimit(RLIMIT_FSIZE, &small);
    bool written = true;
    const std::string errors =
      ErrorsOf([&] { written = vtkImageFile::Write(File(name), picture); });
    setrlimit(RLIMIT_FSIZE, &before);
    CHECK(!written && Contains(errors, File(name)) && !fs::exists(Folder / name));
    ExpectNotWritten(File(name) + ".unknown", picture, "format"); // errors of before are forgotten
  }
  std::signal(SIGXFSZ, handler);
#endif
}

// A file that is there already is replaced, its neighbours are not touched, no temporary remains.
void TestReplacing()
{
  const std::size_t files = NumberOfFiles();
  const auto first = NewImage(1, 1, 1, std::vector<unsigned char>{ 1 });
  const auto second = NewImage(1, 1, 1, std::vector<unsigned char>{ 2 });
  CHECK(vtkImageFile::Write(File("twice.png"), first));
  CHECK(vtkImageFile::Write(File("twice.png"), second));
  CHECK(NumberOfFiles() == files + 1);
  vtkNew<vtkImageData> back;
  CHECK(vtkImageFile::Read(File("twice.png"), back));
  CHECK(GetValues<unsigned char>(back) == std::vector<unsigned char>{ 2 });
}
}

int TestImageFile(int argc, char* argv[])
{
  const std::unique_ptr<char[]> temporary(
    vtkTestUtilities::GetArgOrEnvOrDefault("-T", argc, argv, "VTK_TEMP_DIR", "Testing/Temporary"));
  Folder = fs::path(temporary.get()) / "TestImageFile";
  fs::remove_all(Folder);
  fs::create_directories(Folder);

  TestRoundTrips();
  TestConversion();
  TestOrientation();
  TestFailures();
  const std::size_t files = NumberOfFiles();
  TestFullDisk();
  CHECK(NumberOfFiles() == files);
  TestReplacing();

  if (Failures == 0)
  {
    fs::remove_all(Folder);
  }
  return Result();
}
