// SPDX-License-Identifier: BSD-3-Clause
// Sampling patterns of rays to a light, shared by pixels that hash to the same one.
//
// Scrambled Sobol points, mapped to the shape's own square or disk [-1,1]^2 once, so that a sample costs
// two reads. Rays are traced in steps: so many first, then on until so many. Within a step the order is along a
// Morton curve, so that rays of a packet are near to each other.

#ifndef vtkShadowRayPatterns_h
#define vtkShadowRayPatterns_h

#include "vtkShadowLight.h" // For emission

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkShadowRayPatterns
{
public:
  static constexpr int Count = 256;

  /** Make them, if they are not those of the like of a light, steps (ascending) and a seed. */
  void Update(const vtkShadowLight& light, const std::vector<int>& steps, int seed);

  int GetSamples() const { return this->Samples; }
  /** Well mixed for each pixel; another seed, other patterns for all. */
  std::uint32_t Hash(int pixel) const;
  /** Index of a hash's first sample. */
  std::size_t GetFirst(std::uint32_t hash) const
  {
    return static_cast<std::size_t>(hash % Count) * static_cast<std::size_t>(this->Samples);
  }
  ///@{ Coordinates of samples along the half axes, and emission; empty without a texture.
  const std::vector<float>& GetA() const { return this->A; }
  const std::vector<float>& GetB() const { return this->B; }
  const std::vector<glm::vec3>& GetEmission() const { return this->Emission; }
  ///@}

private:
  int Samples = 0;
  std::vector<int> Steps;
  std::uint32_t Seed = 0;
  int First = -1; // vtkShadowLight::FirstSample
  bool Rectangle = false;
  vtkSmartPointer<vtkImageData> Texture;
  vtkMTimeType TextureTime = 0;
  std::vector<float> A;
  std::vector<float> B;
  std::vector<glm::vec3> Emission;
};

#endif
