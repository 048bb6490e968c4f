// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowTechnique
 * @brief   How visibility is found: what a vtkShadowPass owns, and can change while a window runs.
 *
 * A technique knows the frame that is drawn (vtkShadowFrame) and its settings, and nothing of the pass.
 * It keeps its light data from frame to frame. Others can own it too, and ask several in one frame.
 * Its declaration (vtkShadowDeclaration) tells by traits in which order a frame calls it:
 *
 *   UpdateLightData    after the receivers are drawn, if it needs them
 *   GetVisibilityGLSL  to be run in each prop's shader (forward) or once a pixel (screen space), with
 *                      Activate, SetVisibilityParameters and Deactivate around it
 *   FillVisibility     in screen space (by Evaluate)
 *
 * All are called with the window's context current. An exception that leaves one is told as an error, and
 * the frame is drawn without shadows.
 */

#ifndef vtkShadowTechnique_h
#define vtkShadowTechnique_h

#include "vtkShadowDeclaration.h"        // For traits
#include "vtkShadowSettings.h"           // For settings
#include "vtkSoftShadowsDrawingModule.h" // For export macro

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkVisibilityBuffer;
struct vtkShadowFrame;

class VTKSOFTSHADOWSDRAWING_EXPORT vtkShadowTechnique
{
public:
  /** With settings that outlive it. */
  explicit vtkShadowTechnique(const vtkShadowSettings& settings);
  virtual ~vtkShadowTechnique();
  vtkShadowTechnique(const vtkShadowTechnique&) = delete;
  void operator=(const vtkShadowTechnique&) = delete;

  /** Why it does not run in a window; empty where it does. */
  virtual std::string FindUnsupported(vtkOpenGLRenderWindow*) { return ""; }

  /**
   * Bring the light data of frame.Parts up to date; count in frame.Counts. False where it cannot be had,
   * after an error that says why: the frame is then drawn without shadows.
   */
  virtual bool UpdateLightData(vtkShadowFrame& frame) = 0;

  /**
   * GLSL that defines `SHADOW_VISIBILITY shadowVisibility(int light, vec3 positionVC, vec3 normalVC)`
   * with what vtkShadowLightsFS.glsl declares, counting what it spends in shadowCost. Empty for a
   * technique that fills the buffer itself.
   */
  virtual std::string GetVisibilityGLSL() { return ""; }
  /** Of a technique whose GLSL can run in each prop's shader: whether this light data lets it. */
  virtual bool CanEvaluateForward() { return true; }
  /** Forward is better where this is true and the user has not said which. */
  virtual bool PrefersForward(const vtkShadowFrame&) { return true; }
  /** Bind the light data's textures, before drawing; and unbind them. */
  virtual void Activate(vtkShadowFrame&) {}
  virtual void Deactivate(vtkShadowFrame&) {}
  /** Set what the GLSL needs, on each program that has it. */
  virtual void SetVisibilityParameters(vtkShaderProgram*) {}

  /**
   * Fill the layer of each of frame.Parts in the buffer's target: the visibility, or the quantity that a
   * debug view wants. By default from the GLSL. Where it declares signed shares, the layers are cleared to
   * full visibility (a quantity to 0), and it adds to them.
   */
  virtual void FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer);

  /**
   * Fill the buffer, signed shares resolved, with the light data bound: for whoever owns the technique.
   */
  void Evaluate(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer);

  /** What it needs of this frame; by default what it declares. */
  virtual vtkShadowTraits GetTraits();
  ///@{
  /**
   * How many samples of each light a frame takes, where it samples them (vtkShadowTraits::SamplesLights);
   * else 0. By default the parameter "samples". And to how many frames are to add up, 0 where they are not:
   * by the parameters accumulate and accumulate-samples.
   */
  virtual int GetSamples();
  virtual int GetWantedSamples();
  ///@}
  /** Where samples are wanted, before each frame: whether it shows just what the last one did. */
  virtual void BeginFrame(bool /*still*/) {}
  /** What GetStatistics tells of it beside numbers: JSON, or "". */
  virtual std::string GetReport() { return ""; }

  /** What "cost" shows as white: the most samples that a pixel can take. */
  virtual double GetMaximumCost() { return 1.0; }
  /**
   * The variable of the GLSL that a debug view shows as grey, its largest value white; empty for a
   * view that shows something else. The white is told by GetStatistics(): "debugViewWhite".
   */
  virtual std::string GetDebugQuantity(const std::string& view);
  /** A debug view of another kind, drawn over the viewport that is set. */
  virtual void DrawDebugView(vtkShadowFrame&, const std::string&) {}

  /** Bytes of the light data, by name. */
  virtual std::vector<std::pair<std::string, std::size_t>> GetBytes() { return {}; }
  /** Free the light data; the settings may be another technique's then. */
  virtual void Release(vtkOpenGLRenderWindow* window) = 0;

protected:
  /**
   * Draw the GLSL's visibility of a part of a light into the framebuffer that is bound. With a share,
   * what is drawn is the (negative) change of visibility, to be added up: the share of all of the light
   * data that is bound now.
   */
  void DrawEvaluation(
    vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int part, double share = 0.0);

  const vtkShadowSettings& Settings;
};

#endif
