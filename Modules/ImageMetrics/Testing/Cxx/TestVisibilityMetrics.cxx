// SPDX-License-Identifier: BSD-3-Clause
// Figures against values computed by hand.

#include "ImageMetricsTesting.h"

#include "vtkVisibilityMetrics.h"

#include <limits>

namespace
{
using namespace ImageMetricsTesting;
using Floats = std::vector<float>;
using Bytes = std::vector<unsigned char>;

const float NaN = std::numeric_limits<float>::quiet_NaN();

void SetMask(vtkImageData* image, const Bytes& mask)
{
  image->GetPointData()->AddArray(NewArray<unsigned char>("Receiver", 1, mask));
}

// Update fails with one error that holds the text, and no figure survives.
void ExpectFailure(vtkVisibilityMetrics* metrics, const std::string& text)
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
  CHECK(std::isnan(metrics->GetRMSE()) && std::isnan(metrics->GetPenumbraMaximum()));
  CHECK(metrics->GetNumberOfReceiverPixels() == 0 && metrics->GetNumberOfPenumbraPixels() == 0);
  CHECK(!metrics->GetDifferenceImage());
  CHECK(Contains(metrics->GetJSON(), "\"rmse\":null"));
}

// Errors 0.25, 0, -0.5, 0.25; penumbra where the reference is 0.5 and 0.25.
void TestFigures()
{
  vtkNew<vtkVisibilityMetrics> metrics;
  metrics->SetReference(NewImage<float>(2, 2, 1, { 0.0f, 1.0f, 0.5f, 0.25f }));
  metrics->SetImage(NewImage<float>(2, 2, 1, { 0.25f, 1.0f, 0.0f, 0.5f }));
  CHECK(metrics->Update());
  CHECK_NEAR(metrics->GetRMSE(), std::sqrt(0.375 / 4.0), 1e-12);
  CHECK_NEAR(metrics->GetBias(), 0.0, 1e-12);
  CHECK_NEAR(metrics->GetP99(), 0.5, 1e-12);
  CHECK_NEAR(metrics->GetMaximum(), 0.5, 1e-12);
  CHECK_NEAR(metrics->GetPenumbraRMSE(), std::sqrt(0.3125 / 2.0), 1e-12);
  CHECK_NEAR(metrics->GetPenumbraBias(), -0.125, 1e-12);
  CHECK_NEAR(metrics->GetPenumbraP99(), 0.5, 1e-12);
  CHECK_NEAR(metrics->GetPenumbraMaximum(), 0.5, 1e-12);
  CHECK(metrics->GetNumberOfReceiverPixels() == 4);
  CHECK(metrics->GetNumberOfPenumbraPixels() == 2);
  CHECK(Contains(metrics->GetJSON(), "\"receiver_pixels\":4"));
  CHECK(Contains(metrics->GetJSON(), "\"penumbra\":{\"range\":[0.02,0.98],\"pixels\":2"));

  // Scale 0.25: full red, white, full blue (clamped), full red.
  const Bytes full = { 255, 0, 0, 255, 255, 255, 0, 0, 255, 255, 0, 0 };
  CHECK(GetValues<unsigned char>(metrics->GetDifferenceImage()) == full);
  metrics->SetDifferenceScale(1.0);
  CHECK(metrics->Update());
  const Bytes faint = { 255, 191, 191, 255, 255, 255, 128, 128, 255, 255, 191, 191 };
  CHECK(GetValues<unsigned char>(metrics->GetDifferenceImage()) == faint);

  // The range's ends are inside it: 0.25 is, 0.5 no more.
  metrics->SetPenumbraRange(0.1, 0.25);
  CHECK(metrics->Update());
  CHECK(metrics->GetNumberOfPenumbraPixels() == 1);
  CHECK_NEAR(metrics->GetPenumbraBias(), 0.25, 1e-12);
  metrics->SetPenumbraRange(0.3, 0.4);
  CHECK(metrics->Update());
  CHECK(metrics->GetNumberOfPenumbraPixels() == 0);
  CHECK(metrics->GetPenumbraRMSE() == 0.0 && metrics->GetPenumbraBias() == 0.0);
  CHECK(metrics->GetPenumbraP99() == 0.0 && metrics->GetPenumbraMaximum() == 0.0);
  metrics->SetPenumbraRange(0.4, 0.3);
  ExpectFailure(metrics, "penumbra range");
}

