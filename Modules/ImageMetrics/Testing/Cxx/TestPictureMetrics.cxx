// SPDX-License-Identifier: BSD-3-Clause
// Figures against values computed by hand.

#include "ImageMetricsTesting.h"

#include "vtkPictureMetrics.h"

#include <limits>

namespace
{
using namespace ImageMetricsTesting;
using Floats = std::vector<float>;
using Bytes = std::vector<unsigned char>;

// Update fails with one error that holds the text, and no figure survives.
void ExpectFailure(vtkPictureMetrics* metrics, const std::string& text)
{
  bool updated = true;
  const std::string errors = ErrorsOf(metrics, [&] { updated = metrics->Update(); });
  CHECK(!updated);
  CHECK(Count(errors, "ERROR:") == 1);
  if (!Contains(errors, text))
  {
    std::cout << "expected \"" << text << "\", got " << errors;
    CHECK(!"the error gives the reason");
  }
  CHECK(std::isnan(metrics->GetRMSE()) && std::isnan(metrics->GetCorrectness()));
  CHECK(metrics->GetNumberOfPixels() == 0);
  CHECK(!metrics->GetDifferenceImage());
}

// Byte differences 0, 4, 5, 0, -51, 0: four of six within 4, five within 5.
void TestFigures()
{
  const Bytes reference = { 10, 20, 30, 100, 151, 200 };
  const Bytes bytes = { 10, 24, 35, 100, 100, 200 };
  const double rmse = std::sqrt((4.0 * 4.0 + 5.0 * 5.0 + 51.0 * 51.0) / 6.0) / 255.0;
  vtkNew<vtkPictureMetrics> metrics;
  metrics->SetReference(NewImage(2, 1, 3, reference));
  metrics->SetImage(NewImage(2, 1, 3, bytes));
  CHECK(metrics->Update());
  CHECK_NEAR(metrics->GetCorrectness(), 100.0 * 4.0 / 6.0, 1e-9);
  CHECK_NEAR(metrics->GetRMSE(), rmse, 1e-6);
  CHECK_NEAR(metrics->GetPSNR(), -20.0 * std::log10(rmse), 1e-4);
  CHECK_NEAR(metrics->GetMaximum(), 0.2, 1e-6);
  CHECK(metrics->GetNumberOfPixels() == 2);
  metrics->SetTolerance(5);
  CHECK(metrics->Update());
  CHECK_NEAR(metrics->GetCorrectness(), 100.0 * 5.0 / 6.0, 1e-9);
  metrics->SetTolerance(0);
  CHECK(metrics->Update());
  CHECK_NEAR(metrics->GetCorrectness(), 50.0, 1e-9);
  CHECK(Contains(metrics->GetJSON(), "\"tolerance\":0,\"correctness_percent\":50.0"));
  CHECK(Contains(metrics->GetJSON(), "\"equal\":false"));

  // The worst channels: +5/255 at scale 0.25, and -51/255 at 0.25 and at 0.1.
  Bytes colors = { 255, 235, 235, 51, 51, 255 };
  CHECK(GetValues<unsigned char>(metrics->GetDifferenceImage()) == colors);
  metrics->SetDifferenceScale(0.1);
  CHECK(metrics->Update());
  colors = { 255, 205, 205, 0, 0, 255 };
  CHECK(GetValues<unsigned char>(metrics->GetDifferenceImage()) == colors);
}

void TestEqual()
{
  const auto picture = NewImage<unsigned char>(1, 1, 3, { 1, 2, 3 });
  vtkNew<vtkPictureMetrics> metrics;
  metrics->SetReference(picture);
  metrics->SetImage(picture);
  CHECK(metrics->Update());
  CHECK(metrics->GetCorrectness() == 100.0);
  CHECK(metrics->GetRMSE() == 0.0 && metrics->GetMaximum() == 0.0);
  CHECK(std::isinf(metrics->GetPSNR()) && metrics->GetPSNR() > 0.0);
  CHECK(Contains(metrics->GetJSON(), "\"psnr_db\":null"));
  CHECK(Contains(metrics->GetJSON(), "\"equal\":true"));
}

// Alpha does not count, neither in bytes nor as a NaN; RGB and RGBA can be compared.
void TestAlpha()
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  vtkNew<vtkPictureMetrics> metrics;
  metrics->SetReference(NewImage<unsigned char>(2, 1, 4, { 1, 2, 3, 0, 4, 5, 6, 0 }));
  metrics->SetImage(NewImage<unsigned char>(2, 1, 4, { 1, 2, 3, 255, 4, 5, 6, 255 }));
  CHECK(metrics->Update());
  CHECK(metrics->GetCorrectness() == 100.0 && metrics->GetRMSE() == 0.0);
  metrics->SetImage(NewImage<unsigned char>(2, 1, 3, { 1, 2, 3, 4, 5, 6 }));
  CHECK(metrics->Update());
  CHECK(metrics->GetCorrectness() == 100.0 && metrics->GetRMSE() == 0.0);
  metrics->SetReference(NewImage<float>(1, 1, 4, { 0.0f, 0.5f, 1.0f, nan }));
  metrics->SetImage(NewImage<float>(1, 1, 4, { 0.0f, 0.5f, 0.5f, nan }));
  CHECK(metrics->Update());
  CHECK_NEAR(metrics->GetRMSE(), std::sqrt(0.25 / 3.0), 1e-6);
}

