# SPDX-License-Identifier: BSD-3-Clause
"""Which props cast and receive, and which lights cast."""

import numpy as np

from vtkmodules.vtkCommonCore import vtkInformation

from shadow_testing import Scene, TestCase, create, main, receivers, statistics, technique_names, \
    visibility, vss


def shadow_share(scene, shadows):
    """The share of pixels that see less than the whole light."""
    scene.render(shadows)
    return np.mean(visibility(shadows) < 1)


class Casting(TestCase):
    def test_defaults(self):
        scene = Scene("blocker")
        ground, (blocker,) = scene.actors()
        for prop in (ground, blocker):
            self.assertTrue(vss.vtkShadowPass.GetCasting(prop))
            self.assertTrue(vss.vtkShadowPass.GetReceiving(prop))
        self.assertTrue(vss.vtkShadowPass.GetLightCasting(scene.light))

    def test_keys(self):
        casts = vss.vtkShadowPass.CASTS_SHADOW()
        receives = vss.vtkShadowPass.RECEIVES_SHADOW()
        self.assertEqual(casts.GetName(), "CASTS_SHADOW")
        self.assertEqual(receives.GetName(), "RECEIVES_SHADOW")
        self.assertTrue(casts.IsA("vtkInformationIntegerKey"))
        scene = Scene("blocker")
        ground, (blocker,) = scene.actors()
        # The functions and the keys are the same thing.
        keys = vtkInformation()
        keys.Set(casts, 0)
        blocker.SetPropertyKeys(keys)
        self.assertFalse(vss.vtkShadowPass.GetCasting(blocker))
        vss.vtkShadowPass.SetCasting(blocker, True)
        self.assertEqual(keys.Get(casts), 1)
        # Other keys stay.
        vss.vtkShadowPass.SetReceiving(ground, False)
        self.assertEqual(ground.GetPropertyKeys().Get(receives), 0)
        self.assertEqual(ground.GetPropertyKeys().Get(vss.vtkShadowScenes.GROUND()), 1)

    def test_prop_does_not_cast(self):
        for name in technique_names():
            with self.subTest(technique=name):
                scene = Scene("blocker")
                _, (blocker,) = scene.actors()
                plain = scene.render()
                shadows = create(name)
                before = shadow_share(scene, shadows)
                self.assertGreater(before, 0.05)
                vss.vtkShadowPass.SetCasting(blocker, False)
                self.assertEqual(shadow_share(scene, shadows), 0)
                self.assertLessEqual(np.abs(scene.render(shadows) - plain).max(), 1)
                vss.vtkShadowPass.SetCasting(blocker, True)
                self.assertEqual(shadow_share(scene, shadows), before)

    def test_invisible_prop_does_not_cast(self):
        for name in technique_names():
            scene = Scene("blocker")
            _, (blocker,) = scene.actors()
            blocker.VisibilityOff()
            self.assertEqual(shadow_share(scene, create(name)), 0, name)

    def test_prop_does_not_receive(self):
        for name in technique_names():
            with self.subTest(technique=name):
                scene = Scene("blocker")
                ground, _ = scene.actors()
                plain = scene.render()
                shadows = create(name)
                scene.render(shadows)
                all_receivers = receivers(shadows)
                vss.vtkShadowPass.SetReceiving(ground, False)
                self.assertLessEqual(np.abs(scene.render(shadows) - plain).max(), 1)
                self.assertTrue((visibility(shadows) == 1).all())
                # Only the blocker's pixels are left.
                left = receivers(shadows)
                self.assertLess(left.sum(), 0.5 * all_receivers.sum())
                self.assertGreater(left.sum(), 0)
                self.assertTrue((left <= all_receivers).all())
                vss.vtkShadowPass.SetReceiving(ground, True)
                scene.render(shadows)
                np.testing.assert_array_equal(receivers(shadows), all_receivers)

    def test_light_does_not_cast(self):
        for name in technique_names():
            with self.subTest(technique=name):
                scene = Scene("blocker")
                plain = scene.render()
                shadows = create(name)
                before = shadow_share(scene, shadows)
                vss.vtkShadowPass.SetLightCasting(scene.light, False)
                self.assertFalse(vss.vtkShadowPass.GetLightCasting(scene.light))
                self.assertEqual(shadow_share(scene, shadows), 0)
                self.assertLessEqual(np.abs(scene.render(shadows) - plain).max(), 1)
                self.assertEqual(statistics(shadows)["evaluation"], "none")
                vss.vtkShadowPass.SetLightCasting(scene.light, True)
                self.assertEqual(shadow_share(scene, shadows), before)

    def test_switched_off_light_before_the_casting_one(self):
        # VTK's own pass counts it and draws no shadow at all.
        for name in technique_names():
            scene = Scene("blocker")
            lit = scene.light
            shadows = create(name)
            before = scene.render(shadows)
            off = vss.vtkAreaLight()
            off.SwitchOff()
            scene.renderer.RemoveAllLights()
            scene.renderer.AddLight(off)
            scene.renderer.AddLight(lit)
            np.testing.assert_array_equal(scene.render(shadows), before)


if __name__ == "__main__":
    main()
