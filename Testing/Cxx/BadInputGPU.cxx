// SPDX-License-Identifier: BSD-3-Clause
// What the GPU cannot do: one clear message, and a frame. The tests play a smaller GPU than there is.

#include "ShadowStage.h"
#include "ShadowTest.h"

#include "vtkShadowOpenGL.h"

#include <algorithm>
#include <dlfcn.h>

using ShadowTest::Message;

namespace
{
int LargestTexture = 0; // 0: what the GPU says
int MostLayers = 0;

PFNGLTEXIMAGE3DPROC TexImage3D = nullptr;
PFNGLTEXSTORAGE3DPROC TexStorage3D = nullptr;

/** No memory for any array texture: GL is asked for one that cannot be. */
void GLAPIENTRY FailTexImage3D(GLenum target, GLint level, GLint internal, GLsizei, GLsizei height,
  GLsizei depth, GLint border, GLenum format, GLenum type, const void* pixels)
{
  TexImage3D(target, level, internal, -1, height, depth, border, format, type, pixels);
}

void GLAPIENTRY FailTexStorage3D(
  GLenum target, GLsizei levels, GLenum internal, GLsizei, GLsizei height, GLsizei depth)
{
  TexStorage3D(target, levels, internal, -1, height, depth);
}

void Build(ShadowStage& stage, const std::string& technique)
{
  stage.AddThings();
  stage.AddLight(
    ShadowStage::Supports(technique, LightKind::Sphere) ? LightKind::Sphere : LightKind::Point);
}

void Limit(GLenum name, GLint* value)
{
  if (name == GL_MAX_TEXTURE_SIZE && LargestTexture > 0)
  {
    *value = LargestTexture;
  }
  if (name == GL_MAX_ARRAY_TEXTURE_LAYERS && MostLayers > 0)
  {
    *value = MostLayers;
  }
}

#ifdef glGetIntegerv
// With glad it is a pointer like the rest, which each new window sets to OpenGL's again.
PFNGLGETINTEGERVPROC GetIntegerv = nullptr;

void GLAPIENTRY LimitGetIntegerv(GLenum name, GLint* value)
{
  GetIntegerv(name, value);
  Limit(name, value);
}

void UseLimit()
{
  if (glGetIntegerv != LimitGetIntegerv)
  {
    GetIntegerv = glGetIntegerv;
    glGetIntegerv = LimitGetIntegerv;
  }
}
#else
void UseLimit() {}
#endif
}

#ifndef glGetIntegerv
/** In the place of OpenGL's, for all libraries of this program. */
extern "C" __attribute__((visibility("default"))) void glGetIntegerv(GLenum name, GLint* value)
{
  using Function = void (*)(GLenum, GLint*);
  static const auto original = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "glGetIntegerv"));
  original(name, value);
  Limit(name, value);
}
#endif

//------------------------------------------------------------------------------
// A map larger than the GPU allows: one warning, in however many frames, that tells both sizes; the
// frame is that of the largest map.
SHADOW_TEST(BadInput, ResolutionTooLarge, Each)
{
  if (!ShadowStage::HasParameter(technique, "resolution"))
  {
    return;
  }
  const Visibility expected = RenderVisibility(
    technique, { { "resolution", "300" } }, [&](ShadowStage& stage) { Build(stage, technique); });
  LargestTexture = 300;
  ShadowStage stage;
  UseLimit();
  Build(stage, technique);
  stage.SetPass(technique, { { "resolution", "4000" } });
  stage.Render();
  stage.Render();
  ShadowTest::CheckOneMessage(Message::Warning, { technique, "4000", "300" }, "a map too large");
  ShadowTest::Check(Same(stage.GetVisibility(), expected), "not V of the largest map");
  ShadowTest::CheckEqual(GetRange(expected).first, 0.0, "there is a shadow");
  LargestTexture = 0;
}

//------------------------------------------------------------------------------
// No memory: one error, in however many frames, and the picture of no pass. With memory again, and a
// parameter set or not, the shadow is there.
SHADOW_TEST(BadInput, NoMemory, Each)
{
  ShadowStage stage;
  Build(stage, technique);
  stage.Render();
  const Picture plain = stage.GetPicture();
  TexImage3D = glTexImage3D;
  glTexImage3D = FailTexImage3D;
  TexStorage3D = glTexStorage3D;
  glTexStorage3D = FailTexStorage3D;
  stage.SetPass(technique, { { "evaluation", "screen" } });
  stage.Render();
  const Picture picture = stage.GetPicture();
  stage.Render();
  auto messages = ShadowTest::TakeMessages();
  // GL's own word is this test's doing.
  const auto last = std::remove_if(messages.begin(), messages.end(),
    [](const Message& message) { return message.Source == Message::GL; });
  ShadowTest::Check(last != messages.end(), "the technique makes no array texture");
  ShadowTest::CheckEqual(
    static_cast<double>(last - messages.begin()), 1.0, "messages of two frames");
  ShadowTest::Check(last != messages.begin() && messages[0].Source == Message::Error &&
                      messages[0].Text.find(technique) != std::string::npos &&
                      messages[0].Text.find("memory") != std::string::npos,
    "not an error that tells of the memory");
  ShadowTest::Check(Same(picture, plain), "not the picture of no pass");

  stage.Pass->GetVisibility(0); // whatever it gives
  ShadowTest::TakeMessages();
  glTexImage3D = TexImage3D;
  glTexStorage3D = TexStorage3D;
  stage.Render();
  ShadowTest::CheckNoMessage("with memory again");
  ShadowTest::CheckEqual(GetRange(stage.GetVisibility()).first, 0.0, "lowest V with memory again");
}

//------------------------------------------------------------------------------
// Casters far apart on a plane have layers of their own; where these are too many, one for all, which is
// kept as they would be.
SHADOW_TEST(BadInput, TooManyLayers, Once)
{
  const std::string soft = "planar-soft";
  if (!vtkShadowTechniqueRegistration::Find(soft))
  {
    return;
  }
  ShadowStage stage;
  stage.AddFloor(10.0);
  stage.AddBox({ -6.0, 0.0, 0.4 }, { 0.5, 0.5, 0.8 });
  stage.AddBox({ 6.0, 0.0, 0.4 }, { 0.5, 0.5, 0.8 });
  stage.AddLight(LightKind::Point, { 0.0, -4.0, 12.0 }, { 0.0, 0.0, 0.0 });
  stage.SetPass(soft);
  stage.Render();
  ShadowTest::CheckAtLeast(stage.Count("planarMapsDrawn"), 2.0, "layers of groups");
  MostLayers = 1;
  UseLimit();
  stage.SetPass(soft);
  stage.Render();
  ShadowTest::CheckEqual(stage.Count("planarMapsDrawn"), 1.0, "layers where one can be");
  ShadowTest::CheckEqual(GetRange(stage.GetVisibility()).first, 0.0, "there is a shadow");
  stage.Render();
  ShadowTest::CheckEqual(stage.Count("planarMapsDrawn"), 0.0, "layers drawn again");
  MostLayers = 0;
}
