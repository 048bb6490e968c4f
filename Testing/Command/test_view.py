# SPDX-License-Identifier: BSD-3-Clause
"""The viewer in a window, driven by events: what is seen, printed and written after each of them."""

import json
import os
import re
import shlex
import subprocess
import time
import unittest

import numpy

import model_files as models
import viewer_events as ev
from command_testing import COMMAND, ENVIRONMENT, CommandTest, read_png
from command_testing import start_display as setUpModule  # unittest calls it

SIZE = 200
PLAIN = ["--scene", "boxes", "--size", "%dx%d" % (SIZE, SIZE), "--samples-per-pixel", "0"]
AMBER = [242, 153, 13]  # of vtkAreaLightActor


class ViewTest(CommandTest):
    def play(self, events, *arguments, scene=PLAIN, technique="map-hard"):
        """The window's picture after the events, and what was printed."""
        self.write("events.log", ev.text(events))
        result = self.succeed("view", *scene, "--technique", technique, "--play", "events.log",
                              "--screenshot", "window.png", *arguments)
        return read_png(self.path("window.png")), result.stdout

    def options(self, printed):
        """Each line of options that the key c has printed, as a dictionary."""
        found = []
        for line in printed.splitlines():
            if "--technique" in line and line.startswith("-"):
                words = shlex.split(line)
                found.append({"--set": set()})
                for name, value in zip(words, words[1:]):
                    if name == "--set":
                        found[-1]["--set"].add(value)
                    elif name.startswith("--"):
                        found[-1][name] = value
        return found


