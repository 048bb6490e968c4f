// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPlainEXR.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace
{
constexpr std::uint32_t Magic = 20000630;
constexpr std::int32_t Float = 2; // EXR's number of the type
// Channels of a file stand in the order of their names: of each, the component.
const std::vector<std::pair<std::string, int>>& Channels(int components)
{
  static const std::vector<std::pair<std::string, int>> grey = { { "Y", 0 } };
  static const std::vector<std::pair<std::string, int>> rgb = { { "B", 2 }, { "G", 1 },
    { "R", 0 } };
  static const std::vector<std::pair<std::string, int>> rgba = { { "A", 3 }, { "B", 2 }, { "G", 1 },
    { "R", 0 } };
  return components == 1 ? grey : components == 3 ? rgb : rgba;
}

//------------------------------------------------------------------------------
class Writer
{
public:
  std::vector<unsigned char> File;

  template <typename Value>
  void Put(Value value)
  {
    unsigned char bytes[sizeof(Value)];
    std::memcpy(bytes, &value, sizeof(Value)); // EXR is little endian, as are our machines
    this->File.insert(this->File.end(), bytes, bytes + sizeof(Value));
  }
  void Put(const std::string& text)
  {
    this->File.insert(this->File.end(), text.begin(), text.end());
    this->File.push_back(0);
  }
  void PutHead(const char* name, const char* type, std::size_t size)
  {
    this->Put(std::string(name));
    this->Put(std::string(type));
    this->Put(static_cast<std::int32_t>(size));
  }
  template <typename Value>
  void PutAttribute(const char* name, const char* type, std::initializer_list<Value> values)
  {
    this->PutHead(name, type, values.size() * sizeof(Value));
    for (const Value value : values)
    {
      this->Put(value);
    }
  }
};

//------------------------------------------------------------------------------
class Reader
{
public:
  explicit Reader(const std::vector<unsigned char>& file)
    : File(file)
  {
  }
  std::size_t Place = 0;

  const unsigned char* Take(std::size_t size)
  {
    if (size > this->File.size() - this->Place)
    {
      throw std::runtime_error("it ends too soon");
    }
    const unsigned char* bytes = this->File.data() + this->Place;
    this->Place += size;
    return bytes;
  }
  template <typename Value>
  Value Get()
  {
    Value value;
    std::memcpy(&value, this->Take(sizeof(Value)), sizeof(Value));
    return value;
  }
  std::string GetText()
  {
    std::string text;
    while (const char c = this->Get<char>())
    {
      text += c;
    }
    return text;
  }

private:
  const std::vector<unsigned char>& File;
};
}

//------------------------------------------------------------------------------
bool vtkPlainEXR::IsOne(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::uint32_t magic = 0;
  file.read(reinterpret_cast<char*>(&magic), sizeof(magic));
  return file && magic == Magic;
}

//------------------------------------------------------------------------------
std::vector<unsigned char> vtkPlainEXR::Encode(vtkImageData* image, const std::string& software)
{
  vtkDataArray* pixels = image->GetPointData()->GetScalars();
  const int components = pixels->GetNumberOfComponents();
  const std::int32_t width = image->GetDimensions()[0];
  const std::int32_t height = image->GetDimensions()[1];
  const double scale = pixels->GetDataType() == VTK_UNSIGNED_CHAR ? 255.0 : 1.0;
  const auto& channels = Channels(components);

  Writer writer;
  writer.Put(Magic);
  writer.Put(std::int32_t(2));
  writer.PutHead("channels", "chlist", channels.size() * 18 + 1);
  for (const auto& channel : channels)
  {
    writer.Put(channel.first);
    writer.Put(Float);
    writer.Put(std::int32_t(0)); // linear, and what is reserved
    writer.Put(std::int32_t(1)); // each pixel along x
    writer.Put(std::int32_t(1)); // and y
  }
  writer.Put(std::uint8_t(0));
  writer.PutAttribute<std::uint8_t>("compression", "compression", { 0 });
  writer.PutAttribute<std::int32_t>("dataWindow", "box2i", { 0, 0, width - 1, height - 1 });
  writer.PutAttribute<std::int32_t>("displayWindow", "box2i", { 0, 0, width - 1, height - 1 });
  writer.PutAttribute<std::uint8_t>("lineOrder", "lineOrder", { 0 });
  writer.PutAttribute<float>("pixelAspectRatio", "float", { 1.0f });
  writer.PutAttribute<float>("screenWindowCenter", "v2f", { 0.0f, 0.0f });
  writer.PutAttribute<float>("screenWindowWidth", "float", { 1.0f });
  if (!software.empty())
  {
    writer.PutHead("software", "string", software.size());
    writer.File.insert(writer.File.end(), software.begin(), software.end());
  }
  writer.Put(std::uint8_t(0));
  const std::size_t row = channels.size() * width * sizeof(float);
  const std::size_t first = writer.File.size() + height * sizeof(std::uint64_t);
  for (std::int32_t y = 0; y < height; ++y)
  {
    writer.Put(static_cast<std::uint64_t>(first + y * (row + 8)));
  }
  for (std::int32_t y = 0; y < height; ++y)
  {
    writer.Put(y);
    writer.Put(static_cast<std::int32_t>(row));
    for (const auto& channel : channels)
    {
      for (std::int32_t x = 0; x < width; ++x)
      {
        const vtkIdType pixel = static_cast<vtkIdType>(height - 1 - y) * width + x;
        writer.Put(static_cast<float>(pixels->GetComponent(pixel, channel.second) / scale));
      }
    }
  }
  return writer.File;
}

