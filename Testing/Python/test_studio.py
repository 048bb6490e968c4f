# SPDX-License-Identifier: BSD-3-Clause
"""The studio: light that is good to look at by one line, and that leaves nothing behind."""

import itertools
import math
import os
import subprocess
import sys

import numpy as np
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkLight, vtkLightKit

from shadow_testing import Stage, TestCase, main, receivers, statistics, visibility, vss


class Studio(TestCase):
    def stage(self, floor=False):
        stage = Stage()
        if floor:
            stage.add_floor()
        stage.add_box((-0.8, 0.3, 0.6), (1, 1, 1.2))
        stage.add_sphere((0.9, -0.5, 1.3), 0.6)
        stage.look_at((3.5, -6.5, 4.5), (0.2, 0.2, 0.3))
        return stage

    def draw(self, stage):
        stage.window.Render()
        return stage.grab()

    def test_on_and_off_leaves_the_renderer_as_it_was(self):
        for what in ("headlight", "no frame before", "kit", "own light"):
            for options in ({}, {"ground": "solid"}, {"contact": True}):
                with self.subTest(lights=what, **options):
                    stage = self.stage(floor=True)
                    renderer = stage.renderer
                    if what == "kit":
                        kit = vtkLightKit()
                        kit.AddLightsToRenderer(renderer)
                    elif what == "own light":
                        off = vtkLight()
                        off.SwitchOff()
                        renderer.AddLight(off)
                        stage.add_light()
                    if what == "no frame before":
                        expected = self.draw(self.stage(floor=True))
                    else:
                        expected = self.draw(stage)
                    state = self.state(renderer)
                    vss.studio(renderer, **options)
                    vss.enable(renderer, "map-pcss")
                    during = self.draw(stage)
                    self.assertGreater(np.abs(during - expected).max(), 30)
                    vss.disable(renderer)
                    self.assertEqual(self.state(renderer), state)
                    self.assertTrue((self.draw(stage) == expected).all())

    def state(self, renderer):
        lights = renderer.GetLights()
        camera = renderer.GetActiveCamera()
        return (renderer.GetViewProps().GetNumberOfItems(), renderer.GetUseSSAO(),
                renderer.GetSSAORadius(), renderer.GetSSAOBias(), renderer.GetSSAOBlur(),
                camera.GetClippingRange(), renderer.GetPass(),
                [lights.GetItemAsObject(i).GetSwitch() for i in range(lights.GetNumberOfItems())])

    def test_exposure(self):
        # A white wall, turned through all directions: the brightest is just white, seen from anywhere.
        for darkness in (0.3, 0.65, 1.0):
            stage = Stage((24, 24))
            wall = vtkPlaneSource()
            wall.SetOrigin(-9, -9, 0)
            wall.SetPoint1(9, -9, 0)
            wall.SetPoint2(-9, 9, 0)
            actor = stage.add(wall)
            actor.GetProperty().SetAmbient(0)
            actor.GetProperty().SetDiffuse(1)
            studio = vss.studio(stage.renderer, darkness=darkness, ground=None, up="z")
            camera = stage.renderer.GetActiveCamera()
            camera.ParallelProjectionOn()
            camera.SetParallelScale(0.5)
            camera.SetViewUp(0, 0, 1)
            brightest = 0
            for eye in ((0, -40, 10), (20, -30, 30), (-30, -20, 5)):
                camera.SetPosition(eye)
                camera.SetFocalPoint(0, 0, 0)
                stage.renderer.ResetCameraClippingRange(-20, 20, -20, 20, -20, 20)
                studio.Aim()
                self.draw(stage)
                key = np.array(studio.GetKeyLight().GetPosition())
                to_eye = np.array(eye) / np.linalg.norm(eye)
                side = np.array(studio.GetSideLight().GetTransformedPosition()) - \
                    studio.GetSideLight().GetTransformedFocalPoint()
                side /= np.linalg.norm(side)
                k, f = studio.GetKeyLight().GetIntensity(), studio.GetFillLight().GetIntensity()
                # What faces the camera, and what faces the side, keeps 1 - darkness in shadow.
                self.assertAlmostEqual(f * (1 + to_eye @ side), min(1 - darkness, 0.8165), places=4)
                normal = max(k * key + f * to_eye, k * key + f * (to_eye + side),
                             key=np.linalg.norm)
                self.assertAlmostEqual(np.linalg.norm(normal), 1, places=4)
                normal /= np.linalg.norm(normal)
                actor.SetOrientation(0, 0, 0)
                actor.RotateZ(math.degrees(math.atan2(normal[1], normal[0])))
                actor.RotateY(math.degrees(math.acos(normal[2])))
                brightest = self.draw(stage)[12, 12].max()
                with self.subTest(darkness=darkness, eye=eye):
                    self.assertGreaterEqual(brightest, 253)

    def test_nothing_is_black_and_the_ground_is_not_burnt(self):
        stage = self.stage(floor=True)
        stage.renderer.SetBackground(0.9, 0.9, 0.9)  # on black a catcher shows nothing
        vss.enable(stage.renderer, lights="studio")
        picture = self.draw(stage)
        shadows = vss.vtkShadowPass.FindOn(stage.renderer)
        seen = receivers(shadows)
        self.assertLess(np.mean(picture[seen].max(axis=1) >= 255), 0.01)
        self.assertLess(np.mean(picture[seen].max(axis=1) <= 10), 0.01)

    def test_scale_and_place_change_nothing(self):
        pictures = []
        for scale, offset in ((1, 0), (1e-4, 0), (1e5, 0), (1, 1e6)):
            stage = self.stage(floor=True)
            actors = stage.renderer.GetActors()
            for i in range(actors.GetNumberOfItems()):
                actors.GetItemAsObject(i).SetScale(scale)
                actors.GetItemAsObject(i).SetPosition(offset, 0, 0)
            stage.look_at((3.5 * scale + offset, -6.5 * scale, 4.5 * scale),
                          (0.2 * scale + offset, 0.2 * scale, 0.3 * scale))
            vss.enable(stage.renderer, lights="studio", samples=16)
            pictures.append(self.draw(stage))
        for picture in pictures[1:3]:
            self.assertLess(np.mean(np.abs(picture - pictures[0]).max(axis=2) > 8), 0.01)
        # VTK's own shaders round the vertices there.
        self.assertLess(np.mean(np.abs(pictures[3] - pictures[0]).max(axis=2) > 16), 0.05)

    def test_the_key_stands_still_or_follows(self):
        for follows in (False, True):
            with self.subTest(follows=follows):
                stage = self.stage()
                studio = vss.studio(stage.renderer, follow_camera=follows)
                shadows = vss.enable(stage.renderer, "map-hard")
                self.draw(stage)
                before = np.array(studio.GetKeyLight().GetPosition())
                stage.renderer.GetActiveCamera().Azimuth(40)
                self.draw(stage)
                angle = math.degrees(math.acos(min(1, before.dot(studio.GetKeyLight().GetPosition()))))
                self.assertEqual(angle > 10, follows)
                self.assertEqual(statistics(shadows)["counts"].get("mapsDrawn", 0) > 0, follows)
        studio.SetFollowCamera(False)
        stage.renderer.GetActiveCamera().Azimuth(40)
        studio.Aim()
        before = studio.GetKeyLight().GetPosition()
        self.draw(stage)
        self.assertNotEqual(studio.GetKeyLight().GetPosition(), before)

    def test_the_ground_lies_below_and_does_not_tremble(self):
        stage = self.stage()
        studio = vss.studio(stage.renderer)
        ground = studio.GetGroundActor()
        self.draw(stage)
        box = stage.renderer.GetActors().GetItemAsObject(1)
        size = 2.5
        first = ground.GetBounds()
        self.assertLess(first[5], 0)
        self.assertGreater(first[4], -0.01 * size)
        box.AddPosition(0.002 * size, 0, 0)
        self.draw(stage)
        self.assertEqual(ground.GetBounds(), first)
        box.AddPosition(0, 0, -1)
        self.draw(stage)
        self.assertLess(ground.GetBounds()[5], -1)
        box.AddPosition(0, 0, 1)
        self.draw(stage)
        self.assertGreater(ground.GetBounds()[4], -0.01 * size)

    def test_darkness_is_one_number(self):
        # As a factor it lightens shadows; in the studio the fill answers, and the key still takes all.
        stage = self.stage(floor=True)
        light = stage.add_light()
        plain = stage.render()
        shadows = vss.enable(stage.renderer, "map-hard", darkness=0.4)
        picture = self.draw(stage)
        dark = receivers(shadows) & (visibility(shadows, light) == 0)
        ambient = 0.2 / (0.2 + 0.8)
        self.assertGreater(dark.sum(), 300)
        self.assertTrue((picture[dark] >= (0.6 - 0.01) * plain[dark] * (1 - ambient) - 1).all())
        self.assertGreater(np.abs(picture - plain).max(), 30)
        before = statistics(shadows)["frame"]
        self.assertTrue(shadows.SetParameter("darkness", 0.0))
        self.assertLessEqual(np.abs(self.draw(stage) - plain).max(), 1)
        self.assertEqual(statistics(shadows)["frame"], before + 1)
        vss.disable(stage.renderer)
        shadows = vss.enable(stage.renderer, lights="studio", darkness=0.5)
        self.draw(stage)
        studio = vss.vtkShadowStudio.FindOn(stage.renderer)
        self.assertAlmostEqual(studio.GetFillLight().GetIntensity(), 0.75 * 0.5)
        shadows.SetParameter("darkness", "0.5")
        self.draw(stage)
        self.assertAlmostEqual(studio.GetFillLight().GetIntensity(), 0.75 * 0.75)

    def test_what_cannot_be_is_named(self):
        stage = self.stage()
        for options in ({"softness": -1}, {"darkness": 2}, {"ground": "grass"}, {"up": "w"},
                        {"elevation": float("nan")}):
            with self.subTest(**options):
                with self.assertRaises(ValueError):
                    vss.studio(stage.renderer, **options)
                self.assertIsNone(vss.vtkShadowStudio.FindOn(stage.renderer))
        with self.assertRaises(ValueError):
            vss.enable(stage.renderer, lights="disco")
        vss.vtkShadowStudio().PutOn(None)
        self.assertIn("no renderer", self.errors())


