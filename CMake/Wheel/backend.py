# SPDX-License-Identifier: BSD-3-Clause
"""scikit-build-core, with a VTK to build against got ready first (vtk_sdk.py)."""

import os
import pathlib
import subprocess

import vtk_sdk
from scikit_build_core import build as _build
from scikit_build_core.build import (  # noqa: F401 what a build backend has
    build_sdist, get_requires_for_build_sdist, get_requires_for_build_wheel,
    prepare_metadata_for_build_wheel)


def _cache():
    named = os.environ.get("SOFTSHADOWS_WHEEL_CACHE")
    home = os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache"
    return pathlib.Path(named) if named else pathlib.Path(home) / "vtksoftshadows"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    # The built-in scenes' bunny, where it can be had.
    subprocess.run(["Data/fetch-models", "build/wheel/share/softshadows/models"], check=False)
    settings = dict(config_settings or {})
    given = settings.get("cmake.args", [])
    given = given.split(";") if isinstance(given, str) else list(given)
    settings["cmake.args"] = ["-C", str(vtk_sdk.prepare(_cache())), *given]
    return _build.build_wheel(wheel_directory, settings, metadata_directory)