void TestRangeEnds()
{
  vtkNew<vtkVisibilityMetrics> metrics;
  const auto image = NewImage<float>(4, 1, 1, { 0.0199f, 0.02f, 0.98f, 0.9801f });
  metrics->SetReference(image);
  metrics->SetImage(image);
  CHECK(metrics->Update());
  CHECK(metrics->GetNumberOfPenumbraPixels() == 2);
  CHECK(metrics->GetRMSE() == 0.0 && metrics->GetMaximum() == 0.0);
}

// Errors 1/200 ... 200/200: the 198th is the 99th percentile. Of 201 values it is the 199th.
void TestPercentile()
{
  Floats errors;
  for (int i = 1; i <= 200; ++i)
  {
    errors.push_back(static_cast<float>((i * 77) % 200 + 1) / 200.0f);
  }
  vtkNew<vtkVisibilityMetrics> metrics;
  metrics->SetReference(NewImage<float>(200, 1, 1, Floats(200, 0.0f)));
  metrics->SetImage(NewImage<float>(200, 1, 1, errors));
  CHECK(metrics->Update());
  CHECK_NEAR(metrics->GetP99(), 0.99, 1e-6);
  CHECK_NEAR(metrics->GetMaximum(), 1.0, 1e-12);
  CHECK_NEAR(metrics->GetBias(), 100.5 / 200.0, 1e-6);
  errors.push_back(0.0f);
  metrics->SetReference(NewImage<float>(201, 1, 1, Floats(201, 0.0f)));
  metrics->SetImage(NewImage<float>(201, 1, 1, errors));
  CHECK(metrics->Update());
  CHECK_NEAR(metrics->GetP99(), 0.99, 1e-6);
  // Negative errors rank by their size.
  for (float& error : errors)
  {
    error = -error;
  }
  metrics->SetImage(NewImage<float>(201, 1, 1, errors));
  CHECK(metrics->Update());
  CHECK_NEAR(metrics->GetP99(), 0.99, 1e-6);
}

// Only what is a receiver in both images counts, whatever the other pixels hold.
void TestMask()
{
  const auto reference = NewImage<float>(4, 1, 1, { 0.5f, NaN, 0.5f, 0.5f });
  const auto image = NewImage<float>(4, 1, 1, { 0.75f, 0.0f, NaN, 0.5f });
  SetMask(reference, { 1, 0, 255, 1 });
  SetMask(image, { 1, 1, 0, 255 });
  vtkNew<vtkVisibilityMetrics> metrics;
  metrics->SetReference(reference);
  metrics->SetImage(image);
  CHECK(metrics->Update());
  CHECK(metrics->GetNumberOfReceiverPixels() == 2);
  CHECK_NEAR(metrics->GetBias(), 0.125, 1e-12);
  const Bytes colors = { 255, 0, 0, 128, 128, 128, 128, 128, 128, 255, 255, 255 };
  CHECK(GetValues<unsigned char>(metrics->GetDifferenceImage()) == colors);

  SetMask(image, { 0, 1, 0, 0 });
  ExpectFailure(metrics, "no pixel is a receiver");
  SetMask(image, { 1, 1 });
  ExpectFailure(metrics, "image: its array \"Receiver\"");
}

// Errors 0.25, 0, -0.5, 0.25 where N.L is 1, 0.5, 0, 0.5: what turns away shows nothing.
void TestWeights()
{
  vtkNew<vtkVisibilityMetrics> metrics;
  const auto reference = NewImage<float>(2, 2, 1, { 0.0f, 1.0f, 0.5f, 0.25f });
  const auto image = NewImage<float>(2, 2, 1, { 0.25f, 1.0f, 0.0f, 0.5f });
  metrics->SetReference(reference);
  metrics->SetImage(image);
  CHECK(metrics->Update());
  CHECK_NEAR(metrics->GetWeightedRMSE(), metrics->GetRMSE(), 1e-12);
  CHECK_NEAR(metrics->GetPenumbraWeightedRMSE(), metrics->GetPenumbraRMSE(), 1e-12);
  reference->GetPointData()->AddArray(NewArray<float>("Cosine", 1, { 1.0f, 0.5f, 0.0f, 0.5f }));
  metrics->Modified();
  CHECK(metrics->Update());
  CHECK_NEAR(metrics->GetWeightedRMSE(), std::sqrt((0.0625 + 0.015625) / 1.5), 1e-12);
  CHECK_NEAR(metrics->GetPenumbraWeightedRMSE(), 0.25, 1e-12);
  CHECK(Contains(metrics->GetJSON(), "\"weighted_rmse\":0.2"));
  reference->GetPointData()->AddArray(NewArray<float>("Cosine", 1, { 0.0f, 0.0f, 0.0f, 0.0f }));
  CHECK(metrics->Update());
  CHECK(metrics->GetWeightedRMSE() == 0.0);
  reference->GetPointData()->AddArray(NewArray<float>("Cosine", 1, { 0.0f, 0.0f }));
  ExpectFailure(metrics, "reference: its array \"Cosine\"");
}

