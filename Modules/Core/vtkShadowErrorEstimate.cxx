// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowErrorEstimate.h"

#include "vtkOpenGLRenderWindow.h"
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
bool vtkShadowErrorEstimate::Ask(const vtkShadowFrame& frame, vtkShadowReceivers& receivers,
  const Shown& shown, const vtkLight* light)
{
  const int components = shown.Components;
  const int width = receivers.GetWidth();
  const auto& texels = receivers.Read(frame.Window);
  const auto isReceiver = [&texels](int pixel) { return vtkShadowReceiver::IsOne(texels[pixel]); };
  const auto get = [&](int pixel, int c)
  { return shown.Values[static_cast<std::size_t>(pixel) * components + c]; };

  this->Strata.assign(2, {}); // parts of the light and edges; all else
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
      this->Strata[part ? 0 : 1].Pixels.push_back(i);
    }
  }
  std::mt19937 random(1);
  std::vector<glm::vec4> chosen(static_cast<std::size_t>(Width) * Height, glm::vec4(0.0f));
  this->Pixels.clear();
  for (Stratum& stratum : this->Strata)
  {
    stratum.Chosen = ChooseSome(stratum.Pixels, random);
    for (std::size_t i = 0; i < stratum.Chosen; ++i)
    {
      chosen[this->Pixels.size()] = texels[stratum.Pixels[i]];
      this->Pixels.push_back(stratum.Pixels[i]);
    }
  }

  vtkShadowFrame own = frame; // of this light alone, and rays of its own
  own.Parts.erase(std::remove_if(own.Parts.begin(), own.Parts.end(),
                    [light](const vtkShadowLightPart& part) { return part.Light.Light != light; }),
    own.Parts.end());
  for (auto& part : own.Parts)
  {
    part.Light.FirstSample = -1;
  }
  this->Truth[0] = this->Truth[1] = {};
  if (own.Parts.empty() || this->Pixels.empty())
  {
    return true;
  }
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
    return false;
  }
  this->Receivers.GetTexture().UploadLayer(frame.Window, 0, &chosen[0].x);
  // Other rays than those of the seeds that users take.
  this->Truth[0] = this->Trace(own, light, "40503");
  this->Truth[1] = this->Trace(own, light, "52711");
  return true;
}

//------------------------------------------------------------------------------
std::vector<vtkShadowErrorEstimate::Pixel> vtkShadowErrorEstimate::FindPixels(
  const Shown& shown) const
{
  std::vector<Pixel> found(this->Pixels.size());
  const int components = shown.Components;
  const auto get = [](const Shown& of, std::size_t pixel, int c)
  { return of.Values.empty() ? 1.0 : of.Values[pixel * of.Components + c]; };
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      const double v = get(shown, static_cast<std::size_t>(this->Pixels[i]), c);
      const double a = get(this->Truth[0], i, c);
      const double b = get(this->Truth[1], i, c);
      found[i].Square += (v - a) * (v - b) / components;
      found[i].Difference += (v - 0.5 * (a + b)) / components;
      found[i].Truth += 0.5 * (a + b) / components;
    }
  }
  return found;
}

//------------------------------------------------------------------------------
nlohmann::ordered_json vtkShadowErrorEstimate::Judge(const Shown& shown) const
{
  const auto found = this->FindPixels(shown);
  return { { "receivers", Describe(this->Strata, found, false) },
    { "penumbrae", Describe(this->Strata, found, true) }, { "pixels", this->Pixels.size() } };
}

//------------------------------------------------------------------------------
vtkShadowErrorEstimate::RMSE vtkShadowErrorEstimate::FindError(const Shown& shown) const
{
  const auto found = this->FindPixels(shown);
  for (const bool penumbraAlone : { true, false })
  {
    const Figure square = FindMean(this->Strata, found, &Pixel::Square, penumbraAlone);
    if (square.Known)
    {
      const auto root = [](double value) { return std::sqrt(std::max(0.0, value)); };
      return { root(square.Value), root(square.Value - square.Margin),
        root(square.Value + square.Margin) };
    }
  }
  return {};
}

//------------------------------------------------------------------------------
// What is seen of the light by the chosen receivers.
vtkShadowErrorEstimate::Shown vtkShadowErrorEstimate::Trace(
  vtkShadowFrame& frame, const vtkLight* light, const char* seed)
{
  this->Settings.Set("seed", seed);
  this->Rays->Evaluate(frame, this->Visibility);
  return Read(frame, this->Visibility, light);
}

//------------------------------------------------------------------------------
vtkShadowErrorEstimate::Shown vtkShadowErrorEstimate::Read(
  const vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, const vtkLight* light)
{
  const int stored = buffer.GetComponents();
  Shown shown;
  shown.Components = std::min(3, stored);
  const std::size_t pixels = static_cast<std::size_t>(buffer.GetWidth()) * buffer.GetHeight();
  shown.Values.assign(pixels * shown.Components, 1.0f);
  for (std::size_t part = 0; part < frame.Parts.size(); ++part)
  {
    if (frame.Parts[part].Light.Light != light)
    {
      continue;
    }
    const auto values = buffer.ReadTarget(frame.Window, static_cast<int>(part));
    const float share = static_cast<float>(frame.Parts[part].Share);
    for (std::size_t i = 0; i < shown.Values.size(); ++i)
    {
      const float value = values[i / shown.Components * stored + i % shown.Components];
      shown.Values[i] -= share * (1.0f - std::clamp(value, 0.0f, 1.0f));
    }
  }
  return shown;
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
  return { mean, Margin95 * std::sqrt(std::max(0.0, variance)) / size, true };
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
