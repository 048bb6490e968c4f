# SPDX-License-Identifier: BSD-3-Clause
"""Visibility as numpy: against the closed form of the scene blocker, and as data."""

import json

import numpy as np

from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper

from shadow_testing import SIZE, Scene, Stage, TestCase, array, create, describe, has_parameter, main, \
    meet, receivers, statistics, technique_names, visibility, vss

# RMSE of visibility over the floor's pixels that a technique may have. Exact ones are off by the
# noise of their samples alone: 0.003 at 64 samples.
EXACT = 0.01
APPROXIMATE = 0.15


def floor_places(scene):
    """The floor point (x, y) of each pixel, and which pixels show the floor."""
    floor, (blocker,) = scene.actors()
    position, direction = scene.rays()
    place = meet(position, direction, 0.0)
    bounds = floor.GetBounds()
    # A pixel of margin at the edges, where one place does not say what the pixel shows.
    on_floor = (np.abs(place[..., :2]) < bounds[1] - 0.1).all(axis=-1)
    low, high = np.array(blocker.GetBounds()[:4]).reshape(2, 2).T
    through = meet(position, direction, blocker.GetBounds()[4])[..., :2]
    behind = ((through > low - 0.1) & (through < high + 0.1)).all(axis=-1)
    return place[..., :2], on_floor & ~behind


# What makes techniques sample that do not by default.
SAMPLED = {"occlusion-textures": {"combine": "bits"}, "wedges": {"overlap": "count"}}


