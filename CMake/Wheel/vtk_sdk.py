# SPDX-License-Identifier: BSD-3-Clause
"""What the wheel is built against, from the package index.

    python vtk_sdk.py DIRECTORY     makes it there, and prints a file for cmake -C

VTK's wheels hold no headers, and the index has VTK's SDK (headers, CMake files) for macOS alone. Headers
and CMake files are the same for all systems but for one header and for what names files. So here is
made what an SDK for Linux would be: the SDK's headers and CMake files, the libraries of VTK's wheel for
this interpreter, and the wrapping tools of Debian's VTK, which read and write the same languages.

OpenMesh passes strings, so it is built from source (the index's package openmesh has it) with the C++
ABI of VTK's wheel.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
# The one place that says which VTK: what the wheel depends on. The SDK must be on the index.
VTK_VERSION = re.search(r'"vtk==([0-9.]+)"', (HERE.parents[1] / "pyproject.toml").read_text())[1]
SDK_PLATFORM = ("--platform", "macosx_11_0_arm64", "--python-version", "310")
OPENMESH = "openmesh==1.2.1"
HEADERS = f"vtk-{VTK_VERSION}.data/headers/"
TAG = f"cp{sys.version_info.major}{sys.version_info.minor}"

# Debian's tools under the names of the SDK's, and how newer CMake files call them.
TOOLS = {
    # -MF FILE asks for a list of what was read: left empty.
    "vtkWrapHierarchy": 'if [ "$1" = -MF ]; then : >"$2"; shift 2; fi\nexec {tool} "$@"\n',
    "vtkWrapPython": 'if [ "$1" = -MF ]; then : >"$2"; shift 2; fi\nexec {tool} "$@"\n',
    # Two files, the entry and the module, are one now.
    "vtkWrapPythonInit": '{tool} "$1" "$2.entry" "$2.module"\n'
                         'cat "$2.entry" "$2.module" >"$2"\n'
                         'rm "$2.entry" "$2.module"\n',
}

def download(directory, requirement, pattern, *options):
    """What the index has of a requirement, or what was downloaded before."""
    stem = requirement.replace("-", "_").replace("==", "-")
    found = list(directory.glob(stem + pattern))
    if not found:
        subprocess.run(
            [sys.executable, "-m", "pip", "download", "--quiet", "--disable-pip-version-check",
             "--no-deps", "--dest", str(directory), *options, requirement],
            check=True, stdout=sys.stderr)
        found = list(directory.glob(stem + pattern))
    return found[0]


def extract(wheel, prefix, target):
    """The files of a wheel that lie below a prefix, without it."""
    with zipfile.ZipFile(wheel) as archive:
        for name in archive.namelist():
            if name.startswith(prefix) and not name.endswith("/"):
                path = target / name[len(prefix):]
                path.parent.mkdir(parents=True, exist_ok=True)
                with archive.open(name) as source, open(path, "wb") as out:
                    shutil.copyfileobj(source, out)


def replace(path, *pairs):
    """Replaces in a text what regular expressions match; each must."""
    text = path.read_text()
    for pattern, by in pairs:
        text, count = re.subn(pattern, by, text)
        if not count:
            raise RuntimeError(f"{path} holds nothing like {pattern!r}: another SDK than expected")
    path.write_text(text)


def adapt_headers(include):
    # What VTK's Linux wheels are built with.
    replace(include / "vtkRenderingOpenGLConfigure.h",
            (r"#define VTK_USE_COCOA", "/* #undef VTK_USE_COCOA */"),
            (r"/\* #undef VTK_USE_X \*/", "#define VTK_USE_X"),
            (r"/\* #undef VTK_OPENGL_HAS_EGL \*/", "#define VTK_OPENGL_HAS_EGL"))
    # Hints that Debian's tools do not know: they are for serializers, properties and threads.
    replace(include / "vtkWrappingHints.h",
            (r"\[\[vtk::(propexclude|unblockthreads|marshal\w+)[^\]]*\]\]", ""))
    # Python 2's names, which Debian's tools write.
    replace(include / "vtkPythonCompatibility.h",
            (r"\Z", "#define VTK_PY3K\n#define PyIntObject PyLongObject\n#define PyInt_Type PyLong_Type\n"))


def adapt_cmake(cmake):
    suffix = sysconfig.get_config_var("EXT_SUFFIX")
    version = f"{sys.version_info.major}.{sys.version_info.minor}"
    # The libraries have one name in the wheel, and tools are not the SDK's.
    libraries = (
        (r"build/lib\.macosx[^/]*/vtkmodules/\.dylibs/([^\"]*)\.dylib", r"vtkmodules/\1.so"),
        (r"@rpath/([^\"]*)\.dylib", r"\1.so"),
        (r"list\(APPEND _cmake_import_check[^\n]*\n", ""))
    replace(cmake / "viskores/ViskoresTargets-release.cmake", *libraries)
    replace(cmake / "VTK-targets-release.cmake", *libraries,
            (r"(libvtk\w+?)3\.10\.so", rf"\g<1>{version}.so"))
    replace(cmake / "VTKPython-targets-release.cmake",
            (r"\.cpython-310-darwin\.so", suffix),
            (r"list\(APPEND _cmake_import_check[^\n]*\n", ""))
    replace(cmake / "VTK-targets.cmake", (r";-framework Cocoa", ""))
    replace(cmake / "vtk-config.cmake",
            (r'set\(VTK_USE_X "OFF"\)', 'set(VTK_USE_X "ON")'),
            (r'set\(VTK_OPENGL_HAS_EGL "OFF"\)', 'set(VTK_OPENGL_HAS_EGL "ON")'))
    replace(cmake / "VTK-vtk-module-find-packages.cmake",
            (r"(find_package\(Python3\s+)3\.10", rf"\g<1>{version}"))


def add_tools(directory):
    directory.mkdir(parents=True, exist_ok=True)
    for name, call in TOOLS.items():
        tool = shutil.which(f"{name}-9.1") or shutil.which(name)
        if not tool:
            raise RuntimeError(f"{name} is missing: install python3-vtk9 (Debian 12)")
        script = directory / name
        script.write_text("#!/bin/sh -e\n" + call.format(tool=tool))
        script.chmod(0o755)


def add_openmesh(directory, archive):
    """OpenMesh's core, to be built with what links it."""
    with tarfile.open(archive) as source:
        prefix = re.compile(r"[^/]*/OpenMesh/(src/OpenMesh/Core/.*|LICENSE)")
        for member in source:
            match = prefix.fullmatch(member.name)
            if match and member.isfile():
                path = directory / match[1]
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(source.extractfile(member).read())
    shutil.copy(HERE / "OpenMeshConfig.cmake", directory)


