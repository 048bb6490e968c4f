#include "vtkShadowCasters.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasterFS.h"
#include "vtkShadowCasterVS.h"
#include "vtkShadowHolesFS.h"
#include "vtkShadowHolesVS.h"
#include "vtkShadowLight.h"
#include "vtkShadowMeshes.h"
#include "vtkShadowPass.h"
#include "vtkShadowSurfaces.h"
#include "vtkShadowVTKVersion.h"
#include "vtkTexture.h"
#include "vtkTextureObject.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

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

bool IsFinite(const glm::dmat4& matrix)
{
  const double* values = glm::value_ptr(matrix);
  return std::all_of(values, values + 16, [](double value) { return std::isfinite(value); });
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
  double Opacity;
  bool Receives;
};

/**
 * The opacities below 1 that occur, ascending. Where there are more than so many levels, opacities
 * are rounded to as many between 0 and 1, and what is rounded to 0 casts nothing.
 */
std::vector<double> FindOpacities(std::vector<Placed>& placed, int levels)
{
  std::set<double> found;
  for (const auto& item : placed)
  {
    found.insert(item.Opacity);
  }
  found.erase(1.0);
  if (static_cast<int>(found.size()) > levels)
  {
    found.clear();
    for (auto& item : placed)
    {
      item.Opacity = std::round(item.Opacity * (levels + 1)) / (levels + 1);
      found.insert(item.Opacity);
    }
    placed.erase(std::remove_if(placed.begin(), placed.end(),
                   [](const Placed& item) { return item.Opacity == 0.0; }),
      placed.end());
    found.erase(0.0);
    found.erase(1.0);
  }
  return { found.begin(), found.end() };
}
}

