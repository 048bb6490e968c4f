#include "vtkShadowCasters.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasterFS.h"
#include "vtkShadowCasterVS.h"
#include "vtkShadowPass.h"
#include "vtkShadowVTKVersion.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

namespace
{
std::array<glm::dvec3, 8> BoxCorners(const glm::dvec3& low, const glm::dvec3& high)
{
  std::array<glm::dvec3, 8> corners;
  for (int i = 0; i < 8; ++i)
  {
    corners[i] = { i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z };
  }
  return corners;
}

/** Mappers whose drawn surface is not the polygons of their input. */
bool MakesItsOwnGeometry(vtkMapper* mapper)
{
  return mapper->IsA("vtkPointGaussianMapper") || mapper->IsA("vtkOpenGLSphereMapper") ||
         mapper->IsA("vtkOpenGLStickMapper");
}

bool Casts(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  return mapper &&
         (mapper->IsA("vtkPolyDataMapper") || mapper->IsA("vtkCompositePolyDataMapper")) &&
         !MakesItsOwnGeometry(mapper) && mapper->GetNumberOfInputConnections(0) > 0 &&
         actor->GetProperty()->GetRepresentation() == VTK_SURFACE &&
         !actor->HasTranslucentPolygonalGeometry();
}

/** The polygon data sets that a mapper draws, brought up to date. */
std::vector<vtkPolyData*> GetInputs(vtkMapper* mapper)
{
  mapper->GetInputAlgorithm()->Update();
  vtkDataObject* input = mapper->GetInputDataObject(0, 0);
  if (auto* polygons = vtkPolyData::SafeDownCast(input))
  {
    return { polygons };
  }
  std::vector<vtkPolyData*> result;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    auto block = vtk::TakeSmartPointer(composite->NewIterator());
    for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem())
    {
      if (auto* polygons = vtkPolyData::SafeDownCast(block->GetCurrentDataObject()))
      {
        result.push_back(polygons);
      }
    }
  }
  return result;
}

template <typename Count>
std::size_t Sum(const std::vector<vtkShadowCaster>& casters, Count count)
{
  return std::accumulate(casters.begin(), casters.end(), std::size_t(0),
    [&count](std::size_t sum, const vtkShadowCaster& c) { return sum + count(*c.Mesh); });
}

/** A mesh in the world: what Update gathers before it knows the origin of WC. */
struct Placed
{
  std::shared_ptr<const vtkShadowMesh> Mesh;
  vtkProp* Prop;
  glm::dmat4 MeshToWorld;
};
}

/** What lies on the GPU. */
class vtkShadowCasters::Buffers
{
public:
  unsigned long MeshVersion = 0;
  vtkNew<vtkOpenGLBufferObject> Vertices;
  vtkNew<vtkOpenGLBufferObject> Indices;
  vtkNew<vtkOpenGLVertexArrayObject> VertexArray;
  vtkShaderProgram* Program = nullptr; // owned by the window's shader cache
  std::vector<GLsizei> Counts;         // indices of each caster
  std::vector<std::size_t> Offsets;    // first index of each caster, in bytes
  std::vector<GLint> FirstVertices;    // of each caster
  std::size_t Bytes = 0;
};

//------------------------------------------------------------------------------
glm::dvec3 vtkShadowCaster::GetMiddle() const
{
  return { this->MeshToWC * glm::dvec4(this->Mesh->Middle, 1.0) };
}

//------------------------------------------------------------------------------
double vtkShadowCaster::GetRadius() const
{
  const glm::dmat3 axes(this->MeshToWC);
  return this->Mesh->Radius *
         std::max({ glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]) });
}

//------------------------------------------------------------------------------
vtkShadowCasters::vtkShadowCasters() = default;

//------------------------------------------------------------------------------
vtkShadowCasters::~vtkShadowCasters() = default;

