# SPDX-License-Identifier: BSD-3-Clause
"""The one line renderer.SetPass(pass) shadows a scene and leaves the rest of the picture alone."""

import numpy as np

from shadow_testing import Scene, TestCase, create, describe, has_parameter, main, receivers, statistics, \
    technique_names, visibility


class Pictures(TestCase):
    def test_set_pass_is_enough(self):
        for name in technique_names():
            with self.subTest(technique=name):
                scene = Scene("basic")
                plain = scene.render()
                shadows = create(name)
                shaded = scene.render(shadows)
                seen = visibility(shadows)
                self.assertEqual(shaded.shape[:2], seen.shape)
                change = shaded - plain
                # Shadows only darken, and only what does not see the whole light.
                self.assertLessEqual(change.max(), 1)
                lit = seen == 1
                self.assertLessEqual(np.abs(change[lit]).max(), 1)
                # There is shadow, and what is in umbra on the floor is clearly darker.
                self.assertGreater(np.mean(seen < 0.02), 0.01)
                self.assertGreater(np.mean(lit), 0.5)
                floor = scene.actors()[0]
                floor.GetProperty().LightingOff()
                marked = scene.render()
                floor.GetProperty().LightingOn()
                on_floor = np.any(marked != plain, axis=2)
                umbra = on_floor & (seen < 0.02)
                self.assertGreater(np.mean(umbra), 0.005)
                self.assertLess(change[umbra].max(), -20)

    def test_attenuation_scales_the_shadow(self):
        # 1 - A (1 - V): half the attenuation, half the darkening.
        scene = Scene("blocker")
        plain = scene.render()
        shadows = create("map-hard")
        full = plain - scene.render(shadows)
        scene.light.SetShadowAttenuation(0.5)
        half = plain - scene.render(shadows)
        dark = full.max(axis=2) > 20
        self.assertGreater(dark.sum(), 100)
        self.assertLessEqual(np.abs(half - 0.5 * full)[dark].max(), 1.5)

    def test_off_again(self):
        for name in technique_names():
            scene = Scene("blocker")
            plain = scene.render()
            shaded = scene.render(create(name))
            self.assertFalse(np.array_equal(plain, shaded))
            np.testing.assert_array_equal(scene.render(), plain)

    def test_soft_is_softer_than_hard(self):
        for name in technique_names():
            scene = Scene("blocker")
            shadows = create(name)
            if has_parameter(name, "width"):
                shadows.SetParameter("width", "0.7")  # that of this scene
            scene.render(shadows)
            seen = visibility(shadows)
            penumbra = np.mean((seen > 0.02) & (seen < 0.98))
            if describe(name)["hard"]:
                self.assertLess(penumbra, 0.01, name)
            else:
                self.assertGreater(penumbra, 0.05, name)

    def test_two_frames_are_the_same_and_reuse(self):
        for name in technique_names():
            with self.subTest(technique=name):
                scene = Scene("basic")
                shadows = create(name)
                first = scene.render(shadows)
                self.assertEqual(statistics(shadows)["counts"]["castersRebuilt"], 1)
                np.testing.assert_array_equal(scene.render(shadows), first)
                counts = statistics(shadows)["counts"]
                self.assertEqual(counts["castersRebuilt"], 0)
                self.assertEqual(counts.get("mapsDrawn", 0), 0)
                self.assertEqual(counts.get("meshesBuilt", 0), 0)

    def test_debug_views_draw(self):
        for name in technique_names():
            scene = Scene("blocker")
            shadows = create(name)
            picture = scene.render(shadows)
            for view in shadows.GetDebugViews().split():
                with self.subTest(technique=name, view=view):
                    shadows.SetDebugView(view)
                    shown = scene.render(shadows)
                    self.assertEqual(np.array_equal(shown, picture), view == "none")
            shadows.SetDebugView("visibility")
            shown = scene.render(shadows)
            seen = visibility(shadows)
            on = receivers(shadows)
            np.testing.assert_allclose(shown[on][:, 0], 255 * seen[on], atol=2)


if __name__ == "__main__":
    main()