/** What lies on the GPU. */
class vtkShadowCasters::Buffers
{
public:
  unsigned long MeshVersion = 0;
  vtkNew<vtkOpenGLBufferObject> Vertices;
  vtkNew<vtkOpenGLBufferObject> Indices;
  vtkNew<vtkOpenGLBufferObject> Places; // of holes
  vtkNew<vtkOpenGLVertexArrayObject> VertexArray;
  /** Of casters with holes; that of nullptr is 1 everywhere. */
  std::map<std::shared_ptr<const vtkShadowAlphaMap>, vtkSmartPointer<vtkTextureObject>> Maps;
  vtkShaderProgram* Program = nullptr; // owned by the window's shader cache
  std::vector<GLsizei> Counts;         // indices of each caster
  std::vector<std::size_t> Offsets;    // first index of each caster, in bytes
  std::vector<GLint> FirstVertices;    // of each caster
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
bool vtkShadowCaster::IsSeenBy(const vtkShadowLight& light) const
{
  return this->Opacity >= light.LeastOpacity;
}

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
vtkShadowCasters::vtkShadowCasters()
  : Meshes(new vtkShadowMeshes)
{
}

//------------------------------------------------------------------------------
vtkShadowCasters::~vtkShadowCasters() = default;

//------------------------------------------------------------------------------
bool vtkShadowCasters::Update(
  vtkRenderer* renderer, vtkTranslucentCasters translucent, int levels, double alphaThreshold)
{
  this->UnknownAlphas = 0;
  vtkShadowMeshes known; // of this time; what is in it no more is forgotten
  std::vector<Placed> placed;
  std::vector<std::array<glm::dvec3, 8>> receivers; // in the world
  std::size_t dropped = 0;
  std::size_t notFinite = 0;
  const auto add = [&](vtkProp* root, vtkProp* prop, vtkMatrix4x4* matrix)
  {
    const glm::dmat4 modelToWorld = glm::transpose(glm::make_mat4(matrix->GetData()));
    bool surfaces = false; // of the prop, that may cast
    const bool receives = vtkShadowPass::GetReceiving(root);
    const auto addSurface = [&](const vtkShadowSurface& surface)
    {
      this->UnknownAlphas += surface.AlphaUnknown ? 1 : 0;
      const bool weighted = surface.Translucent && translucent == vtkTranslucentCasters::Weighted;
      const double opacity = weighted ? std::min(surface.Opacity, 1.0) : 1.0;
      if ((surface.Translucent && translucent == vtkTranslucentCasters::Off) || !(opacity > 0.0))
      {
        return;
      }
      const auto mesh = known.Find(surface, alphaThreshold, *this->Meshes);
      // What casts nothing has no place: it must not move the origin, nor widen a map.
      surfaces = surfaces || !mesh->Indices.empty() || mesh->Dropped > 0;
      dropped += mesh->Dropped;
      notFinite +=
        IsFinite(modelToWorld) ? mesh->NotFinite : mesh->NotFinite + mesh->GetNumberOfTriangles();
      if (!mesh->Indices.empty() && IsFinite(modelToWorld))
      {
        placed.push_back(
          { mesh, prop, glm::translate(modelToWorld, mesh->Centre), opacity, receives });
      }
    };
    if (vtkShadowPass::GetCasting(root) && !vtkShadowPass::GetShadowCatcher(root))
    {
      vtkForEachShadowSurface(prop, matrix, addSurface);
    }
    auto* actor = vtkActor::SafeDownCast(prop);
    if (surfaces || !actor || !actor->GetMapper() || !receives)
    {
      return;
    }
    const double* b = actor->GetMapper()->GetBounds();
    if (b && b[0] <= b[1] &&
        std::all_of(b, b + 6, [](double bound) { return std::isfinite(bound); }) &&
        IsFinite(modelToWorld))
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
      vtkShadowPass::ForEachPart(
        prop, [&](vtkProp* part, vtkMatrix4x4* matrix) { add(prop, part, matrix); });
    }
  }
  *this->Meshes = std::move(known);
  this->Dropped = dropped;
  this->NotFinite = notFinite;
  this->Opacities = FindOpacities(placed, levels);

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
    vtkShadowCaster caster{ item.Mesh, item.Prop, worldToWC * item.MeshToWorld, item.Opacity,
      item.Receives, {} };
    changed = changed || meshesChanged ||
              caster.MeshToWC != this->Casters[casters.size()].MeshToWC ||
              caster.Opacity != this->Casters[casters.size()].Opacity;
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
std::size_t vtkShadowCasters::GetNumberOfClearTriangles() const
{
  return Sum(this->Casters, [](const vtkShadowMesh& m) { return m.Clear; });
}

//------------------------------------------------------------------------------
std::size_t vtkShadowCasters::GetNumberWithHoles() const
{
  return Sum(this->Casters, [](const vtkShadowMesh& m) { return m.Holes ? 1 : 0; });
}

//------------------------------------------------------------------------------
void vtkShadowCasters::Upload(vtkOpenGLRenderWindow* window)
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
    gpu.Counts.assign(this->Casters.size(), 0);
    gpu.Offsets.assign(this->Casters.size(), 0);
    gpu.FirstVertices.assign(this->Casters.size(), 0);
    std::vector<std::size_t> order(this->Casters.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_partition(order.begin(), order.end(),
      [this](std::size_t i) { return this->Casters[i].Mesh->Holes != nullptr; });
    std::map<const vtkShadowMesh*, std::size_t> known; // casters share their mesh's place
    for (const std::size_t i : order)
    {
      const vtkShadowMesh& mesh = *this->Casters[i].Mesh;
      const auto place = known.emplace(&mesh, i);
      const std::size_t same = place.first->second;
      gpu.Counts[i] = static_cast<GLsizei>(mesh.Indices.size());
      gpu.Offsets[i] = place.second ? indices.size() * sizeof(std::uint32_t) : gpu.Offsets[same];
      gpu.FirstVertices[i] =
        place.second ? static_cast<GLint>(vertices.size() / 3) : gpu.FirstVertices[same];
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
    gpu.UploadHoles(window, this->Casters, order);
    gpu.MeshVersion = this->MeshVersion;
  }
}

//------------------------------------------------------------------------------
vtkShaderProgram* vtkShadowCasters::Bind(vtkOpenGLRenderWindow* window,
  vtkOpenGLBufferObject* indices, const vtkShadowCasterDraw& how, bool holes)
{
  Buffers& gpu = *this->GPU;
  std::string vertexShader = how.VertexShader ? how.VertexShader : vtkShadowCasterVS;
  std::string fragmentShader = how.FragmentShader ? how.FragmentShader : vtkShadowCasterFS;
  if (holes)
  {
    const auto replace = [](std::string& shader, const char* declaration, const char* call)
    {
      vtkShaderProgram::Substitute(shader, "//VTK::ShadowHoles::Dec", declaration);
      vtkShaderProgram::Substitute(shader, "//VTK::ShadowHoles::Impl", call);
    };
    replace(vertexShader, vtkShadowHolesVS, "shadowPassPlace();");
    replace(fragmentShader, vtkShadowHolesFS, "shadowDiscardHole();");
  }
  vtkShaderProgram* program = window->GetShaderCache()->ReadyShaderProgram(
    vertexShader.c_str(), fragmentShader.c_str(), how.GeometryShader ? how.GeometryShader : "");
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
    if (holes)
    {
      gpu.VertexArray->AddAttributeArray(
        program, gpu.Places, "shadowPlace", 0, 3 * sizeof(float), VTK_FLOAT, 3, false);
    }
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
  this->Upload(window);
  Buffers& gpu = *this->GPU;
  for (const bool holes : { false, true })
  {
    vtkShaderProgram* program = nullptr;
    for (const int i : casters)
    {
      const vtkShadowHoles* ofCaster = this->Casters[i].Mesh->Holes.get();
      if ((ofCaster != nullptr) != holes)
      {
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
      this->SetCaster(program, WCToClip, this->Casters[i], how);
      vtkTextureObject* map = holes ? gpu.Maps[ofCaster->Map] : nullptr;
      if (map)
      {
        map->Activate();
        program->SetUniformi("shadowAlphaMap", map->GetTextureUnit());
        program->SetUniformf("shadowLeastAlpha", ofCaster->Threshold);
      }
      glDrawElements(GL_TRIANGLES, gpu.Counts[i], GL_UNSIGNED_INT,
        reinterpret_cast<const void*>(gpu.Offsets[i]));
      if (map)
      {
        map->Deactivate();
      }
    }
    gpu.VertexArray->Release();
  }
}

//------------------------------------------------------------------------------
void vtkShadowCasters::DrawParts(vtkOpenGLRenderWindow* window, const glm::dmat4& WCToClip,
  unsigned int primitive, vtkOpenGLBufferObject* indices,
  const std::vector<vtkShadowCasterPart>& parts, const vtkShadowCasterDraw& how)
{
  this->Upload(window);
  Buffers& gpu = *this->GPU;
  vtkShaderProgram* program = parts.empty() ? nullptr : this->Bind(window, indices, how, false);
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
    this->GPU->Places->ReleaseGraphicsResources();
    for (auto& entry : this->GPU->Maps)
    {
      entry.second->ReleaseGraphicsResources(window);
    }
    this->GPU.reset();
  }
}
