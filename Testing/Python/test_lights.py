# SPDX-License-Identifier: BSD-3-Clause
"""Several lights: each has its own shadow, and the picture is the sum."""

import numpy as np
from vtkmodules.vtkRenderingCore import vtkLight, vtkLightKit

from shadow_testing import Stage, TestCase, create_fine, family_names, main, receivers, \
    statistics, technique_names, visibility, vss


def make_diffuse(stage):
    """Diffuse alone, so that a picture is a sum over lights."""
    actors = stage.renderer.GetActors()
    for i in range(actors.GetNumberOfItems()):
        actors.GetItemAsObject(i).GetProperty().SetAmbient(0)
        actors.GetItemAsObject(i).GetProperty().SetDiffuse(1)


class Lights(TestCase):
    def stage(self):
        stage = Stage()
        stage.add_things()
        return stage

    def test_kit(self):
        # Five lights that go with the camera: together, each is seen as when it is alone.
        for name in family_names():
            stage = self.stage()
            kit = vtkLightKit()
            kit.AddLightsToRenderer(stage.renderer)
            kit.Update()
            collection = stage.renderer.GetLights()
            lights = [collection.GetItemAsObject(i) for i in range(5)]
            shadows = create_fine(name)
            for eye in ((3.5, -6.5, 4.5), (-4.5, -5, 4)):
                stage.look_at(eye)
                stage.render(shadows)
                together = [visibility(shadows, light).copy() for light in lights]
                dark = [int((seen == 0).sum()) for seen in together]
                with self.subTest(technique=name, eye=eye):
                    self.assertEqual(len(statistics(shadows)["lights"]), 5)
                    self.assertGreater(sum(dark), 3000)
                    self.assertEqual(len(set(dark)), 5)  # no light has another's shadow
                for i, light in enumerate(lights):
                    for other in lights:
                        other.SetSwitch(other is light)
                    stage.render(shadows)
                    with self.subTest(technique=name, eye=eye, light=i):
                        differ = np.abs(visibility(shadows, light) - together[i]) > 0.5
                        self.assertLess(differ.mean(), 0.002)
                for light in lights:
                    light.SwitchOn()

    def test_sum_of_several(self):
        stage = self.stage()
        make_diffuse(stage)
        lights = [stage.add_light(position, positional) for position, positional in (
            ((-2.5, -2, 5.5), True), ((-3, 1, 4), False), ((-1, -4, 5), True))]
        for light, color in zip(lights, ((0.5, 0.3, 0.1), (0.1, 0.4, 0.2), (0.2, 0.2, 0.6))):
            light.SetDiffuseColor(*color)
        alone = []
        for light in lights:
            for other in lights:
                other.SetSwitch(other is light)
            alone.append(stage.render())
        for light in lights:
            light.SwitchOn()
        for name in technique_names():
            with self.subTest(technique=name):
                shadows = create_fine(name)
                picture = stage.render(shadows)
                expected = 0
                for light, plain in zip(lights, alone):
                    seen = visibility(shadows, light)
                    self.assertGreater((seen == 0).sum(), 300)
                    expected = expected + seen[..., None] * plain
                # The roundings of four pictures; and, in shadow maps, edges that are decided by
                # a normal which is not packed here as it is there.
                wrong = np.abs(picture - expected)[receivers(shadows)] > 2
                self.assertLess(wrong.mean(), 0.002)

    def test_switched(self):
        # A light that is off, black or taken away has no shadow, and the others keep theirs.
        for name in technique_names():
            stage = self.stage()
            first, second = stage.add_light(), stage.add_light((3, -1, 5))
            shadows = create_fine(name)
            stage.render(shadows)
            before = visibility(shadows, second).copy()
            changes = {
                "off": (lambda: first.SwitchOff(), lambda: first.SwitchOn()),
                "black": (lambda: first.SetIntensity(0), lambda: first.SetIntensity(1)),
                "removed": (lambda: stage.renderer.RemoveLight(first),
                            lambda: stage.renderer.AddLight(first)),
            }
            for what, (change, back) in changes.items():
                with self.subTest(technique=name, first=what):
                    change()
                    stage.render(shadows)
                    if what == "removed":
                        self.assertIsNone(shadows.GetVisibility(first))
                        self.assertIn("not in the renderer", self.errors())
                    else:
                        self.assertTrue((visibility(shadows, first) == 1).all())
                    np.testing.assert_array_equal(visibility(shadows, second), before)
                    back()
                    stage.render(shadows)
                    self.assertGreater((visibility(shadows, first) == 0).sum(), 500)
                    np.testing.assert_array_equal(visibility(shadows, second), before)

    def test_attenuation_of_each(self):
        # The picture is the plain one times 1 - A (1 - V), for the light whose A it is.
        stage = self.stage()
        make_diffuse(stage)
        light = stage.add_light()
        plain = stage.render()
        for name in technique_names():
            for attenuation in (0, 0.3, 1):
                with self.subTest(technique=name, attenuation=attenuation):
                    light.SetShadowAttenuation(attenuation)
                    shadows = create_fine(name)
                    picture = stage.render(shadows)
                    factor = 1 - attenuation * (1 - visibility(shadows)[..., None])
                    wrong = np.abs(picture - factor * plain)[receivers(shadows)] > 1.01
                    self.assertLess(wrong.mean(), 0.002)

    def test_headlight(self):
        # What shines along the eye's rays hides all that is in its shadow.
        for name in technique_names():
            with self.subTest(technique=name):
                stage = self.stage()
                light = vtkLight()
                light.SetLightTypeToHeadlight()
                stage.renderer.AddLight(light)
                camera = stage.renderer.GetActiveCamera()
                camera.ParallelProjectionOn()
                camera.SetParallelScale(3)
                shadows = create_fine(name)
                for eye in ((3.5, -6.5, 4.5), (-4, -3, 6)):
                    stage.look_at(eye)
                    plain = stage.render()
                    picture = stage.render(shadows)
                    darker = (np.abs(picture - plain) > 1).any(axis=2)
                    self.assertLess(darker.mean(), 0.005)  # pixels on edges
                # In perspective the eye's rays diverge, and its light does not: what lies beside
                # the middle shows its shadow.
                camera.ParallelProjectionOff()
                stage.look_at((3.5, -4, 3), focus=(2.5, 0, 0), angle=80)
                stage.render(shadows)
                self.assertGreater((visibility(shadows, light) < 0.5).sum(), 50)

    def test_a_program_without_lights(self):
        # VTK makes a headlight in the first frame; the one line is enough there too.
        stage = self.stage()
        plain = stage.render()
        for name in family_names():
            with self.subTest(technique=name):
                stage = self.stage()
                shadows = vss.enable(stage.renderer, name)
                stage.window.Render()
                picture = stage.grab()
                seen = visibility(shadows)
                self.assertEqual(len(statistics(shadows)["lights"]), 1)
                self.assertLessEqual(np.abs(picture - plain)[seen == 1].max(), 1)


if __name__ == "__main__":
    main()
