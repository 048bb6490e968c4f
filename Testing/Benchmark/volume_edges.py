#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Pixels where a hard technique differs from a ray-traced point light, and how far from an edge.

    PYTHONPATH=build/lib/python /usr/bin/python3 Testing/Benchmark/volume_edges.py \\
        [--technique volume-hard] [--set counting=z-fail] [SCENE...]

True edges are found by rays at four times the picture's resolution, so that features narrower than a
pixel count. A pixel is far where all of them within two pixels see the same.
"""
import argparse

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

import vtksoftshadows as vss

FINER = 4
PIXELS = 2


class View:
    def __init__(self, scene):
        self.renderer, self.window = vtkRenderer(), vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.AddRenderer(self.renderer)
        vss.vtkShadowScenes.Build(scene, self.renderer)
        for light in self.renderer.GetLights():
            light.SetShapeToPoint()

    def look(self, technique, size, parameters=()):
        self.window.SetSize(size, size)
        shadows = vss.vtkShadowTechniques.Create(technique)
        for name, value in parameters:
            shadows.SetParameter(name, value)
        self.renderer.SetPass(shadows)
        self.window.Render()
        data = shadows.GetVisibility(0).GetPointData()
        shape = (size, size)
        return (vtk_to_numpy(data.GetArray("Visibility")).reshape(shape) > 0.5,
                vtk_to_numpy(data.GetArray("Receiver")).reshape(shape) > 0)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("scenes", nargs="*", metavar="SCENE", default=["basic", "huge", "tree"])
    parser.add_argument("--technique", default="volume-hard")
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE")
    parser.add_argument("--size", type=int, default=400)
    arguments = parser.parse_args()
    parameters = [setting.split("=", 1) for setting in arguments.set]
    for scene in arguments.scenes or parser.get_default("scenes"):
        view = View(scene)
        truth, receives = view.look("ray-traced", arguments.size)
        fine, fine_receives = view.look("ray-traced", FINER * arguments.size)
        seen, _ = view.look(arguments.technique, arguments.size, parameters)
        wrong = np.argwhere((seen != truth) & receives)
        far = 0
        for y, x in wrong:
            window = np.s_[max(0, y - PIXELS) * FINER:(y + PIXELS + 1) * FINER,
                           max(0, x - PIXELS) * FINER:(x + PIXELS + 1) * FINER]
            far += not ((fine[window] != truth[y, x]) & fine_receives[window]).any()
        print(f"{scene}: {len(wrong)} of {receives.sum()} pixels differ, "
              f"{100 * len(wrong) / receives.sum():.4f} %; {far} further than {PIXELS} pixels "
              "from an edge")


if __name__ == "__main__":
    main()
