# SPDX-License-Identifier: BSD-3-Clause
"""The shadow catcher: nothing of it shows but the shadow on it."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray

from shadow_testing import Stage, TestCase, create_fine, family_names, grown, main, receivers, \
    technique_names, visibility, vss


class CatcherStage(Stage):
    def __init__(self, peeling=False):
        super().__init__()
        self.renderer.SetBackground(0.9, 0.8, 0.3)
        self.renderer.SetUseDepthPeeling(peeling)
        self.floor = self.add_things()
        self.floor.GetProperty().SetColor(0.1, 0.5, 0.2)
        self.light = self.add_light()
        covered = self.covered(self.floor)
        self.things = ~grown(~covered, 1)
        on_floor = (np.abs(self.floor_points()[..., :2]) < 2.9).all(axis=-1)
        self.on_floor = on_floor & ~grown(covered, 1)

    def without(self, shadows):
        """What a catcher in full light leaves: the same without the floor."""
        self.floor.VisibilityOff()
        picture = self.render(shadows)
        self.floor.VisibilityOn()
        return picture


class Catcher(TestCase):
    def test_switch(self):
        stage = CatcherStage()
        key = vss.vtkShadowPass.SHADOW_CATCHER()
        self.assertEqual(key.GetName(), "SHADOW_CATCHER")
        self.assertFalse(vss.vtkShadowPass.GetShadowCatcher(stage.floor))
        for catches in (True, False):
            vss.vtkShadowPass.SetShadowCatcher(stage.floor, catches)
            self.assertIs(vss.vtkShadowPass.GetShadowCatcher(stage.floor), catches)
            self.assertEqual(stage.floor.GetPropertyKeys().Get(key) != 0, catches)

    def test_only_the_shadow_shows(self):
        # The background shows through by V; the other props are as without a catcher.
        for name in technique_names():
            for peel in (False, True):
                with self.subTest(technique=name, peeling=peel):
                    stage = CatcherStage(peel)
                    vss.vtkShadowPass.SetShadowCatcher(stage.floor, True)
                    shadows = create_fine(name)
                    without = stage.without(shadows)
                    self.errors()  # planar techniques say that nothing receives
                    picture = stage.render(shadows)
                    seen = visibility(shadows)
                    self.assertGreater((seen[stage.on_floor] == 0).sum(), 500)
                    self.assertGreater((seen[stage.on_floor] == 1).sum(), 3000)
                    self.assertTrue(receivers(shadows)[stage.on_floor].all())
                    expected = np.round(seen[..., None] * without)
                    self.assertLessEqual(np.abs(picture - expected)[stage.on_floor].max(), 1)
                    self.assertLessEqual(np.abs(picture - without)[stage.things].max(), 1)

    def test_alpha(self):
        # To be laid over another picture: what is seen of the catcher is its shadow's alpha.
        for name in technique_names():
            with self.subTest(technique=name):
                stage = CatcherStage(peeling=True)
                stage.window.SetAlphaBitPlanes(1)
                stage.renderer.SetBackgroundAlpha(0)
                vss.vtkShadowPass.SetShadowCatcher(stage.floor, True)
                shadows = create_fine(name)
                stage.render(shadows)
                width, height = stage.window.GetSize()
                pixels = vtkUnsignedCharArray()
                stage.window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels)
                alpha = vtk_to_numpy(pixels).reshape(height, width, 4)[..., 3] / 255
                hidden = 1 - visibility(shadows)[stage.on_floor]
                np.testing.assert_allclose(alpha[stage.on_floor], hidden, atol=1.5 / 255)
                self.assertTrue((alpha[stage.things] == 1).all())
                self.assertTrue((alpha[-1] == 0).all())  # the sky

    def test_of_two_lights(self):
        # Half of the light missing is half black; a light that does not cast counts as light.
        for name in technique_names():
            with self.subTest(technique=name):
                stage = CatcherStage()
                stage.renderer.RemoveAllLights()
                lights = [stage.add_light((x, 0.5, 2), positional=False) for x in (-1, 1)]
                vss.vtkShadowPass.SetShadowCatcher(stage.floor, True)
                shadows = create_fine(name)
                without = stage.without(shadows)
                self.errors()  # planar techniques say that nothing receives
                for second in (True, False):
                    vss.vtkShadowPass.SetLightCasting(lights[1], second)
                    picture = stage.render(shadows)
                    share = sum(visibility(shadows, light) for light in lights) / 2
                    expected = np.round(share[..., None] * without)
                    self.assertLessEqual(np.abs(picture - expected)[stage.on_floor].max(), 2)
                    self.assertGreater((np.abs(share - 0.5)[stage.on_floor] < 0.01).sum(), 300)

    def test_off_again(self):
        for name in family_names():
            with self.subTest(technique=name):
                stage = CatcherStage()
                plain = stage.render()
                ordinary = stage.render(create_fine(name))
                vss.vtkShadowPass.SetShadowCatcher(stage.floor, True)
                shadows = vss.enable(stage.renderer, name)
                caught = stage.render(shadows)
                self.assertGreater(np.mean((caught != ordinary).any(axis=2)), 0.3)
                # Without a shadow pass, it is an ordinary prop.
                vss.disable(stage.renderer)
                np.testing.assert_array_equal(stage.render(), plain)
                # And with one, once it is no catcher any more.
                vss.vtkShadowPass.SetShadowCatcher(stage.floor, False)
                np.testing.assert_array_equal(stage.render(create_fine(name)), ordinary)


if __name__ == "__main__":
    main()
