# SPDX-License-Identifier: BSD-3-Clause
"""Every block of Python in the README and the documentation runs, page by page, in its order.

What the pages speak of is there: a renderer with a scene, its window, a ground, a widget.
C++ and CMake of the README: Testing/Installed.
"""

import pathlib
import re
import subprocess
import tempfile
import unittest

import shadow_testing
from vtkmodules.vtkInteractionWidgets import vtkBoxWidget
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

ROOT = pathlib.Path(__file__).parents[2]
FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.M | re.S)
KNOWN = {"python", "cpp", "cmake", ""}  # "": diagrams


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
                    if language == "python":
                        exec(compile(text, str(page), "exec"), names)
                        stage.window.Render()
                        count += 1
            if "grab" in names:
                alpha = names["grab"].GetOutput().GetScalarComponentAsDouble(0, 0, 0, 3)
                self.assertLess(alpha, 255)
        self.assertGreater(count, 5)

    def test_commands(self):
        # Those of the README that draw, as they stand, in a folder of their own.
        text = (ROOT / "README.md").read_text().replace("\\\n", " ")
        lines = re.findall(r"^    build/bin/softshadows ((?:render|list).*)$", text, re.M)
        self.assertGreater(len(lines), 2)
        build = pathlib.Path(shadow_testing.vss.__file__).parents[3]
        command = build / "bin" / "softshadows"
        if not command.exists():
            self.skipTest("the command is not built")
        with tempfile.TemporaryDirectory() as folder:
            for line in lines:
                words = line.split("#")[0].replace("build/", f"{build}/").split()
                model = next((word for word in words if word.endswith(".ply")), None)
                if model and not pathlib.Path(model).exists():
                    continue  # not fetched
                run = subprocess.run([command, *words], cwd=folder, capture_output=True, text=True,
                                     check=False)
                with self.subTest(line):
                    self.assertEqual((run.returncode, run.stderr), (0, ""))

    def test_links(self):
        # Pictures and pages that are named are there.
        for page in pages():
            for target in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", page.read_text()):
                with self.subTest(page=page.name, target=target):
                    self.assertTrue((page.parent / target).exists())


if __name__ == "__main__":
    unittest.main(verbosity=2)
