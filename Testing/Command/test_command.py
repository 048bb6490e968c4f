# SPDX-License-Identifier: BSD-3-Clause
"""Runs the command softshadows as a user does: what it writes, says and returns.

See command_testing for what it needs.
"""

import json
import os
import signal
import subprocess
import time
import unittest

import numpy

import model_files as models
from command_testing import COMMAND, ENVIRONMENT, CommandTest, read_png
from command_testing import start_display as setUpModule  # unittest calls it

SMALL = ["--size", "160x120"]


class HelpAndList(CommandTest):
    def test_help(self):
        self.assertIn("render", self.succeed("--help").stdout)
        for name in ("list", "render", "compare"):
            self.assertIn("Usage: softshadows " + name, self.succeed(name, "--help").stdout)
        self.assertRegex(self.succeed("--version").stdout, r"^softshadows \d+\.\d+\.\d+")

    def test_list(self):
        text = self.succeed("list").stdout
        everything = json.loads(self.succeed("list", "--json").stdout)
        self.assertEqual(sorted(everything), ["scenes", "techniques"])
        for kind in everything.values():
            for one in kind:
                self.assertIn(one["name"], text)
        names = {one["name"] for one in everything["techniques"]}
        self.assertLessEqual({"map-hard", "map-soft"}, names)
        scenes = json.loads(self.succeed("list", "scenes", "--json").stdout)
        self.assertEqual(scenes, {"scenes": everything["scenes"]})

    def test_wrong_usage(self):
        self.expect_failure(2, ["subcommand"])
        self.expect_failure(2, ["nonsense"], "nonsense")
        self.expect_failure(2, ["--nonsense"], "list", "--nonsense")
        self.expect_failure(2, ["nonsense", "techniques"], "list", "nonsense")


