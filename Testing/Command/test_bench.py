# SPDX-License-Identifier: BSD-3-Clause
"""Runs softshadows bench as a user does: what its three files hold, and what it refuses.

See command_testing for what it needs. Without jsonschema the form of results.json is not tested.
"""

import csv
import html
import json
import math
import os
import pathlib
import re
import signal
import subprocess
import time
import unittest

import numpy

import model_files as models
from command_testing import COMMAND, ENVIRONMENT, CommandTest
from command_testing import start_display as setUpModule  # unittest calls it

try:
    import jsonschema
except ImportError:
    jsonschema = None

ROOT = pathlib.Path(__file__).parents[2]
FILES = ["report.html", "results.csv", "results.json"]
# Square, since VTK 9.1's own pass is wrong in windows that are not.
SMALL = ["--size", "100x100", "--reference-samples", "64"]
FEW = ["--techniques", "map-hard,map-pcss,map-soft,vtkShadowMapPass,ray-traced",
       "--sweep", "map-pcss:samples=8,32", "--sweep", "map-soft:samples=4,16",
       "--sweep", "map-hard:resolution=256,512", "--sweep", "ray-traced:samples=1,4,16"]
SCENE = ["bench", "--scene", "blocker", *SMALL, "--frames", "3", "--budget", "8"]
PIXELS = ("penumbra", "all")
TIMES = ("static", "dynamic")


def measured(case):
    return [entry for entry in case["entries"] if "skipped" not in entry]


def error_of(entry, pixels):
    return (entry["error"]["penumbra"] if pixels == "penumbra" else entry["error"])["rmse"]


def added(entry, time_kind):
    return entry["time"][time_kind]["added"]["median"]


def one_case(entries, **more):
    return {"title": "A test", "size": [60, 45], "reference": 0, "frames": 3, "budget": 8,
            "cases": [dict({"scene": "blocker"}, **more)], "entries": entries}


class BenchTest(CommandTest):
    def read(self, *names):
        with open(self.path(os.path.join(*names, "results.json"))) as file:
            return json.load(file)

    def bench(self, *arguments, name="out"):
        self.succeed(*arguments, "-o", name)
        self.assertEqual(sorted(os.listdir(self.path(name))), FILES)
        return self.read(name)

    def validate(self, results):
        if jsonschema is None:
            self.skipTest("no jsonschema")
        with open(ROOT / "Documentation/results/results.schema.json") as file:
            schema = json.load(file)
        jsonschema.validate(results, schema)

    def settings(self, results, technique):
        return [entry["setting"] for entry in results["cases"][0]["entries"]
                if entry["technique"] == technique]


class Suites(unittest.TestCase):
    def test_form(self):
        if jsonschema is None:
            self.skipTest("no jsonschema")
        folder = ROOT / "Apps/softshadows/suites"
        schema = json.loads((folder / "suite.schema.json").read_text())
        suites = [path for path in sorted(folder.glob("*.json")) if "schema" not in path.name]
        suites += sorted((ROOT / "Testing/Benchmark").glob("*.json"))
        self.assertIn("quick.json", [path.name for path in suites])
        for path in suites:
            suite = json.loads(path.read_text())
            jsonschema.validate(suite, schema)
            keys = {case.get("published") for case in suite.get("cases", [])} - {None}
            names = [case.get("name", case["scene"]) for case in suite.get("cases", [])]
            self.assertEqual(len(names), len(set(names)), path.name)
            for entry in suite["entries"]:
                figures = entry.get("published", {}).get("milliseconds")
                self.assertIn(keys if figures else set(), (set(), set(figures or {})), path.name)


