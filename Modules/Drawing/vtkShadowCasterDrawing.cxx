// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCasterDrawing.h"

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasterFS.h"
#include "vtkShadowCasterVS.h"
#include "vtkShadowHolesFS.h"
#include "vtkShadowHolesVS.h"
#include "vtkShadowOpenGL.h"
#include "vtkTexture.h"
#include "vtkTextureObject.h"

#include <glm/common.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace
{
/** So far beyond a side of the picture, in its half sides, what is culled is not seen: rounding is far less. */
constexpr double Clearance = 1e-4;

/** All of a box lies beyond the same side of the picture. */
bool IsBeyond(const glm::dmat4& toClip, const glm::dvec3& low, const glm::dvec3& high)
{
  const glm::dvec4 w = (1.0 + Clearance) * glm::row(toClip, 3);
  for (int axis = 0; axis < 2; ++axis)
  {
    for (const double sign : { 1.0, -1.0 })
    {
      // The least of a linear function over the box: inside of the picture it is not positive.
      const glm::dvec4 side = sign * glm::row(toClip, axis) - w;
      double least = side.w;
      for (int i = 0; i < 3; ++i)
      {
        least += std::min(side[i] * low[i], side[i] * high[i]);
      }
      if (least > 0.0)
      {
        return true;
      }
    }
  }
  return false;
}

/** Some triangles of a mesh, one after another, and their box. */
struct Chunk
{
  std::size_t First; // index
  std::size_t Count;
  glm::dvec3 Low;
  glm::dvec3 High;
};

/** Empty where the mesh is not large. */
std::vector<Chunk> MakeChunks(const vtkShadowMesh& mesh)
{
  std::vector<Chunk> chunks;
  constexpr std::size_t size = 3 * vtkShadowCasterDrawing::ChunkTriangles;
  for (std::size_t first = 0; mesh.Indices.size() > size && first < mesh.Indices.size();
       first += size)
  {
    const std::size_t count = std::min(size, mesh.Indices.size() - first);
    Chunk chunk{ first, count, mesh.Maximum, mesh.Minimum };
    for (std::size_t i = first; i < first + count; ++i)
    {
      const float* position = &mesh.Positions[3 * std::size_t(mesh.Indices[i])];
      const glm::dvec3 p(position[0], position[1], position[2]);
      chunk.Low = glm::min(chunk.Low, p);
      chunk.High = glm::max(chunk.High, p);
    }
    chunks.push_back(chunk);
  }
  return chunks;
}
}

/** What lies on the GPU. */
class vtkShadowCasterDrawing::Buffers
{
public:
  unsigned long MeshVersion = 0;
  vtkNew<vtkOpenGLBufferObject> Vertices;
  vtkNew<vtkOpenGLBufferObject> Indices;
  vtkNew<vtkOpenGLBufferObject> Places; // of holes
  /** Of casters with holes; that of nullptr is 1 everywhere. */
  std::map<std::shared_ptr<const vtkShadowAlphaMap>, vtkSmartPointer<vtkTextureObject>> Maps;
  vtkShadowPrograms Programs;
  /** Of each caster. */
  struct Place
  {
    std::size_t Count = 0; // indices
    std::size_t First = 0; // index
    GLint FirstVertex = 0;
  };
  std::vector<Place> PlaceOf;
  std::map<const vtkShadowMesh*, std::vector<Chunk>> Chunks; // of large meshes
  std::size_t Bytes = 0;

