// SPDX-License-Identifier: BSD-3-Clause
// What the image regression tests of all families share: one scene, one technique, one picture,
// compared with its baseline twice.
//
// VTK's own comparison (vtkRegressionTestImage) forgives a difference of up to 105 of 255 in each
// channel, and any value found within two pixels: soft shadows for hard ones pass. It writes the
// difference picture, though, and what a dashboard reads. So the numbers are looked at as well:
// fewer than 1 % of the channel values may differ from the baseline by more than 4 of 255. Measured
// on the baselines here, that share is
//
//   11 to 14 %     with no shadows
//   5 to 6 %       hard for soft, soft for hard
//   2.6 to 2.9 %   16 samples instead of 64 or 256
//   2.7 %, 0.9 %   soft shadows, hard ones moved by a pixel (4.4 %, 1.9 % by two)
//   3 to 4 %       the light a fifth larger
//   1.6 %          maps of 128 texels' side
//   0.3 %          accumulated maps against ray tracing, two roads to the same picture
//   0.2 to 0.4 %   maps of half or twice the resolution
//   0              the same again
//
// which leaves room for what other drivers and compilers do to pixels on edges, and to the last
// bits of shading, and for little else.

#ifndef ShadowRegression_h
#define ShadowRegression_h

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkRegressionTestImage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShadowPass.h"
#include "vtkShadowScenes.h"
#include "vtkShadowTechniques.h"
#include "vtkSmartPointer.h"
#include "vtkWindowToImageFilter.h"

#include <cstdlib>
#include <iostream>
#include <map>
#include <string>

namespace ShadowRegression
{
constexpr int Tolerance = 4;        // of 255
constexpr double MostDiffer = 0.01; // of all channel values

//------------------------------------------------------------------------------
inline vtkSmartPointer<vtkImageData> ReadBaseline(int argc, char* argv[])
{
  std::string path;
  for (int i = 1; i + 1 < argc; ++i)
  {
    if (std::string(argv[i]) == "-V")
    {
      path = argv[i + 1];
    }
  }
  vtkNew<vtkPNGReader> reader;
  if (path.empty() || !reader->CanReadFile(path.c_str()))
  {
    std::cout << "No baseline '" << path << "'.\n";
    return nullptr;
  }
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

//------------------------------------------------------------------------------
/** The share of channel values that differ by more than the tolerance; 1 where the sizes differ. */
inline double GetDifference(vtkImageData* picture, vtkImageData* baseline)
{
  const int* size = picture->GetDimensions();
  const int* expected = baseline->GetDimensions();
  const int channels = picture->GetNumberOfScalarComponents();
  if (size[0] != expected[0] || size[1] != expected[1] ||
      baseline->GetNumberOfScalarComponents() != channels ||
      baseline->GetScalarType() != VTK_UNSIGNED_CHAR)
  {
    return 1.0;
  }
  const auto* a = static_cast<const unsigned char*>(picture->GetScalarPointer());
  const auto* b = static_cast<const unsigned char*>(baseline->GetScalarPointer());
  const int values = size[0] * size[1] * channels;
  int differing = 0;
  for (int i = 0; i < values; ++i)
  {
    differing += std::abs(a[i] - b[i]) > Tolerance ? 1 : 0;
  }
  return static_cast<double>(differing) / values;
}

//------------------------------------------------------------------------------
/** What a test returns: 0 where the scene, drawn by the technique, is the baseline given by -V. */
inline int Test(int argc, char* argv[], const char* scene, const char* technique,
  const std::map<std::string, std::string>& parameters = {})
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(300, 300);
  window->AddRenderer(renderer);
  auto pass = vtkSmartPointer<vtkShadowPass>::Take(vtkShadowTechniques::Create(technique));
  if (!pass || !vtkShadowScenes::Build(scene, renderer))
  {
    return EXIT_FAILURE;
  }
  pass->SetParameter("terminator", "facets"); // the geometry as it is
  for (const auto& parameter : parameters)
  {
    if (!pass->SetParameter(parameter.first, parameter.second))
    {
      return EXIT_FAILURE;
    }
  }
  renderer->SetPass(pass);
  window->Render();

  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  grab->Update();

  const bool alike = vtkRegressionTestImage(window) != vtkTesting::FAILED;
  const auto baseline = ReadBaseline(argc, argv);
  const double difference = baseline ? GetDifference(grab->GetOutput(), baseline) : 1.0;
  std::cout << 100.0 * difference << " % of the values differ by more than " << Tolerance
            << "; fewer than " << 100.0 * MostDiffer << " % may.\n";
  return alike && difference < MostDiffer ? EXIT_SUCCESS : EXIT_FAILURE;
}
}

#endif
