# SPDX-License-Identifier: BSD-3-Clause
"""Cameras and lights that options name: what they say is what is drawn."""

import json
import os
import unittest

from command_testing import ENVIRONMENT, CommandTest, read_png
from command_testing import start_display as setUpModule  # unittest calls it
import model_files as models

AMBER = [242, 153, 13]  # of vtkAreaLightActor


def words(numbers):
    return ",".join(repr(number) for number in numbers)


class Views(CommandTest):
    def render(self, *arguments, scene=("--scene", "basic"), name="out.png"):
        result = self.succeed("render", *scene, "--size", "160x120", "-o", name, "--technique",
                              "map-hard", "--samples-per-pixel", "0", "--json", *arguments)
        return json.loads(result.stdout), read_png(self.path(name))

    def test_camera_as_it_is(self):
        figures, base = self.render()
        camera = figures["camera"]
        same = ["--camera-position", words(camera["camera_position"]),
                "--camera-target", words(camera["camera_target"]),
                "--view-up", words(camera["view_up"]), "--view-angle", repr(camera["view_angle"])]
        again, picture = self.render(*same)
        self.assertEqual(again["camera"], camera)
        self.assertTrue((picture == base).all())

    def test_camera_moves(self):
        _, base = self.render()
        for option, value in (("--camera-position", "3,4,5"), ("--camera-target", "1,1,1"),
                              ("--view-up", "1,0,0"), ("--view-angle", "60"),
                              ("--parallel-scale", "2")):
            figures, picture = self.render(option, value)
            self.assertGreater(abs(picture - base).max(), 20, option)
            told = figures["camera"][option[2:].replace("-", "_")]
            self.assertEqual(told, [float(one) for one in value.split(",")]
                             if "," in value else float(value))

    def test_camera_upside_down(self):
        # Half a turn about the line of sight is half a turn of the picture, but for pixels at edges.
        figures, base = self.render()
        up = words([-value for value in figures["camera"]["view_up"]])
        _, picture = self.render("--view-up", up)
        self.assertGreater((abs(picture[::-1, ::-1] - base).max(axis=2) <= 8).mean(), 0.98)

    def test_light_as_it_is(self):
        figures, base = self.render()
        light = figures["scene"]["light"]
        self.assertEqual(light["shape"], "rectangle")
        one = "rectangle:width=%r:height=%r:position=%s:target=%s" % (
            light["width"], light["height"], words(light["position"]), words(light["target"]))
        again, picture = self.render("--light", one)
        self.assertEqual(again["scene"]["light"], light)
        self.assertTrue((picture == base).all())
        # Two halves of it in one place: but for rounding the same.
        half = one + ":intensity=0.5"
        again, picture = self.render("--light", half, "--light", half)
        self.assertEqual(again["scene"]["further_lights"], [light])
        self.assertLessEqual(abs(picture - base).max(), 2)

    def test_lights(self):
        red = "sphere:position=-4,-3,6:color=1,0,0"
        blue = "sphere:position=4,-3,6:color=0,0,1"
        both = self.render("--light", red, "--light", blue)[1]
        for channel, other in ((0, blue), (2, red)):  # each light's own channel is as if it were alone
            alone = self.render("--light", red if channel == 0 else blue)[1]
            self.assertTrue((both[..., channel] >= alone[..., channel]).all())
            self.assertGreater(abs(both - alone).max(), 20, other)
        _, spot = self.render("--light", "directional:angle=3:position=-1,-1,2:target=0,0,0")
        self.assertGreater(abs(both - spot).max(), 20)

    def test_show_lights(self):
        options = ["--light-position", "0,0,2.5"]
        plain = self.render(*options)[1]
        shown = self.render(*options, "--show-lights")[1]
        amber = (abs(shown - AMBER).max(axis=2) <= 1)
        self.assertGreater(amber.sum(), 20)
        self.assertTrue((shown[~amber] == plain[~amber]).all())

    def test_studio(self):
        model = (self.write("a.obj", models.obj()),)
        _, base = self.render(scene=model)
        figures, _ = self.render("--camera-position", "3,1,2", scene=model)
        key = figures["scene"]["light"]["position"]
        _, same = self.render("--studio-key", words(key), "--studio-softness", repr(1 / 3),
                              scene=model)
        self.assertTrue((same == base).all())  # the camera that is asked for does not move the key
        _, other = self.render("--studio-key", "1,1,0", scene=model)
        self.assertGreater(abs(other - base).max(), 20)
        _, shown = self.render("--show-lights", scene=model)
        self.assertEqual(shown.shape, base.shape)

    def test_compare_and_bench(self):
        options = ["--scene", "blocker", "--size", "40x40", "--reference-samples", "16",
                   "--frames", "1", "--techniques", "map-hard", "--camera-position", "0.5,0.5,9",
                   "--light", "sphere:position=1,0,5", "--light", "disk:position=-1,0,5"]
        self.assertIn("map-hard", self.succeed("compare", *options).stdout)
        self.succeed("bench", *options, "--budget", "3", "-o", "results")
        with open(self.path("results/results.json")) as file:
            case = json.load(file)["cases"][0]
        self.assertEqual(case["scene"]["lights"], 2)

    def test_shaders(self):
        os.mkdir(self.path("shaders"))
        self.run_command("render", "--scene", "blocker", "--size", "40x40", "-o", "out.png",
                         "--technique", "map-pcss",
                         environment=dict(ENVIRONMENT, SOFTSHADOWS_SHADERS=self.path("shaders")))
        names = os.listdir(self.path("shaders"))
        self.assertEqual({name.split("-")[0] for name in names} & {"prop", "casters"},
                         {"prop", "casters"})
        texts = []
        for name in names:
            with open(self.path("shaders/" + name)) as file:
                texts.append(file.read())
            self.assertRegex(name, r"^\w+-[0-9a-f]+\.(vert|geom|frag)$")
        self.assertEqual(len(texts), len(set(zip(texts, [name.split("-")[0] for name in names]))))
        self.assertTrue(any("shadowVisibility(" in text and "//VTK::" not in text for text in texts))

    def test_wrong(self):
        start = ["render", "--scene", "blocker", "--size", "40x40", "-o", "out.png"]
        for expected, arguments in (
                (["--camera-position", "three numbers"], ["--camera-position", "1,2"]),
                (["no direction"], ["--camera-position", "1,1,1", "--camera-target", "1,1,1"]),
                (["--view-up"], ["--view-up", "0,0,0"]),
                (["--view-angle", "179"], ["--view-angle", "180"]),
                (["--parallel-scale"], ["--parallel-scale", "0"]),
                (["blob", "sphere"], ["--light", "blob"]),
                (["weight", "radius"], ["--light", "sphere:weight=3"]),
                (["position", "three"], ["--light", "sphere:position=1,2"]),
                (["radius", "number"], ["--light", "sphere:radius=x"]),
                (["color"], ["--light", "sphere:color=2,0,0"]),
                (["exclude"], ["--light", "sphere", "--light-radius", "1"]),
                (["studio"], ["--studio-key", "1,1,1"])):
            self.expect_failure(2, expected, *start, *arguments)


if __name__ == "__main__":
    unittest.main()
