# SPDX-License-Identifier: BSD-3-Clause
"""What users' disks, pipes and damaged files do to the command softshadows: one clear message, no
crash, no end that does not come, and nothing lost that was there before.

See command_testing for what it needs.
"""

import json
import os
import resource
import struct
import subprocess
import unittest

import model_files as models
from command_testing import COMMAND, ENVIRONMENT, CommandTest
from command_testing import start_display as setUpModule  # unittest calls it

SMALL = ["--size", "60x45", "--technique", "none"]
SCENE = ["render", "--scene", "blocker", *SMALL]
MiB = 1 << 20


class Models(CommandTest):
    def refuse(self, name, content, *words):
        self.write(name, content)
        self.expect_failure(1, [name, *words], "render", name, *SMALL, "-o", "out.png")

    def test_cut_short(self):
        floats = struct.pack(">24f", *(c for p in models.CUBE for c in p))
        binary = b"# vtk DataFile Version 3.0\ntest\nBINARY\nDATASET POLYDATA\nPOINTS 8 float\n"
        grid = ("# vtk DataFile Version 3.0\ntest\nASCII\nDATASET STRUCTURED_GRID\n"
                "DIMENSIONS 2 2 2\nPOINTS 8 float\n" + models.points_text(models.CUBE))
        self.refuse("binary.vtk", binary + floats[:50])
        self.refuse("grid.vtk", grid[:-20])
        self.refuse("a.stl", models.binary_stl()[:-70], "cut short", "10 of its 12")
        self.refuse("b.stl", models.stl()[:-60])
        # A count that is too small is common; what is there is taken.
        whole = models.binary_stl()
        self.write("c.stl", whole[:80] + struct.pack("<I", 3) + whole[84:])
        self.assertIn(" 12 triangles", self.succeed("render", "c.stl", *SMALL, "-o", "o.png").stdout)

    def test_sizes_that_nothing_has(self):
        self.refuse("a.ply", models.ply().replace("vertex 8", "vertex -1e300"), "damaged")
        self.refuse("b.ply", models.ply().replace("vertex 8", "vertex 2000000000"))
        self.refuse("a.vtp", models.vtp().replace('NumberOfPoints="8"',
                                                  'NumberOfPoints="400000000000"'), "memory")
        # VTK's reader alone has not read this in minutes.
        self.refuse("b.vtp", models.vtp().replace('NumberOfComponents="3"',
                                                  'NumberOfComponents="2147483648"'))
        self.refuse("a.gltf", models.gltf().replace('"nodes": [{"mesh": 0}]',
                                                    '"nodes": [{"matrix": ["x"]}]'))
        self.refuse("b.gltf", "[" * 1000000)
        offsets = models.vtp().replace(">4 8 12 16 20 24<", ">4 8 12 16 20 99<")
        self.assertNotEqual(offsets, models.vtp())
        self.refuse("c.vtp", offsets)

    def test_compressed_data_that_is_damaged(self):
        # VTK says "Aborting", which is also what its window says that finds no display.
        text = models.vtp()
        start = text.index("<Points>") + len("<Points>")
        end = text.index("</Points>")
        text = (text[:start] + '<DataArray type="Float32" NumberOfComponents="3" format="appended" '
                'offset="999"/>' + text[end:])
        text = text.replace("<VTKFile ", '<VTKFile compressor="vtkZLibDataCompressor" '
                            'header_type="UInt32" ')
        self.refuse("a.vtp", text.replace("</VTKFile>", '<AppendedData encoding="raw">_</AppendedData>'
                                          "</VTKFile>"))

    def test_faces_of_several_forms(self):
        points = models.points_text(models.CUBE, "v ")
        more = "vt 0 0\nvn 0 0 1\nvn 0 1 0\n"
        faces = "f 1 4 3 2\nf 5/1 6/1 7/1 8/1\nf 1//1 2//1 6//1 5//1\nf 2/1/1 3/1/1 7/1/1 6/1/1\n"
        for name, text in (("all.obj", points + more + faces),
                           ("within.obj", points + more + "f 1/1/1 4 3//2 2/1\nf 5 6 7 8\n" * 2),
                           ("unused.obj", points + more + "f 1 4 3 2\n" * 4),
                           ("lines.obj", points + more + faces.replace(" 3", " \\\n3")),
                           ("textures.obj", points + more + "f 5/1 6/1 7/1 8/1\nf 1 2 3 4\n" * 2)):
            result = self.succeed("render", self.write(name, text), *SMALL, "-o", "out.png")
            self.assertIn(" 8 triangles", result.stdout, name)
            self.assertEqual(result.stderr, "", name)

    def test_a_flood_of_warnings(self):
        lines = "".join("line %d\n" % i for i in range(3000))
        text = models.vtk().replace("POLYGONS", "METADATA\nINFORMATION 3000\n" + lines +
                                    "\nPOLYGONS")
        name = self.write("a.vtk", text)
        result = self.succeed("render", name, *SMALL, "-o", "out.png")
        self.assertIn('warning: "a.vtk": ', result.stderr)
        self.assertRegex(result.stderr, "warning: [0-9]+ more")
        self.assertLess(len(result.stderr.splitlines()), 25)

    def test_no_regular_files(self):
        os.mkfifo(self.path("pipe.obj"))
        os.symlink("/dev/zero", self.path("zero.ply"))
        os.symlink("/dev/zero", self.path("zero.json"))
        os.symlink("/dev/zero", self.path("zero.png"))
        for name in ("pipe.obj", "zero.ply"):
            self.expect_failure(1, [name, "regular"], "render", name, *SMALL, "-o", "out.png")
        for name in ("pipe.obj", "zero.json"):
            self.expect_failure(1, [name, "regular"], "bench", "--suite", name, "-o", "out")
        self.expect_failure(1, ["zero.png", "regular"], "compare", "zero.png", "zero.png")

    def test_control_characters(self):
        for name, content in (("a.ply", models.ply().replace("float x", "\x1b]0;x\x07 x")),
                              ("b.vtk", models.vtk().replace("POLYGONS", "\x1b[31mPOLY\xc2\x9b")),
                              ("c\x1b[2J.obj", "nothing")):
            self.write(name, content)
            result = self.run_command("render", name, *SMALL, "-o", "out.png")
            self.assertEqual(result.returncode, 1)
            self.assertNotRegex(result.stderr[:-1], "[\x00-\x1f\x7f-\x9f]", name)
        suite = {"title": "t", "size": [16, 16], "reference": 0, "budget": 1, "frames": 1,
                 "cases": [{"scene": "blocker", "name": "\x1b[31mred"}],
                 "entries": [{"technique": "map-hard"}]}
        name = self.write("a.json", json.dumps(suite))
        self.assertNotIn("\x1b", self.succeed("bench", "--suite", name).stdout)
        name = self.write("b.json", '{"title": "\x1b[31m"}')
        self.assertNotIn("\x1b", self.run_command("bench", "--suite", name).stderr)