  /** Places and maps of casters with holes, whose vertices come first in this order. */
  void UploadHoles(vtkOpenGLRenderWindow* window, const std::vector<vtkShadowCaster>& casters,
    const std::vector<std::size_t>& order)
  {
    std::vector<float> places;
    std::set<const vtkShadowMesh*> known;
    const auto before = std::move(this->Maps);
    this->Maps.clear();
    for (const std::size_t i : order)
    {
      const vtkShadowHoles* holes = casters[i].Mesh->Holes.get();
      if (!holes || !known.insert(casters[i].Mesh.get()).second)
      {
        continue;
      }
      places.insert(places.end(), holes->Places.begin(), holes->Places.end());
      auto& texture = this->Maps[holes->Map];
      const auto old = before.find(holes->Map);
      if (!texture)
      {
        texture = old != before.end() ? old->second : MakeTexture(window, holes->Map.get());
      }
    }
    for (const auto& entry : before)
    {
      if (this->Maps.count(entry.first) == 0)
      {
        entry.second->ReleaseGraphicsResources(window);
      }
    }
    for (const auto& entry : this->Maps)
    {
      this->Bytes += entry.first ? entry.first->Texels.size() : 1;
    }
    if (!places.empty())
    {
      this->Places->Upload(places, vtkOpenGLBufferObject::ArrayBuffer);
      this->Bytes += places.size() * sizeof(float);
    }
    else
    {
      this->Places->ReleaseGraphicsResources();
    }
  }

private:
  static vtkSmartPointer<vtkTextureObject> MakeTexture(
    vtkOpenGLRenderWindow* window, const vtkShadowAlphaMap* map)
  {
    unsigned char one = 255;
    auto texture = vtkSmartPointer<vtkTextureObject>::New();
    texture->SetContext(window);
    texture->Create2DFromRaw(map ? map->Width : 1, map ? map->Height : 1, 1, VTK_UNSIGNED_CHAR,
      map ? const_cast<unsigned char*>(map->Texels.data()) : &one);
    const bool linear = map && map->Linear;
    const int filter = linear ? vtkTextureObject::Linear : vtkTextureObject::Nearest;
    texture->SetMinificationFilter(filter);
    texture->SetMagnificationFilter(filter);
    int wrap = vtkTextureObject::ClampToEdge;
    switch (map ? map->Wrap : static_cast<int>(vtkTexture::ClampToEdge))
    {
      case vtkTexture::Repeat:
        wrap = vtkTextureObject::Repeat;
        break;
      case vtkTexture::MirroredRepeat:
        wrap = vtkTextureObject::MirroredRepeat;
        break;
      case vtkTexture::ClampToBorder:
        wrap = vtkTextureObject::ClampToBorder;
        break;
      default:
        break;
    }
    texture->SetWrapS(wrap);
    texture->SetWrapT(wrap);
    const float border = map ? map->Border / 255.0f : 0.0f;
    texture->SetBorderColor(border, border, border, border);
    return texture;
  }
};

//------------------------------------------------------------------------------
vtkShadowCasterDrawing::vtkShadowCasterDrawing(const vtkShadowCasters& casters)
  : Casters(casters)
{
}

//------------------------------------------------------------------------------
vtkShadowCasterDrawing::~vtkShadowCasterDrawing() = default;

