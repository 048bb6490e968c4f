// SPDX-License-Identifier: BSD-3-Clause
// The triangles that cast shadows, gathered from the props of a renderer and kept while unchanged.
//
// On the CPU each mesh keeps float positions relative to its own centre and triangle indices; each
// caster is a mesh and a matrix, composed in double precision, to SWC: world axes with the origin at
// GetOrigin(), so that scenes far from the world's origin lose nothing. Meshes are
// shared: the ray tracer keeps a BVH, and shadow volumes an adjacency, for each of them.
//
// Translucent casters that count by their opacity: a caster of opacity a hides a share a of each light's
// rays, always the same ones, so that of several in a row the most opaque counts. The light is then
// seen in parts, one for each opacity that occurs: V is the sum of share times the V of what casts at
// that share, and every technique gets it right without knowing of it.
//
// What draws them on the GPU: vtkShadowCasterDrawing.

#ifndef vtkShadowCasters_h
#define vtkShadowCasters_h

#include "vtkShadowMesh.h"               // For vtkShadowMesh
#include "vtkSoftShadowsCastersModule.h" // For export macro

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

class vtkProp;
class vtkRenderer;
class vtkShadowMeshes;
struct vtkLightSample;
struct vtkShadowLight;
struct vtkShadowLightPart;

/** Whether translucent casters cast: not at all, as if they were opaque, or by their opacity. */
enum class vtkTranslucentCasters
{
  Off,
  Opaque,
  Weighted
};

/** A mesh in its place. */
struct VTKSOFTSHADOWSCASTERS_EXPORT vtkShadowCaster
{
  std::shared_ptr<const vtkShadowMesh> Mesh;
  vtkProp* Prop = nullptr; // whose it is; not to be used beyond the frame
  glm::dmat4 MeshToSWC{ 1.0 };
  /** Of parts of the lights (vtkShadowLightPart::LeastOpacity), those up to this one see it. */
  double Opacity = 1.0;
  /** Its prop, or the assembly that this is a part of, receives shadows. */
  bool Receives = true;
  /** Corners of the mesh's box in SWC. */
  std::array<glm::dvec3, 8> Corners;

  /** Whether a part of a light has it in its way. */
  bool IsSeenBy(const vtkShadowLightPart& part) const;

  ///@{ A sphere around it, in SWC.
  glm::dvec3 GetMiddle() const;
  double GetRadius() const;
  ///@}
};

class VTKSOFTSHADOWSCASTERS_EXPORT vtkShadowCasters
{
public:
  vtkShadowCasters();
  ~vtkShadowCasters();
  vtkShadowCasters(const vtkShadowCasters&) = delete;
  void operator=(const vtkShadowCasters&) = delete;

  /**
   * Gather what the renderer's visible props cast. True when anything changed.
   * Casting: what vtkShadowSurfaces.h names, of props and those within assemblies that are not
   * switched off by vtkShadowTags::SetCasting, and translucent ones as told. Their opacities are
   * rounded to so many levels between 0 and 1 where more of them occur. Where the alpha of colours
   * and textures is below a threshold, a surface has a hole. Updates the mappers' inputs.
   */
  bool Update(vtkRenderer* renderer, vtkTranslucentCasters translucent = vtkTranslucentCasters::Off,
    int levels = 0, double alphaThreshold = 0.5);

  const std::vector<vtkShadowCaster>& Get() const { return this->Casters; }
  /** Boxes of visible props that do not cast but can receive, as eight corners in SWC. */
  const std::vector<std::array<glm::dvec3, 8>>& GetReceivers() const { return this->Receivers; }

  /** The opacities of translucent casters that count by them, ascending. */
  const std::vector<double>& GetOpacities() const { return this->Opacities; }

  /** Origin of SWC in the world. It stays until the casters leave its neighbourhood. */
  const glm::dvec3& GetOrigin() const { return this->Origin; }
  /** Mean of the middles of some casters' boxes, in SWC. */
  glm::dvec3 GetMiddle(const std::vector<int>& casters) const;
  /**
   * Places on a light for light data of some casters, in the world (see vtkShadowLight::GetPlaces): those
   * of a sphere lie on the disk that faces the casters' middle, since no one receiver is meant.
   */
  std::vector<vtkLightSample> GetPlaces(
    const vtkShadowLight& light, int count, const std::vector<int>& casters) const;
  /**
   * The middles of count, a square number, equal squares of a light, likewise; of one its centre. Each
   * stands for as much of the light's area.
   */
  std::vector<vtkLightSample> GetMiddles(
    const vtkShadowLight& light, int count, const std::vector<int>& casters) const;
  /** Diagonal of the box around all casters, in world units. */
  double GetSize() const { return this->Size; }
  /** Rises with every change of what casts. */
  unsigned long GetVersion() const { return this->Version; }
  /** Rises when the boxes of GetReceivers() change. */
  unsigned long GetReceiverVersion() const { return this->ReceiverVersion; }
  /** Rises only when meshes came, went or changed: matrices alone leave it. */
  unsigned long GetMeshVersion() const { return this->MeshVersion; }

  std::size_t GetNumberOfVertices() const;
  std::size_t GetNumberOfTriangles() const;
  ///@{ Triangles that were degenerate or not finite, also of props that have no others and do not cast.
  std::size_t GetNumberOfDroppedTriangles() const { return this->Dropped; }
  std::size_t GetNumberOfTrianglesNotFinite() const { return this->NotFinite; }
  ///@}
  /** Those that alpha leaves nothing of. */
  std::size_t GetNumberOfClearTriangles() const;
  /** How many casters have holes within their triangles. */
  std::size_t GetNumberWithHoles() const;
  /** Props of alpha that is not known, and that cast without. */
  std::size_t GetNumberOfUnknownAlphas() const { return this->UnknownAlphas; }

private:
  std::vector<vtkShadowCaster> Casters;
  std::unique_ptr<vtkShadowMeshes> Meshes; // of the surfaces
  std::vector<double> Opacities;
  std::vector<std::array<glm::dvec3, 8>> Receivers;
  glm::dvec3 Origin{ 0.0 };
  double Size = 0.0;
  std::size_t Dropped = 0;
  std::size_t NotFinite = 0;
  unsigned long Version = 0;
  unsigned long MeshVersion = 0;
  unsigned long ReceiverVersion = 0;
  std::size_t UnknownAlphas = 0;
};

#endif
