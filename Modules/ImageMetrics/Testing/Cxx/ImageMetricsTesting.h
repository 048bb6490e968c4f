// SPDX-License-Identifier: BSD-3-Clause
// What the tests of this module share.

#ifndef ImageMetricsTesting_h
#define ImageMetricsTesting_h

#include "ShadowTesting.h"

#include "vtkCallbackCommand.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStringOutputWindow.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace ImageMetricsTesting
{
using ShadowTesting::Failures;
using ShadowTesting::Result;

template <typename Value>
struct ArrayOf;
template <>
struct ArrayOf<float>
{
  using Type = vtkFloatArray;
};
template <>
struct ArrayOf<unsigned char>
{
  using Type = vtkUnsignedCharArray;
};

template <typename Value>
vtkSmartPointer<typename ArrayOf<Value>::Type> NewArray(
  const char* name, int components, const std::vector<Value>& values)
{
  auto array = vtkSmartPointer<typename ArrayOf<Value>::Type>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  for (Value value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}

// A picture, its values from the bottom row upwards.
template <typename Value>
vtkSmartPointer<vtkImageData> NewImage(int width, int height, int components,
  const std::vector<Value>& values, const char* name = "Visibility")
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->GetPointData()->SetScalars(NewArray<Value>(name, components, values));
  return image;
}

template <typename Value>
std::vector<Value> GetValues(vtkImageData* image)
{
  using Array = typename ArrayOf<Value>::Type;
  Array* array = image ? Array::SafeDownCast(image->GetPointData()->GetScalars()) : nullptr;
  return array ? std::vector<Value>(array->Begin(), array->End()) : std::vector<Value>();
}

// What VTK reports without an object while the function runs; nothing is printed.
inline std::string ErrorsOf(const std::function<void()>& function)
{
  vtkSmartPointer<vtkOutputWindow> before = vtkOutputWindow::GetInstance();
  const vtkLogger::Verbosity verbosity = vtkLogger::GetCurrentVerbosityCutoff();
  vtkNew<vtkStringOutputWindow> window;
  vtkOutputWindow::SetInstance(window);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  function();
  vtkLogger::SetStderrVerbosity(verbosity);
  vtkOutputWindow::SetInstance(before);
  return window->GetOutput();
}

// What an object reports while the function runs; nothing is printed.
inline std::string ErrorsOf(vtkObject* object, const std::function<void()>& function)
{
  std::string text;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&text);
  observer->SetCallback([](vtkObject*, unsigned long, void* client, void* data)
    { *static_cast<std::string*>(client) += static_cast<const char*>(data); });
  const unsigned long tag = object->AddObserver(vtkCommand::ErrorEvent, observer);
  function();
  object->RemoveObserver(tag);
  return text;
}

inline bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

inline int Count(const std::string& text, const std::string& part)
{
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
  {
    ++count;
  }
  return count;
}
}

#endif
