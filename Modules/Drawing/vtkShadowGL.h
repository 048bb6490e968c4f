// SPDX-License-Identifier: BSD-3-Clause
// What the passes need of OpenGL beyond VTK 9.1's classes: array and buffer textures, samplers,
// layered framebuffers, quads, and timers. All keep VTK's state cache right.

#ifndef vtkShadowGL_h
#define vtkShadowGL_h

#include "vtkSoftShadowsDrawingModule.h" // For export macro

#include <glm/vec4.hpp>

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/** A 2D array texture, or a buffer texture of four floats a texel. */
class VTKSOFTSHADOWSDRAWING_EXPORT vtkShadowTexture
{
public:
  enum class Format
  {
    Depth,        // 32-bit float
    Depth24,      // and 8 bits of stencil, as windows have it
    DepthStencil, // 32-bit float, and 8 bits of stencil
    Float1,       // 32-bit float each
    Float2,
    Float4,
    Byte1, // 8 bits each for 0 to 1
    Byte4,
    Half1, // 16-bit float each
    Half4,
    Integer1, // 32-bit unsigned each, for usampler2DArray
    Integer4
  };
  enum class Sampling
  {
    Nearest,
    Linear,         // of the four nearest; of several levels, of the two nearest levels
    CompareNearest, // depth <= stored depth, for sampler2DArrayShadow
    CompareLinear
  };

  vtkShadowTexture() = default;
  vtkShadowTexture(const vtkShadowTexture&) = delete;
  void operator=(const vtkShadowTexture&) = delete;

  /**
   * Make it this size, if it is not; the content is then undefined. Each of further levels is half
   * as wide and high as the one before. False when out of memory.
   */
  bool Allocate(vtkOpenGLRenderWindow* window, Format format, int width, int height, int layers,
    int levels = 1);
  void SetSampling(vtkOpenGLRenderWindow* window, Sampling sampling);
  void UploadBuffer(vtkOpenGLRenderWindow* window, const std::vector<glm::vec4>& texels);
  /** Replace one layer by width x height x components floats, bottom row first. */
  void UploadLayer(vtkOpenGLRenderWindow* window, int layer, const float* values);
  /** Make the further levels of all layers from the first one. */
  void MakeLevels(vtkOpenGLRenderWindow* window);

  /** Bind to a texture unit of VTK's, until Deactivate. Both may be called twice. */
  void Activate(vtkOpenGLRenderWindow* window);
  void Deactivate(vtkOpenGLRenderWindow* window);
  int GetUnit() const { return this->Unit; }

  void Release(vtkOpenGLRenderWindow* window);

  unsigned int GetHandle() const { return this->Handle; }
  /** Rises whenever the content is lost; the handle may come again. */
  unsigned long GetGeneration() const { return this->Generation; }
  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  int GetLayers() const { return this->Layers; }
  int GetLevels() const { return this->Levels; }
  Format GetFormat() const { return this->TexelFormat; }
  bool HasStencil() const
  {
    return this->TexelFormat == Format::Depth24 || this->TexelFormat == Format::DepthStencil;
  }
  std::size_t GetBytes() const { return this->Bytes; }

private:
  unsigned int Target = 0;
  unsigned int Handle = 0;
  unsigned long Generation = 0;
  unsigned int Buffer = 0;
  Format TexelFormat = Format::Depth;
  int Width = 0;
  int Height = 0;
  int Layers = 0;
  int Levels = 0;
  int Unit = -1;
  std::size_t Bytes = 0;
};

/**
 * A second look at a texture that is sampled in another way: a texture unit and a sampler object.
 */
class VTKSOFTSHADOWSDRAWING_EXPORT vtkShadowSampler
{
public:
  vtkShadowSampler() = default;
  vtkShadowSampler(const vtkShadowSampler&) = delete;
  void operator=(const vtkShadowSampler&) = delete;

  /** Bind, until Deactivate. Both may be called twice. */
  void Activate(vtkOpenGLRenderWindow* window, const vtkShadowTexture& texture,
    vtkShadowTexture::Sampling sampling);
  void Deactivate(vtkOpenGLRenderWindow* window);
  int GetUnit() const { return this->Unit; }
  void Release(vtkOpenGLRenderWindow* window);

private:
  unsigned int Handle = 0;
  int Unit = -1;
};