class Render(CommandTest):
    def render(self, *arguments, technique="map-hard", name="out.png"):
        result = self.succeed("render", *arguments, *SMALL, "-o", name, "--technique", technique)
        return result, read_png(self.path(name))

    def test_formats(self):
        # The same cube, whatever the file: the same picture, but for the colour of glTF.
        files = {"a.obj": models.obj(), "a.ply": models.ply(), "a.stl": models.stl(),
                 "b.stl": models.binary_stl(), "a.vtp": models.vtp(), "a.vtk": models.vtk(),
                 "grid.vtk": models.grid_vtk(), "a.gltf": models.gltf(), "a.glb": models.glb()}
        pictures = {}
        for name, content in files.items():
            result, pictures[name] = self.render(self.write(name, content), "--ground")
            self.assertIn("14 triangles", result.stdout)
            self.assertEqual(result.stderr, "")
            self.assertEqual(pictures[name].shape, (120, 160, 3))
        for name, picture in pictures.items():
            like = "a.gltf" if name == "a.glb" else "a.obj"
            if name != "a.gltf":
                difference = abs(picture - pictures[like]).max(axis=2)
                self.assertLess((difference > 8).mean(), 0.005, name)
        red = pictures["a.gltf"].astype(int)
        self.assertGreater((red[:, :, 0] - red[:, :, 1] > 60).mean(), 0.05)

    def test_several_models(self):
        moved = [(x + 3, y, z) for x, y, z in models.CUBE]
        self.write("a.obj", models.obj())
        self.write("b.ply", models.ply(moved))
        self.assertIn("26 triangles", self.render("a.obj", "b.ply", "--ground")[0].stdout)

    def test_shadow(self):
        model = self.write("a.obj", models.obj())
        _, plain = self.render(model, "--ground", technique="none")
        for technique in ("map-hard", "map-soft"):
            _, picture = self.render(model, "--ground", technique=technique)
            darker = (plain - picture).max(axis=2)
            self.assertGreater((darker > 30).mean(), 0.02, technique)
            self.assertLess((picture - plain).max(), 3, technique)

    def test_options(self):
        box = [(x, y, 2 * z) for x, y, z in models.CUBE]  # a cube looks the same whatever is up
        model = self.write("a.stl", models.stl(box))
        base = self.render(model, "--ground")[1]
        for options in (["--up", "z"], ["--light-position", "-3,4,-2"],
                        ["--light-shape", "directional"], ["--samples-per-pixel", "0"],
                        ["--background", "0.1,0.2,0.9"], ["--debug-view", "visibility"]):
            picture = self.render(model, "--ground", *options)[1]
            self.assertGreater(abs(picture - base).max(), 8, options)
        directional = ["--ground", "--light-shape", "directional", "--light-position", "-3,4,-2"]
        here, there = (self.render(model, *directional, "--light-target", target)[1]
                       for target in ("0,0,0", "2,0,1"))
        self.assertGreater(abs(here - there).max(), 8)
        corner = self.render(model, "--background", "0.1,0.2,0.9")[1][0, 0]
        self.assertLess(abs(corner - [26, 51, 230]).max(), 3)

    def test_soft_lights(self):
        model = self.write("a.stl", models.stl())
        hard = self.render(model, "--ground", "--light-shape", "point", technique="map-soft")[1]
        for options in (["--light-radius", "1"], ["--light-shape", "disk", "--light-radius", "1"],
                        ["--light-shape", "rectangle", "--light-width", "1", "--light-height", "2"],
                        ["--light-shape", "directional", "--light-angle", "20"]):
            soft = self.render(model, "--ground", "--set", "samples=16", *options,
                               technique="map-soft")[1]
            self.assertGreater((abs(soft - hard).max(axis=2) > 8).mean(), 0.01, options)

    def test_light_without_size(self):
        model = self.write("a.obj", models.obj())
        point, _ = self.render(model, "--ground", "--light-shape", "point", name="point.png")
        zero, _ = self.render(model, "--ground", "--light-radius", "0", name="zero.png")
        self.assertEqual(point.stderr, "")
        self.assertIn("note: the light has no size", zero.stderr)
        self.assertTrue(self.compare("zero.png", "point.png")["equal"])

    def test_shadow_catcher(self):
        model = self.write("a.obj", models.obj())
        options = ["render", model, *SMALL, "--ground", "--technique", "map-hard",
                   "--samples-per-pixel", "0",  # a pixel is in shadow or not
                   "--light-shape", "sphere"]  # the only light: in the studio fills are left
        self.succeed(*options, "-o", "catcher.png", "--shadow-catcher")
        self.succeed(*options, "-o", "picture.png")
        alpha = read_png(self.path("catcher.png"))[..., 3]
        picture = read_png(self.path("picture.png"))
        self.assertEqual(picture.shape[2], 3)
        self.assertGreater((alpha == 0).mean(), 0.3)  # the ground in light, and the background
        self.assertGreater((alpha == 255).mean(), 0.05)  # the model, and a hard shadow
        # At a hard shadow's edge alone, which is filtered over a texel.
        self.assertLess(((alpha > 0) & (alpha < 255)).mean(), 0.005)
        self.expect_failure(2, ["--ground"], "render", model, "-o", "a.png", "--shadow-catcher")
        self.expect_failure(2, ["--shadow-catcher"], "render", model, "--ground", "-o", "a.png",
                            "--technique", "none", "--shadow-catcher")

    def test_outputs(self):
        result = self.succeed(
            "render", "--scene", "blocker", *SMALL, "-o", "out.png", "--visibility", "v.exr",
            "--stats", "stats.json", "--frames", "3", "--quality", "low", "--set",
            "samples=4", "--json")
        self.assertEqual(sorted(os.listdir(self.folder)), ["out.png", "stats.json", "v.exr"])
        with open(self.path("stats.json")) as file:
            stats = json.load(file)
        self.assertEqual(json.loads(result.stdout), stats)
        self.assertEqual(stats["technique"], "map-pcss")
        self.assertEqual(stats["parameters"]["samples"], "4")
        self.assertEqual(stats["size"], [160, 120])
        self.assertEqual(stats["scene"]["triangles"], 4)
        self.assertGreater(stats["frame_milliseconds"], 0)
        self.assertIn("bytes", stats["pass"])
        same = json.loads(self.succeed("compare", "v.exr", "v.exr", "--json").stdout)
        self.assertEqual(same["visibility"]["rmse"], 0)

    def test_points_that_are_not_finite(self):
        for name, content in (("a.obj", models.obj(models.NAN_CUBE)),
                              ("a.ply", models.ply(models.NAN_CUBE)),
                              ("b.ply", models.ply(models.INFINITE_CUBE)),
                              ("a.vtp", models.vtp(models.NAN_CUBE)),
                              ("a.gltf", models.gltf(models.NAN_CUBE))):
            result, _ = self.render(self.write(name, content), "--ground")
            self.assertRegex(result.stderr, 'warning: "%s": 1 of 8 points is not finite' % name)
        result, _ = self.render(self.write("a.stl", models.stl(models.NAN_CUBE)), "--ground")
        self.assertIn("points are not finite", result.stderr)

    def test_degenerate_triangles(self):
        faces = models.QUADS + [(0, 0, 0), (1, 1, 2)]
        result, _ = self.render(self.write("a.obj", models.obj(faces=faces)), "--ground")
        self.assertEqual(result.stderr, "")


