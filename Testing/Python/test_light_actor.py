# SPDX-License-Identifier: BSD-3-Clause
"""A light that is shown: as large as it is, where it is, and without a shadow."""

import numpy as np
from vtkmodules.vtkRenderingCore import vtkLight

from shadow_testing import Scene, Stage, TestCase, create, main, visibility, vss


def show(light, samples=64):
    shown = vss.vtkAreaLightActor()
    shown.SetLight(light)
    shown.SetSamples(samples)
    return shown


class LightActor(TestCase):
    def light(self, shape="Sphere"):
        light = vss.vtkAreaLight()
        getattr(light, "SetShapeTo" + shape)()
        light.SetPosition(1, 2, 5)
        light.SetFocalPoint(1, 2, 0)
        light.SetRadius(0.5)
        light.SetWidth(4)
        light.SetHeight(2)
        return light

    def assert_bounds(self, light, expected, **options):
        np.testing.assert_allclose(show(light, **options).GetBounds(), expected, atol=1e-9)

    def test_shapes(self):
        # A flat light's line ahead is as long as its larger half; a circle of 64 sides has its four corners.
        self.assert_bounds(self.light("Sphere"), (0.5, 1.5, 1.5, 2.5, 4.5, 5.5))
        self.assert_bounds(self.light("Disk"), (0.5, 1.5, 1.5, 2.5, 4.5, 5))
        self.assert_bounds(self.light("Rectangle"), (-1, 3, 1, 3, 3, 5))
        self.assert_bounds(self.light("Point"), (1, 1, 2, 2, 5, 5))
        sun = self.light()
        sun.PositionalOff()
        sun.SetAngularDiameter(90)  # as wide as it is far: 5 x tan(45 degrees)
        self.assert_bounds(sun, (-4, 6, -3, 7, 0, 5))
        plain = vtkLight()
        plain.SetPosition(3, 0, 0)
        self.assert_bounds(plain, (3, 3, 0, 0, 0, 0))

    def test_nothing_to_show(self):
        self.assertGreater(*vss.vtkAreaLightActor().GetBounds()[:2])  # none
        self.assertGreater(*show(self.light("Point"), samples=0).GetBounds()[:2])

    def test_it_follows(self):
        light = self.light()
        shown = show(light)
        shown.GetBounds()
        light.SetPosition(0, 0, 9)
        light.SetFocalPoint(0, 0, 0)
        light.SetRadius(2)
        np.testing.assert_allclose(shown.GetBounds(), (-2, 2, -2, 2, 7, 11), atol=1e-9)

    def test_samples_alone(self):
        # One sample is the light's centre, whatever its size.
        light = self.light()
        stage = Stage()
        stage.look_at((1, -8, 5), (1, 2, 5))
        stage.renderer.AddViewProp(show(light, samples=1))
        stage.window.Render()
        middle = stage.grab()
        height, width, _ = middle.shape
        self.assertGreater(middle[height // 2, width // 2, 0], 200)

    def test_no_shadow(self):
        scene = Scene("basic")
        light = scene.light
        for technique in ("map-hard", "map-soft"):
            shadows = create(technique)
            scene.render(shadows)
            before = visibility(shadows).copy()
            shown = show(light)
            scene.renderer.AddViewProp(shown)
            picture = scene.render(shadows)
            after = visibility(shadows)
            shown.VisibilityOff()
            hidden = (scene.render(shadows) != picture).any(axis=2)
            scene.renderer.RemoveViewProp(shown)
            self.assertTrue((after[~hidden] == before[~hidden]).all())


if __name__ == "__main__":
    main()