/** Draws fragment shaders over the viewport that is set. */
class VTKSOFTSHADOWSDRAWING_EXPORT vtkShadowQuad
{
public:
  vtkShadowQuad() = default;
  vtkShadowQuad(const vtkShadowQuad&) = delete;
  void operator=(const vtkShadowQuad&) = delete;

  void Draw(vtkOpenGLRenderWindow* window, const std::string& fragmentShader,
    const std::function<void(vtkShaderProgram*)>& setParameters);
  void Release();

private:
  unsigned int VertexArray = 0;
};

/**
 * Draws into layers of textures: while one of these lives, its framebuffer is bound, the viewport
 * is the whole layer, the scissor test and blending are off; afterwards all is as before.
 */
class VTKSOFTSHADOWSDRAWING_EXPORT vtkShadowFramebuffer
{
public:
  vtkShadowFramebuffer() = default;
  vtkShadowFramebuffer(const vtkShadowFramebuffer&) = delete;
  void operator=(const vtkShadowFramebuffer&) = delete;

  class VTKSOFTSHADOWSDRAWING_EXPORT Scope
  {
  public:
    Scope(vtkOpenGLRenderWindow* window, vtkShadowFramebuffer& framebuffer,
      const vtkShadowTexture* color, const vtkShadowTexture* depth, int layer);
    /** Into several colour targets of one size: gl_FragData[0] and on. */
    Scope(vtkOpenGLRenderWindow* window, vtkShadowFramebuffer& framebuffer,
      std::vector<const vtkShadowTexture*> colors, const vtkShadowTexture* depth, int layer);
    ~Scope();
    Scope(const Scope&) = delete;
    void operator=(const Scope&) = delete;

    /** Go on with another layer, or level, of the same textures. */
    void SetLayer(int layer, int level = 0);
    /** Draw into a rectangle of the layer alone, such as a tile of an atlas, until the next SetLayer. */
    void SetRectangle(int x, int y, int width, int height);

  private:
    vtkOpenGLRenderWindow* Window;
    std::vector<const vtkShadowTexture*> Colors;
    const vtkShadowTexture* Depth;
    int Viewport[4];
    int Scissor[4];
    bool ScissorTest;
    bool Blend;
  };

  /**
   * Read a layer of a colour texture of floats, row by row from the bottom, as many values a texel as it
   * has channels.
   */
  void Read(
    vtkOpenGLRenderWindow* window, const vtkShadowTexture& texture, int layer, float* values);

  void Release(vtkOpenGLRenderWindow* window);

private:
  unsigned int Handle = 0;
  unsigned int Attached = 0; // colour targets
};

/** GPU time by stage, from timestamps; a frame's times are read when they are asked for. */
class VTKSOFTSHADOWSDRAWING_EXPORT vtkShadowTimers
{
public:
  vtkShadowTimers() = default;
  vtkShadowTimers(const vtkShadowTimers&) = delete;
  void operator=(const vtkShadowTimers&) = delete;

  /** Forget the last frame. */
  void StartFrame();
  /** Some of the last frame's times are still to be read, for which the window must be current. */
  bool ArePending() const { return !this->Spans.empty() && this->Milliseconds.empty(); }
  /** Milliseconds by stage of the last frame; waits for the GPU. */
  const std::map<std::string, double>& GetMilliseconds();
  void Release();

  class VTKSOFTSHADOWSDRAWING_EXPORT Scope
  {
  public:
    Scope(vtkShadowTimers& timers, const char* stage);
    ~Scope();
    Scope(const Scope&) = delete;
    void operator=(const Scope&) = delete;

  private:
    vtkShadowTimers& Timers;
    std::size_t Index;
  };

private:
  struct Span
  {
    std::string Stage;
    unsigned int Queries[2];
  };
  std::vector<Span> Spans;
  std::vector<unsigned int> Free;
  std::map<std::string, double> Milliseconds;
};

#endif
