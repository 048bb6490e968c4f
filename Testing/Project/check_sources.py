#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What holds for the sources as text: licence lines, lengths, and which parts know which.

    check_sources.py [FOLDER]    of the project in FOLDER; by default this one's

Exit 1 after naming each file that breaks a rule.
"""

import pathlib
import re
import sys

LICENCE = "SPDX-License-Identifier: BSD-3-Clause"
SOURCES = {".h", ".cxx", ".glsl", ".py", ".cmake"}
LONGEST = 600  # lines; a file past it asks to be two
# Tables of cases, of which a half is no better to read than the whole.
LONG = {"Modules/Drawing/Testing/Cxx/TestLightFrusta.cxx", "Testing/Cxx/Alpha.cxx",
        "Testing/Cxx/Planar.cxx"}
# Each module, and those that it may include from, itself besides. Families do not know each other.
BELOW = {
    "Casters": [],
    "Drawing": ["Casters"],
    "Core": ["Casters", "Drawing"],
    "Automatic": ["Casters", "Drawing", "Core"],
    "OcclusionTextures": ["Casters", "Drawing", "Core"],
    "PlanarShadows": ["Casters", "Drawing", "Core"],
    "RayTracing": ["Casters", "Drawing", "Core"],
    "ShadowMaps": ["Casters", "Drawing", "Core"],
    "ShadowVolumes": ["Casters", "Drawing", "Core"],
    "VirtualShadowMaps": ["Casters", "Drawing", "Core"],
    "ImageMetrics": [],
}
# In Core, the parts of the pass that can be read by themselves know neither it nor its state.
PARTS = ["vtkShadowDebugViews", "vtkShadowInjection", "vtkShadowInjector", "vtkShadowReadback",
         "vtkShadowReceiverDrawing", "vtkShadowScreen", "vtkShadowShaderText", "vtkShadowStages"]
PASS = {"vtkShadowPass.h", "vtkShadowPassInternals.h"}
INCLUDE = re.compile(r'^#include "([^"]+)"', re.M)


def sources(root):
    for top in ("Apps", "CMake", "Data", "Documentation", "Modules", "Testing"):
        for path in sorted((root / top).rglob("*")):
            if path.suffix in SOURCES or path.name == "CMakeLists.txt":
                yield path


def find_circle(graph):
    """Names of headers that include each other in a circle, or an empty list."""
    done = set()

    def visit(name, path):
        if name in path:
            return path[path.index(name):] + [name]
        if name in done:
            return []
        for other in graph.get(name, ()):
            circle = visit(other, path + [name])
            if circle:
                return circle
        done.add(name)
        return []

    for name in graph:
        circle = visit(name, [])
        if circle:
            return circle
    return []


def check(root):
    """Yield a line for each rule that is broken."""
    homes = {path.name: path.parent.name for path in (root / "Modules").glob("*/*.h")}
    graph = {}
    for path in sources(root):
        name = path.relative_to(root).as_posix()
        text = path.read_text()
        if LICENCE not in "\n".join(text.split("\n", 2)[:2]):
            yield f"{name}: no licence line ({LICENCE})"
        lines = text.count("\n")
        if lines > LONGEST and name not in LONG:
            yield f"{name}: {lines} lines, more than {LONGEST}"
        if "\t" in text:
            yield f"{name}: has a tab"
        if path.parent.parent != root / "Modules" or path.suffix not in (".h", ".cxx"):
            continue
        included = [one for one in INCLUDE.findall(text) if one in homes]
        if path.suffix == ".h":
            graph[path.name] = included
        module = path.parent.name
        if module not in BELOW:
            yield f"{name}: the module {module} has no place in {pathlib.Path(__file__).name}"
            continue
        for one in included:
            if homes[one] != module and homes[one] not in BELOW[module]:
                yield f"{name}: includes {one} of {homes[one]}, which does not lie below {module}"
            if path.stem in PARTS and one in PASS:
                yield f"{name}: includes {one}, though it is a part of the pass"
    circle = find_circle(graph)
    if circle:
        yield "headers include each other: " + " -> ".join(circle)


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
    root = root if len(sys.argv) > 1 else root.parents[2]
    broken = list(check(root))
    print("\n".join(broken) or "the sources keep the rules")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
