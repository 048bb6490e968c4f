// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowErrorEstimate.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkShadowDeclaration.h"
#include "vtkShadowFrame.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
constexpr int Width = 64;
constexpr int Height = 32;
/** Of each kind of pixels. */
constexpr std::size_t MostChosen = Width * Height / 2;
/** Rays of each of both estimates. */
const char* const Samples = "128";
/** V that is a part of the light, as metrics have it. */
constexpr double Least = 0.02;
constexpr double Most = 0.98;
/** Half of a 95 % interval, in standard errors. */
constexpr double Margin95 = 1.96;

const vtkShadowDeclaration* FindRays()
{
  return vtkShadowTechniqueRegistration::Find("ray-traced");
}

/** Bring some to the front, at random but always the same. */
std::size_t ChooseSome(std::vector<int>& pixels, std::mt19937& random)
{
  const std::size_t count = std::min(pixels.size(), MostChosen);
  for (std::size_t i = 0; i < count; ++i)
  {
    std::swap(pixels[i], pixels[i + random() % (pixels.size() - i)]);
  }
  return count;
}
}

//------------------------------------------------------------------------------
bool vtkShadowErrorEstimate::IsPossible()
{
  return FindRays() != nullptr;
}

//------------------------------------------------------------------------------
nlohmann::ordered_json vtkShadowErrorEstimate::Make(const vtkShadowFrame& frame,
  vtkShadowReceivers& receivers, vtkImageData* visibility, const vtkLight* light)
{
  vtkDataArray* shown = visibility->GetPointData()->GetScalars();
  const int components = shown->GetNumberOfComponents();
  const int width = receivers.GetWidth();
  const auto& texels = receivers.Read(frame.Window);
  const auto isReceiver = [&texels](int pixel) { return vtkShadowReceiver::IsOne(texels[pixel]); };
  const auto get = [&](int pixel, int c) { return shown->GetComponent(pixel, c); };

  std::vector<Stratum> strata(2); // parts of the light and edges; all else
  const int count = static_cast<int>(texels.size());
  for (int i = 0; i < count; ++i)
  {
    if (isReceiver(i))
    {
      bool part = false;
      for (int c = 0; c < components; ++c)
      {
        const double v = get(i, c);
        part = part || (v > Least && v < Most) ||
               (i % width > 0 && isReceiver(i - 1) && std::abs(v - get(i - 1, c)) > Least) ||
               (i >= width && isReceiver(i - width) && std::abs(v - get(i - width, c)) > Least);
      }
      strata[part ? 0 : 1].Pixels.push_back(i);
    }
  }
  std::mt19937 random(1);
  std::vector<glm::vec4> chosen(static_cast<std::size_t>(Width) * Height, glm::vec4(0.0f));
  std::vector<int> pixels;
  for (Stratum& stratum : strata)
  {
    stratum.Chosen = ChooseSome(stratum.Pixels, random);
    for (std::size_t i = 0; i < stratum.Chosen; ++i)
    {
      chosen[pixels.size()] = texels[stratum.Pixels[i]];
      pixels.push_back(stratum.Pixels[i]);
    }
  }

  vtkShadowFrame own = frame; // of this light alone
  own.Parts.erase(std::remove_if(own.Parts.begin(), own.Parts.end(),
                    [light](const vtkShadowLightPart& part) { return part.Light.Light != light; }),
    own.Parts.end());
  std::vector<float> truth[2];
  if (!own.Parts.empty() && !pixels.empty())
  {
    if (!this->Rays)
    {
      this->Settings.Reset(FindRays());
      this->Settings.Set("samples", Samples);
      this->Rays = FindRays()->Make(this->Settings);
    }
    if (!this->Receivers.Allocate(frame.Window, Width, Height) ||
        !this->Visibility.Allocate(
          frame.Window, this->Receivers, static_cast<int>(own.Parts.size()), own.Color) ||
        !this->Rays->UpdateLightData(own))
    {
      return nullptr;
    }
    this->Receivers.GetTexture().UploadLayer(frame.Window, 0, &chosen[0].x);
    // Other rays than those of the seeds that users take.
    truth[0] = this->Trace(own, "40503");
    truth[1] = this->Trace(own, "52711");
  }
  std::vector<Pixel> found(pixels.size());
  const int stored = this->Visibility.GetComponents();
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      const double v = get(pixels[i], c);
      const double a = truth[0].empty() ? 1.0 : truth[0][i * stored + c];
      const double b = truth[1].empty() ? 1.0 : truth[1][i * stored + c];
      found[i].Square += (v - a) * (v - b) / components;
      found[i].Difference += (v - 0.5 * (a + b)) / components;
      found[i].Truth += 0.5 * (a + b) / components;
    }
  }
  return { { "receivers", Describe(strata, found, false) },
    { "penumbrae", Describe(strata, found, true) }, { "pixels", pixels.size() } };
}