//------------------------------------------------------------------------------
std::string vtkPlainEXR::Decode(const std::vector<unsigned char>& file, vtkImageData* image)
{
  Reader reader(file);
  reader.Take(4);
  if (reader.Get<std::uint32_t>() != 2)
  {
    return "it is no EXR file of one part in scan lines";
  }
  std::vector<std::string> names;
  std::int32_t window[4] = { 0, 0, -1, -1 };
  for (std::string name = reader.GetText(); !name.empty(); name = reader.GetText())
  {
    reader.GetText(); // its type follows from the name
    const std::int32_t size = reader.Get<std::int32_t>();
    const std::size_t end = reader.Place + std::max<std::int32_t>(size, 0);
    if (name == "channels")
    {
      for (std::string channel = reader.GetText(); !channel.empty(); channel = reader.GetText())
      {
        names.push_back(channel);
        if (reader.Get<std::int32_t>() != Float)
        {
          return "it holds other values than 32-bit floats (built without OpenImageIO)";
        }
        reader.Take(12);
      }
    }
    else if (name == "compression" && reader.Get<std::uint8_t>() != 0)
    {
      return "it is compressed (built without OpenImageIO)";
    }
    else if (name == "dataWindow")
    {
      std::memcpy(window, reader.Take(sizeof(window)), sizeof(window));
    }
    reader.Place = 0;
    reader.Take(end);
  }
  const int components = static_cast<int>(names.size());
  if (components != 1 && components != 3 && components != 4)
  {
    return "it has " + std::to_string(components) + " channels, not 1, 3 or 4";
  }
  const std::int64_t width = std::int64_t(window[2]) - window[0] + 1;
  const std::int64_t height = std::int64_t(window[3]) - window[1] + 1;
  const std::size_t row =
    static_cast<std::size_t>(std::max<std::int64_t>(width, 0)) * components * sizeof(float);
  if (width < 1 || height < 1 || row > file.size() ||
      static_cast<std::size_t>(height) > file.size() / row)
  {
    return "it ends too soon";
  }
  const auto& channels = Channels(components);
  vtkNew<vtkFloatArray> pixels;
  pixels->SetName("ImageScalars");
  pixels->SetNumberOfComponents(components);
  pixels->SetNumberOfTuples(width * height);
  reader.Take(height * sizeof(std::uint64_t));
  for (std::int64_t line = 0; line < height; ++line)
  {
    const std::int64_t y = std::int64_t(reader.Get<std::int32_t>()) - window[1];
    if (y < 0 || y >= height || reader.Get<std::int32_t>() != static_cast<std::int32_t>(row))
    {
      return "its lines are damaged";
    }
    for (int c = 0; c < components; ++c)
    {
      const int component = components == 1 ? 0 : channels[c].second;
      for (std::int64_t x = 0; x < width; ++x)
      {
        pixels->SetComponent((height - 1 - y) * width + x, component, reader.Get<float>());
      }
    }
  }
  image->Initialize();
  image->SetDimensions(static_cast<int>(width), static_cast<int>(height), 1);
  image->GetPointData()->SetScalars(pixels);
  return "";
}
