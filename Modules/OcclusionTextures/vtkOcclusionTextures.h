// SPDX-License-Identifier: BSD-3-Clause
// The occlusion textures of a frame's lights: slices of the casters, drawn at once, and what is made of them
// to be looked up. Kept while lights, casters and settings are unchanged.
//
//   slices   RGBA8    up to four, a channel each slice; a layer each view of a light
//   nearest  R32F     what is nearest to the light, of the same draw; a layer each view
//   levels   RGBA8    of N-buffers, even and odd ones in two textures: means over boxes of 2^level texels
//   mips     RGBA8    slices with levels
//   sums     RGBA32UI summed-area tables, and two steps between
//   bits     R32UI    all slices of a texel
//   sets     RGBA32F buffer, or uniforms if few: see vtkOcclusionLookUpFS.glsl
//   samples  RGBA32F buffer  two texels a sample of a light
//
// All textures of a frame have one size, the largest that a view needs: `resolution` along the longer side.

#ifndef vtkOcclusionTextures_h
#define vtkOcclusionTextures_h

#include "vtkOcclusionSlices.h" // For slices
#include "vtkOcclusionViews.h"  // For views
#include "vtkShadowChanges.h"   // For what is kept
#include "vtkShadowGL.h"        // For textures
#include "vtkShadowVectors.h"   // For sets

#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

class vtkOpenGLState;
class vtkShaderProgram;
struct vtkShadowFrame;

struct vtkOcclusionSettings
{
  enum class Filter
  {
    Sums,
    Means,
    Mips,
    Bits
  };
  int Resolution = 512;
  int Slices = 16;
  Filter Prefilter = Filter::Means;
  vtkOcclusionSlice::Placement Placement = vtkOcclusionSlice::Placement::Uniform;
  bool Twice = false; // each slice holds the one before too
  bool Skipping = true;
  int Samples = 32;    // of Bits
  std::string Combine; // as the parameter names it

  bool operator==(const vtkOcclusionSettings& other) const;
};

class vtkOcclusionTextures
{
public:
  static constexpr int MostSlices = 16;

  /** Bring them up to date, counting in the frame. False when out of memory. */
  bool Update(vtkShadowFrame& frame, const vtkOcclusionSettings& settings);

  std::string GetGLSL() const;
  void SetParameters(vtkShaderProgram* program);
  void Activate(vtkShadowFrame& frame);
  void Deactivate(vtkShadowFrame& frame);

  /** Draw the slices of the first view, or what is looked up of them, over the viewport. */
  void DrawView(vtkShadowFrame& frame, bool levels);

  /** The most that a receiver's look-ups cost. */
  double GetMaximumCost() const;
  std::vector<std::pair<std::string, std::size_t>> GetBytes() const;
  void Release(vtkOpenGLRenderWindow* window);

private:
  using Filter = vtkOcclusionSettings::Filter;

  struct Set
  {
    int Part = 0;
    vtkOcclusionView View;
    std::vector<vtkOcclusionSlice> Slices;
    glm::dvec2 Low{ 0.0 }; // the texture's window, with its border
    glm::dvec2 Texel{ 1.0 };
    glm::ivec2 Size{ 1 };
    double Kernel = 0.0; // the widest that is asked for, in texels
  };

  std::vector<Set> MakeSets(vtkShadowFrame& frame, int part) const;
  void FitWindow(Set& set) const;
  bool Allocate(vtkShadowFrame& frame);
  void Draw(vtkShadowFrame& frame, int set);
  void Make(vtkShadowFrame& frame, int first, int count);
  void MakeMeans(vtkShadowFrame& frame, int set);
  void MakeSums(vtkShadowFrame& frame, int set);
  void MakeBits(vtkShadowFrame& frame, int set);
  void DrawCopy(vtkShadowFrame& frame, vtkShadowTexture& target, int layer, int set, int slices);
  void UpdateVectors(vtkShadowFrame& frame);
  void UpdateSamples(vtkShadowFrame& frame);
  /** Compares of a receiver at a contact. */
  int GetContacts() const { return std::min((this->Current.Samples + 1) / 2, 32); }
  int GetEvenLevels() const { return (this->Levels + 1) / 2; }
  int GetOddLevels() const { return std::max(1, this->Levels / 2); }
  vtkShadowTexture& GetLevel(int level) { return level % 2 ? this->Odd : this->Even; }
  int GetLayer(int set, int target, int level) const;

  vtkOcclusionSettings Current;
  vtkShadowChanges Changes;
  std::vector<Set> Sets;  // by part
  std::vector<int> First; // of each part, and the number of all
  int Targets = 1;
  int Levels = 1;
  int MostInSet = 1; // slices
  bool Color = false;
  bool Hard = false;

  std::array<vtkShadowTexture, 4> Slices;
  vtkShadowTexture Nearest;
  vtkShadowTexture Even;
  vtkShadowTexture Odd;
  vtkShadowTexture Mips;
  vtkShadowTexture Sums;
  std::array<vtkShadowTexture, 2> Steps;
  vtkShadowTexture Bits;
  vtkShadowVectors Vectors;
  vtkShadowVectors Samples;
  vtkShadowFramebuffer Framebuffer;
};

#endif