// Floats beyond 1 show as 255 but differ as numbers; the peak of the PSNR stays 1.
void TestFloat()
{
  vtkNew<vtkPictureMetrics> metrics;
  metrics->SetReference(NewImage<float>(2, 1, 1, { 1.0f, 0.5f }));
  metrics->SetImage(NewImage<float>(2, 1, 1, { 3.0f, 0.5f }));
  CHECK(metrics->Update());
  CHECK(metrics->GetCorrectness() == 100.0);
  CHECK_NEAR(metrics->GetMaximum(), 2.0, 1e-6);
  CHECK_NEAR(metrics->GetRMSE(), std::sqrt(2.0), 1e-6);
  CHECK_NEAR(metrics->GetPSNR(), -20.0 * std::log10(std::sqrt(2.0)), 1e-4);

  // Bytes against floats.
  metrics->SetReference(NewImage<unsigned char>(2, 1, 1, { 255, 51 }));
  metrics->SetImage(NewImage<float>(2, 1, 1, { 1.0f, 0.2f }));
  CHECK(metrics->Update());
  CHECK(metrics->GetCorrectness() == 100.0);
  CHECK_NEAR(metrics->GetMaximum(), 0.0, 1e-6);
}

// Position matters: the same bytes in another place differ.
void TestPlace()
{
  vtkNew<vtkPictureMetrics> metrics;
  Bytes values(64 * 32 * 3, 0);
  metrics->SetReference(NewImage(64, 32, 3, values));
  values[3 * (64 * 31 + 63)] = 255; // top right
  metrics->SetImage(NewImage(64, 32, 3, values));
  CHECK(metrics->Update());
  CHECK_NEAR(metrics->GetRMSE(), std::sqrt(1.0 / (64.0 * 32.0 * 3.0)), 1e-6);
  CHECK_NEAR(metrics->GetCorrectness(), 100.0 - 100.0 / (64.0 * 32.0 * 3.0), 1e-9);
  const Bytes colors = GetValues<unsigned char>(metrics->GetDifferenceImage());
  CHECK(colors.size() == values.size());
  CHECK(colors[3 * (64 * 31 + 63) + 1] == 0 && colors[1] == 255);
}

void TestFailures()
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  vtkNew<vtkPictureMetrics> metrics;
  CHECK(std::isnan(metrics->GetRMSE()) && Contains(metrics->GetJSON(), "\"equal\":false"));
  ExpectFailure(metrics, "reference: there is no image");
  metrics->SetReference(NewImage<unsigned char>(2, 1, 3, Bytes(6, 0)));
  ExpectFailure(metrics, "image: there is no image");
  metrics->SetImage(NewImage<unsigned char>(1, 2, 3, Bytes(6, 0)));
  ExpectFailure(metrics, "the image is 1 x 2, the reference 2 x 1");
  metrics->SetImage(NewImage<unsigned char>(2, 1, 1, Bytes(2, 0)));
  ExpectFailure(metrics, "1 colour channels, the reference 3");
  metrics->SetImage(NewImage<unsigned char>(2, 1, 2, Bytes(4, 0)));
  ExpectFailure(metrics, "with 2 components");
  metrics->SetImage(NewImage<float>(2, 1, 3, { 0.0f, nan, 0.0f, 0.0f, 0.0f, nan }));
  ExpectFailure(metrics, "2 values of the image and 0 of the reference are NaN");
}
}

int TestPictureMetrics(int, char*[])
{
  TestFigures();
  TestEqual();
  TestAlpha();
  TestFloat();
  TestPlace();
  TestFailures();
  return Result();
}
