# SPDX-License-Identifier: BSD-3-Clause
"""check_deb.py CPACK BUILD FOLDER VERSION CMAKE...: make the Debian package of a build, unpack it into an
empty root in FOLDER, and use it there: the command, C++ (the documentation's examples, configured by
CMAKE...), Python and the manual page. What is used does not lie in the build."""

import os
import pathlib
import shutil
import subprocess
import sys

CPACK, BUILD, FOLDER, VERSION, *CMAKE = sys.argv[1:]
FOLDER = pathlib.Path(FOLDER)
ROOT = FOLDER / "root"


def run(*words, **variables):
    environment = {name: value for name, value in os.environ.items()
                   if name not in ("PYTHONPATH", "LD_LIBRARY_PATH", "SOFTSHADOWS_DATA")}
    environment.update(variables)
    done = subprocess.run([str(word) for word in words], cwd=FOLDER, env=environment, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    assert done.returncode == 0, "%s\n%s" % (words, done.stdout)
    return done.stdout


def check_libraries(program):
    """Ours come from the root."""
    ours = [line for line in run("ldd", program).splitlines() if "vtkSoftShadows" in line]
    assert ours, program
    for line in ours:
        assert str(ROOT) in line, line


def main():
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    run(CPACK, "--config", pathlib.Path(BUILD) / "CPackConfig.cmake", "-G", "DEB", "-B", FOLDER)
    package, = FOLDER.glob("*.deb")
    assert run("dpkg-deb", "-f", package, "Version").strip() == VERSION, package
    depends = run("dpkg-deb", "-f", package, "Depends")
    for name in ("libvtk9.1", "python3-vtk9", "libc6"):
        assert name in depends, depends
    assert "vtksoftshadows" not in depends, depends
    run("dpkg-deb", "-x", package, ROOT)
    usr = ROOT / "usr"

    # The name that programs link to is of the version, by the rule of CONTRIBUTING.md.
    major, minor, _ = VERSION.split(".")
    soname = run("objdump", "-p", usr / "lib/libvtkSoftShadowsCore.so").split("SONAME")[1].split()[0]
    assert soname == "libvtkSoftShadowsCore.so." + (major if major != "0" else f"{major}.{minor}")

    command = usr / "bin/softshadows"
    check_libraries(command)
    assert VERSION in run(command, "--version")
    fetched = (pathlib.Path(BUILD) / "share/softshadows/models/bunny.ply").exists()
    told = run(command, "render", "--scene", "bunny", "--size", "80x80", "-o", "bunny.png")
    assert not fetched or "stands in" not in told, told
    assert (usr / "share/softshadows/models/bunny.ply").exists() == fetched

    python = {"PYTHONDONTWRITEBYTECODE": "1"}
    tell = "import site; site.addsitedir('%s'); import vtksoftshadows as v; " \
           "print(v.__file__, v.__version__)" % (usr / "lib/python3/dist-packages")
    told = run(sys.executable, "-c", tell, **python)
    assert str(ROOT) in os.path.realpath(told.split()[0]) and VERSION in told, told
    run(sys.executable, pathlib.Path(CMAKE[CMAKE.index("-S") + 1]) / "soft_shadows.py", "python.png",
        PYTHONPATH=str(usr / "lib/python"), **python)

    run(*CMAKE, "-B", "examples", "-DCMAKE_PREFIX_PATH=%s" % usr)
    run(CMAKE[0], "--build", "examples")
    check_libraries(FOLDER / "examples/soft_shadows")
    run("examples/soft_shadows", "cxx.png")

    manual = next((usr / "share/man/man1").glob("softshadows.1*"))
    text = manual.read_text()
    for word in ("render", "view", "\\-\\-camera\\-position", "Page Up", VERSION):
        assert word in text, word
    print(package.name, soname)


main()
