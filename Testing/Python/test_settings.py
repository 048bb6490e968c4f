# SPDX-License-Identifier: BSD-3-Clause
"""What a Python user sets: the arguments of enable, errors that name the choices, locales, versions."""

import locale
import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass

from shadow_testing import Scene, Stage, TestCase, array, describe, main, receivers, statistics, \
    technique_names, visibility, vss

HERE = os.path.dirname(os.path.abspath(__file__))


class Arguments(TestCase):
    def setUp(self):
        super().setUp()
        self.stage = Stage()
        self.renderer = self.stage.renderer

    def refused(self, error, words, *arguments, **keywords):
        """enable raises this, its text has these words, nothing is printed, nothing is set."""
        before = vtkRenderStepsPass()
        self.renderer.SetPass(before)
        with self.subTest(arguments=arguments, **keywords):
            with self.assertRaises(error) as caught:
                vss.enable(*(arguments or (self.renderer,)), **keywords)
            for word in words:
                self.assertIn(word, str(caught.exception))
            self.assertEqual(self.errors(), "")
            self.assertIs(self.renderer.GetPass(), before)

    def test_what_is_not_a_renderer(self):
        for function in (vss.enable, vss.disable):
            for what, word in ((self.stage.window, "GetRenderers"), (None, "None"),
                               ("renderer", "str")):
                with self.assertRaises(TypeError) as caught:
                    function(what)
                self.assertIn("vtkRenderer", str(caught.exception))
                self.assertIn(word, str(caught.exception))

    def test_technique(self):
        self.refused(ValueError, ["'map-psss'", "did you mean 'map-pcss'?"] + technique_names(),
                     technique="map-psss")
        self.refused(ValueError, technique_names(), technique="")
        for wrong in (3, vss.vtkShadowTechniques):
            self.refused(TypeError, ["technique"], technique=wrong)

    def test_parameter_that_is_not_there(self):
        known = [parameter["name"].replace("-", "_")
                 for parameter in describe("map-pcss")["parameters"]]
        self.refused(ValueError, ["map-pcss", "'sampels'", "did you mean 'samples'?"] + known,
                     sampels=64)
        self.refused(ValueError, known, translucent="weighted")

    def test_value_out_of_range(self):
        for wrong in (0, 1025, 63.5, np.float64(0.5), float("nan"), float("inf"), "many", "64,0",
                      10 ** 400):
            self.refused(ValueError, ["samples", "whole number from 1 to 1024"], samples=wrong)
        self.refused(ValueError, ["width", "number from 0 to 4"], technique="map-pcf", width=-0.1)
        self.refused(ValueError, ["off, opaque, weighted"], translucent_casters="perhaps")
        self.refused(ValueError, ["midpoint", "on or off"], midpoint="perhaps")

    def test_value_of_another_kind(self):
        for wrong in (None, True, [64], (64,), {}, np.array([64]), 64j, b"64"):
            self.refused(TypeError, ["samples", "whole number"], samples=wrong)
        self.refused(TypeError, ["width", "a number"], technique="map-pcf", width=np.True_)
        self.refused(TypeError, ["off, opaque, weighted"], translucent_casters=1)
        self.refused(TypeError, ["midpoint", "True or False"], midpoint=None)

    def test_radius(self):
        for wrong in (-1, float("nan"), float("inf"), np.float32(-0.5)):
            self.refused(ValueError, ["radius", "0 or more"], radius=wrong)
        for wrong in ("big", "0.2", True, [1], 1j):
            self.refused(TypeError, ["radius", "number"], radius=wrong)
        for right in (0, 2, 0.25, np.float32(0.25), np.array(0.25)):
            self.assertEqual(
                vss.enable(self.renderer, radius=right).GetDefaultLightRadius(), float(right))

    def test_quality(self):
        self.refused(ValueError, ["'best'", "preview, low, medium, high, reference"], quality="best")
        self.refused(TypeError, ["preview, low, medium, high, reference"], quality=2)
        for name in technique_names():
            for quality in ("low", "medium", "high", "reference"):
                shadows = vss.enable(self.renderer, name, quality=quality)
                for parameter in describe(name)["parameters"]:
                    expected = parameter.get("presets", {}).get(quality, parameter["default"])
                    self.assertEqual(shadows.GetParameter(parameter["name"]), expected)
        # What is set by itself counts.
        shadows = vss.enable(self.renderer, quality="low", samples=7)
        self.assertEqual(shadows.GetParameter("samples"), "7")

    def test_numbers_in_any_form(self):
        for value in (32, 32.0, np.int64(32), np.uint8(32), np.float32(32), np.array(32), "32",
                      "32.0", "+32"):
            shadows = vss.enable(self.renderer, samples=value)
            self.assertEqual(shadows.GetParameter("samples"), "32")
        for value in (0.5, np.float32(0.5), np.float64(0.5), ".5"):
            shadows = vss.enable(self.renderer, "map-pcf", width=value)
            self.assertEqual(float(shadows.GetParameter("width")), 0.5)
        for value in (True, np.True_, 1, "on", "true"):
            shadows = vss.enable(self.renderer, midpoint=value)
            self.assertEqual(shadows.GetParameter("midpoint"), "on")
        for value in (False, np.False_, 0, "off", "false"):
            shadows = vss.enable(self.renderer, midpoint=value)
            self.assertEqual(shadows.GetParameter("midpoint"), "off")