//------------------------------------------------------------------------------
bool vtkShadowCasters::Update(vtkRenderer* renderer)
{
  // Meshes that are still valid, by their source.
  std::map<vtkPolyData*, std::shared_ptr<const vtkShadowMesh>> known;
  for (const auto& caster : this->Casters)
  {
    known[caster.Mesh->Source] = caster.Mesh;
  }

  std::vector<Placed> placed;
  std::vector<std::array<glm::dvec3, 8>> receivers; // in the world
  const auto addActor = [&](vtkProp* root, vtkActor* actor, vtkMatrix4x4* matrix)
  {
    const glm::dmat4 modelToWorld = glm::transpose(glm::make_mat4(matrix->GetData()));
    const std::size_t before = placed.size();
    if (vtkShadowPass::GetCasting(root) && Casts(actor))
    {
      for (vtkPolyData* polygons : GetInputs(actor->GetMapper()))
      {
        auto& mesh = known[polygons];
        if (!mesh || mesh->SourceTime != vtkShadowMesh::GetShapeTime(polygons))
        {
          mesh = vtkShadowMesh::Make(polygons);
        }
        if (!mesh->Indices.empty() || mesh->Dropped > 0)
        {
          placed.push_back({ mesh, actor, glm::translate(modelToWorld, mesh->Centre) });
        }
      }
    }
    const double* b = actor->GetMapper() ? actor->GetMapper()->GetBounds() : nullptr;
    if (placed.size() == before && vtkShadowPass::GetReceiving(root) && b && b[0] <= b[1])
    {
      receivers.push_back(BoxCorners({ b[0], b[2], b[4] }, { b[1], b[3], b[5] }));
      for (auto& corner : receivers.back())
      {
        corner = glm::dvec3(modelToWorld * glm::dvec4(corner, 1.0));
      }
    }
  };
  vtkCollectionSimpleIterator cookie;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    if (prop->GetVisibility())
    {
      vtkShadowPass::ForEachActor(
        prop, [&](vtkActor* actor, vtkMatrix4x4* matrix) { addActor(prop, actor, matrix); });
    }
  }

  bool changed = placed.size() != this->Casters.size();
  bool meshesChanged = changed;
  glm::dvec3 low(std::numeric_limits<double>::max());
  glm::dvec3 high(std::numeric_limits<double>::lowest());
  for (std::size_t i = 0; i < placed.size(); ++i)
  {
    const auto& mesh = *placed[i].Mesh;
    for (const auto& corner : BoxCorners(mesh.Minimum, mesh.Maximum))
    {
      const glm::dvec3 p(placed[i].MeshToWorld * glm::dvec4(corner, 1.0));
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    meshesChanged = meshesChanged || this->Casters[i].Mesh != placed[i].Mesh;
  }
  // The origin stays as long as it is near: moving it would rebuild everything else.
  const glm::dvec3 centre = 0.5 * (low + high);
  this->Size = placed.empty() ? 0.0 : glm::length(high - low);
  if (!placed.empty() && glm::length(centre - this->Origin) > this->Size)
  {
    this->Origin = centre;
    changed = true;
  }

  std::vector<vtkShadowCaster> casters;
  casters.reserve(placed.size());
  const glm::dmat4 worldToWC = glm::translate(glm::dmat4(1.0), -this->Origin);
  for (const auto& item : placed)
  {
    vtkShadowCaster caster{ item.Mesh, item.Prop, worldToWC * item.MeshToWorld, {} };
    changed = changed || meshesChanged || caster.MeshToWC != this->Casters[casters.size()].MeshToWC;
    caster.Corners = BoxCorners(item.Mesh->Minimum, item.Mesh->Maximum);
    for (auto& corner : caster.Corners)
    {
      corner = glm::dvec3(caster.MeshToWC * glm::dvec4(corner, 1.0));
    }
    casters.push_back(std::move(caster));
  }
  this->Casters = std::move(casters);

  for (auto& box : receivers)
  {
    for (auto& corner : box)
    {
      corner -= this->Origin;
    }
  }
  this->ReceiverVersion += receivers != this->Receivers ? 1 : 0;
  this->Receivers = std::move(receivers);

  this->MeshVersion += meshesChanged ? 1 : 0;
  this->Version += changed ? 1 : 0;
  return changed;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkShadowCasters::GetMiddle(const std::vector<int>& casters) const
{
  glm::dvec3 middle(0.0);
  for (const int i : casters)
  {
    const auto& corners = this->Casters[i].Corners;
    middle += 0.5 * (corners[0] + corners[7]) / static_cast<double>(casters.size());
  }
  return middle;
}

//------------------------------------------------------------------------------
std::size_t vtkShadowCasters::GetNumberOfVertices() const
{
  return Sum(this->Casters, [](const vtkShadowMesh& m) { return m.GetNumberOfVertices(); });
}

//------------------------------------------------------------------------------
std::size_t vtkShadowCasters::GetNumberOfTriangles() const
{
  return Sum(this->Casters, [](const vtkShadowMesh& m) { return m.GetNumberOfTriangles(); });
}

//------------------------------------------------------------------------------
std::size_t vtkShadowCasters::GetNumberOfDroppedTriangles() const
{
  return Sum(this->Casters, [](const vtkShadowMesh& m) { return m.Dropped; });
}

//------------------------------------------------------------------------------
std::size_t vtkShadowCasters::GetNumberOfTrianglesNotFinite() const
{
  return Sum(this->Casters, [](const vtkShadowMesh& m) { return m.NotFinite; });
}

//------------------------------------------------------------------------------
void vtkShadowCasters::Upload()
{
  if (!this->GPU)
  {
    this->GPU = std::make_unique<Buffers>();
  }
  Buffers& gpu = *this->GPU;
  if (gpu.MeshVersion != this->MeshVersion)
  {
    std::vector<float> vertices;
    std::vector<std::uint32_t> indices;
    vertices.reserve(3 * this->GetNumberOfVertices());
    indices.reserve(3 * this->GetNumberOfTriangles());
    gpu.Counts.clear();
    gpu.Offsets.clear();
    gpu.FirstVertices.clear();
    std::map<const vtkShadowMesh*, std::size_t> known; // casters share their mesh's place
    for (std::size_t i = 0; i < this->Casters.size(); ++i)
    {
      const vtkShadowMesh& mesh = *this->Casters[i].Mesh;
      const auto place = known.emplace(&mesh, i);
      const std::size_t same = place.first->second;
      gpu.Counts.push_back(static_cast<GLsizei>(mesh.Indices.size()));
      gpu.Offsets.push_back(
        place.second ? indices.size() * sizeof(std::uint32_t) : gpu.Offsets[same]);
      gpu.FirstVertices.push_back(
        place.second ? static_cast<GLint>(vertices.size() / 3) : gpu.FirstVertices[same]);
      if (!place.second)
      {
        continue;
      }
      vertices.insert(vertices.end(), mesh.Positions.begin(),
        mesh.Positions.begin() + 3 * mesh.GetNumberOfVertices());
      for (const std::uint32_t index : mesh.Indices)
      {
        indices.push_back(gpu.FirstVertices[i] + index);
      }
    }
    gpu.Vertices->Upload(vertices, vtkOpenGLBufferObject::ArrayBuffer);
    gpu.VertexArray->Bind();
    gpu.Indices->Upload(indices, vtkOpenGLBufferObject::ElementArrayBuffer);
    gpu.VertexArray->Release();
    gpu.Program = nullptr; // attributes are to be bound anew
    gpu.Bytes = vertices.size() * sizeof(float) + indices.size() * sizeof(std::uint32_t);
    gpu.MeshVersion = this->MeshVersion;
  }
}

//------------------------------------------------------------------------------
vtkShaderProgram* vtkShadowCasters::Bind(
  vtkOpenGLRenderWindow* window, vtkOpenGLBufferObject* indices, const vtkShadowCasterDraw& how)
{
  Buffers& gpu = *this->GPU;
  vtkShaderProgram* program = window->GetShaderCache()->ReadyShaderProgram(
    how.VertexShader ? how.VertexShader : vtkShadowCasterVS,
    how.FragmentShader ? how.FragmentShader : vtkShadowCasterFS,
    how.GeometryShader ? how.GeometryShader : "");
  if (!program)
  {
    return nullptr; // the shader cache has reported why
  }
  if (how.SetParameters)
  {
    how.SetParameters(program);
  }
  if (program != gpu.Program)
  {
    gpu.VertexArray->ShaderProgramChanged(); // it is bound to the attributes of one
  }
  gpu.VertexArray->Bind();
  if (program != gpu.Program)
  {
    gpu.VertexArray->AddAttributeArray(
      program, gpu.Vertices, "vertexMC", 0, 3 * sizeof(float), VTK_FLOAT, 3, false);
    gpu.Program = program;
  }
  indices->Bind();
  return program;
}

//------------------------------------------------------------------------------
void vtkShadowCasters::SetCaster(vtkShaderProgram* program, const glm::dmat4& WCToClip,
  const vtkShadowCaster& caster, const vtkShadowCasterDraw& how)
{
  const glm::mat4 matrix(WCToClip * caster.MeshToWC);
  program->SetUniformMatrix4x4("MCToClip", const_cast<float*>(glm::value_ptr(matrix)));
  if (how.SetCasterParameters)
  {
    how.SetCasterParameters(program, caster);
  }
}

//------------------------------------------------------------------------------
void vtkShadowCasters::Draw(vtkOpenGLRenderWindow* window, const glm::dmat4& WCToClip,
  const std::vector<int>& casters, const vtkShadowCasterDraw& how)
{
  this->Upload();
  Buffers& gpu = *this->GPU;
  vtkShaderProgram* program = this->Bind(window, gpu.Indices, how);
  if (!program)
  {
    return;
  }
  for (const int i : casters)
  {
    this->SetCaster(program, WCToClip, this->Casters[i], how);
    glDrawElements(
      GL_TRIANGLES, gpu.Counts[i], GL_UNSIGNED_INT, reinterpret_cast<const void*>(gpu.Offsets[i]));
  }
  gpu.VertexArray->Release();
}

//------------------------------------------------------------------------------
void vtkShadowCasters::DrawParts(vtkOpenGLRenderWindow* window, const glm::dmat4& WCToClip,
  unsigned int primitive, vtkOpenGLBufferObject* indices,
  const std::vector<vtkShadowCasterPart>& parts, const vtkShadowCasterDraw& how)
{
  this->Upload();
  Buffers& gpu = *this->GPU;
  vtkShaderProgram* program = parts.empty() ? nullptr : this->Bind(window, indices, how);
  if (!program)
  {
    return;
  }
  for (const auto& part : parts)
  {
    this->SetCaster(program, WCToClip, this->Casters[part.Caster], how);
    glDrawElementsBaseVertex(primitive, static_cast<GLsizei>(part.Count), GL_UNSIGNED_INT,
      reinterpret_cast<const void*>(part.First * sizeof(std::uint32_t)),
      gpu.FirstVertices[part.Caster]);
  }
  gpu.VertexArray->Release();
}

//------------------------------------------------------------------------------
std::size_t vtkShadowCasters::GetGPUBytes() const
{
  return this->GPU ? this->GPU->Bytes : 0;
}

//------------------------------------------------------------------------------
void vtkShadowCasters::ReleaseGraphicsResources(vtkOpenGLRenderWindow* window)
{
  if (this->GPU)
  {
    this->GPU->VertexArray->ReleaseGraphicsResources();
    this->GPU->Vertices->ReleaseGraphicsResources();
    this->GPU->Indices->ReleaseGraphicsResources();
    this->GPU.reset();
  }
}
