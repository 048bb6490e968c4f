# SPDX-License-Identifier: BSD-3-Clause
"""Every block of Python in the README and the documentation runs, page by page, in its order.

What the pages speak of is there: a renderer with a scene, its window, a ground, a widget.
C++ and CMake of the pages: Testing/Installed; their links: Testing/Project/check_links.py.
"""

import json
import pathlib
import re
import subprocess
import tempfile
import unittest
from importlib.util import find_spec

import shadow_testing
from vtkmodules.vtkInteractionWidgets import vtkBoxWidget
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

ROOT = pathlib.Path(__file__).parents[2]
FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.M | re.S)
KNOWN = {"python", "cpp", "cmake", ""}  # "": diagrams

# Put into lines of the command that do not say it themselves, since these take minutes as they stand: small
# pictures, few rays, few frames. A budget that they say is replaced.
SHORT = {"compare": {"--size": "60x60", "--reference-samples": "16", "--frames": "1"},
         "bench": {"--size": "40x40", "--reference-samples": "16", "--frames": "1", "--budget": "20"}}


def pages():
    return [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "Documentation").rglob("*.md"))]


class Blocks(shadow_testing.TestCase):
    def test_python(self):
        count = 0
        for page in pages():
            stage = shadow_testing.Stage()
            ground = stage.add_things()
            widget = vtkBoxWidget()
            names = {"renderer": stage.renderer, "window": stage.window, "ground": ground,
                     "widget": widget, "vtksoftshadows": shadow_testing.vss,
                     "vtkWindowToImageFilter": vtkWindowToImageFilter, "print": lambda *_: None}
            for language, text in FENCE.findall(page.read_text()):
                with self.subTest(page=page.name, block=text.split("\n")[0]):
                    self.assertIn(language, KNOWN)
                    if "import pyvista" in text and not find_spec("pyvista"):
                        compile(text, str(page), "exec")  # Testing/Wheel runs what is like it
                    elif language == "python":
                        exec(compile(text, str(page), "exec"), names)
                        stage.window.Render()
                        count += 1
            if "grab" in names:
                alpha = names["grab"].GetOutput().GetScalarComponentAsDouble(0, 0, 0, 3)
                self.assertLess(alpha, 255)
        self.assertGreater(count, 5)

    def run_lines(self, pattern, least):
        """Lines of the command as they stand, but for SHORT, in a folder of their own."""
        build = pathlib.Path(shadow_testing.vss.__file__).parents[3]
        command = build / "bin" / "softshadows"
        if not command.exists():
            self.skipTest("the command is not built")
        lines = {line for page in pages() for line in re.findall(
            rf"^    build/bin/softshadows ((?:{pattern})\b.*)$",
            page.read_text().replace("\\\n", " "), re.M)}
        self.assertGreaterEqual(len(lines), least)
        for line in sorted(lines):
            words = line.split("#")[0].replace("build/", f"{build}/").split()
            model = next((word for word in words if word.endswith(".ply")), None)
            if model and not pathlib.Path(model).exists():
                continue  # not fetched
            if "--suite" in words:
                # Three quarters of an hour, with pictures whose size is the suite's: are they there?
                tell = subprocess.run([command, "bench", "--help"], capture_output=True, text=True,
                                      check=True).stdout
                for suite in words[words.index("--suite") + 1].split(","):
                    self.assertRegex(tell, rf"--suite A,B,.*\b{suite}\b")
                continue
            words += [word for option, value in SHORT.get(words[0], {}).items()
                      if option not in words for word in (option, value)]
            if words[0] == "bench":
                words[words.index("--budget") + 1] = SHORT["bench"]["--budget"]
            with tempfile.TemporaryDirectory() as folder, self.subTest(line):
                run = subprocess.run([command, *words], cwd=folder, capture_output=True, text=True,
                                     check=False)
                notes = [note for note in run.stderr.splitlines() if "note: --budget" not in note]
                self.assertEqual((run.returncode, notes), (0, []))
                if "-o" in words:
                    self.assertTrue((pathlib.Path(folder) / words[words.index("-o") + 1]).exists())

    def test_render(self):
        self.run_lines("render|list", 3)

    def test_compare(self):
        self.run_lines("compare", 1)

    def test_bench(self):
        self.run_lines("bench", 5)

    def test_bootstrap(self):
        # It installs, builds and runs this test; so here is only looked whether it knows what pages say.
        cases = re.findall(r"^  (\w+)\)", (ROOT / "bootstrap").read_text(), re.M)
        said = {word for page in pages()
                for word in re.findall(r"^    \./bootstrap (\w+)", page.read_text(), re.M)}
        self.assertGreater(len(said), 3)
        self.assertLessEqual(said, set(cases))

    def test_programs(self):
        # Lines that call programs name those that are there; Example.* and test_gallery run them.
        count = 0
        for page in pages():
            for program in re.findall(r"/usr/bin/python3 ([\w/.]+)", page.read_text()):
                self.assertTrue((ROOT / program).exists(), program)
                count += 1
        self.assertGreater(count, 2)

    def test_json(self):
        # The entry that benchmark.md adds to a suite.
        text = (ROOT / "Documentation" / "benchmark.md").read_text()
        (entry,) = re.findall(r'^    ({ "technique".*})$', text, re.M)
        self.assertIn("sweep", json.loads(entry))


if __name__ == "__main__":
    unittest.main(verbosity=2)