class Visibilities(TestCase):
    def test_a_list_of_them(self):
        for name in technique_names():
            scene = Stage()
            scene.add_things()
            lights = [scene.add_light(), scene.add_light((3, -1, 4.5))]
            shadows = vss.enable(scene.renderer, name)
            scene.window.Render()
            images = [shadows.GetVisibility(light) for light in lights]
            self.assertEqual(len({image.__this__ for image in images}), 2)
            values = [array(image, "Visibility") for image in images]
            self.assertGreater(np.mean(values[0] != values[1]), 0.02)
            before = [value.copy() for value in values]
            lights[0].SetPosition(2, 3, 5)
            scene.window.Render()
            self.assertGreater(np.mean(visibility(shadows, 0) != before[0]), 0.02)
            np.testing.assert_array_equal(values, before)


class Locale(TestCase):
    def test_decimal_comma(self):
        def show():
            scene = Scene("basic")
            shadows = vss.enable(scene.renderer, "map-pcf", width=0.07)
            scene.window.Render()
            self.assertGreater(statistics(shadows)["counts"]["triangles"], 0)
            values = visibility(shadows)[receivers(shadows)].copy()
            return values, shadows.GetParameter("width")

        expected, width = show()
        penumbra = np.mean((expected > 0.02) & (expected < 0.98))
        self.assertGreater(penumbra, 0.02)
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8",
                            os.path.join(folder, "de_DE.UTF-8")], check=True)
            os.environ["LOCPATH"] = folder
            try:
                locale.setlocale(locale.LC_ALL, "de_DE.UTF-8")
                self.assertEqual(locale.localeconv()["decimal_point"], ",")
                values, text = show()
            finally:
                locale.setlocale(locale.LC_ALL, "C")
                del os.environ["LOCPATH"]
        self.assertEqual(text, width)
        np.testing.assert_array_equal(values, expected)


class Package(unittest.TestCase):
    def run_python(self, code, **environment):
        return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True,
                              check=False, cwd=HERE, env={**os.environ, **environment})

    def test_another_vtk(self):
        run = self.run_python("""
import sys
import vtkmodules.vtkCommonCore as core
built = core.vtkVersion.GetVTKVersion()
class Other:
    GetVTKMajorVersion = staticmethod(lambda: 9)
    GetVTKMinorVersion = staticmethod(lambda: 99)
    GetVTKVersion = staticmethod(lambda: "9.99.1")
core.vtkVersion = Other
try:
    import vtksoftshadows
except ImportError as error:
    assert "9.99.1" in str(error) and built in str(error), error
    assert "vtkSoftShadows" not in open("/proc/self/maps").read()
    print("refused")
""")
        self.assertEqual(run.stdout.strip(), "refused", run.stderr)


if __name__ == "__main__":
    main()