class Report(BenchTest):
    """One run, looked at from all sides."""

    shared = None

    def setUp(self):
        super().setUp()
        if Report.shared is None:
            Report.shared = self.bench(*SCENE, *FEW)
            for name in FILES[:2]:
                with open(self.path(os.path.join("out", name))) as file:
                    setattr(Report, name.split(".")[1], file.read())
        self.results = Report.shared
        self.case = self.results["cases"][0]

    def candidates(self):
        return [entry for entry in measured(self.case) if entry["kind"] != "none"]

    def test_form(self):
        self.validate(self.results)

    def test_what_was_measured(self):
        self.assertTrue(self.results["complete"])
        self.assertEqual(self.results["suite"], "quick")
        self.assertEqual(self.case["scene"]["name"], "blocker")
        self.assertEqual(self.case["scene"]["triangles"], 4)
        self.assertEqual(self.case["size"], [100, 100])
        self.assertEqual(self.case["reference"]["samples"], 64)
        self.assertGreater(self.case["reference"]["noise"]["rmse"], 0)
        ids = [entry["id"] for entry in self.case["entries"]]
        self.assertEqual(len(ids), len(set(ids)))
        self.assertEqual(ids[0], "none")
        for technique, name, values in (
                ("map-pcss", "samples", ["8", "32"]), ("map-soft", "samples", ["4", "16"]),
                ("map-hard", "resolution", ["256", "512"]),
                ("ray-traced", "samples", ["1", "4", "16"])):
            self.assertEqual(self.settings(self.results, technique), [{name: v} for v in values])
        self.assertEqual(len(self.settings(self.results, "vtkShadowMapPass")), 1)
        for entry in measured(self.case):
            for kind in TIMES:
                figures = entry["time"][kind]
                self.assertGreaterEqual(figures["frames"], 3)
                self.assertLessEqual(figures["lower"], figures["median"])
                self.assertLessEqual(figures["median"], figures["upper"])
        # Rays are told of what traces some.
        for entry in measured(self.case):
            traces = entry["technique"].startswith("ray-")
            self.assertEqual(entry["megarays_per_second"] is not None, traces, entry["id"])
            self.assertTrue(not traces or entry["megarays_per_second"] > 0.0)
        kinds = {entry["technique"]: entry["kind"] for entry in self.candidates()}
        self.assertEqual(kinds["vtkShadowMapPass"], "peer")
        self.assertEqual(kinds["map-hard"], "technique")

    def test_csv(self):
        rows = list(csv.DictReader(Report.csv.splitlines()))
        entries = self.case["entries"]
        self.assertEqual([row["entry"] for row in rows], [entry["id"] for entry in entries])
        self.assertEqual({row["case"] for row in rows}, {self.case["id"]})
        for row, entry in zip(rows, entries):
            figures = {"rmse": entry["error"]["rmse"], "bytes": entry["bytes"],
                       "penumbra_rmse": error_of(entry, "penumbra"),
                       "maximum": entry["error"]["maximum"],
                       "correctness_percent": entry["picture"]["correctness_percent"],
                       "psnr_db": entry["picture"]["psnr_db"],
                       "megarays_per_second": entry["megarays_per_second"],
                       "build_ms": entry["time"]["build_milliseconds"]}
            for kind in TIMES:
                figures[kind + "_ms"] = entry["time"][kind]["median"]
                figures[kind + "_added_ms"] = added(entry, kind)
                figures[kind + "_ratio"] = entry["time"][kind]["ratio"]
            for name, figure in figures.items():
                self.assertEqual(row[name], "" if figure is None else row[name], entry["id"])
                if figure is not None:
                    self.assertAlmostEqual(float(row[name]), figure, places=9, msg=name)

    def test_html(self):
        text = Report.html
        links = re.findall(r"""\b(?:src|href|action|poster)\s*=\s*["']?([^"'\s>]+)""", text)
        links += re.findall(r"""url\(\s*["']?([^"')]+)""", text)
        for link in links:
            self.assertRegex(link, "^(#|data:)")
        self.assertNotIn("@import", text)
        shown = html.unescape(text)
        for entry in self.case["entries"]:
            self.assertIn(entry["id"], shown)

    def test_fronts(self):
        entries = self.candidates()
        for pixels in PIXELS:
            for kind in TIMES:
                front = self.case["fronts"][pixels][kind]
                point = {e["id"]: (added(e, kind), error_of(e, pixels)) for e in entries}
                expected = [name for name, (ms, error) in point.items()
                            if not any(m <= ms and e <= error and (m, e) != (ms, error)
                                       for m, e in point.values())]
                expected.sort(key=lambda name: point[name])
                self.assertEqual(front, expected, (pixels, kind))

    def test_against_rays(self):
        entries = {entry["id"]: entry for entry in self.candidates()}
        rows = self.case["against_rays"]
        self.assertTrue(rows)
        for row in rows:
            entry, pixels, kind = entries[row["entry"]], row["pixels"], row["time"]
            self.assertNotIn(entry["technique"], ("ray-traced", "vtkShadowMapPass"))
            error, ms = row["error"], row["milliseconds"]
            self.assertAlmostEqual(error, error_of(entry, pixels), places=6)
            self.assertAlmostEqual(ms, added(entry, kind), places=6)
            for other in entries.values():  # no other technique is faster and better
                if other["technique"].startswith("map-"):
                    self.assertFalse(added(other, kind) < ms and error_of(other, pixels) < error)
            rays = sorted((-error_of(e, pixels), added(e, kind), float(e["setting"]["samples"]))
                          for e in entries.values() if e["technique"] == "ray-traced")
            errors, times, samples = numpy.abs(numpy.array(rays).T)
            if (numpy.diff(times) > 0).all():  # else some setting is not on the rays' own front
                expected = [numpy.exp(numpy.interp(-math.log(error), -numpy.log(errors),
                                                   numpy.log(column))) for column in (times, samples)]
                numpy.testing.assert_allclose([row["rays_milliseconds"], row["rays"]], expected,
                                              rtol=1e-4)
            self.assertAlmostEqual(row["factor"], row["rays_milliseconds"] / ms, places=4)

    def test_advice(self):
        entries = [e for e in self.candidates() if e["technique"] != "vtkShadowMapPass"]
        advice = self.case["advice"]
        self.assertEqual({(row["pixels"], row["time"]) for row in advice["under_error"]},
                         {(pixels, kind) for pixels in PIXELS for kind in TIMES})
        for row in advice["under_error"]:
            fits = [(added(e, row["time"]), error_of(e, row["pixels"]), e["id"]) for e in entries
                    if error_of(e, row["pixels"]) <= row["error"]]
            self.assertEqual((row["milliseconds"], row["reached"], row["entry"]),
                             min(fits, default=(None, None, None)))
        for row in advice["under_time"]:
            fits = [(error_of(e, row["pixels"]), added(e, row["time"]), e["id"]) for e in entries
                    if added(e, row["time"]) <= row["milliseconds"]]
            self.assertEqual((row["error"], row["reached"], row["entry"]),
                             min(fits, default=(None, None, None)))

    def test_errors_are_those_of_another_run(self):
        again = self.bench(*SCENE, *FEW, name="again")["cases"][0]
        for one, other in zip(self.case["entries"], again["entries"]):
            for key in ("id", "parameters", "error", "picture", "bytes"):
                self.assertEqual(one.get(key), other.get(key), one["id"])

    def test_errors_are_those_of_compare(self):
        compared = json.loads(self.succeed(
            "compare", "--scene", "blocker", *SMALL, "--techniques", "map-hard,map-pcss",
            "--set", "map-hard:resolution=512", "--set", "map-pcss:samples=32", "--frames", "1",
            "--json").stdout)["techniques"]
        entries = {entry["id"]: entry for entry in self.case["entries"]}
        # compare's reference is one of the two whose mean is bench's. Seen as lengths of vectors,
        # |v - r| and |v - s| are at most |r - s| apart, and that is the noise.
        bound = 1.001 * self.case["reference"]["noise"]["rmse"] + 1e-9
        for row, name in zip(compared, ("none", "map-hard resolution=512",
                                        "map-pcss samples=32")):
            self.assertAlmostEqual(entries[name]["error"]["rmse"], row["visibility"]["rmse"],
                                   delta=bound, msg=name)
            self.assertAlmostEqual(entries[name]["error"]["bias"], row["visibility"]["bias"],
                                   delta=bound, msg=name)

    def test_errors_make_sense(self):
        error = {entry["id"]: error_of(entry, "all") for entry in self.case["entries"]}
        self.assertLess(error["map-pcss samples=32"], 0.5 * error["map-hard resolution=512"])
        self.assertLess(error["map-hard resolution=512"], error["none"])
        self.assertLess(error["ray-traced samples=16"], error["ray-traced samples=1"])
        # VTK's light is a point: a hard shadow, read from two pictures of 8 bits.
        vtk = next(e for e in self.case["entries"] if e["technique"] == "vtkShadowMapPass")
        self.assertLess(abs(error[vtk["id"]] - error["map-hard resolution=512"]), 0.05)


