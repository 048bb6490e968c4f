# SPDX-License-Identifier: BSD-3-Clause
"""Random damage to models, suites and arguments: the command ends by itself, with an exit code of its
own, one message of its own form, and no file that it did not promise.

The damage is the same in each run. SOFTSHADOWS_FUZZ=100 tries a hundred times as many,
SOFTSHADOWS_FUZZ_SEED=N others. See command_testing for what it needs.
"""

import concurrent.futures
import json
import os
import random
import re
import subprocess
import tempfile
import unittest

import model_files as models
from command_testing import COMMAND, ENVIRONMENT
from command_testing import start_display as setUpModule  # unittest calls it

TIMES = int(os.environ.get("SOFTSHADOWS_FUZZ", "1"))
SEED = int(os.environ.get("SOFTSHADOWS_FUZZ_SEED", "22"))
NO_END = 100  # seconds; what has not ended then never will

MODELS = {"a.obj": models.obj(), "b.obj": "vt 0 0\nvn 0 0 1\n" + models.obj(), "a.ply": models.ply(),
          "a.stl": models.stl(), "b.stl": models.binary_stl(), "a.vtp": models.vtp(),
          "a.vtk": models.vtk(), "grid.vtk": models.grid_vtk(), "a.gltf": models.gltf(),
          "a.glb": models.glb()}
SUITE = {"title": "t", "about": "a", "size": [16, 16], "reference": 0, "frames": 1, "budget": 1,
         "cases": [{"scene": "blocker", "name": "n", "light": {"scale": 1, "position": [1, 2, 9]},
                    "lights": 2, "set": ["map-hard:resolution=64"], "axis": "lights"}],
         "entries": [{"technique": "map-hard", "set": {"resolution": 64}, "label": "l"},
                     {"peer": "vtkShadowMapPass", "sweep": {"resolution": [64, "128"]}}]}
SMALL = ["--size", "16x16", "--techniques", "map-hard", "--frames", "1", "--reference-samples"]
LINES = [
    ["list", "techniques", "--json"],
    ["render", "--scene", "blocker", "--size", "16x16", "-o", "o.png", "--technique", "map-hard",
     "--set", "resolution=64", "--stats", "s.json", "--visibility", "v.exr", "--up", "z"],
    ["render", "a.obj", "--ground", "--size", "16x16", "-o", "o.png", "--technique", "map-pcss",
     "--light-shape", "disk", "--light-radius", "1", "--light-position", "1,2,3",
     "--background", "0,0,1", "--samples-per-pixel", "4", "--quality", "low"],
    ["compare", "--scene", "blocker", *SMALL, "4", "-o", "out", "--json"],
    ["bench", "--scene", "blocker", *SMALL, "0", "--budget", "1", "-o", "out", "--lights", "1,2",
     "--sweep", "map-hard:resolution=64,128"]]
ODD = ["", " ", "nan", "-inf", "-1", "0", "1e400", "99999999999999999999", "0x10", "1,2", "1,,2", "=",
       ":=", "a=b=c", "\x1b[2J", "%s%n", "x" * 3000, "\udcff", "--", "-", "-o", "--json", ",", "16x",
       "../", ".", "out/"]
NUMBERS = [b"-1", b"0", b"2", b"255", b"65536", b"2147483648", b"-2147483649", b"4294967295",
           b"18446744073709551616", b"1e300", b"-1e999", b"nan", b"0x7f", b"1.5", b""]
VALUES = [None, True, -1, 0, 1.5, 2 ** 40, 1e300, "", "x", "\x1b", [], [1], {}, {"x": 1}]


def damage_bytes(content, chance):
    """Some of what happens to files, once to thrice."""
    content = bytearray(content if isinstance(content, bytes) else content.encode())
    for _ in range(chance.randint(1, 3)):
        at = chance.randrange(len(content) + 1)
        length = chance.choice([1, 2, 8, 50])
        kind = chance.randrange(7)
        numbers = [found.span() for found in re.finditer(rb"[0-9][0-9.]*", content)]
        if kind == 0:
            del content[at:]
        elif kind == 1:
            del content[at:at + length]
        elif kind == 2:
            content[at:at] = content[at:at + length]
        elif kind == 3:
            content[at:at + length] = chance.randbytes(length)
        elif kind == 4 and at < len(content):
            content[at] ^= 1 << chance.randrange(8)
        elif numbers:
            start, end = chance.choice(numbers)
            content[start:end] = chance.choice(NUMBERS)
    return bytes(content)


