# SPDX-License-Identifier: BSD-3-Clause
"""The rules of check_sources.py see what breaks them."""

import pathlib
import tempfile
import unittest

import check_sources

LICENCE = f"// {check_sources.LICENCE}\n"


class TestCheckSources(unittest.TestCase):

    def broken(self, **files):
        """What is broken in a project of these files; __ stands for a folder."""
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in files.items():
                path = root / (name.replace("__", "/") + ".h")
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            return "\n".join(check_sources.check(root))

    def test_rules(self):
        low, high = "Modules__Casters__Low", "Modules__Core__High"
        up = '#include "High.h"\n'
        self.assertEqual(self.broken(**{low: LICENCE, high: LICENCE + '#include "Low.h"\n'}), "")
        self.assertIn("no licence", self.broken(**{low: "\n"}))
        self.assertIn("tab", self.broken(**{low: LICENCE + "\t\n"}))
        self.assertIn("601 lines", self.broken(**{low: LICENCE + 600 * "\n"}))
        self.assertIn("High.h of Core", self.broken(**{low: LICENCE + up, high: LICENCE}))
        self.assertIn("has no place", self.broken(Modules__Other__A=LICENCE))
        self.assertIn("each other", self.broken(
            **{low: LICENCE + '#include "B.h"\n', "Modules__Casters__B": LICENCE + '#include "Low.h"\n'}))
        self.assertIn("part of the pass", self.broken(
            Modules__Core__vtkShadowStages=LICENCE + '#include "vtkShadowPass.h"\n',
            Modules__Core__vtkShadowPass=LICENCE))


if __name__ == "__main__":
    unittest.main()
