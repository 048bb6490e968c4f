// SPDX-License-Identifier: BSD-3-Clause
// The stages of a frame up to visibility, and what they keep: lights, casters, the camera, the technique's
// light data, the screen's buffers. See vtkShadowPass, which draws the receivers and the picture.

#ifndef vtkShadowStages_h
#define vtkShadowStages_h

#include "vtkShadowCasterDrawing.h"
#include "vtkShadowCasters.h"
#include "vtkShadowFrame.h"
#include "vtkShadowGL.h"
#include "vtkShadowScreen.h"

#include <functional>
#include <string>
#include <vector>

class vtkLight;
class vtkShadowSettings;
class vtkShadowTechnique;

class vtkShadowStages
{
public:
  vtkShadowStages();

  /** Of the renderer's frame, before its stages. */
  void Start(vtkRenderer* renderer, vtkOpenGLRenderWindow* window, const int size[2],
    vtkShadowMessages* messages);
  /**
   * Gather lights, casters and the camera for a technique. False where there is no shadow to be drawn:
   * `messages` have said why, if it is not that nothing casts.
   */
  bool Gather(const vtkShadowSettings& settings, double defaultRadius, double defaultAngle);
  /** Bring the technique's light data up to date. False after an error. */
  bool UpdateLightData(vtkShadowTechnique& technique);
  /**
   * Choose where visibility is evaluated: once light data is there; and before it, without a technique,
   * where it is made from receivers, which is in screen space.
   */
  void ChooseEvaluation(vtkShadowTechnique* technique, const vtkShadowSettings& settings);
  /** Make room for the receivers of a screen, and for their visibility. False after an error. */
  bool Allocate(vtkShadowScreen& screen);
  /** Fill a screen's visibility, or a quantity. False after an error. */
  bool Evaluate(vtkShadowTechnique& technique, vtkShadowScreen& screen);
  /** Add a screen's visibility to the mean of so many frames before. False after an error. */
  bool Accumulate(vtkShadowScreen& screen, int before);
  /**
   * Call something of the technique's. Where an exception leaves it: false, after an error, and the technique
   * has no light data.
   */
  bool Guard(vtkShadowTechnique& technique, const std::function<bool()>& call);

  bool IsInScreenSpace() const { return this->ScreenSpace; }
  vtkShadowFrame& GetFrame() { return this->Frame; }
  const vtkShadowCasters& GetCasters() const { return this->Casters; }
  vtkShadowTimers& GetTimers() { return this->Timers; }
  /** How each light was treated. */
  const std::vector<std::string>& GetLightNotes() const { return this->LightNotes; }
  /** The lights that cast in the frame, then the renderer's others. The former may be gone since. */
  std::vector<vtkLight*> GetLights() const;

  std::size_t GetCasterBytes() const { return this->Drawing.GetBytes(); }
  std::size_t GetBufferBytes() const
  {
    return this->Opaque.GetBytes() + this->Translucent.GetBytes();
  }
  void Release(vtkOpenGLRenderWindow* window);
  ///@{
  /**
   * Where the technique is another one: before its first frame, forget what served the old one alone. Finish
   * counts what was drawn in a frame, and after such a one frees the casters' buffers if nothing was.
   */
  void ReleaseOfTechnique();
  void Finish();
  ///@}

  vtkShadowScreen Opaque;
  vtkShadowScreen Translucent;

private:
  bool GatherLights(const vtkShadowSettings& settings, double defaultRadius, double defaultAngle);
  bool GatherCasters(const vtkShadowSettings& settings);
  bool SetCamera();

  vtkShadowFrame Frame;
  vtkShadowCasters Casters;
  vtkShadowCasterDrawing Drawing;
  vtkShadowTimers Timers;
  vtkShadowQuad Quad;
  std::vector<std::string> LightNotes;
  bool ScreenSpace = false;
  bool NewTechnique = false;
};

#endif