class Sizes(TestCase):
    """Lights that have no size get one, or a word."""

    def setUp(self):
        super().setUp()
        vss.vtkShadowPass.SetAdvice(True)

    def tearDown(self):
        vss.vtkShadowPass.SetAdvice(False)
        super().tearDown()

    def test_an_angle_for_plain_directional_lights(self):
        for kit in (False, True):
            stage = Stage()
            stage.add_things()
            if kit:
                vtkLightKit().AddLightsToRenderer(stage.renderer)
            else:
                stage.add_light(positional=False)
            shares = []
            for angle in (0, 12):
                shadows = vss.enable(stage.renderer, "map-pcss", angle=angle)
                stage.window.Render()
                values = visibility(shadows, 0)
                shares.append(np.mean((values > 0.02) & (values < 0.98)))
            with self.subTest(kit=kit):
                self.assertLess(shares[0], 0.002)
                self.assertGreater(shares[1], 0.003)
            self.assertIn("no light has a size", self.errors())

    def say(self, change, technique="map-pcss", **options):
        stage = Stage()
        stage.add_things()
        light = vss.vtkAreaLight()
        light.SetPosition(-2.5, -2, 5.5)
        change(light)
        stage.renderer.AddLight(light)
        vss.enable(stage.renderer, technique, **options)
        stage.window.Render()
        stage.window.Render()
        return self.errors()

    def test_one_word(self):
        self.assertEqual(self.say(lambda light: None), "")
        said = self.say(lambda light: light.SetRadius(1e-4))
        self.assertEqual(said.count("less than a thousandth"), 1)
        self.assertIn("more than the whole scene", self.say(lambda light: light.SetRadius(50)))
        self.assertEqual(self.say(lambda light: light.SetRadius(50), "map-hard"), "")

        def far(light):  # as large to the eye as a lamp
            light.SetPosition(-2.5e4, -2e4, 5.5e4)
            light.SetRadius(5e3)
        self.assertEqual(self.say(far), "")
        said = self.say(lambda light: light.SetPosition(0.9, -0.5, 1.3))
        self.assertIn("the light at (0.9, -0.5, 1.3) lies inside the scene", said)
        self.assertEqual(self.say(lambda light: light.SetShapeToPoint()), "")  # as it was said

    def test_a_light_that_is_too_large_for_a_filter(self):
        def change(light):
            light.SetRadius(2.5)  # from six away, of a scene of eight
        for technique in ("map-pcss", "planar-fake", "occlusion-textures", "virtual-maps", "wedges"):
            with self.subTest(technique=technique):
                self.assertIn('"map-soft" is right there', self.say(change, technique))
        self.assertEqual(self.say(change, "map-soft"), "")

    def say_of_balls(self, heights, technique="map-pcss"):
        """Four times four balls at each height, under a light of ten degrees."""
        stage = Stage()
        stage.add_floor()
        for place in itertools.product((-1.5, -0.5, 0.5, 1.5), (-1.5, -0.5, 0.5, 1.5), heights):
            stage.add_sphere(place, 0.3)
        light = vss.vtkAreaLight()
        light.PositionalOff()
        light.SetPosition(0, 0, 9)
        light.SetAngularDiameter(10)
        stage.renderer.AddLight(light)
        shadows = vss.enable(stage.renderer, technique)
        stage.window.Render()
        stage.window.Render()
        return self.errors(), statistics(shadows)["counts"].get("lightsWithLayers")

    def test_layers_that_a_filter_does_not_know(self):
        for technique in ("map-pcss", "map-pcf", "map-combined", "map-jitter", "map-blur"):
            with self.subTest(technique):
                said, count = self.say_of_balls((0.5, 2), technique)
                self.assertEqual(said.count("lie behind each other"), 1)
                self.assertEqual(count, 1)
                self.assertEqual(self.say_of_balls((0.5,), technique), ("", 0))
        for technique in ("map-soft", "map-trace"):
            self.assertEqual(self.say_of_balls((0.5, 2), technique), ("", None))

    def test_headlights(self):
        stage = Stage()
        stage.add_things()
        vss.enable(stage.renderer)
        stage.window.Render()
        self.assertIn("shines from the camera", self.errors())

    def test_a_negative_size_is_refused(self):
        light = vss.vtkAreaLight()
        for name in ("Radius", "Width", "Height", "AngularDiameter"):
            before = getattr(light, f"Get{name}")()
            for value in (-3, float("nan")):
                getattr(light, f"Set{name}")(value)
                self.assertIn(f"{name} is zero or more", self.errors())
                self.assertEqual(getattr(light, f"Get{name}")(), before)

    def test_fit(self):
        light = vss.vtkAreaLight()
        self.assertFalse(light.GetPlaced())
        light.FitTo((10, 14, 0, 0, 0, 3), 0.5)  # a diagonal of 5
        self.assertEqual(light.GetFocalPoint(), (12, 0, 1.5))
        self.assertAlmostEqual(math.dist(light.GetPosition(), light.GetFocalPoint()), 7.5)
        self.assertAlmostEqual(light.GetRadius(), 1.25)
        self.assertAlmostEqual(light.GetWidth(), 2.5)
        # Seen from the middle, that is the directional light's angle.
        self.assertAlmostEqual(light.GetAngularDiameter(),
                               2 * math.degrees(math.atan(1.25 / 7.5)))
        light.SetPosition(12, 0, 99)
        light.FitTo((10, 14, 0, 0, 0, 3), 0.5)
        self.assertEqual(light.GetPosition(), (12, 0, 9))
        light.FitTo((1, -1, 1, -1, 1, -1))  # nothing
        self.assertEqual(light.GetPosition(), (12, 0, 9))

    def test_a_light_that_was_never_placed_is_fitted(self):
        stage = Stage()
        stage.add_things()
        actors = stage.renderer.GetActors()
        for i in range(actors.GetNumberOfItems()):
            actors.GetItemAsObject(i).SetScale(100)
        stage.look_at((350, -650, 450), (20, 20, 30))
        light = vss.vtkAreaLight()
        stage.renderer.AddLight(light)
        shadows = vss.enable(stage.renderer)
        stage.window.Render()
        self.assertGreater(light.GetRadius(), 50)
        self.assertGreater(np.mean(visibility(shadows, light) < 0.5), 0.01)

    def test_a_camera_lights_size_scales_with_its_place(self):
        # Things ten times as large, from ten times as far away: the same picture.
        shares = []
        for scale in (1, 10):
            stage = Stage()
            stage.add_things()
            actors = stage.renderer.GetActors()
            for i in range(actors.GetNumberOfItems()):
                actors.GetItemAsObject(i).SetScale(scale)
            stage.look_at((3.5 * scale, -6.5 * scale, 4.5 * scale))
            light = vss.vtkAreaLight()
            light.SetLightTypeToCameraLight()
            light.SetPosition(-0.6, 0.7, 0.5)
            light.SetRadius(0.1)
            stage.renderer.AddLight(light)
            shadows = vss.enable(stage.renderer)
            stage.window.Render()
            shares.append(visibility(shadows, light).mean())
        self.assertLess(shares[0], 0.95)
        self.assertAlmostEqual(*shares, places=3)


