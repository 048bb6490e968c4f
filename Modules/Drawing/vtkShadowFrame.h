// SPDX-License-Identifier: BSD-3-Clause
// What a technique sees of the frame that is being drawn.

#ifndef vtkShadowFrame_h
#define vtkShadowFrame_h

#include "vtkShadowLight.h"              // For lights
#include "vtkShadowView.h"               // For the camera
#include "vtkSoftShadowsDrawingModule.h" // For export macro

#include <map>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkShaderProgram;
class vtkShadowCasterDrawing;
class vtkShadowCasters;
class vtkShadowMessages;
class vtkShadowQuad;
class vtkShadowReceivers;
class vtkShadowTimers;

struct VTKSOFTSHADOWSDRAWING_EXPORT vtkShadowFrame : vtkShadowView
{
  vtkRenderer* Renderer = nullptr;
  vtkOpenGLRenderWindow* Window = nullptr;
  const vtkShadowCasters* Casters = nullptr;
  vtkShadowCasterDrawing* Drawing = nullptr; // of these
  vtkShadowTimers* Timers = nullptr;
  vtkShadowQuad* Quad = nullptr;
  vtkShadowMessages* Messages = nullptr;
  /** Those of the picture's opaque surfaces, for techniques that declare to need them; else nullptr. */
  vtkShadowReceivers* Receivers = nullptr;
  ///@{ What the window draws with: samples a pixel, and whether a processor makes the pixels.
  int SamplesPerPixel = 1;
  bool IsSoftware = false;
  ///@}
  /** So many parts of lights cast at most: as many as uniforms are sure to hold. */
  static constexpr int MostParts = 16;
  /** The casting lights that this technique can treat. */
  std::vector<vtkShadowLight> Lights;
  /** Their parts, one after another: what light data is made for, and `light` in GLSL. */
  std::vector<vtkShadowLightPart> Parts;
  /** Any of the lights is textured: visibility is then a colour. */
  bool Color = false;
  /** All lights count as their centres: the technique is hard, or they have no size. */
  bool Hard = false;
  /**
   * Side of a texture, in texels: as it is asked for, but `smallest` at least. 0 asks for about a texel a
   * pixel where what it holds fills the picture, or for `detail` where that is more, from `least` on: a
   * power of two, so that a window can be resized without new textures. More than the GPU allows gives a
   * warning, and what it allows.
   */
  int ChooseResolution(int asked, int smallest, int least, double detail = 0.0) const;
  /** GLSL that declares the lights (vtkShadowLightsFS.glsl), with `#define`s; and the uniforms of it. */
  std::string GetLightsGLSL(const std::string& definitions = "") const;
  void SetLights(vtkShaderProgram* program) const;
  /**
   * Lights that casters see under more than 28 degrees. What is known from a light's centre stands for
   * less and less of it, the larger it is: such techniques count them as "lightsTooLarge", which users
   * are told of (vtkShadowAdvice).
   */
  double CountLargeLights() const;
  /** Counts for GetStatistics(), by name; a technique adds its own. */
  std::map<std::string, double> Counts;
};

#endif