class Outputs(CommandTest):
    def run_with(self, *arguments, limits=(), **more):
        def set_limits():
            for kind, value in limits:
                resource.setrlimit(kind, (value, value))
        return subprocess.run([COMMAND, *arguments], cwd=self.folder, text=True, timeout=120,
                              env=ENVIRONMENT, stderr=subprocess.PIPE, preexec_fn=set_limits, **more)

    def test_standard_output_is_full(self):
        suite = ["--techniques", "map-hard", "--frames", "1", "--size", "16x16"]
        picture = self.write("a.obj", models.obj())
        self.succeed(*SCENE, "-o", "a.png")
        for arguments in (["--help"], ["--version"], ["list"], ["list", "--json"],
                          [*SCENE, "-o", "out.png"], [*SCENE, "-o", "out.png", "--json"],
                          ["render", picture, *SMALL, "-o", "out.png"],
                          ["compare", "a.png", "a.png"],
                          ["bench", "--scene", "blocker", *suite, "--budget", "1",
                           "--reference-samples", "0"]):
            with open("/dev/full", "w") as full:
                result = self.run_with(*arguments, stdout=full)
            self.assertEqual(result.returncode, 1, arguments)
            self.assertRegex(result.stderr, "error: cannot write to standard output: ", arguments)

    def test_standard_output_is_closed(self):
        model = self.write("a.obj", models.obj())
        for arguments in (["list"], ["render", model, *SMALL, "-o", "out.png"]):
            result = subprocess.run(["/bin/sh", "-c", '"$@" >&-', "sh", COMMAND, *arguments],
                                    cwd=self.folder, env=ENVIRONMENT, stderr=subprocess.PIPE,
                                    text=True, timeout=120)
            self.assertEqual(result.returncode, 1)
            self.assertIn("standard output", result.stderr)
        with open(self.path(model)) as file:
            self.assertEqual(file.read(), models.obj())

    def test_files_cannot_grow(self):
        # As on a full disk; and no file stays behind.
        self.write("out.png", "old")
        for name in ("out.png", "s.json"):
            arguments = [*SCENE[:3], "--technique", "none", "--size", "900x700", "-o", "out.png",
                         "--stats", "s.json"]
            size = 2000 if name == "out.png" else 100
            result = self.run_with(*arguments, limits=[(resource.RLIMIT_FSIZE, size)],
                                   stdout=subprocess.DEVNULL)
            self.assertEqual(result.returncode, 1, result.stderr)
            self.assertRegex(result.stderr, 'error: cannot write "(out.png|s.json)"')
            self.assertEqual(os.listdir(self.folder), ["out.png"])
        with open(self.path("out.png")) as file:
            self.assertEqual(file.read(), "old")

    def test_inputs_stay(self):
        model = self.write("a.obj", models.obj())
        os.symlink(model, self.path("link.json"))
        os.link(self.path(model), self.path("same.json"))
        for name in ("a.obj", "link.json", "./same.json"):
            self.expect_failure(2, [name, "input"], "render", model, *SMALL, "-o", "out.png",
                                "--stats", name)
        os.rename(self.path("same.json"), self.path("same.png"))
        self.expect_failure(2, ["same.png", "input"], "render", model, *SMALL, "-o", "same.png")
        # And what a model refers to.
        description, data = models.gltf_parts()
        description["buffers"][0]["uri"] = "data.png"
        self.write("data.png", data)
        gltf = self.write("a.gltf", json.dumps(description))
        self.expect_failure(2, ["data.png", "input"], "render", gltf, *SMALL, "-o", "data.png")
        # Of what is written into a folder, too.
        os.mkdir(self.path("out"))
        suite = {"title": "t", "reference": 0, "cases": [{"scene": "blocker"}],
                 "entries": [{"technique": "map-hard"}]}
        self.write("out/results.json", json.dumps(suite))
        self.expect_failure(2, ["out/results.json", "input"], "bench", "--suite",
                            "out/results.json", "-o", "out")
        with open(self.path(model)) as file:
            self.assertEqual(file.read(), models.obj())

    def test_standard_output_is_no_file(self):
        with open(self.path("printed"), "w") as printed:
            for name in ("/dev/stdout", "printed"):
                result = self.run_with(*SCENE, "-o", "out.png", "--stats", name, stdout=printed)
                self.assertEqual(result.returncode, 1)
                self.assertIn("--json", result.stderr)
        self.expect_failure(1, ["/dev/stdout", "--json"], *SCENE, "-o", "out.png", "--stats",
                            "/dev/stdout")

    def test_folders_with_a_slash(self):
        fast = ["--techniques", "map-hard", "--size", "16x16", "--frames", "1",
                "--reference-samples"]
        self.succeed("bench", "--scene", "blocker", *fast, "0", "--budget", "1", "-o", "new/")
        self.assertIn("results.json", os.listdir(self.path("new")))
        described = json.loads(self.succeed("list", "techniques", "--json").stdout)["techniques"]
        if "ray-traced" in [one["name"] for one in described]:
            self.succeed("compare", "--scene", "blocker", *fast, "4", "-o", "other/")
            self.assertIn("map-hard.png", os.listdir(self.path("other")))

    def test_names_that_are_no_text(self):
        name = os.fsdecode(b"a\xff.obj")
        self.write(name, models.obj())
        result = self.succeed("render", name, *SMALL, "-o", "out.png", "--json", "--stats", "s.json")
        self.assertEqual(json.loads(result.stdout)["scene"]["triangles"], 12)


