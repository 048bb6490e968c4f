# SPDX-License-Identifier: BSD-3-Clause
"""One folder that runs on a Linux with a GPU driver and nothing else.

    python bundle.py BUILD OUTPUT     from a build for the wheel's VTK, with tests

OUTPUT gets the programs, our libraries, those of VTK that they need, the model, and run-gpu;
OUTPUT.tar.xz is the same in one file.
"""

import json
import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
PROGRAMS = ("softshadows", "softshadowsTests")
# What belongs to the system or to its GPU driver.
SYSTEM = re.compile(r"(ld-linux|lib(c|m|dl|pthread|rt|EGL|GL|GLX|OpenGL|GLdispatch|gbm|drm)\.so)")
# Laws that between them go through all of a technique, and those where a GPU may be another.
LAWS = (r"^(Law\.|Seams|Switching|Pyramid|Translucency|Caching.OnlyTheChangedIsRebuilt|Virtual|"
        r"ClosedForm)")


def needed(file):
    text = subprocess.run(["objdump", "-p", file], check=True, capture_output=True, text=True).stdout
    return re.findall(r"NEEDED +(\S+)", text)


def system_libraries():
    text = subprocess.run(["/sbin/ldconfig", "-p"], check=True, capture_output=True, text=True).stdout
    return {name: path for name, path in re.findall(r"^\s(\S+) \(libc6,x86-64.*=> (\S+)$", text, re.M)}


def collect(build, vtk):
    """Of each library needed its name, its file, and whether the system may have it."""
    system = system_libraries()
    ours = (build / "lib", vtk / "vtkmodules", vtk / "vtk.libs")
    found = {}
    waiting = [name for program in PROGRAMS for name in needed(build / "bin" / program)]
    while waiting:
        name = waiting.pop()
        if name in found or SYSTEM.match(name):
            continue
        own = next((folder / name for folder in ours if (folder / name).exists()), None)
        path = own or pathlib.Path(system[name])
        # Ray tracing's are not everywhere; what is below X and C++ mostly is.
        found[name] = path, own is not None or re.match(r"lib(embree|tbb)", name) is not None
        waiting += needed(path)
    return found


def laws(build):
    text = subprocess.run(["ctest", "--show-only=json-v1", "-R", LAWS], check=True, cwd=build,
                          capture_output=True, text=True).stdout
    commands = (test.get("command", []) for test in json.loads(text)["tests"])
    return [" ".join(command[1:]) for command in commands
            if command and command[0].endswith("/softshadowsTests")]


def make(build, output):
    cache = (build / "CMakeCache.txt").read_text()
    vtk = pathlib.Path(re.search(r"^VTK_DIR:\w+=(.*)$", cache, re.M)[1]).parents[2]
    shutil.rmtree(output, ignore_errors=True)
    for folder in ("bin", "lib", "lib-fallback", "share/softshadows"):
        (output / folder).mkdir(parents=True)
    for program in PROGRAMS:
        shutil.copy(build / "bin" / program, output / "bin")
    for name, (path, own) in collect(build, vtk).items():
        shutil.copy(path.resolve(), output / ("lib" if own else "lib-fallback") / name)
    for file in [*(output / "bin").iterdir(), *(output / "lib").iterdir()]:
        subprocess.run(["strip", "--strip-unneeded", file], check=False, stderr=subprocess.DEVNULL)
    models = build / "share/softshadows/models"
    if models.exists():
        shutil.copytree(models, output / "share/softshadows/models")
    (output / "laws.txt").write_text("\n".join(laws(build)) + "\n")
    shutil.copy(HERE / "run-gpu", output)
    archive = pathlib.Path(f"{output}.tar.xz")
    subprocess.run(["tar", "--sort=name", "--owner=0", "--group=0", "-C", output.parent, "-I", "xz -6 -T0",
                    "-cf", archive, output.name], check=True)
    size = archive.stat().st_size / 1e6
    print(f"{archive}: {size:.1f} MB")
    if size > 55:
        sys.exit("that is more than 55 MB")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    make(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve())
