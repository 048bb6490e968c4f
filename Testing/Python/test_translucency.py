# SPDX-License-Identifier: BSD-3-Clause
"""Translucent props: by which rule they cast, and that they are drawn in VTK's order."""

import numpy as np
from vtkmodules.vtkRenderingOpenGL2 import vtkCameraPass, vtkDepthPeelingPass, \
    vtkDualDepthPeelingPass, vtkLightsPass, vtkOpaquePass, vtkRenderPassCollection, \
    vtkSequencePass, vtkTranslucentPass

from shadow_testing import Stage, TestCase, create_fine, main, receivers, technique_names, \
    visibility

LIGHT = np.array([0, 0, 6])


class BoxStage(Stage):
    """Translucent boxes over a floor, and a light right above its middle."""

    def __init__(self, *opacities):
        super().__init__()
        self.floor = self.add_floor()
        self.boxes = []
        # One above the other, the upper one to the right of the lower one.
        for i, opacity in enumerate(opacities):
            place = (0.5 * i, 0, 1 + 0.6 * i)
            self.boxes.append(self.add_box(place, (1, 1, 0.2), opacity=opacity))
        self.light = self.add_light(tuple(LIGHT))
        self.look_at((0, -6, 5))

    def behind(self, box, margin):
        """Pixels of the floor, and which of them lie behind the box as the light sees it, surely
        (a negative margin) or perhaps (a positive one)."""
        place = self.floor_points()
        bounds = np.array(box.GetBounds()).reshape(3, 2)
        inside = np.zeros(place.shape[:2], bool)
        for height in np.linspace(*bounds[2], 5):
            through = (place + (LIGHT - place) * height / LIGHT[2])[..., :2]
            inside |= ((through > bounds[:2, 0] - margin) &
                       (through < bounds[:2, 1] + margin)).all(axis=-1)
        return inside

    def floor_pixels(self):
        on_floor = (np.abs(self.floor_points()[..., :2]) < 2.9).all(axis=-1)
        return on_floor & ~self.covered(self.floor)


def expected_of(rule, opacity):
    return {"off": 1, "opaque": 0, "weighted": 1 - opacity}[rule]


class Rules(TestCase):
    def test_one_box(self):
        # V behind a box of opacity a: 1, 0, or 1 - a.
        for opacity in (0.25, 0.7):
            stage = BoxStage(opacity)
            floor = stage.floor_pixels()
            behind = floor & stage.behind(stage.boxes[0], -0.04)
            beside = floor & ~stage.behind(stage.boxes[0], 0.04)
            self.assertGreater(behind.sum(), 200)
            for name in technique_names():
                for rule in ("off", "opaque", "weighted"):
                    with self.subTest(technique=name, rule=rule, opacity=opacity):
                        shadows = create_fine(name, translucent_casters=rule)
                        stage.render(shadows)
                        seen = visibility(shadows)
                        np.testing.assert_allclose(
                            seen[behind], expected_of(rule, opacity), atol=1e-3)
                        self.assertTrue((seen[beside] == 1).all())

    def test_the_most_opaque_in_a_row_counts(self):
        pale, dense = 0.25, 0.75
        stage = BoxStage(pale, dense)
        floor = stage.floor_pixels()
        surely = [stage.behind(box, -0.04) for box in stage.boxes]
        perhaps = [stage.behind(box, 0.04) for box in stage.boxes]
        regions = {1 - pale: surely[0] & ~perhaps[1], 1 - dense: surely[1]}
        for name in technique_names():
            shadows = create_fine(name, translucent_casters="weighted")
            stage.render(shadows)
            for value, region in regions.items():
                with self.subTest(technique=name, visibility=value):
                    self.assertGreater((region & floor).sum(), 80)
                    np.testing.assert_allclose(
                        visibility(shadows)[region & floor], value, atol=1e-3)

    def test_an_opacity_that_changes_is_followed(self):
        stage = BoxStage(0.5)
        behind = stage.floor_pixels() & stage.behind(stage.boxes[0], -0.04)
        for name in technique_names():
            shadows = create_fine(name, translucent_casters="weighted")
            for opacity in (0.5, 0.2, 0.9, 1, 0):
                with self.subTest(technique=name, opacity=opacity):
                    stage.boxes[0].GetProperty().SetOpacity(opacity)
                    stage.render(shadows)
                    np.testing.assert_allclose(
                        visibility(shadows)[behind], 1 - opacity, atol=1e-3)


def peeling(kind):
    """What VTK draws without a pass, with this way of peeling, as a pass."""
    peel = kind()
    peel.SetTranslucentPass(vtkTranslucentPass())
    peel.SetMaximumNumberOfPeels(8)
    passes = vtkRenderPassCollection()
    for step in (vtkLightsPass(), vtkOpaquePass(), peel):
        passes.AddItem(step)
    steps = vtkSequencePass()
    steps.SetPasses(passes)
    camera = vtkCameraPass()
    camera.SetDelegatePass(steps)
    return camera


class Peeling(TestCase):
    def check(self, stage, name, delegate=None):
        """The floor is VTK's picture where it is lit; where it is dark, that of the light out."""
        floor = stage.floor_pixels()
        boxes = stage.covered(stage.floor)
        plain = stage.render(delegate)
        stage.light.SetIntensity(1e-6)
        out = stage.render(delegate)
        stage.light.SetIntensity(1)
        shadows = create_fine(name, translucent_casters="opaque")
        shadows.SetDelegatePass(delegate)
        picture = stage.render(shadows)
        seen = visibility(shadows)
        floor &= receivers(shadows)
        lit = floor & (seen == 1)
        dark = floor & (seen == 0)
        self.assertGreater(lit.sum(), 2000)
        self.assertGreater(dark.sum(), 200)
        self.assertLessEqual(np.abs(picture - plain)[lit].max(), 1)
        self.assertLessEqual(np.abs(picture - out)[dark].max(), 1)
        # Where the boxes are, what is seen of them and through them is between the two.
        self.assertTrue((picture <= plain + 1)[boxes].all())
        self.assertTrue((picture >= out - 1)[boxes].all())
        self.assertGreater(np.ptp(plain[boxes], axis=0).max(), 20)

    def test_of_the_renderer(self):
        for name in technique_names():
            for peel in (False, True):
                with self.subTest(technique=name, peeling=peel):
                    stage = BoxStage(0.4, 0.6)
                    stage.renderer.SetUseDepthPeeling(peel)
                    self.check(stage, name)

    def test_as_the_delegate(self):
        for name in technique_names():
            for kind in (vtkDualDepthPeelingPass, vtkDepthPeelingPass):
                with self.subTest(technique=name, kind=kind.__name__):
                    stage = BoxStage(0.4, 0.6)
                    delegate = peeling(kind)
                    self.check(stage, name, delegate)
                    stage.renderer.SetPass(None)
                    delegate.ReleaseGraphicsResources(stage.window)


if __name__ == "__main__":
    main()
