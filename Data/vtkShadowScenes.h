// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowScenes
 * @brief   Built-in scenes by name, and a ground, a light and a camera for scenes of one's own.
 *
 * Build() fills a renderer with actors, one vtkAreaLight, a camera and a background; no window is
 * needed. All built-in scenes have z up and, where they have a floor, the floor at z = 0. They are
 * deterministic: the same name gives the same triangles on every run.
 *
 * The scenes `bunny` and `huge` use bunny.ply, which Data/fetch-models brings. It is looked for in
 * the directory that the environment variable SOFTSHADOWS_DATA names, then in share/softshadows/models
 * of the installation or build that the library lies in. If it is nowhere, a procedural model stands
 * in and GetModelNote() says so.
 */

#ifndef vtkShadowScenes_h
#define vtkShadowScenes_h

#include "vtkObject.h"
#include "vtkSoftShadowsScenesModule.h" // For export macro

#include <string> // For return values

class vtkAreaLight;
class vtkInformationIntegerKey;
class vtkRenderer;

class VTKSOFTSHADOWSSCENES_EXPORT vtkShadowScenes : public vtkObject
{
public:
  static vtkShadowScenes* New();
  vtkTypeMacro(vtkShadowScenes, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The names of the scenes, by index from 0. An index out of range gives nullptr.
   */
  static int GetNumberOfScenes();
  static const char* GetName(int i);
  ///@}

  /**
   * What a scene is, as JSON text: name, title, triangles (all of the scene's triangles at its
   * defaults, or null where that depends on VTK's version) and parameters, each with name, default,
   * min and max. An unknown name gives an error and an empty string.
   */
  static std::string Describe(const std::string& name);

  /**
   * Add a scene's actors and its one vtkAreaLight (scene light, positional, no cone) to the
   * renderer, set its active camera and background, and switch off its automatic light. Nothing that
   * the renderer holds is removed.
   *
   * `triangles` is how many triangles the scene shall have, within 1 %; 0 takes the scene's default.
   * Only `plant` can be told (10,000 to 2,000,000, default 100,000): a number that cannot be used
   * gives an error, and the scene is built at its default.
   *
   * Returns false, with an error, for an unknown name or no renderer.
   */
  static bool Build(const std::string& name, vtkRenderer* renderer, int triangles = 0);

  /**
   * Why a stand-in was used for a model in the last Build(), or an empty string.
   */
  static std::string GetModelNote();

  /**
   * Add a ground under the renderer's visible props: a square of two triangles, centred below them
   * at their lowest point, its side 6 times their largest horizontal extent. upAxis is 0, 1 or 2 for
   * x, y or z up (default: 2). Returns false, with an error, if there is nothing visible.
   */
  static bool AddGround(vtkRenderer* renderer, int upAxis = 2);

  /**
   * Add a spherical light above and to the side of the visible props: twice the diagonal of their
   * bounds away from their centre, radius 0.12 times their height. A ground does not count. Returns the light, or nullptr, with an error, if there is nothing visible.
   */
  static vtkAreaLight* AddLight(vtkRenderer* renderer, int upAxis = 2);

  /**
   * Point the active camera at the visible props in a three-quarter view from above, the props
   * filling most of the picture. A ground does not count, except for the clipping range.
   */
  static void ResetCamera(vtkRenderer* renderer, int upAxis = 2);
  /** The same, so that the props' shadow on their ground fits in too, in the light of a vtkShadowStudio. */
  static void ResetCameraWithShadow(vtkRenderer* renderer, int upAxis = 2);

  /**
   * Visible fraction, 0 to 1, of the scene `blocker`'s light from the floor point (x, y, 0), in
   * closed form.
   */
  static double BlockerVisibility(double x, double y);

  /**
   * Visible fraction, 0 to 1, of a rectangular light from the floor point (x, y, 0), in closed form.
   * The light, 2 lightHalfWidth (along x) by 2 lightHalfHeight (along y), and the square blocker of
   * half side blockerHalfSide are parallel to the floor, their sides parallel to x and y, and centred
   * over the origin at those heights. A light of no width or height gives the limit of a thin one.
   */
  static double RectangleVisibility(double lightHalfWidth, double lightHalfHeight,
    double lightHeight, double blockerHalfSide, double blockerHeight, double x, double y);

  /**
   * Key that is set (to 1) in the property keys of a ground's actor: that of AddGround(), and the
   * floors of the built-in scenes.
   */
  static vtkInformationIntegerKey* GROUND();

protected:
  vtkShadowScenes() = default;
  ~vtkShadowScenes() override = default;

private:
  vtkShadowScenes(const vtkShadowScenes&) = delete;
  void operator=(const vtkShadowScenes&) = delete;
};

#endif