def places(value):
    """Each container in a JSON value, with each of its keys."""
    keys = value if isinstance(value, dict) else range(len(value)) if isinstance(value, list) else ()
    for key in keys:
        yield value, key
        yield from places(value[key])


def damage_suite(chance):
    if chance.random() < 0.4:
        return damage_bytes(json.dumps(SUITE), chance)
    suite = json.loads(json.dumps(SUITE))
    for _ in range(chance.randint(1, 2)):
        container, key = chance.choice(list(places(suite)))
        kind = chance.randrange(4)
        if kind == 0:
            del container[key]
        elif kind == 1 and isinstance(container, dict):
            container["x" + str(key)] = container.pop(key)
        else:
            container[key] = chance.choice(VALUES)
    return json.dumps(suite).encode()


def damage_line(chance):
    line = list(chance.choice(LINES))
    for _ in range(chance.randint(1, 2)):
        at = chance.randrange(len(line))
        kind = chance.randrange(4)
        if kind == 0:
            del line[at]
        elif kind == 1:
            line.insert(at, chance.choice(ODD))
        elif kind == 2:
            line[at] = chance.choice(ODD)
        else:
            other = chance.choice(LINES)
            line.insert(at, chance.choice(other))
        line = line or ["list"]
    return line


class Fuzz(unittest.TestCase):
    def find_fault(self, files, line, damaged=None):
        """What is wrong with how the command ends, or None. Messages name the damaged file."""
        with tempfile.TemporaryDirectory() as folder:
            for name, content in files.items():
                with open(os.path.join(folder, name), "wb") as file:
                    file.write(content if isinstance(content, bytes) else content.encode())
            try:
                result = subprocess.run([COMMAND, *line], cwd=folder, env=ENVIRONMENT,
                                        stdin=subprocess.DEVNULL, capture_output=True,
                                        timeout=NO_END)
            except subprocess.TimeoutExpired:
                return "it does not end"
            hidden = [name for name in os.listdir(folder) if name.startswith(".softshadows")]
            changed = []
            for name, content in files.items():
                with open(os.path.join(folder, name), "rb") as file:
                    if file.read() != (content if isinstance(content, bytes) else content.encode()):
                        changed.append(name)
        said = result.stderr.decode(errors="surrogateescape")
        lines = said.split("\n")[:-1]
        errors = [one for one in lines if one.startswith("softshadows: error: ")]
        if result.returncode not in (0, 1, 2):
            return "it ends with %d: %s" % (result.returncode, said)
        if len(errors) != (0 if result.returncode == 0 else 1) or \
                not all(one.startswith(("softshadows: ", "See: ")) for one in lines):
            return "exit code %d, and says: %s" % (result.returncode, said)
        if re.search("[\x00-\x09\x0b-\x1f\x7f-\x9f]", said):
            return "control characters: " + repr(said)
        if hidden or changed:
            return "%s left behind, %s changed" % (hidden, changed)
        if result.returncode == 1 and damaged and damaged not in said:
            return "the message does not name the file: " + said
        return None

    def check(self, runs):
        self.assertGreater(len(runs), 20)
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            faults = list(pool.map(lambda run: self.find_fault(*run), runs))
        for run, fault in zip(runs, faults):
            with self.subTest(run=run):
                self.assertIsNone(fault)

    def test_models(self):
        chance = random.Random(SEED)
        self.check([({name: damage_bytes(content, chance)},
                     ["render", name, "--size", "16x16", "--technique", "none", "-o", "o.png"],
                     name) for name, content in MODELS.items() for _ in range(3 * TIMES)])

    def test_suites(self):
        chance = random.Random(SEED + 1)
        self.check([({"suite.json": damage_suite(chance)},
                     ["bench", "--suite", "suite.json", "-o", "out"], "suite.json")
                    for _ in range(24 * TIMES)])

    def test_arguments(self):
        chance = random.Random(SEED + 2)
        self.check([({"a.obj": models.obj()}, damage_line(chance)) for _ in range(30 * TIMES)])


if __name__ == "__main__":
    unittest.main()