//------------------------------------------------------------------------------
// What is seen of the light by the chosen receivers.
std::vector<float> vtkShadowErrorEstimate::Trace(vtkShadowFrame& frame, const char* seed)
{
  this->Settings.Set("seed", seed);
  this->Rays->Evaluate(frame, this->Visibility);
  std::vector<float> sum;
  for (std::size_t part = 0; part < frame.Parts.size(); ++part)
  {
    const auto values = this->Visibility.ReadTarget(frame.Window, static_cast<int>(part));
    const float share = static_cast<float>(frame.Parts[part].Share);
    sum.resize(values.size(), 1.0f);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      sum[i] -= share * (1.0f - std::clamp(values[i], 0.0f, 1.0f));
    }
  }
  return sum;
}

//------------------------------------------------------------------------------
// Of all pixels that the strata hold, or of those in penumbrae: a quotient of sums over the strata, whose
// variance is that of its linear part.
vtkShadowErrorEstimate::Figure vtkShadowErrorEstimate::FindMean(const std::vector<Stratum>& strata,
  const std::vector<Pixel>& pixels, double Pixel::*quantity, bool penumbraAlone)
{
  const auto counts = [penumbraAlone](const Pixel& pixel)
  { return !penumbraAlone || (pixel.Truth > Least && pixel.Truth < Most) ? 1.0 : 0.0; };
  const auto forEach = [&](const auto& visit)
  {
    std::size_t first = 0;
    for (const Stratum& stratum : strata)
    {
      const double weight =
        stratum.Chosen > 0 ? static_cast<double>(stratum.Pixels.size()) / stratum.Chosen : 0.0;
      visit(stratum, first, weight);
      first += stratum.Chosen;
    }
  };
  double sum = 0.0;
  double size = 0.0;
  forEach(
    [&](const Stratum& stratum, std::size_t first, double weight)
    {
      for (std::size_t i = first; i < first + stratum.Chosen; ++i)
      {
        sum += weight * counts(pixels[i]) * pixels[i].*quantity;
        size += weight * counts(pixels[i]);
      }
    });
  if (!(size > 0.0))
  {
    return {};
  }
  const double mean = sum / size;
  double variance = 0.0;
  forEach(
    [&](const Stratum& stratum, std::size_t first, double weight)
    {
      double linear = 0.0;
      double squares = 0.0;
      for (std::size_t i = first; i < first + stratum.Chosen; ++i)
      {
        const double rest = counts(pixels[i]) * (pixels[i].*quantity - mean);
        linear += rest;
        squares += rest * rest;
      }
      const double n = static_cast<double>(stratum.Chosen);
      if (n > 1.0)
      {
        const double left = 1.0 - n / static_cast<double>(stratum.Pixels.size());
        variance += weight * weight * left * (squares - linear * linear / n) * n / (n - 1.0);
      }
    });
  return { mean, Margin95 * std::sqrt(std::max(0.0, variance)) / size };
}

//------------------------------------------------------------------------------
nlohmann::ordered_json vtkShadowErrorEstimate::Describe(
  const std::vector<Stratum>& strata, const std::vector<Pixel>& pixels, bool penumbraAlone)
{
  const auto root = [](double square) { return std::sqrt(std::max(0.0, square)); };
  const Figure square = FindMean(strata, pixels, &Pixel::Square, penumbraAlone);
  const Figure bias = FindMean(strata, pixels, &Pixel::Difference, penumbraAlone);
  return { { "rmse", root(square.Value) },
    { "rmseInterval", { root(square.Value - square.Margin), root(square.Value + square.Margin) } },
    { "bias", bias.Value },
    { "biasInterval", { bias.Value - bias.Margin, bias.Value + bias.Margin } } };
}

//------------------------------------------------------------------------------
void vtkShadowErrorEstimate::Release(vtkOpenGLRenderWindow* window)
{
  if (this->Rays)
  {
    this->Rays->Release(window);
    this->Rays.reset();
  }
  this->Receivers.Release(window);
  this->Visibility.Release(window);
}