class Keys(ViewTest):
    def told(self, *groups, technique="map-pcss", start=()):
        """The options at the start and after each group of events."""
        events = ev.key("c")
        for group in groups:
            events += group + ev.key("c")
        _, printed = self.play(events, *start, technique=technique)
        found = self.options(printed)
        self.assertEqual(len(found), len(groups) + 1, printed)
        return found

    @staticmethod
    def light(options):
        parts = dict(part.split("=") for part in options["--light"].split(":")[1:])
        return {name: [float(one) for one in value.split(",")] for name, value in parts.items()}

    def test_light(self):
        base, up, down, larger, smaller = self.told(
            ev.key("Prior"), ev.key("Next"), ev.key("bracketright"), ev.key("bracketleft"))
        start = self.light(base)
        raised = self.light(up)
        self.assertEqual(raised["position"][:2], start["position"][:2])
        self.assertGreater(raised["position"][2], start["position"][2])
        numpy.testing.assert_allclose(self.light(down)["position"], start["position"], rtol=1e-12)
        size = "radius" if "radius" in start else "width"
        self.assertAlmostEqual(self.light(larger)[size][0], 1.1 * start[size][0])
        self.assertAlmostEqual(self.light(smaller)[size][0], start[size][0])

    def test_zoom(self):
        found = self.told(ev.key("plus"), ev.key("minus"), ev.key("equal"), ev.key("KP_Subtract"),
                          ev.keys("plus", "plus", "r"))

        def distance(options):
            place, target = ([float(one) for one in options[name].split(",")]
                             for name in ("--camera-position", "--camera-target"))
            return numpy.linalg.norm(numpy.subtract(place, target))
        base = distance(found[0])
        for options, factor in zip(found, (1, 1.1, 1, 1.1, 1, 1)):
            self.assertAlmostEqual(distance(options), base / factor)
        self.assertEqual(found[-1], found[0])

    def test_techniques(self):
        names = ["none"] + [one["name"] for one in json.loads(
            self.succeed("list", "techniques", "--json").stdout)["techniques"]]
        at = names.index("map-pcss")
        after, before = self.told(ev.key("space"), ev.key("space", True) + ev.key("space", True))[1:]
        self.assertEqual(after["--technique"], names[at + 1])
        self.assertEqual(before["--technique"], names[at - 1])
        # All of them, and the first again: each is drawn.
        events = [line for _ in names for line in ev.key("space")] + ev.key("c")
        _, printed = self.play(events, technique="none")
        self.assertEqual(self.options(printed)[-1]["--technique"], "none")
        drawn = re.findall(r"^([\w-]+): \d+ frames", printed, re.M)
        self.assertEqual(sorted(drawn), sorted(names))

    def test_parameters(self):
        described = next(one for one in json.loads(self.succeed(
            "list", "techniques", "--json").stdout)["techniques"] if one["name"] == "map-pcss")
        names = [one["name"] for one in described["parameters"]]
        down = ["Down"] * names.index("samples")
        right, left, other = self.told(ev.keys(*down, "Right"), ev.keys("Left", "Left"),
                                       ev.keys("Right", "Up", "Down", "Down", "Right"))[1:]
        self.assertEqual(right["--set"], {"samples=128"})
        self.assertEqual(left["--set"], {"samples=32"})
        self.assertEqual(len(other["--set"]), 1)  # that of the next parameter
        self.assertIn(next(iter(other["--set"])).split("=")[0], names)
        # Quality by number keys, samples by n, midpoint maps by m: upper and lower case.
        low, high, samples, again, off = self.told(ev.key("2"), ev.key("4"), ev.key("n"),
                                                   ev.key("N", True), ev.key("M", True))[1:]
        presets = {one["name"]: one["presets"] for one in described["parameters"]
                   if "presets" in one}
        self.assertIn("samples=" + presets["samples"]["low"], low["--set"])
        self.assertEqual(high["--set"], set())
        self.assertEqual(samples["--set"], {"samples=100"})
        self.assertEqual(again["--set"], set())
        self.assertEqual(len(off["--set"]), 1)
        self.assertIn("midpoint=", next(iter(off["--set"])))
        preview, medium, reference = self.told(ev.key("1"), ev.key("3"), ev.key("5"))[1:]
        self.assertNotEqual(preview["--set"], reference["--set"])
        self.assertNotEqual(medium["--set"], reference["--set"])

    def test_debug_views(self):
        one, back = self.told(ev.key("d"), ev.key("D", True))[1:]
        self.assertEqual(one["--debug-view"], "visibility")
        self.assertNotIn("--debug-view", back)

    def test_spin(self):
        spun, still, casters, stopped = self.told(
            ev.key("Return") + ev.ticks(3), ev.key("Return") + ev.ticks(2),
            ev.key("Return", True) + ev.ticks(5), ev.key("Return", True) + ev.ticks(2))[1:]
        self.assertEqual(spun["--camera-position"], still["--camera-position"])
        self.assertNotIn("--turn", still)
        self.assertEqual(casters["--turn"], "5")
        self.assertEqual(stopped["--turn"], "5")
        self.assertEqual(casters["--camera-position"], spun["--camera-position"])
        place, moved = ([float(one) for one in options["--camera-position"].split(",")]
                        for options in (self.told()[0], spun))
        self.assertAlmostEqual(place[2], moved[2])
        self.assertGreater(numpy.linalg.norm(numpy.subtract(place, moved)), 1e-3)

    def test_mouse(self):
        middle = (100, 100)
        turned, moved, nearer, farther = self.told(
            ev.drag("Left", middle, (130, 90)), ev.drag("Middle", middle, (100, 130)),
            [ev.mouse("MouseWheelForward", *middle)], [ev.mouse("MouseWheelBackward", *middle)])[1:]
        base = self.told()[0]
        self.assertNotEqual(turned["--camera-position"], base["--camera-position"])
        self.assertEqual(turned["--light"], base["--light"])
        self.assertEqual(moved["--camera-position"], turned["--camera-position"])
        start, after = self.light(base)["position"], self.light(moved)["position"]
        self.assertAlmostEqual(start[2], after[2])
        self.assertGreater(numpy.linalg.norm(numpy.subtract(start, after)), 0.01)
        self.assertNotEqual(nearer["--camera-position"], moved["--camera-position"])
        numpy.testing.assert_allclose(
            [float(one) for one in farther["--camera-position"].split(",")],
            [float(one) for one in moved["--camera-position"].split(",")], rtol=1e-9)

    def test_end(self):
        _, printed = self.play(ev.keys("Escape", "c"))
        self.assertEqual(self.options(printed), [])  # after the end nothing is done

    def test_every_key_is_tested(self):
        with open(__file__) as file:
            tests = file.read()
        help_text = self.succeed("view", "--help").stdout.split("Keys and mouse:")[1]
        tested = {"Page Up, Page Down": ("Prior", "Next"), "+, -": ("plus", "minus"),
                  "Space": ("space",), "1 to 5": "12345", "Up, Down": ("Up", "Down"),
                  "Left, Right": ("Left", "Right"), "[, ]": ("bracketleft", "bracketright"),
                  "comma, period": ("comma", "period"), "?": ("question",), "Esc": ("Escape",)}
        rows = [re.split(r"  +", line, maxsplit=1)[0] for line in help_text.splitlines()
                if line.strip() and not line.startswith(("Left drag", "Middle", "Right b", "Wheel"))]
        self.assertGreater(len(rows), 20)
        for row in rows:
            for name in tested.get(row, (row,)):
                self.assertTrue('"%s"' % name in tests or '"%s"' % name.upper() in tests, row)