// Three components: each counts; a pixel is penumbra if one of its components is.
void TestColour()
{
  vtkNew<vtkVisibilityMetrics> metrics;
  metrics->SetReference(NewImage<float>(2, 1, 3, { 0.0f, 0.5f, 1.0f, 1.0f, 1.0f, 1.0f }));
  metrics->SetImage(NewImage<float>(2, 1, 3, { 0.0f, 0.75f, 0.5f, 1.0f, 1.0f, 0.75f }));
  CHECK(metrics->Update());
  CHECK(metrics->GetNumberOfReceiverPixels() == 2 && metrics->GetNumberOfPenumbraPixels() == 1);
  CHECK_NEAR(metrics->GetRMSE(), std::sqrt((0.0625 + 0.25 + 0.0625) / 6.0), 1e-12);
  CHECK_NEAR(metrics->GetBias(), -0.5 / 6.0, 1e-12);
  CHECK_NEAR(metrics->GetPenumbraRMSE(), std::sqrt((0.0625 + 0.25) / 3.0), 1e-12);
  const Bytes colors = { 0, 0, 255, 0, 0, 255 };
  CHECK(GetValues<unsigned char>(metrics->GetDifferenceImage()) == colors);
}

// "Visibility" goes before the active scalars; without it these are taken.
void TestArrays()
{
  const auto reference = NewImage<float>(1, 1, 1, { 0.5f }, "ImageScalars");
  const auto image = NewImage<float>(1, 1, 1, { 0.0f }, "Other");
  image->GetPointData()->AddArray(NewArray<float>("Visibility", 1, { 0.75f }));
  vtkNew<vtkVisibilityMetrics> metrics;
  metrics->SetReference(reference);
  metrics->SetImage(image);
  CHECK(metrics->Update());
  CHECK_NEAR(metrics->GetBias(), 0.25, 1e-12);
}

void TestFailures()
{
  vtkNew<vtkVisibilityMetrics> metrics;
  CHECK(std::isnan(metrics->GetRMSE()) && metrics->GetNumberOfReceiverPixels() == 0);
  ExpectFailure(metrics, "reference: there is no image");
  metrics->SetReference(NewImage<float>(2, 2, 1, { 0.0f, 1.0f, 0.5f, 0.25f }));
  ExpectFailure(metrics, "image: there is no image");
  metrics->SetImage(NewImage<float>(4, 1, 1, { 0.0f, 1.0f, 0.5f, 0.25f }));
  ExpectFailure(metrics, "the image is 4 x 1, the reference 2 x 2");
  metrics->SetImage(NewImage<float>(2, 2, 3, Floats(12, 0.5f)));
  ExpectFailure(metrics, "3 components, the reference 1");
  metrics->SetImage(NewImage<float>(2, 2, 4, Floats(16, 0.5f)));
  ExpectFailure(metrics, "float with 4 components");
  metrics->SetImage(NewImage<unsigned char>(2, 2, 1, Bytes(4, 0)));
  ExpectFailure(metrics, "unsigned char with 1 components");
  metrics->SetImage(
    NewImage<float>(2, 2, 1, { NaN, 1.0f, NaN, std::numeric_limits<float>::infinity() }));
  ExpectFailure(metrics, "3 values of the image and 0 of the reference");
}
}

int TestVisibilityMetrics(int, char*[])
{
  TestFigures();
  TestWeights();
  TestRangeEnds();
  TestPercentile();
  TestMask();
  TestColour();
  TestArrays();
  TestFailures();
  return Result();
}
