# SPDX-License-Identifier: BSD-3-Clause
"""check_links.py finds what leads nowhere, and nothing else."""

import pathlib
import tempfile
import unittest

import check_links


class Links(unittest.TestCase):
    def broken(self, **files):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder).resolve()
            (root / "Documentation").mkdir()
            for name, text in files.items():
                place = root / ("README.md" if name == "README" else f"Documentation/{name}.md")
                place.write_text(text)
            return list(check_links.check(root))

    def test_good(self):
        self.assertEqual(self.broken(
            README="[a](Documentation/a.md#how-it-works) [b](https://vtk.org) `[no](link.md)`\n"
                   "```\n[no](link.md)\n```\n[c](#top)\n# Top\n",
            a="# How `it` works\n[back](../README.md)"), [])

    def test_bad(self):
        for link, word in (("Documentation/b.md", "not there"), ("Documentation/a.md#b", "heading"),
                           ("../outside.md", "not there"), ("https://nowhere", "web"),
                           ("mail:me@example.org", "web")):
            found = self.broken(README=f"[a](Documentation/a.md) [b]({link})", a="# A")
            self.assertEqual(len(found), 1, link)
            self.assertIn(word, found[0])

    def test_alone(self):
        self.assertEqual(self.broken(README="", a=""),
                         ["Documentation/a.md: no page has a link to it"])


if __name__ == "__main__":
    unittest.main()
