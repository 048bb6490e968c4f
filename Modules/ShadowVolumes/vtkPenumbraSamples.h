// SPDX-License-Identifier: BSD-3-Clause
// Samples of a light that edges are counted for: as digits of floats, four floats a target. What is
// added up is exact as long as a count stays within half of a digit's base.

#ifndef vtkPenumbraSamples_h
#define vtkPenumbraSamples_h

#include <cstddef>
#include <string>
#include <vector>

class vtkShaderProgram;
struct vtkShadowLight;

class vtkPenumbraSamples
{
public:
  static constexpr int MostTargets = 8;
  /** Counts up to this take the fewest targets. */
  static constexpr std::size_t LeastMost = 31;

  int Count = 0;
  int Digits = 4; // of a float: 4 of base 64, 3 of base 256, or 2 of base 4096
  bool Color = false;

  /** So many of a light, whose counts are within a number. */
  void Set(const vtkShadowLight& light, int count, std::size_t mostNested);
  /** All are counted in so many passes, the first of which have that many targets. */
  int GetPasses() const;
  int GetTargets(int pass) const;
  /** Definitions of vtkPenumbraCountFS.glsl and vtkPenumbraSamplesFS.glsl. */
  std::string GetDefinitions(int pass) const;
  void SetParameters(vtkShaderProgram* program, int pass) const;

private:
  int GetOfTarget() const { return 4 * this->Digits; }
  std::vector<float> X; // on the light, in half axes
  std::vector<float> Y;
  std::vector<float> Weights[3];
};

#endif