class Failures(CommandTest):
    def refuse(self, code, words, *arguments):
        self.expect_failure(code, words, "render", *arguments, *SMALL, "-o", "out.png")

    def test_models(self):
        nan = [("nan", 0, 0)] * 8
        bad = {"empty.obj": ("", "empty"),
               "points.obj": (models.obj(faces=[]), "no polygons"),
               "garbage.obj": ("what is this\n", "no polygons"),
               "garbage.stl": ("x" * 100, ""),
               "garbage.ply": ("x" * 100, ""),
               "garbage.vtp": ("<a>", ""),
               "garbage.vtk": ("x\ny\n", ""),
               "garbage.gltf": ("{", ""),
               "garbage.glb": ("x" * 100, ""),
               "cut.ply": (models.ply()[:-20], ""),  # VTK's reader crashes on these two
               "cut.vtk": (models.vtk()[:-20], ""),
               "cut.vtp": (models.vtp()[:-200], ""),
               "image.vtk": (models.image_vtk(), "no polygons"),
               "nan.obj": (models.obj(nan), "8 of 8 points"),
               "nan.ply": (models.ply(nan), "8 of 8 points"),
               "index.obj": (models.obj(faces=[(0, 1, 99)]), "points that are not there"),
               "a.xyz": ("1 2 3", "Known: obj")}
        for name, (content, word) in bad.items():
            self.refuse(1, [name, word], self.write(name, content))
        self.refuse(1, ["missing.obj", "no file"], "missing.obj")
        os.mkdir(self.path("folder.obj"))
        self.refuse(1, ["folder.obj", "folder"], "folder.obj")
        self.write("good.obj", models.obj())
        self.refuse(1, ["missing.obj"], "good.obj", "missing.obj")

    def test_values(self):
        model = self.write("a.obj", models.obj())
        for words, arguments in (
                (["nonsense", "map-hard"], ["--technique", "nonsense"]),
                (["nonsense", "resolution"], ["--set", "nonsense=1"]),
                (["resolution", "-5"], ["--set", "resolution=-5"]),
                (["filter", "nearest"], ["--set", "filter=nonsense"]),
                (["nonsense"], ["--set", "nonsense:samples=3"]),
                (["nonsense", "reference"], ["--quality", "nonsense"]),
                (["nonsense", "visibility"], ["--debug-view", "nonsense"]),
                (["blob", "sphere"], ["--light-shape", "blob"]),
                (["--light-radius"], ["--light-radius", "-1"]),
                (["--light-radius"], ["--light-radius", "nan"]),
                (["--light-angle"], ["--light-shape", "directional", "--light-angle", "100"]),
                (["target"], ["--light-shape", "disk", "--light-position", "1,1,1",
                              "--light-target", "1,1,1"]),
                (["0x5"], ["--size", "0x5"]), (["99999"], ["--size", "99999x5"]),
                (["--up", "'w'"], ["--up", "w"]), (["--background"], ["--background", "2,0,0"]),
                (["--samples-per-pixel"], ["--samples-per-pixel", "9"]),
                (["--frames"], ["--frames", "0"])):
            self.expect_failure(2, words, "render", model, "-o", "out.png", *arguments)
        self.refuse(2, ["nonsense", "blocker"], "--scene", "nonsense")
        self.refuse(2, ["bunny", "triangles"], "--scene", "bunny", "--triangles", "5")
        self.refuse(2, ["plant", "2000000"], "--scene", "plant", "--triangles", "5")

    def test_usage(self):
        model = self.write("a.obj", models.obj())
        for words, arguments in (
                (["--output"], [model]), (["nothing to draw"], ["-o", "out.png"]),
                (["exclude"], [model, "--scene", "bunny", "-o", "out.png"]),
                (["--nonsense"], [model, "-o", "out.png", "--nonsense"]),
                (["samples"], [model, "-o", "out.png", "--set", "samples"]),
                (["1,2"], [model, "-o", "out.png", "--light-position", "1,2"]),
                (["abc"], [model, "-o", "out.png", "--light-radius", "abc"]),
                (["10"], [model, "-o", "out.png", "--size", "10"]),
                (["--light-angle", "sphere"], [model, "-o", "out.png", "--light-angle", "3"]),
                (["--triangles"], [model, "-o", "out.png", "--triangles", "100000"]),
                (["twice"], [model, "-o", "out.png", "--visibility", "out.png"]),
                (["--visibility"], [model, "-o", "out.png", "--technique", "none",
                                    "--visibility", "v.exr"])):
            self.expect_failure(2, words, "render", *arguments)

    def test_places(self):
        model = self.write("a.obj", models.obj())
        self.write("file", "")
        os.mkdir(self.path("folder.png"))
        for words, arguments in (
                (["none/out.png", "folder"], ["-o", "none/out.png"]),
                (["out.nonsense"], ["-o", "out.nonsense"]),
                (["\"out\"", "extension"], ["-o", "out"]), (["folder.png"], ["-o", "folder.png"]),
                (["file/out.png"], ["-o", "file/out.png"]),
                (["/proc/out.png"], ["-o", "/proc/out.png"]),
                (["none/s.json"], ["-o", "out.png", "--stats", "none/s.json"]),
                (["v.gif"], ["-o", "out.png", "--visibility", "v.gif"])):
            self.expect_failure(1, words, "render", model, *SMALL, *arguments)

    def test_old_files_stay(self):
        old = self.write("out.png", "old")
        self.refuse(1, ["missing.obj"], "missing.obj")
        self.write("nan.obj", models.obj([("nan", 0, 0)] * 8))
        self.refuse(1, ["nan.obj"], "nan.obj")
        os.chmod(self.path(old), 0o444)
        self.refuse(1, ["out.png", "write-protected"], "--scene", "blocker")
        with open(self.path(old)) as file:
            self.assertEqual(file.read(), "old")

    def test_display(self):
        none = {k: v for k, v in ENVIRONMENT.items() if k != "DISPLAY"}
        arguments = ["render", "--scene", "blocker", "-o", "out.png"]
        self.expect_failure(1, ["DISPLAY", "Xvfb"], *arguments, environment=none)
        away = dict(none, DISPLAY=":7654")
        self.expect_failure(1, [":7654", "Xvfb"], *arguments, environment=away)

    def test_interrupt(self):
        process = subprocess.Popen(
            [COMMAND, "compare", "--scene", "huge", "--reference-samples", "16384", "-o", "out"],
            cwd=self.folder, env=ENVIRONMENT, stderr=subprocess.DEVNULL)
        time.sleep(1.5)
        process.send_signal(signal.SIGINT)
        self.assertNotEqual(process.wait(timeout=30), 0)
        self.assertEqual(os.listdir(self.folder), [])


