# SPDX-License-Identifier: BSD-3-Clause
"""The package imports in silence, and holds what it should at its top level."""

import subprocess
import sys
import unittest

import vtksoftshadows


class Package(unittest.TestCase):
    def test_import_prints_nothing(self):
        run = subprocess.run([sys.executable, "-W", "error", "-c", "import vtksoftshadows"],
                             capture_output=True, text=True, check=False)
        self.assertEqual((run.returncode, run.stdout, run.stderr), (0, "", ""))

    def test_import_alone_is_enough_to_draw(self):
        # Without the OpenGL factory a renderer would be an abstract one.
        code = ("import vtksoftshadows; from vtkmodules.vtkRenderingCore import vtkRenderer;"
                "print(vtkRenderer().GetClassName())")
        run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True,
                             check=False)
        self.assertEqual(run.stdout.strip(), "vtkOpenGLRenderer", run.stderr)

    def test_classes_at_top_level(self):
        for name in ("vtkAreaLight", "vtkShadowPass", "vtkShadowTechniques"):
            self.assertTrue(hasattr(vtksoftshadows, name), name)

    def test_class_of_each_technique_at_top_level(self):
        techniques = vtksoftshadows.vtkShadowTechniques
        self.assertGreater(techniques.GetNumberOfTechniques(), 0)
        for i in range(techniques.GetNumberOfTechniques()):
            shadows = techniques.Create(techniques.GetName(i))
            kind = getattr(vtksoftshadows, shadows.GetClassName())
            self.assertIsInstance(shadows, kind)
            self.assertIsInstance(shadows, vtksoftshadows.vtkShadowPass)
            self.assertTrue(shadows.IsA("vtkRenderPass"))
            self.assertEqual(kind().GetClassName(), shadows.GetClassName())

    def test_version_and_documentation(self):
        self.assertRegex(vtksoftshadows.__version__, r"^\d+\.\d+\.\d+$")
        self.assertIn("vtkShadowTechniques", vtksoftshadows.__doc__)
        self.assertIn("visibility", vtksoftshadows.vtkShadowPass.__doc__)

    def test_only_classes_at_top_level(self):
        public = [name for name in dir(vtksoftshadows) if name.startswith("vtk")]
        strange = [name for name in public
                   if not isinstance(getattr(vtksoftshadows, name), type) and
                   not name.startswith("vtkSoftShadows") and name != "vtkmodules"]
        self.assertEqual(strange, [])


if __name__ == "__main__":
    unittest.main(verbosity=2)