//------------------------------------------------------------------------------
void vtkShadowCasterDrawing::Upload(vtkOpenGLRenderWindow* window)
{
  this->Used = true;
  if (!this->GPU)
  {
    this->GPU = std::make_unique<Buffers>();
  }
  Buffers& gpu = *this->GPU;
  if (gpu.MeshVersion == this->Casters.GetMeshVersion())
  {
    return;
  }
  const auto& casters = this->Casters.Get();
  std::vector<float> vertices;
  std::vector<std::uint32_t> indices;
  vertices.reserve(3 * this->Casters.GetNumberOfVertices());
  indices.reserve(3 * this->Casters.GetNumberOfTriangles());
  gpu.PlaceOf.assign(casters.size(), {});
  gpu.Chunks.clear();
  std::vector<std::size_t> order(casters.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_partition(order.begin(), order.end(),
    [&casters](std::size_t i) { return casters[i].Mesh->Holes != nullptr; });
  std::map<const vtkShadowMesh*, std::size_t> known; // casters share their mesh's place
  for (const std::size_t i : order)
  {
    const vtkShadowMesh& mesh = *casters[i].Mesh;
    const auto place = known.emplace(&mesh, i);
    if (!place.second)
    {
      gpu.PlaceOf[i] = gpu.PlaceOf[place.first->second];
      continue;
    }
    const auto firstVertex = static_cast<std::uint32_t>(vertices.size() / 3);
    gpu.PlaceOf[i] = { mesh.Indices.size(), indices.size(), static_cast<GLint>(firstVertex) };
    vertices.insert(vertices.end(), mesh.Positions.begin(),
      mesh.Positions.begin() + 3 * mesh.GetNumberOfVertices());
    for (const std::uint32_t index : mesh.Indices)
    {
      indices.push_back(firstVertex + index);
    }
    auto chunks = MakeChunks(mesh);
    if (!chunks.empty())
    {
      gpu.Chunks.emplace(&mesh, std::move(chunks));
    }
  }
  gpu.Vertices->Upload(vertices, vtkOpenGLBufferObject::ArrayBuffer);
  glBindVertexArray(0); // or the indices would become that array's
  gpu.Indices->Upload(indices, vtkOpenGLBufferObject::ElementArrayBuffer);
  gpu.Bytes = vertices.size() * sizeof(float) + indices.size() * sizeof(std::uint32_t);
  gpu.UploadHoles(window, casters, order);
  gpu.MeshVersion = this->Casters.GetMeshVersion();
}

//------------------------------------------------------------------------------
vtkShadowPrograms::Program* vtkShadowCasterDrawing::Bind(vtkOpenGLRenderWindow* window,
  vtkOpenGLBufferObject* indices, const vtkShadowCasterDraw& how, bool holes)
{
  Buffers& gpu = *this->GPU;
  const vtkShadowPrograms::Sources sources{ how.VertexShader ? how.VertexShader : vtkShadowCasterVS,
    how.GeometryShader, how.FragmentShader ? how.FragmentShader : vtkShadowCasterFS,
    how.Definitions, holes };
  vtkShadowPrograms::Program* program = gpu.Programs.Use(window, sources,
    [holes](std::string& vertex, std::string& fragment)
    {
      const auto replace = [](std::string& shader, const char* declaration, const char* call)
      {
        vtkShaderProgram::Substitute(shader, "//VTK::ShadowHoles::Dec", declaration);
        vtkShaderProgram::Substitute(shader, "//VTK::ShadowHoles::Impl", call);
      };
      if (holes)
      {
        replace(vertex, vtkShadowHolesVS, "shadowPassPlace();");
        replace(fragment, vtkShadowHolesFS, "shadowDiscardHole();");
      }
    });
  if (!program)
  {
    return nullptr;
  }
  if (how.SetParameters)
  {
    how.SetParameters(program->Shaders);
    program->VertexArray->Bind(); // whatever that bound
  }
  if (program->Version != gpu.MeshVersion)
  {
    program->VertexArray->ShaderProgramChanged(); // attributes are to be bound anew
    program->VertexArray->Bind();
    program->VertexArray->AddAttributeArray(
      program->Shaders, gpu.Vertices, "vertexMC", 0, 3 * sizeof(float), VTK_FLOAT, 3, false);
    // Shaders without the marks fill holes.
    if (holes && program->Shaders->IsAttributeUsed("shadowPlace"))
    {
      program->VertexArray->AddAttributeArray(
        program->Shaders, gpu.Places, "shadowPlace", 0, 3 * sizeof(float), VTK_FLOAT, 3, false);
    }
    program->Version = gpu.MeshVersion;
  }
  indices->Bind();
  return program;
}

//------------------------------------------------------------------------------
void vtkShadowCasterDrawing::SetCaster(vtkShaderProgram* program, const glm::dmat4& MCToClip,
  const vtkShadowCaster& caster, const vtkShadowCasterDraw& how)
{
  glm::mat4 matrix(MCToClip);
  program->SetUniformMatrix4x4("MCToClip", glm::value_ptr(matrix));
  if (how.SetCasterParameters)
  {
    how.SetCasterParameters(program, caster);
  }
}

//------------------------------------------------------------------------------
void vtkShadowCasterDrawing::DrawVisible(std::size_t caster, const glm::dmat4& MCToClip)
{
  const Buffers::Place& place = this->GPU->PlaceOf[caster];
  const auto draw = [this, &place](std::size_t first, std::size_t count)
  {
    this->Drawn += count / 3;
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
      reinterpret_cast<const void*>((place.First + first) * sizeof(std::uint32_t)));
  };
  const auto chunks = this->GPU->Chunks.find(this->Casters.Get()[caster].Mesh.get());
  if (chunks == this->GPU->Chunks.end())
  {
    ++this->DrawnChunks;
    draw(0, place.Count);
    return;
  }
  std::size_t first = 0;
  std::size_t count = 0; // of neighbours that are seen
  for (const Chunk& chunk : chunks->second)
  {
    if (IsBeyond(MCToClip, chunk.Low, chunk.High))
    {
      this->Culled += chunk.Count / 3;
      continue;
    }
    if (first + count != chunk.First)
    {
      if (count > 0)
      {
        draw(first, count);
      }
      first = chunk.First;
      count = 0;
    }
    ++this->DrawnChunks;
    count += chunk.Count;
  }
  if (count > 0)
  {
    draw(first, count);
  }
}