class Pictures(ViewTest):
    def setUp(self):
        super().setUp()
        self.base, _ = self.play(ev.key("i"))

    def share(self, picture, other):
        return (abs(picture - other).max(axis=2) > 8).mean()

    def test_unknown_keys_do_nothing(self):
        picture, _ = self.play(ev.keys("i", "q", "w", "p", "x", "F5", "Tab", "0"))
        self.assertTrue((picture == self.base).all())

    def test_text(self):
        picture, _ = self.play([])
        different = abs(picture - self.base).max(axis=2) > 8
        self.assertGreater(different[:100, :100].mean(), 0.1)
        again, _ = self.play(ev.keys("i", "i", "I"))
        self.assertTrue((again == self.base).all())

    def test_help(self):
        picture, _ = self.play(ev.keys("i", "question"))
        self.assertGreater(self.share(picture, self.base), 0.2)
        again, _ = self.play(ev.keys("i", "question", "question"))
        self.assertTrue((again == self.base).all())

    def test_light_model(self):
        far = ev.keys("i", *["minus"] * 14)
        without, _ = self.play(far)
        shown, _ = self.play(far + ev.key("l"))
        amber = abs(shown - AMBER).max(axis=2) <= 1
        self.assertGreater(amber.sum(), 3)
        self.assertTrue((shown[~amber] == without[~amber]).all())
        again, _ = self.play(far + ev.keys("l", "L"))
        self.assertTrue((again == without).all())

    def test_menu(self):
        opened, _ = self.play(ev.key("i") + ev.click("Right", 20, 190))
        self.assertGreater(self.share(opened, self.base), 0.1)
        # Beside it nothing is chosen; on its first line "none" is.
        beside, _ = self.play(ev.key("i") + ev.click("Right", 100, 190) + ev.click("Left", 20, 5))
        self.assertTrue((beside == self.base).all())
        picture, printed = self.play(ev.key("i") + ev.click("Right", 20, 199) +
                                     ev.click("Left", 30, 196) + ev.key("c"))
        self.assertEqual(self.options(printed)[-1]["--technique"], "none")
        plain, _ = self.play(ev.key("i"), technique="none")
        self.assertTrue((picture == plain).all())

    def test_split(self):
        # Either side is its part of the whole picture, but for what is interpolated over pixels' borders.
        split, _ = self.play(ev.keys("i", "v"), technique="map-hard")
        right, _ = self.play(ev.key("i"), technique="ray-traced")
        self.assertLess(self.share(split[:, :96], self.base[:, :96]), 0.005)
        self.assertLess(self.share(split[:, 104:], right[:, 104:]), 0.005)
        self.assertGreater(self.share(split[:, 104:], self.base[:, 104:]), 0.005)
        for events in (ev.keys("comma", "comma"), ev.drag("Left", (100, 50), (80, 50))):
            moved, _ = self.play(ev.keys("i", "v") + events)
            self.assertLess(self.share(moved[:, :76], self.base[:, :76]), 0.005)
            self.assertLess(self.share(moved[:, 84:], right[:, 84:]), 0.005)
            back, _ = self.play(ev.keys("i", "v") + events + ev.keys("period", "v"))
            self.assertTrue((back == self.base).all())

    def test_split_by_technique(self):
        names = ["none"] + [one["name"] for one in json.loads(
            self.succeed("list", "techniques", "--json").stdout)["techniques"]]
        after = names[names.index("map-hard") + 1]
        split, _ = self.play(ev.keys("i", "b"))
        right, _ = self.play(ev.key("i"), technique=after)
        self.assertLess(self.share(split[:, 104:], right[:, 104:]), 0.005)

    def test_errors(self):
        shown, _ = self.play(ev.keys("i", "e"))
        self.assertGreater(self.share(shown, self.base), 0.2)
        self.assertEqual(len(numpy.unique(shown[90:110, 90:110].reshape(-1, 3), axis=0)) > 0, True)
        again, _ = self.play(ev.keys("i", "e", "e"))
        self.assertTrue((again == self.base).all())

    def test_quality_falls_and_comes_back(self):
        held = ev.drag("Left", (100, 100), (120, 100), (121, 100), (122, 100), (123, 100),
                       release=False)
        release = [ev.mouse("LeftButtonRelease", 123, 100)]
        full, _ = self.play(ev.key("i") + held, "--least-rate", "0", technique="map-pcss")
        fallen, _ = self.play(ev.key("i") + held, "--least-rate", "1e9", technique="map-pcss")
        back, printed = self.play(ev.key("i") + held + release + ev.key("c"), "--least-rate",
                                  "1e9", technique="map-pcss")
        self.assertTrue((back == full).all())
        self.assertFalse((fallen == full).all())
        self.assertEqual(self.options(printed)[-1]["--set"], set())


