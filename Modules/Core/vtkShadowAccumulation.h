// SPDX-License-Identifier: BSD-3-Clause
// How far the frames of a scene that stands still add up (parameter accumulate).
//
// Frame k takes samples k n to (k + 1) n of one stratified sequence over each light, and the mean of what
// they see is shown (vtkVisibilityBuffer::Accumulate). What visibility depends on is noted in each frame: camera,
// size, lights, casters, what is drawn, settings; where any of it is another, the first frame is next.

#ifndef vtkShadowAccumulation_h
#define vtkShadowAccumulation_h

#include "vtkShadowLight.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkProp;
class vtkShadowTechnique;
struct vtkShadowFrame;

class vtkShadowAccumulation
{
public:
  /**
   * Before a frame's light data: whether it is one of several, and which; its lights are told. `time` is when
   * what the user set last changed.
   */
  void Begin(vtkShadowFrame& frame, const std::vector<vtkSmartPointer<vtkProp>>& props,
    vtkShadowTechnique& technique, vtkMTimeType time);
  /** The frame has been added. */
  void Count();
  /** Nothing is known of the last frame. */
  void Forget();
  /**
   * Once a frame's visibility is there: count what has added up ("accumulatedFrames", "accumulatedSamples"), and
   * forget all where no shadows are drawn.
   */
  void End(vtkShadowFrame& frame, bool active);

  /** This frame is one of several. */
  bool IsOn() const { return this->On; }
  /** Frames before this one that show the same. */
  int GetBefore() const { return this->Frames; }
  /** All samples have been taken: there is nothing to be done. */
  bool IsFinished() const { return this->Frames >= this->Wanted; }

private:
  /** What visibility depends on. */
  struct Scenery
  {
    std::vector<double> Numbers;
    std::vector<vtkShadowLightPart> Parts;
    std::vector<const void*> Objects;
    std::vector<vtkMTimeType> Times;

    bool operator==(const Scenery& other) const;
  };
  static Scenery Describe(const vtkShadowFrame& frame,
    const std::vector<vtkSmartPointer<vtkProp>>& props, vtkMTimeType time);

  Scenery Known;
  bool On = false;
  int Frames = 0;
  int Samples = 0; // a frame
  int Wanted = 0;  // frames
};

#endif
