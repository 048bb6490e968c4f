# SPDX-License-Identifier: BSD-3-Clause
"""extract_readme.py README FOLDER: its C++ and CMake as a project, main.cxx and CMakeLists.txt, as they stand."""

import pathlib
import re
import sys

readme, folder = map(pathlib.Path, sys.argv[1:])
folder.mkdir(parents=True, exist_ok=True)
for language, name in (("cpp", "main.cxx"), ("cmake", "CMakeLists.txt")):
    blocks = re.findall(rf"^```{language}\n(.*?)^```$", readme.read_text(), re.M | re.S)
    assert len(blocks) == 1, f"{readme} has {len(blocks)} blocks of {language}, not one whole"
    (folder / name).write_text(blocks[0])