//------------------------------------------------------------------------------
void vtkShadowCasterDrawing::Draw(vtkOpenGLRenderWindow* window, const glm::dmat4& SWCToClip,
  const std::vector<int>& casters, const vtkShadowCasterDraw& how)
{
  this->Upload(window);
  Buffers& gpu = *this->GPU;
  for (const bool holes : { false, true })
  {
    vtkShadowPrograms::Program* program = nullptr;
    for (const int i : casters)
    {
      const vtkShadowCaster& caster = this->Casters.Get()[i];
      const vtkShadowHoles* ofCaster = how.FillHoles ? nullptr : caster.Mesh->Holes.get();
      if ((ofCaster != nullptr) != holes)
      {
        continue;
      }
      const glm::dmat4 MCToClip = SWCToClip * caster.MeshToSWC;
      if (IsBeyond(MCToClip, caster.Mesh->Minimum, caster.Mesh->Maximum))
      {
        this->Culled += caster.Mesh->GetNumberOfTriangles();
        continue;
      }
      if (!program)
      {
        program = this->Bind(window, gpu.Indices, how, holes);
        if (!program)
        {
          return;
        }
      }
      this->SetCaster(program->Shaders, MCToClip, caster, how);
      vtkTextureObject* map = holes ? gpu.Maps[ofCaster->Map] : nullptr;
      if (map)
      {
        map->Activate();
        program->Shaders->SetUniformi("shadowAlphaMap", map->GetTextureUnit());
        program->Shaders->SetUniformf("shadowLeastAlpha", ofCaster->Threshold);
      }
      this->DrawVisible(static_cast<std::size_t>(i), MCToClip);
      if (map)
      {
        map->Deactivate();
      }
    }
    if (program)
    {
      program->VertexArray->Release();
    }
  }
}

//------------------------------------------------------------------------------
void vtkShadowCasterDrawing::DrawParts(vtkOpenGLRenderWindow* window, const glm::dmat4& SWCToClip,
  unsigned int primitive, vtkOpenGLBufferObject* indices,
  const std::vector<vtkShadowCasterPart>& parts, const vtkShadowCasterDraw& how)
{
  this->Upload(window);
  vtkShadowPrograms::Program* program =
    parts.empty() ? nullptr : this->Bind(window, indices, how, false);
  if (!program)
  {
    return;
  }
  for (const auto& part : parts)
  {
    const vtkShadowCaster& caster = this->Casters.Get()[part.Caster];
    this->SetCaster(program->Shaders, SWCToClip * caster.MeshToSWC, caster, how);
    if (how.SetPartParameters)
    {
      how.SetPartParameters(program->Shaders, part);
    }
    glDrawElementsBaseVertex(primitive, static_cast<GLsizei>(part.Count), GL_UNSIGNED_INT,
      reinterpret_cast<const void*>(part.First * sizeof(std::uint32_t)),
      this->GPU->PlaceOf[part.Caster].FirstVertex);
  }
  program->VertexArray->Release();
}

//------------------------------------------------------------------------------
std::size_t vtkShadowCasterDrawing::GetBytes() const
{
  return this->GPU ? this->GPU->Bytes : 0;
}

//------------------------------------------------------------------------------
void vtkShadowCasterDrawing::ReleasePrograms()
{
  if (this->GPU)
  {
    this->GPU->Programs.Release();
  }
}

//------------------------------------------------------------------------------
void vtkShadowCasterDrawing::Release(vtkOpenGLRenderWindow* window)
{
  if (!this->GPU)
  {
    return;
  }
  this->ReleasePrograms();
  this->GPU->Vertices->ReleaseGraphicsResources();
  this->GPU->Indices->ReleaseGraphicsResources();
  this->GPU->Places->ReleaseGraphicsResources();
  for (auto& entry : this->GPU->Maps)
  {
    entry.second->ReleaseGraphicsResources(window);
  }
  this->GPU.reset();
}