class Options(BenchTest):
    def test_model(self):
        model = self.write("a.ply", models.ply())
        results = self.bench("bench", model, "--ground", *SMALL, "--frames", "2", "--budget", "8",
                             "--techniques", "map-hard,planar-hard")
        self.assertEqual(results["cases"][0]["scene"]["triangles"], 14)
        techniques = [entry["technique"] for entry in results["cases"][0]["entries"]]
        self.assertEqual(sorted(set(techniques[1:])), ["map-hard", "planar-hard"])
        self.validate(results)

    def test_sweep(self):
        both = self.bench(*SCENE, "--techniques", "map-pcss", "--sweep", "samples=4,8",
                          "--sweep", "map-pcss:resolution=128,256")
        self.assertEqual(self.settings(both, "map-pcss"),
                         [{"samples": s, "resolution": r} for s in "48" for r in ("128", "256")])
        parameters = both["cases"][0]["entries"][1]["parameters"]
        self.assertEqual((parameters["samples"], parameters["resolution"]), ("4", "128"))
        bare = self.bench(*SCENE, "--techniques", "map-pcss,map-soft", "--sweep", "samples=4",
                          name="bare")
        for technique in ("map-pcss", "map-soft"):
            self.assertEqual(self.settings(bare, technique), [{"samples": "4"}])

    def test_lights(self):
        results = self.bench(*SCENE, "--techniques", "map-soft", "--sweep", "samples=16",
                             "--lights", "0.5,1,2")
        self.assertEqual(len(results["cases"]), 3)
        widths = [case["scene"]["light"]["width"] for case in results["cases"]]
        self.assertEqual([width / widths[1] for width in widths], [0.5, 1, 2])
        penumbrae = [case["reference"]["penumbra_pixels"] for case in results["cases"]]
        self.assertLess(penumbrae[0], penumbrae[1])
        self.assertLess(penumbrae[1], penumbrae[2])
        self.validate(results)

    def test_suites(self):
        plain = [{"technique": "map-hard", "label": "Hard",
                  "published": {"correctness": 90,
                                "milliseconds": {"there": {"static": 3, "dynamic": 5}}}}]
        suite = dict(one_case(plain, published="there", reference=16, lights=2),
                     published={"source": "a table", "correctness": 50,
                                "unshadowed_milliseconds": {"there": 2}})
        suite["cases"][0]["samples_per_pixel"] = 4
        self.write("first.json", json.dumps(suite))
        self.write("second.json", json.dumps(one_case([{"technique": "map-soft",
                                                        "set": {"samples": 4}}])))
        self.succeed("bench", "--suite", "first.json,second.json", "-o", "out")
        self.assertEqual(sorted(os.listdir(self.path("out"))), ["first", "second"])
        for name in ("first", "second"):
            self.assertEqual(sorted(os.listdir(self.path("out/" + name))), FILES)
            self.assertEqual(self.read("out", name)["suite"], name)
            self.assertEqual(self.read("out", name)["cases"][0]["samples_per_pixel"],
                             4 if name == "first" else 0)
            self.validate(self.read("out", name))
        case = self.read("out", "first")["cases"][0]
        self.assertEqual(case["scene"]["lights"], 2)
        hard = case["entries"][1]
        self.assertEqual(hard["label"], "Hard")
        self.assertEqual(hard["published"],
                         {"correctness": 90, "static_ratio": 1.5, "dynamic_ratio": 2.5})
        # Figures without times need none of the frame that times are a ratio to.
        del plain[0]["published"]["milliseconds"]
        del suite["published"]["unshadowed_milliseconds"]
        suite["entries"] = plain
        self.write("third.json", json.dumps(suite))
        third = self.bench("bench", "--suite", "third.json", name="out3")["cases"][0]
        self.assertEqual(third["entries"][1]["published"], {"correctness": 90})
        without = self.read("out", "second")["cases"][0]
        self.assertIsNone(without["reference"])
        self.assertIsNone(without["entries"][1]["error"])
        self.assertEqual(without["entries"][1]["parameters"]["samples"], "4")

    def test_scaling(self):
        entries = [{"technique": "map-hard"}, {"technique": "map-pcss", "set": {"samples": 8}}]
        suite = one_case(entries)
        suite["cases"] = [
            {"name": "small", "scene": "basic", "size": [80, 60], "axis": "pixels"},
            {"name": "large", "scene": "basic", "size": [320, 240], "axis": "pixels"},
            {"name": "one", "scene": "basic", "lights": 1, "axis": "lights"},
            {"name": "three", "scene": "basic", "lights": 3, "axis": "lights"}]
        self.write("axes.json", json.dumps(suite))
        results = self.bench("bench", "--suite", "axes.json")
        self.validate(results)
        self.assertEqual([case["value"] for case in results["cases"]],
                         [80 * 60, 320 * 240, 1, 3])
        rows = {(row["axis"], row["entry"], row["time"]): row for row in results["scaling"]}
        self.assertEqual(len(rows), 2 * 2 * 2)
        for (axis, name, kind), row in rows.items():
            points = [[case["value"], added(entry, kind)] for case in results["cases"]
                      for entry in case["entries"]
                      if case["axis"] == axis and entry["id"] == name
                      and added(entry, kind) > 0]  # less is noise, and has no logarithm
            numpy.testing.assert_allclose(row["points"], points, rtol=1e-6)
            if len(points) > 1:
                logs = numpy.log(points)
                self.assertAlmostEqual(row["exponent"], numpy.polyfit(*logs.T, 1)[0], places=4)
            else:
                self.assertIsNone(row["exponent"])