class Arguments(CommandTest):
    def test_values_that_are_empty(self):
        for option in ("--technique", "--quality", "--up", "--light-shape", "--light-radius",
                       "--stats", "--visibility", "--debug-view", "--set"):
            self.expect_failure(2, [option, "empty"], *SCENE[:3], "-o", "out.png", option, "")
        for option in ("--suite", "--techniques", "--sweep", "--lights", "--budget", "-o"):
            words = ["--output" if option == "-o" else option, "empty"]
            self.expect_failure(2, words, "bench", "--scene", "blocker", option, "")
        self.expect_failure(2, ["empty"], "render", "", "-o", "out.png")
        self.expect_failure(2, ["empty"], "list", "")

    def test_numbers(self):
        for value in ("nan", "inf", "0", "1e7", "-3", "5x"):
            self.expect_failure(2, ["--budget", value, "from 1"], "bench", "--scene", "blocker",
                                "--budget", value)

    def test_values_are_usage_and_files_are_not(self):
        # 2: what is wrong with the command line alone; 1: with what it names.
        light = ["--light-shape", "disk", "--light-position", "1,1,1", "--light-target", "1,1,1"]
        for code, words, arguments in (
                (2, ["nonsense", "map-hard"], [*SCENE[:3], "--technique", "nonsense"]),
                (2, ["target"], [*SCENE[:3], *light]),
                (2, ["--frames"], [*SCENE, "--frames", "0"]),
                (1, ["missing.obj"], ["render", "missing.obj"]),
                (1, ["none/out.png"], [*SCENE, "-o", "none/out.png"])):
            out = [] if "-o" in arguments else ["-o", "out.png"]
            self.expect_failure(code, words, *arguments, *out)

    def suite(self, words, **change):
        suite = {"title": "t", "reference": 0, "cases": [{"scene": "blocker", "size": [16, 16]}],
                 "entries": [{"technique": "map-hard"}]}
        name = self.write("bad.json", json.dumps(dict(suite, **change)))
        self.expect_failure(1, ["bad.json", *words], "bench", "--suite", name, "-o", "out")

    def test_suites_in_their_own_words(self):
        self.suite(["[entries][0]", "one of technique or peer"], entries=[{}])
        self.suite(["one of technique or peer"],
                   entries=[{"technique": "map-hard", "peer": "ray-traced"}])
        self.suite(["[axis]", "none of triangles, lights", "or light-size"],
                   cases=[{"scene": "blocker", "axis": "x"}])
        self.suite(["'siez'", "title", "entries"], siez=3)
        self.suite(["[technique]", "string"], entries=[{"technique": 3}])
        self.suite(["[set][0]", "NAME=VALUE"], cases=[{"scene": "blocker", "set": ["x"]}])
        values = [str(i) for i in range(100)]
        self.suite(["combinations"], entries=[
            {"technique": "map-pcss", "sweep": {name: values for name in "abcd"}}])
        self.suite(["[triangles]"], cases=[{"scene": "plant", "triangles": 4294967297}])
        self.suite(["nonsense", "blocker"], cases=[{"scene": "nonsense"}])
        # A light that the scene does not have is the suite's fault, and one case's alone.
        suite = {"title": "t", "reference": 0, "frames": 1, "budget": 1, "size": [16, 16],
                 "cases": [{"scene": "blocker", "name": "a", "light": {"radius": 1}},
                           {"scene": "blocker", "name": "b"}],
                 "entries": [{"technique": "map-hard"}]}
        name = self.write("light.json", json.dumps(suite))
        result = self.run_command("bench", "--suite", name)
        self.assertEqual(result.returncode, 1)
        self.assertIn("b: 4 triangles", result.stdout)
        self.assertRegex(result.stderr, "error: a: --light-radius")

    def test_memory_of_a_picture(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_AS, (1600 * MiB, 1600 * MiB))
        result = subprocess.run(
            [COMMAND, "render", "--scene", "blocker", "--technique", "none", "-o", "out.png",
             "--size", "16384x16384"],
            cwd=self.folder, env=ENVIRONMENT, text=True, capture_output=True, timeout=120,
            preexec_fn=limit)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn("16384x16384", result.stderr)
        self.assertEqual(os.listdir(self.folder), [])


if __name__ == "__main__":
    unittest.main()