class Compare(CommandTest):
    def has_reference(self):
        described = json.loads(self.succeed("list", "techniques", "--json").stdout)
        return "ray-traced" in [one["name"] for one in described["techniques"]]

    def test_techniques(self):
        if not self.has_reference():
            self.skipTest("no ray-traced reference in this build")
        command = ["compare", "--scene", "blocker", *SMALL, "--reference-samples", "64",
                   "--frames", "2"]
        result = json.loads(self.succeed(
            *command, "--techniques", "map-soft,map-hard,ray-traced", "--set", "samples=16",
            "--set", "map-soft:samples=32", "-o", "out", "--json").stdout)
        rows = {row["technique"]: row for row in result["techniques"]}
        self.assertEqual(list(rows), ["none", "map-soft", "map-hard", "ray-traced"])
        self.assertEqual(rows["map-soft"]["parameters"]["samples"], "32")
        self.assertEqual(rows["ray-traced"]["parameters"]["samples"], "16")
        error = {name: row["visibility"]["rmse"] for name, row in rows.items()}
        self.assertLess(error["map-soft"], 0.5 * error["map-hard"])
        self.assertLess(error["map-hard"], error["none"])
        self.assertEqual(rows["none"]["added_milliseconds"], 0)
        self.assertGreater(rows["map-hard"]["bytes"], 0)
        self.assertGreater(rows["map-soft"]["picture"]["correctness_percent"],
                           rows["none"]["picture"]["correctness_percent"])
        names = ["reference.png"] + [n + end for n in rows for end in (".png", "-difference.png")]
        self.assertEqual(sorted(os.listdir(self.path("out"))), sorted(names))

        table = self.succeed(*command, "--techniques", "map-hard").stdout.splitlines()
        self.assertTrue(table[0].startswith("blocker: 4 triangles"))
        self.assertEqual([line.split()[0] for line in table[1:]], ["technique", "none", "map-hard"])

    def test_all_techniques_of_a_model(self):
        if not self.has_reference():
            self.skipTest("no ray-traced reference in this build")
        model = self.write("a.ply", models.ply())
        result = json.loads(self.succeed(
            "compare", model, "--ground", *SMALL, "--reference-samples", "64", "--frames", "1",
            "--quality", "low", "--json").stdout)
        described = json.loads(self.succeed("list", "techniques", "--json").stdout)["techniques"]
        names = [row["technique"] for row in result["techniques"]]
        self.assertEqual(sorted(names[1:]), sorted(one["name"] for one in described))
        hard = [one["name"] for one in described if one["hard"]]
        self.assertEqual(names[:1 + len(hard)], ["none"] + hard)

    def test_failures(self):
        scene = ["compare", "--scene", "blocker"]
        self.expect_failure(2, ["nonsense"], *scene, "--techniques", "nonsense")
        self.expect_failure(2, ["nonsense"], *scene, "--set", "nonsense=1")
        self.expect_failure(2, ["map-soft"], *scene, "--techniques", "map-hard",
                  "--set", "map-soft:samples=4")
        self.expect_failure(1, ["none/out"], *scene, "-o", "none/out")
        self.expect_failure(2, ["--frames"], *scene, "--frames", "0")
        self.expect_failure(2, ["nothing to draw"], "compare")
        if self.has_reference():
            self.expect_failure(2, ["--reference-samples"], *scene, "--reference-samples", "0")

    def test_pictures(self):
        scene = ["render", "--scene", "blocker"]
        self.succeed(*scene, *SMALL, "-o", "a.png", "--technique", "map-hard")
        self.succeed(*scene, *SMALL, "-o", "b.png", "--technique", "none")
        self.succeed(*scene, "--size", "80x60", "-o", "c.png", "--technique", "none")
        a, b = read_png(self.path("a.png")), read_png(self.path("b.png"))
        metrics = self.compare("a.png", "b.png")
        rmse = numpy.sqrt((((a - b) / 255.0) ** 2).mean())
        self.assertAlmostEqual(metrics["rmse"], rmse, places=5)
        correct = 100.0 * (abs(a - b) <= 4).mean()
        self.assertAlmostEqual(metrics["correctness_percent"], correct, places=5)
        self.assertTrue(self.compare("a.png", "a.png")["equal"])
        self.assertIn("PSNR", self.succeed("compare", "a.png", "b.png", "-o", "d.png").stdout)
        self.assertEqual(read_png(self.path("d.png")).shape, (120, 160, 3))
        self.expect_failure(1, ["c.png", "80 x 60"], "compare", "a.png", "c.png")
        self.expect_failure(1, ["missing.png"], "compare", "a.png", "missing.png")
        self.expect_failure(1, ["e.png"], "compare", "a.png", self.write("e.png", "no picture"))
        self.expect_failure(2, ["two at a time"], "compare", "a.png", "b.png", "c.png")
        self.expect_failure(2, ["--size"], "compare", "a.png", "b.png", "--size", "3x3")
        self.expect_failure(2, ["a.png"], "compare", "a.png", "b.png", "-o", "a.png")


if __name__ == "__main__":
    unittest.main()
