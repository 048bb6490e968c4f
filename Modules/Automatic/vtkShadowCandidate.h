// SPDX-License-Identifier: BSD-3-Clause
// A technique at some settings, and what it takes and gives on a frame.

#ifndef vtkShadowCandidate_h
#define vtkShadowCandidate_h

#include "vtkShadowErrorEstimate.h"
#include "vtkShadowSettings.h"
#include "vtkShadowTechnique.h"

#include <nlohmann/json.hpp>

#include <memory>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkVisibilityBuffer;
struct vtkShadowDeclaration;
struct vtkShadowFrame;

class vtkShadowCandidate
{
public:
  /** Of a declared technique at quality low (0) to reference (3), or preview (-1). */
  vtkShadowCandidate(const vtkShadowDeclaration& declaration, int level);

  /**
   * Draw the visibility of a frame's parts, several times, and time it. False, and Note tells why, where it
   * cannot.
   */
  bool Draw(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer);
  /** Free what it holds. */
  void Release(vtkOpenGLRenderWindow* window);

  const vtkShadowDeclaration& GetDeclaration() const { return *this->Settings.GetDeclaration(); }
  vtkShadowTechnique& GetTechnique() { return *this->Technique; }
  bool IsSame(const vtkShadowCandidate& other) const;
  nlohmann::ordered_json GetJSON() const;

  ///@{ Milliseconds of a frame: of a camera that moves; of lights or casters that do; that adds to others.
  double Static = 0.0;
  double Dynamic = 0.0;
  double Adding = 0.0;
  ///@}
  vtkShadowErrorEstimate::RMSE Error;
  std::string Note; // why it could not be tried

private:
  vtkShadowSettings Settings;
  std::unique_ptr<vtkShadowTechnique> Technique;
};

#endif
