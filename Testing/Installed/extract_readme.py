# SPDX-License-Identifier: BSD-3-Clause
"""extract_readme.py PAGE README FOLDER: the page's C++ and CMake as a project, main.cxx and CMakeLists.txt, as
they stand. The README's C++ is a part of it."""

import pathlib
import re
import sys

page, readme, folder = map(pathlib.Path, sys.argv[1:])
folder.mkdir(parents=True, exist_ok=True)


def blocks(path, language):
    return re.findall(rf"^```{language}\n(.*?)^```$", path.read_text(), re.M | re.S)


for language, name in (("cpp", "main.cxx"), ("cmake", "CMakeLists.txt")):
    found = blocks(page, language)
    assert len(found) == 1, f"{page} has {len(found)} blocks of {language}, not one whole"
    (folder / name).write_text(found[0])
    for part in blocks(readme, language):
        for line in part.splitlines():
            assert line in found[0], f"{readme}: '{line}' is not in the program of {page}"