class Ends(BenchTest):
    def test_budget(self):
        # What a second allows is not known, but it is less than this.
        results = self.bench("bench", "--scene", "basic", "--size", "300x300", "--frames", "1000",
                             "--reference-samples", "16", "--budget", "1", "--techniques",
                             "map-hard,volume-soft", "--sweep", "volume-soft:samples=16")
        self.validate(results)
        frames = [e["time"][kind]["frames"] for e in measured(results["cases"][0])
                  for kind in TIMES if e.get("time")]
        self.assertTrue(frames)  # not all of it went into errors
        self.assertLess(min(frames), 1000)
        # Fewer frames than wanted are no gap; an entry without any is.
        self.assertEqual(results["complete"], min(frames) > 0 and all(
            e.get("time") for e in measured(results["cases"][0])))
        self.assertEqual(results["budget_seconds"], 1)

    def test_a_case_fails(self):
        # The camera of the second looks away from all that could receive.
        suite = one_case([{"technique": "map-hard"}])
        suite["cases"] = [{"scene": "blocker"},
                          {"name": "away", "scene": "blocker", "reference": 16,
                           "camera": {"position": [0, 0, 50], "focus": [0, 1, 99]}},
                          {"name": "third", "scene": "blocker"}]
        self.write("three.json", json.dumps(suite))
        result = self.run_command("bench", "--suite", "three.json", "-o", "out")
        results = self.read("out")
        self.validate(results)
        self.assertEqual([case["id"] for case in results["cases"]], ["blocker", "third"])
        self.assertEqual([failure["case"] for failure in results["failures"]], ["away"])
        self.assertEqual(result.returncode, 1)
        self.assertIn("away: " + results["failures"][0]["reason"], result.stderr)
        self.assertFalse(results["complete"])

    def test_no_penumbra(self):
        results = self.bench(*SCENE, "--lights", "0", "--techniques", "map-hard,ray-traced")
        self.validate(results)
        case = results["cases"][0]
        self.assertEqual(case["reference"]["penumbra_pixels"], 0)
        for entry in case["entries"]:
            self.assertIsNone(entry["error"]["penumbra"]["rmse"])
        self.assertEqual(case["fronts"]["penumbra"], {"static": [], "dynamic": []})
        self.assertTrue(case["fronts"]["all"]["static"])
        self.assertEqual({row["pixels"] for row in case["advice"]["under_error"]}, {"all"})

    def test_names(self):
        # Quotes, commas and bytes that are no text.
        name = os.fsdecode(b'a "b", \xff.ply')
        self.write(name, models.ply())
        results = self.bench("bench", name, *SMALL, "--budget", "3", "--frames", "3",
                             "--techniques", "map-hard")
        with open(self.path("out/results.csv"), newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual({row["case"].split(",")[0] for row in rows}, {'a "b"'})
        self.assertEqual(len(rows), len(results["cases"][0]["entries"]))

    def test_several_lights_beside_vtk(self):
        # Of the first light alone, so that others change nothing.
        suite = one_case([{"peer": "vtkShadowMapPass"}], reference=64, size=[100, 100])
        suite["cases"].append(dict(suite["cases"][0], name="three", lights=3))
        self.write("lights.json", json.dumps(suite))
        one, three = self.bench("bench", "--suite", "lights.json")["cases"]
        # A third of the light in 8 bits: three times as coarse.
        self.assertAlmostEqual(error_of(one["entries"][1], "all"),
                               error_of(three["entries"][1], "all"), delta=0.01)

    def test_interrupt(self):
        process = subprocess.Popen(
            [COMMAND, "bench", "--scene", "basic", "--size", "300x300", "--reference-samples",
             "16", "--frames", "1000", "--budget", "600", "-o", "out"],
            cwd=self.folder, env=ENVIRONMENT, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL)
        time.sleep(4)
        process.send_signal(signal.SIGINT)
        # Once more, while the report is being made: by another signal, since the next one ends it.
        time.sleep(0.3)
        process.send_signal(signal.SIGTERM)
        self.assertEqual(process.wait(timeout=60), 130)
        self.assertEqual(os.listdir(self.folder), ["out"])
        self.assertEqual(sorted(os.listdir(self.path("out"))), FILES)
        results = self.read("out")
        self.assertFalse(results["complete"])
        self.validate(results)
        self.assertTrue(any(entry.get("error") for case in results["cases"]
                            for entry in case["entries"]))
        with open(self.path("out/results.csv")) as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), sum(len(case["entries"]) for case in results["cases"]))
        with open(self.path("out/report.html")) as file:
            self.assertTrue(file.read().rstrip().endswith("</html>"))

    def test_failures(self):
        scene = ["bench", "--scene", "blocker", *SMALL]
        out = ["-o", "out"]
        for code, words, arguments in (
                (2, ["nonsense", "thesis"], ["bench", "--suite", "nonsense"]),
                (2, ["nonsense", "map-hard"], [*scene, "--techniques", "nonsense"]),
                (2, ["samples", "many"], [*scene, "--sweep", "map-pcss:samples=8,many"]),
                (2, ["samples", "-3"], [*scene, "--sweep", "map-pcss:samples=-3"]),
                (2, ["--sweep", "samples"], [*scene, "--sweep", "samples"]),
                (2, ["nonsense"], [*scene, "--sweep", "nonsense=1"]),
                (2, ["nonsense"], [*scene, "--sweep", "map-pcss:nonsense=1"]),
                (2, ["--budget"], [*scene, "--budget", "0"]),
                (2, ["--frames"], [*scene, "--frames", "0"]),
                (2, ["--lights", "-1"], [*scene, "--lights", "1,-1"]),
                (2, ["--lights", "x"], [*scene, "--lights", "x"]),
                (2, ["quick", "scene"], ["bench", "--suite", "quick"]),
                (2, ["--lights", "twice"], [*scene, "--lights", "1,1"]),
                (2, ["--sweep", "twice"], [*scene, "--sweep", "map-pcss:samples=8,8"]),
                (2, ["scaling", "two"], ["bench", "--suite", "scaling,scaling"]),
                (2, ["--size", "suite"], ["bench", "--suite", "scaling", "--size", "9x9"]),
                (2, ["nothing to draw"], ["bench"])):
            self.expect_failure(code, words, *arguments, *out)
        model = self.write("a.ply", models.ply())
        self.expect_failure(2, ["suite"], "bench", model, "--suite", "scaling", *out)
        self.expect_failure(2, ["exclude"], "bench", model, "--scene", "blocker", *out)
        self.write("file", "")
        for place in ("none/out", "file/out", "file"):
            self.expect_failure(1, [place], *scene, "-o", place)

    def test_bad_suites(self):
        good = one_case([{"technique": "map-hard"}])
        self.write("no.json", "no JSON")
        self.expect_failure(1, ["no.json", "JSON"], "bench", "--suite", "no.json", "-o", "out")
        for words, change in (
                (["title"], {"title": None}), (["entries"], {"entries": None}),
                (["cases"], {"cases": [{"name": "no scene"}]}), (["siez"], {"siez": [1, 1]}),
                (["reference"], {"reference": "many"}),
                (["entries", "peer"], {"entries": [{"peer": "nonsense"}]}),
                (["nonsense"], {"entries": [{"technique": "nonsense"}]}),
                (["nonsense"], {"entries": [{"technique": "map-hard", "set": {"nonsense": 1}}]}),
                (["nonsense"], {"cases": [{"scene": "blocker", "set": ["nonsense=1"]}]}),
                (["nonsense"], {"cases": [{"scene": "nonsense"}]})):
            bad = {k: v for k, v in dict(good, **change).items() if v is not None}
            name = self.write("bad.json", json.dumps(bad))
            if words != ["nonsense"]:  # of the form, not of what the program knows
                words = ["bad.json", *words]
            self.expect_failure(1, words, "bench", "--suite", name, "-o", "out")
        self.write("axis.json", json.dumps(one_case(good["entries"], axis="resolution")))
        self.expect_failure(1, ["axis", "resolution"], "bench", "--suite", "axis.json", "-o", "out")
        told = [{"technique": "map-hard",
                 "published": {"milliseconds": {"there": {"static": 3, "dynamic": 5}}}}]
        self.write("told.json", json.dumps(one_case(told, published="there")))
        self.expect_failure(
            1, ["unshadowed_milliseconds", "there"], "bench", "--suite", "told.json", "-o", "out")


if __name__ == "__main__":
    unittest.main()