def prepare(directory):
    """Makes all of it in a directory unless it is there; returns the file for cmake -C."""
    directory = pathlib.Path(directory).resolve()
    content = directory / f"vtk-{VTK_VERSION}-{sysconfig.get_config_var('SOABI')}"
    cache = content / "wheel.cmake"
    if cache.exists():
        return cache
    shutil.rmtree(content, ignore_errors=True)
    content.mkdir(parents=True)
    binary = ("--only-binary", ":all:")
    sdk = download(directory, f"vtk-sdk=={VTK_VERSION}", "-*macosx*.whl", *SDK_PLATFORM, *binary)
    vtk = download(directory, f"vtk=={VTK_VERSION}", f"-{TAG}-*.whl", *binary)
    extract(sdk, "vtk_sdk/content/" + HEADERS, content / HEADERS)
    extract(vtk, "", content)
    adapt_headers(content / HEADERS / f"vtk-{VTK_VERSION.rsplit('.', 1)[0]}")
    adapt_cmake(content / HEADERS / "cmake")
    add_tools(content / "bin")
    add_openmesh(content / "OpenMesh",
                 download(directory, OPENMESH, ".tar.gz", "--no-binary", ":all:"))
    # Strings in either of libstdc++'s two forms: as VTK's libraries have them.
    new_abi = b"__cxx11" in (content / "vtkmodules/libvtkCommonCore.so").read_bytes()
    cache.write_text("".join(f'set({name} "{value}" CACHE {kind} "")\n' for name, value, kind in (
        ("SOFTSHADOWS_WHEEL", "ON", "BOOL"),
        ("VTK_DIR", content / HEADERS / "cmake", "PATH"),
        ("OpenMesh_DIR", content / "OpenMesh", "PATH"),
        ("CMAKE_CXX_FLAGS", f"-D_GLIBCXX_USE_CXX11_ABI={int(new_abi)}", "STRING"),
        ("Python3_EXECUTABLE", sys.executable, "FILEPATH"))))
    return cache


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    print(prepare(os.path.abspath(sys.argv[1])))
