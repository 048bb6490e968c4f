# SPDX-License-Identifier: BSD-3-Clause
"""enable and disable: shadows on an existing program by a line, and off again."""

import json

import numpy as np
from vtkmodules.vtkRenderingCore import vtkLight
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass

from shadow_testing import Scene, TestCase, main, receivers, technique_names, visibility, vss


class Enable(TestCase):
    def look(self, scene):
        return scene.render(scene.renderer.GetPass())

    def test_on_and_off(self):
        scene = Scene("basic")
        before = self.look(scene)
        shadows = vss.enable(scene.renderer, samples=32)
        self.assertEqual(shadows.GetTechnique(), "map-pcss")
        self.assertEqual(shadows.GetParameter("samples"), "32")
        self.assertIs(scene.renderer.GetPass(), shadows)
        # A tenth of the picture is in shadow at least, and nothing is brighter.
        during = self.look(scene)
        self.assertGreater(np.mean(during.sum(axis=2) < before.sum(axis=2) - 30), 0.05)
        self.assertFalse((during > before + 1).any())
        vss.disable(scene.renderer)
        self.assertIsNone(scene.renderer.GetPass())
        self.assertTrue((self.look(scene) == before).all())

    def test_auto_chooses(self):
        scene = Scene("basic")
        shadows = vss.enable(scene.renderer, "auto", error=0.1)
        self.look(scene)
        choice = json.loads(shadows.GetStatistics())["choice"]
        self.assertIn(choice["chosen"]["technique"], technique_names())
        self.assertLessEqual(choice["chosen"]["rmseInterval"][1], 0.1)
        self.assertGreater(len(choice["tried"]), 3)
        with self.assertRaises(ValueError):
            vss.enable(scene.renderer, "auto", error=2)
        with self.assertRaises(ValueError):
            vss.enable(scene.renderer, "auto", time=-1)

    def test_frames_add_up(self):
        scene = Scene("basic")
        shadows = vss.enable(scene.renderer, "map-soft", samples=8, accumulate=True,
                             accumulate_samples=32)
        self.assertFalse(shadows.IsFinished())
        for frame in range(4):
            self.assertFalse(shadows.IsFinished())
            self.look(scene)
        self.assertTrue(shadows.IsFinished())
        counts = json.loads(shadows.GetStatistics())["counts"]
        self.assertEqual(counts["accumulatedSamples"], 32)

    def test_a_keyword_has_underscores_for_hyphens(self):
        scene = Scene("basic")
        shadows = vss.enable(scene.renderer, translucent_casters="weighted", midpoint=False)
        self.assertEqual(shadows.GetParameter("translucent-casters"), "weighted")
        self.assertEqual(shadows.GetParameter("midpoint"), "off")

    def test_radius_is_of_plain_lights(self):
        scene = Scene("basic")
        light = vtkLight()
        light.SetPositional(True)
        light.SetPosition(scene.light.GetPosition())
        light.SetFocalPoint(scene.light.GetFocalPoint())
        scene.renderer.RemoveAllLights()
        scene.renderer.AddLight(light)
        shares = []
        for radius in (None, 0.4):
            shadows = vss.enable(scene.renderer, "map-soft", radius=radius, midpoint=False)
            self.look(scene)
            values = visibility(shadows)[receivers(shadows)]
            shares.append(np.mean((values > 0.02) & (values < 0.98)))
        self.assertEqual(shares[0], 0.0)
        self.assertGreater(shares[1], 0.01)

    def test_the_pass_before_is_shaded_and_comes_back(self):
        scene = Scene("basic")
        before = vtkRenderStepsPass()
        scene.renderer.SetPass(before)
        first = vss.enable(scene.renderer)
        second = vss.enable(scene.renderer, "map-hard")
        self.assertIs(second.GetDelegatePass(), before)
        self.assertIsNot(first, second)
        vss.disable(scene.renderer)
        self.assertIs(scene.renderer.GetPass(), before)
        vss.disable(scene.renderer)  # nothing to take off
        self.assertIs(scene.renderer.GetPass(), before)

    def test_what_cannot_be_changes_nothing(self):
        scene = Scene("basic")
        shadows = vss.enable(scene.renderer)
        for arguments in ({"technique": "map-nothing"}, {"samples": 0}, {"nothing": 1},
                          {"translucent_casters": "perhaps"}, {"radius": -1},
                          {"radius": float("nan")}):
            with self.subTest(**arguments):
                with self.assertRaises(ValueError):
                    vss.enable(scene.renderer, **arguments)
                self.assertIs(scene.renderer.GetPass(), shadows)


if __name__ == "__main__":
    main()
