# SPDX-License-Identifier: BSD-3-Clause
"""Turning shadows off gives the memory back, whatever way they are turned off."""

import gc
import os
import subprocess
import sys
import unittest

from shadow_testing import Scene, TestCase, create, family_names, has_parameter, main, \
    statistics, technique_names, visibility, vss

# Megabytes that the process may grow by over 100 times on and off. At most 1.2 were measured, of
# any technique and all of it in the first 60: pages that the allocator keeps. What a pass holds is
# 0.3 at least (a visibility buffer, a map of 256 x 256), which would be 30 if each time leaked it.
GROWTH = 4


def total(shadows):
    return statistics(shadows)["bytes"]["total"]


def resident():
    """Megabytes of the process in memory."""
    gc.collect()
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2 ** 20


class Memory(TestCase):
    def test_taken_off_the_renderer(self):
        for name in technique_names():
            with self.subTest(technique=name):
                scene = Scene("basic")
                shadows = create(name)
                first = scene.render(shadows)
                visibility(shadows)
                held = total(shadows)
                self.assertGreater(held, 0)
                scene.renderer.SetPass(None)
                self.assertEqual(total(shadows), 0)
                scene.render()
                self.assertEqual(total(shadows), 0)
                # And on again: as at first.
                self.assertTrue((scene.render(shadows) == first).all())
                visibility(shadows)
                self.assertEqual(total(shadows), held)

    def test_replaced_by_another(self):
        scene = Scene("basic")
        passes = [create(name) for name in technique_names()]
        for shadows in passes + passes:
            scene.render(shadows)
            for other in passes:
                self.assertEqual(total(other) > 0, other is shadows)

    def test_window_released_and_closed(self):
        for name in technique_names():
            with self.subTest(technique=name):
                scene = Scene("blocker")
                shadows = create(name)
                first = scene.render(shadows)
                scene.window.Finalize()
                self.assertEqual(total(shadows), 0)
                self.assertTrue((scene.render(shadows) == first).all())
                self.assertGreater(total(shadows), 0)

    def test_window_goes_before_the_pass(self):
        for name in technique_names():
            with self.subTest(technique=name):
                scene = Scene("blocker")
                shadows = create(name)
                scene.render(shadows)
                del scene
                gc.collect()
                self.assertEqual(total(shadows), 0)

    def test_another_window_after_the_first_is_gone(self):
        for name in technique_names():
            with self.subTest(technique=name):
                expected = Scene("blocker").render(create(name))
                shadows = create(name)
                Scene("blocker").render(shadows)
                gc.collect()
                self.assertTrue((Scene("blocker").render(shadows) == expected).all())

    def test_two_windows_by_turns(self):
        # A pass serves one renderer at a time: it moves, and takes nothing along.
        for name in technique_names():
            with self.subTest(technique=name):
                shadows = create(name)
                scenes = [Scene("blocker"), Scene("blocker", size=(100, 140))]
                expected = [scene.render(create(name)) for scene in scenes]
                for _ in range(2):
                    for scene, picture in zip(scenes, expected):
                        self.assertTrue((scene.render(shadows) == picture).all())

    def test_visibility_of_a_closed_window(self):
        # An error and None, or the last visibility; no crash, for which it has its own process.
        code = ("from shadow_testing import *; scene = Scene('blocker'); shadows = create(%r);"
                "scene.render(shadows); scene.window.Finalize(); shadows.GetVisibility(0)")
        for name in technique_names():
            with self.subTest(technique=name):
                run = subprocess.run(
                    [sys.executable, "-c", code % name], capture_output=True, check=False,
                    cwd=os.path.dirname(os.path.abspath(__file__)))
                self.assertEqual(run.returncode, 0)

    def test_does_not_grow(self):
        for name in technique_names():
            scene = Scene("blocker")
            shadows = create(name)
            largest = []
            for _ in range(2):  # the same frames again: what they need is there
                sizes = []
                for i in range(6):
                    scene.renderer.GetActiveCamera().SetPosition(0.2 * i, -6, 8)
                    scene.light.SetPosition(0.1 * i, 0, 6)
                    scene.render(shadows)
                    sizes.append(total(shadows))
                largest.append(max(sizes))
            self.assertEqual(largest[1], largest[0], name)

    @unittest.skipUnless(os.path.exists("/proc/self/statm"), "needs /proc to see the memory")
    def test_enabled_and_disabled_again_and_again(self):
        # With small maps: what a driver keeps for the next large one would drown what leaks.
        small = {"resolution": 256, "samples": 4}
        for name in ["map-pcss"] + family_names():
            with self.subTest(technique=name):
                scene = Scene("blocker")
                parameters = {key: value for key, value in small.items()
                              if has_parameter(name, key)}
                for i in range(120):
                    if i == 20:
                        before = resident()
                    shadows = vss.enable(scene.renderer, name, **parameters)
                    scene.window.Render()
                    visibility(shadows)
                    self.assertGreater(total(shadows), 0)
                    vss.disable(scene.renderer)
                    self.assertEqual(total(shadows), 0)
                    scene.window.Render()
                growth = resident() - before
                print(f"{name}: {growth:+.2f} MB after 100 times")
                self.assertLess(growth, GROWTH)


if __name__ == "__main__":
    main()