class Visibility(TestCase):
    def closed_form(self, scene, half_width, half_height):
        place, shown = floor_places(scene)
        blocker = scene.actors()[1][0].GetBounds()
        height = scene.light.GetPosition()[2]
        form = vss.vtkShadowScenes.RectangleVisibility
        expected = np.array([form(half_width, half_height, height, blocker[1], blocker[4], x, y)
                             for x, y in place[shown]])
        return shown, expected

    def test_closed_form_of_the_scene(self):
        scene = Scene("blocker")
        place, shown = floor_places(scene)
        _, expected = self.closed_form(scene, scene.light.GetWidth() / 2,
                                       scene.light.GetHeight() / 2)
        by_name = [vss.vtkShadowScenes.BlockerVisibility(x, y) for x, y in place[shown]]
        np.testing.assert_allclose(by_name, expected, atol=1e-12)
        self.assertGreater(np.mean((expected > 0.02) & (expected < 0.98)), 0.1)
        self.assertGreater(np.mean(expected == 0), 0.005)

    def test_seeds_of_rays(self):
        scene = Scene("blocker")
        shown, expected = self.closed_form(scene, scene.light.GetWidth() / 2,
                                           scene.light.GetHeight() / 2)
        shadows = create("ray-traced", samples=16)
        seen = []
        for seed in (0, 1, 0):
            shadows.SetParameter("seed", str(seed))
            scene.render(shadows)
            seen.append(visibility(shadows)[shown])
        np.testing.assert_array_equal(seen[0], seen[2])
        # Their errors are of one size and independent: two of them differ by sqrt(2) of it.
        errors = [np.sqrt(np.mean((values - expected) ** 2)) for values in seen]
        difference = np.sqrt(np.mean((seen[0] - seen[1]) ** 2))
        self.assertAlmostEqual(errors[0] / errors[1], 1.0, delta=0.1)
        self.assertAlmostEqual(difference / errors[0], np.sqrt(2), delta=0.15)

    def test_against_closed_form(self):
        for name in technique_names():
            with self.subTest(technique=name):
                scene = Scene("blocker")
                about = describe(name)
                shadows = create(name)
                scene.render(shadows)
                seen = visibility(shadows)
                if about["hard"]:
                    # The light's centre decides: all but the pixels on the shadow's edge are right.
                    shown, expected = self.closed_form(scene, 0, 0)
                    wrong = np.mean(np.abs(seen[shown] - expected) > 0.5)
                    print(f"{name}: {wrong:.5f} of the pixels wrong")
                    self.assertLess(wrong, 0.004)
                    continue
                shown, expected = self.closed_form(
                    scene, scene.light.GetWidth() / 2, scene.light.GetHeight() / 2)
                error = seen[shown] - expected
                rmse = np.sqrt(np.mean(error ** 2))
                print(f"{name}: RMSE {rmse:.4f}, bias {error.mean():+.4f}, "
                      f"maximum {np.abs(error).max():.3f}")
                exact = about["lightShapes"]["rectangle"] == "exact"
                self.assertLess(rmse, EXACT if exact else APPROXIMATE)
                self.assertLess(abs(error.mean()), (EXACT if exact else APPROXIMATE) / 4)

    def test_more_samples_less_error(self):
        for name in technique_names():
            if not has_parameter(name, "samples") or has_parameter(name, "width"):
                continue  # of a constant width: it is that which errs
            errors = []
            for samples in (4, 64):
                scene = Scene("blocker")
                shadows = create(name, samples=samples, **SAMPLED.get(name, {}))
                scene.render(shadows)
                shown, expected = self.closed_form(
                    scene, scene.light.GetWidth() / 2, scene.light.GetHeight() / 2)
                errors.append(np.sqrt(np.mean((visibility(shadows)[shown] - expected) ** 2)))
            self.assertLess(errors[1], 0.5 * errors[0], name)

    def test_arrays(self):
        for name in technique_names():
            scene = Scene("blocker")
            shadows = create(name)
            scene.render(shadows)
            image = shadows.GetVisibility(0)
            self.assertEqual(image.GetDimensions(), (SIZE[0], SIZE[1], 1))
            seen = array(image, "Visibility")
            self.assertEqual(seen.dtype, np.float32)
            self.assertEqual(seen.shape, (SIZE[1], SIZE[0]))
            self.assertTrue(np.isfinite(seen).all())
            self.assertTrue(((seen >= 0) & (seen <= 1)).all())
            mask = array(image, "Receiver")
            self.assertEqual(mask.dtype, np.uint8)
            self.assertLessEqual(set(np.unique(mask)), {0, 1})
            # Nothing is seen in the sky, and it sees the light.
            self.assertFalse(mask[-1].all())
            self.assertTrue((seen[mask == 0] == 1).all())

    def test_by_light_and_by_number(self):
        scene = Scene("blocker")
        second = vtkLight()
        second.SetPositional(True)
        second.SetPosition(-5, 3, 6)
        second.SetConeAngle(90)
        scene.renderer.AddLight(second)
        for name in technique_names():
            shadows = create(name)
            scene.render(shadows)
            first_seen, second_seen = [visibility(shadows, i) for i in range(2)]
            np.testing.assert_array_equal(visibility(shadows, scene.light), first_seen)
            np.testing.assert_array_equal(visibility(shadows, second), second_seen)
            self.assertGreater(np.mean(first_seen != second_seen), 0.02)
            # A light that casts no shadow sees everything, one that is not there is told.
            second.SwitchOff()
            scene.render(shadows)
            self.assertTrue((visibility(shadows, 1) == 1).all())
            self.assertTrue((visibility(shadows, second) == 1).all())
            second.SwitchOn()
            self.assertIsNone(shadows.GetVisibility(2))
            self.assertIn("0 to 1", self.errors())
            self.assertIsNone(shadows.GetVisibility(vtkLight()))
            self.assertIn("not in the renderer", self.errors())

    def test_of_what_a_frame_draws(self):
        # A mapper without input has no bounds: VTK draws nothing of it, and says nothing.
        stage = Stage()
        stage.add_floor()
        stage.add_things()
        stage.add_light()
        stage.look_at((3, -6, 4))
        empty = vtkActor()
        empty.SetMapper(vtkPolyDataMapper())
        for name in technique_names():
            with self.subTest(technique=name):
                shadows = create(name)
                stage.render(shadows)
                without = visibility(shadows)
                stage.renderer.AddActor(empty)
                stage.render(shadows)
                np.testing.assert_array_equal(visibility(shadows), without)
                self.assertEqual(self.errors(), "")
                stage.renderer.RemoveActor(empty)

    def test_evaluations_agree(self):
        for name in technique_names():
            pictures = []
            for evaluation in ("auto", "screen"):
                scene = Scene("basic")
                shadows = create(name, evaluation=evaluation)
                pictures.append(scene.render(shadows))
                self.assertIn(statistics(shadows)["evaluation"], ("forward", "screen"))
            change = np.abs(pictures[1] - pictures[0])
            self.assertLess(np.mean(change > 8), 0.01, name)

    def test_statistics(self):
        for name in technique_names():
            with self.subTest(technique=name):
                scene = Scene("basic")
                shadows = create(name)
                scene.render(shadows)
                scene.render(shadows)
                told = json.loads(shadows.GetStatistics())
                self.assertEqual(told["technique"], name)
                self.assertEqual(told["frame"], 2)
                self.assertEqual(told["counts"]["triangles"], 17408)
                self.assertEqual(told["counts"]["trianglesDropped"], 0)
                self.assertEqual(len(told["lights"]), 1)
                self.assertIn("rectangle", told["lights"][0])
                self.assertGreater(told["bytes"]["total"], 0)
                self.assertEqual(
                    told["bytes"]["total"],
                    sum(size for key, size in told["bytes"].items() if key != "total"))
                self.assertGreater(told["milliseconds"]["shading"], 0)
                for time in told["milliseconds"].values():
                    self.assertGreaterEqual(time, 0)


if __name__ == "__main__":
    main()
