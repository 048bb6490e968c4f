// SPDX-License-Identifier: BSD-3-Clause
// The silhouettes of casters from places on the lights, kept while lights and casters are unchanged: for
// whatever stands on them.
//
//   lines  index buffer  8 bytes a silhouette edge and place: pairs of the casters' vertices
//
// What does not fit into the memory allowed is found anew whenever it is asked for.

#ifndef vtkShadowSilhouetteCache_h
#define vtkShadowSilhouetteCache_h

#include "vtkNew.h"                            // For buffers
#include "vtkOpenGLBufferObject.h"             // For buffers
#include "vtkShadowAdjacency.h"                // For adjacencies
#include "vtkShadowChanges.h"                  // For what is kept
#include "vtkShadowLight.h"                    // For samples
#include "vtkShadowSilhouettes.h"              // For silhouettes
#include "vtkSoftShadowsShadowVolumesModule.h" // For export macro

#include <glm/vec4.hpp>

#include <cstddef>
#include <memory>
#include <vector>

struct vtkShadowFrame;

class VTKSOFTSHADOWSSHADOWVOLUMES_EXPORT vtkShadowSilhouetteCache
{
public:
  /** Silhouettes of up to vtkShadowSilhouettes::MostPlaces places. */
  struct Batch
  {
    vtkShadowSilhouettes Silhouettes;
    vtkNew<vtkOpenGLBufferObject> Lines;
    std::size_t Bytes = 0;
  };

  struct Options
  {
    /** Places on each light that has a size; 1 is its centre. */
    int Samples = 1;
    /** They are the middles of equal squares of the light, a square number of them; a textured one is whole. */
    bool Split = false;
    /** A caster has a part for each loop of its silhouette. */
    bool Loops = false;
    /** Lines stay on the CPU too, those of all places. */
    bool KeepLines = false;
    /** A bound on nested volumes need not be lower. */
    std::size_t EnoughNested = 255;
    /** Bytes for all lines. */
    std::size_t MemoryLimit = std::size_t(1) << 32;

    bool operator==(const Options& other) const
    {
      return this->Samples == other.Samples && this->Split == other.Split &&
             this->Loops == other.Loops && this->KeepLines == other.KeepLines &&
             this->EnoughNested == other.EnoughNested && this->MemoryLimit == other.MemoryLimit;
    }
  };
  /** Bring silhouettes up to date. What was done is counted in the frame. */
  void Update(vtkShadowFrame& frame, const Options& options);
  /** Rises whenever silhouettes were found anew for some light. */
  unsigned long GetVersion() const { return this->Version; }

  ///@{ Of a part of a light: the samples, and where they are in SWC (directions towards it: w 0).
  const std::vector<vtkLightSample>& GetSamples(int part) const
  {
    return this->Parts[part].Samples;
  }
  const glm::dvec4& GetPlace(int part, int sample) const
  {
    return this->Parts[part].Places[sample];
  }
  ///@}
  /** Casters that count for a part of a light: indices of vtkShadowCasters::Get(). */
  const std::vector<int>& GetCasters(int part) const { return this->Parts[part].Casters; }
  /** Rises whenever a part's silhouettes were found anew. */
  unsigned long GetVersion(int part) const { return this->Parts[part].Version; }
  /** What a sample's silhouette lies in; valid until the next call. */
  const Batch& GetBatch(vtkShadowFrame& frame, int part, int sample);
  /** The silhouette of a sample, of its batch. */
  static const vtkShadowSilhouette& Get(const Batch& batch, int sample)
  {
    return batch.Silhouettes.Get()[sample % vtkShadowSilhouettes::MostPlaces];
  }
  const vtkShadowAdjacencies& GetAdjacencies() const { return this->Adjacencies; }

  /** Bytes on the GPU. */
  std::size_t GetBytes() const;
  void Release();

private:
  struct PartState
  {
    std::vector<int> Casters;
    std::vector<vtkLightSample> Samples;
    std::vector<glm::dvec4> Places;
    std::vector<std::unique_ptr<Batch>> Batches; // those that are kept
    unsigned long Version = 0;
  };

  void UpdatePart(vtkShadowFrame& frame, int part, std::vector<int> casters, std::size_t& bytes);
  void Find(vtkShadowFrame& frame, const PartState& state, int batch, Batch& result);
  static std::size_t ReleaseBatches(PartState& state);

  Options Wanted;
  vtkShadowChanges Changes;
  unsigned long Version = 0;
  vtkShadowAdjacencies Adjacencies;
  std::vector<PartState> Parts;
  Batch Unkept; // one that is not kept
  int UnkeptLight = -1;
  int UnkeptBatch = -1;
};

#endif
