# SPDX-License-Identifier: BSD-3-Clause
"""Create, Describe, SetParameter, quality and debug views: without a window."""

import json

from shadow_testing import TestCase, create, describe, main, declared_names, vss


def values_of(parameter):
    """Values that a parameter takes, and values that it does not."""
    if parameter["type"] == "choice":
        return parameter["choices"], ["", "no such choice", parameter["choices"][0] + " "]
    if parameter["type"] == "boolean":
        return ["on", "off"], ["", "perhaps", "2"]
    low, high = parameter["minimum"], parameter["maximum"]
    good = [low, high, parameter["default"]]
    bad = [low - 1, high + 1, "nan", "inf", "", "many", f"{low} {high}", f"{low}x"]
    if parameter["type"] == "integer":
        good = [int(low), int(high), parameter["default"]]
        bad += [low + 0.5]
    return good, bad


class Techniques(TestCase):
    def test_names_are_sorted_and_unique(self):
        names = declared_names()
        self.assertEqual(names, sorted(set(names)))

    def test_unknown_name(self):
        self.assertIsNone(vss.vtkShadowTechniques.Create("map-nothing"))
        told = self.errors()
        for name in ["map-nothing"] + declared_names():
            self.assertIn(name, told)
        self.assertEqual(vss.vtkShadowTechniques.Describe("map-nothing"), "")
        self.assertIn("map-nothing", self.errors())
        for i in (-1, len(declared_names())):
            self.assertEqual(vss.vtkShadowTechniques.GetName(i), "")
            self.assertIn("no technique", self.errors())

    def test_describe(self):
        for name in declared_names():
            with self.subTest(technique=name):
                about = json.loads(vss.vtkShadowTechniques.Describe(name))
                self.assertEqual(about["name"], name)
                for key in ("title", "paper", "class"):
                    self.assertTrue(about[key], key)
                self.assertEqual(set(about["lightShapes"]), {
                    "point", "sphere", "disk", "rectangle", "directional", "textured"})
                self.assertLessEqual(set(about["lightShapes"].values()),
                                     {"exact", "approximate", "unsupported"})
                self.assertTrue(about["resources"])
                self.assertIsInstance(about["limits"], list)
                names = [parameter["name"] for parameter in about["parameters"]]
                self.assertEqual(len(names), len(set(names)))
                self.assertIn("evaluation", names)
                for parameter in about["parameters"]:
                    self.assertTrue(parameter["meaning"])
                    self.assertLessEqual({"type", "default", "unit"}, set(parameter))

    def test_parameters(self):
        for name in declared_names():
            shadows = create(name)
            self.assertEqual(shadows.GetTechnique(), name)
            for parameter in describe(name)["parameters"]:
                key, default = parameter["name"], parameter["default"]
                good, bad = values_of(parameter)
                with self.subTest(technique=name, parameter=key):
                    self.assertEqual(shadows.GetParameter(key), default)
                    self.assertIs(shadows.SetParameter(key, default), True)
                    for value in good:
                        self.assertIs(shadows.SetParameter(key, str(value)), True, value)
                        self.assertEqual(shadows.GetParameter(key), str(value))
                    self.assertTrue(shadows.SetParameter(key, default))
                    self.assertEqual(self.errors(), "")
                    for value in bad:
                        self.assertIs(shadows.SetParameter(key, str(value)), False, value)
                        told = self.errors()
                        for part in [name, key, "'%s'" % value] + parameter.get("choices", []):
                            self.assertIn(part, told)
                        if "minimum" in parameter:
                            self.assertIn(" from ", told)
                        # Refused, and nothing else: the last good value stays.
                        self.assertEqual(shadows.GetParameter(key), default)

    def test_unknown_parameter(self):
        for name in declared_names():
            shadows = create(name)
            self.assertIs(shadows.SetParameter("smaples", "64"), False)
            told = self.errors()
            for parameter in describe(name)["parameters"]:
                self.assertIn(parameter["name"], told)
            self.assertEqual(shadows.GetParameter("smaples"), "")
            self.assertIn("smaples", self.errors())

    def test_quality(self):
        for name in declared_names():
            shadows = create(name)
            for level in ("low", "medium", "high", "reference"):
                getattr(shadows, "SetQualityTo" + level.capitalize())()
                for parameter in describe(name)["parameters"]:
                    if "presets" in parameter:
                        self.assertEqual(shadows.GetParameter(parameter["name"]),
                                         parameter["presets"][level])
            # High is the default.
            shadows.SetQualityToHigh()
            for parameter in describe(name)["parameters"]:
                if "presets" in parameter:
                    self.assertEqual(shadows.GetParameter(parameter["name"]), parameter["default"])

    def test_set_technique(self):
        for name in declared_names():
            shadows = create(name)
            for parameter in describe(name)["parameters"]:
                if "minimum" in parameter:
                    shadows.SetParameter(parameter["name"], str(int(parameter["minimum"])))
            self.assertIs(shadows.SetTechnique(name), True)
            for parameter in describe(name)["parameters"]:
                self.assertEqual(shadows.GetParameter(parameter["name"]), parameter["default"])
            self.assertIs(shadows.SetTechnique("map-nothing"), False)
            self.assertIn("map-nothing", self.errors())
            self.assertEqual(shadows.GetTechnique(), name)

    def test_debug_views(self):
        for name in declared_names():
            shadows = create(name)
            views = shadows.GetDebugViews().split()
            self.assertLessEqual({"none", "visibility", "penumbra", "cost"}, set(views))
            for view in views:
                self.assertIs(shadows.SetDebugView(view), True)
                self.assertEqual(shadows.GetDebugView(), view)
            self.assertIs(shadows.SetDebugView("nothing"), False)
            told = self.errors()
            for view in views:
                self.assertIn(view, told)

    def test_print(self):
        for name in declared_names():
            text = str(create(name))
            self.assertIn("Technique: " + name, text)
            for parameter in describe(name)["parameters"]:
                self.assertIn(parameter["name"] + ": " + parameter["default"], text)

    def test_before_the_first_frame(self):
        for name in declared_names():
            shadows = create(name)
            self.assertIsNone(shadows.GetVisibility(0))
            self.assertIn("GetVisibility", self.errors())
            self.assertEqual(json.loads(shadows.GetStatistics())["bytes"]["total"], 0)


if __name__ == "__main__":
    main()
