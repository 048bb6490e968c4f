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

  /**
   * Bring silhouettes up to date, from so many samples of each light that has a size, within a limit of
   * bytes for all lines. What was done is counted in the frame.
   */
  void Update(vtkShadowFrame& frame, int samples, std::size_t memoryLimit);
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
  };

  void UpdatePart(vtkShadowFrame& frame, int part, std::vector<int> casters, std::size_t& bytes);
  void Find(vtkShadowFrame& frame, const PartState& state, int batch, Batch& result);
  static std::size_t ReleaseBatches(PartState& state);

  int Samples = 0;
  std::size_t MemoryLimit = 0;
  vtkShadowChanges Changes;
  unsigned long Version = 0;
  vtkShadowAdjacencies Adjacencies;
  std::vector<PartState> Parts;
  Batch Unkept; // one that is not kept
  int UnkeptLight = -1;
  int UnkeptBatch = -1;
};

#endif