class Snapshots(ViewTest):
    def assert_reproduced(self, events, *arguments, **keywords):
        self.play(ev.key("i") + events + ev.key("s"), *arguments, **keywords)
        with open(self.path("softshadows-001.json")) as file:
            settings = json.load(file)
        self.succeed("render", *settings["options"], "-o", "again.png", "--visibility", "again.exr")
        self.assertTrue(settings["command"].startswith("softshadows render "))
        self.assertEqual(shlex.split(settings["command"])[2:], settings["options"])
        picture, again = (read_png(self.path(name)) for name in ("softshadows-001.png", "again.png"))
        self.assertLessEqual(abs(picture - again).max(), 1)
        return picture

    def test_scene(self):
        self.assert_reproduced(
            ev.drag("Left", (100, 100), (130, 90)) + ev.drag("Middle", (100, 100), (110, 120)) +
            ev.keys("plus", "bracketright", "Prior", "2", "n", "l") + ev.key("Return", True) +
            ev.ticks(7), "--ground", technique="map-pcss")

    def test_smooth_edges(self):
        self.assert_reproduced(
            ev.drag("Left", (60, 60), (20, 70)), scene=["--scene", "basic", "--size", "160x120"],
            technique="map-soft")

    def test_studio(self):
        model = self.write("a b.obj", models.obj())
        self.assert_reproduced(
            ev.drag("Left", (60, 60), (20, 70)) + ev.drag("Middle", (60, 60), (70, 40)) +
            ev.keys("bracketright", "plus"), scene=[model, "--size", "160x120"],
            technique="map-soft")

    def test_debug_view(self):
        self.assert_reproduced(ev.key("d"), technique="map-pcss")

    def test_names(self):
        self.write("softshadows-002-visibility.exr", "mine")
        _, printed = self.play(ev.keys("s", "S", "space", "s"), technique="map-hard")
        names = sorted(name for name in os.listdir(self.folder) if name.startswith("softshadows"))
        self.assertEqual([name for name in names if name.endswith(".json")],
                         ["softshadows-001.json", "softshadows-003.json", "softshadows-004.json"])
        with open(self.path("softshadows-002-visibility.exr")) as file:
            self.assertEqual(file.read(), "mine")
        self.assertEqual(printed.count("wrote softshadows-"), 3)


class Windows(ViewTest):
    def test_bad_files(self):
        bad = self.write("bad.obj", "what is this\n")
        self.write("events.log", ev.text(ev.keys("c", "space")))
        for model, word in ((bad, "no polygons"), ("missing.obj", "no file")):
            result = self.run_command("view", model, "--size", "200x200", "--play", "events.log",
                                      "--screenshot", "window.png")
            self.assertEqual(result.returncode, 1)
            self.assertIn(word, result.stderr)
            picture = read_png(self.path("window.png"))  # the message, in the window
            self.assertGreater(len(numpy.unique(picture.reshape(-1, 3), axis=0)), 2)

    def test_usage(self):
        self.expect_failure(2, ["nothing to draw"], "view")
        self.expect_failure(2, ["nonsense"], "view", "--scene", "nonsense")
        self.expect_failure(2, ["nonsense", "map-hard"], "view", "--scene", "boxes", "--technique",
                            "nonsense")
        self.expect_failure(1, ["missing.log"], "view", "--scene", "boxes", "--play", "missing.log")

    def test_console(self):
        _, printed = self.play(ev.key("Prior"), technique="map-hard")
        self.assertRegex(printed, r"loaded boxes: \d+ ms")
        self.assertRegex(printed, r"map-hard: light data in [\d.]+ ms")
        self.assertRegex(printed, r"map-hard: \d+ frames, [\d.]+ a second")

    def test_real_keys(self):
        # By the X server's own events, recorded; played again they give the same window.
        try:
            display = ev.Display(ENVIRONMENT["DISPLAY"])
        except OSError as error:
            self.skipTest(str(error))
        self.addCleanup(display.close)
        process = subprocess.Popen(
            [COMMAND, "view", *PLAIN, "--technique", "map-hard", "--record", "real.log",
             "--screenshot", "real.png"], cwd=self.folder, env=ENVIRONMENT, text=True,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.kill)
        while "light data" not in process.stdout.readline():  # then it listens
            self.assertIsNone(process.poll())
        time.sleep(0.5)
        display.move(100, 100)
        for name in ("i", "space", "plus", "c"):
            display.key(name)
        told = process.stdout.readline()
        while "--technique" not in told:
            told = process.stdout.readline()
        display.key("Escape")
        self.assertEqual(process.wait(timeout=60), 0, process.stderr.read())
        self.assertNotIn("--technique map-hard", told)
        real = read_png(self.path("real.png"))
        with open(self.path("real.log")) as file:
            lines = [line for line in file.read().splitlines()
                     if line.startswith(("Key", "#")) and "Escape" not in line]
        self.write("played.log", "\n".join(lines) + "\n")
        result = self.succeed("view", *PLAIN, "--technique", "map-hard", "--play", "played.log",
                              "--screenshot", "played.png")
        self.assertEqual(self.options(result.stdout), self.options(told))
        self.assertTrue((read_png(self.path("played.png")) == real).all())


if __name__ == "__main__":
    unittest.main()