class AsNumbers(TestCase):
    def test_visibility_as_an_array(self):
        stage = Stage()
        stage.add_things()
        light = stage.add_light()
        with self.assertRaisesRegex(ValueError, "enable"):
            vss.visibility(stage.renderer)
        shadows = vss.enable(stage.renderer, "map-hard")
        with self.assertRaisesRegex(ValueError, "render with this pass first"):
            vss.visibility(stage.renderer)
        stage.window.Render()
        rows = vss.visibility(stage.renderer, light)
        self.assertEqual(rows.shape, (120, 160))
        self.assertTrue((rows == visibility(shadows, light)[::-1]).all())
        with self.assertRaisesRegex(ValueError, "not in the renderer"):
            vss.visibility(stage.renderer, vtkLight())

    def test_parameters_as_numbers(self):
        shadows = vss.vtkShadowTechniques.Create("map-pcss")
        for name, value, text in (("samples", 128, "128"), ("darkness", 0.25, "0.25"),
                                  ("midpoint", False, "off"), ("evaluation", "screen", "screen")):
            self.assertTrue(shadows.SetParameter(name, value))
            self.assertEqual(shadows.GetParameter(name), text)
        self.assertFalse(shadows.SetParameter("samples", -1))
        self.assertIn("1 to 1024", self.errors())

    def test_preview_is_the_least(self):
        shadows = vss.vtkShadowTechniques.Create("map-pcss")
        samples = []
        for quality in ("Preview", "Low", "Medium", "High", "Reference"):
            getattr(shadows, f"SetQualityTo{quality}")()
            samples.append(int(shadows.GetParameter("samples")))
        self.assertEqual(samples, sorted(set(samples)))

    def test_without_a_display(self):
        program = ("import vtksoftshadows; from vtkmodules.vtkRenderingCore import vtkRenderer; "
                   "vtksoftshadows.enable(vtkRenderer())")
        run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True,
                             check=True, env={**os.environ, "DISPLAY": ""})
        version = vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion()
        if version >= (9, 4):
            self.assertNotIn("xvfb-run", run.stderr)  # VTK then draws without a display
        else:
            self.assertIn("xvfb-run", run.stderr)


if __name__ == "__main__":
    main()
