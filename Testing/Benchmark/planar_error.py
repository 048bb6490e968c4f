#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Error of visibility on the floor alone, which is what shadows on planes are for.

    planar_error.py [SCENE...]

400 x 400, against 1024 rays a pixel: RMSE over the floor's pixels and in its penumbra, and the bias.
Needs the Python package vtksoftshadows on the path.
"""
import sys

import numpy
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, the factory of render windows
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow
from vtksoftshadows import vtkShadowPass, vtkShadowScenes, vtkShadowTechniques

CONTESTANTS = (("planar-hard", {}), ("planar-soft", {}), ("planar-soft", {"samples": "1024"}),
               ("planar-fake", {}), ("map-hard", {}), ("map-pcss", {}), ("map-soft", {}))


def find_floor(renderer):
    props = renderer.GetViewProps()
    bounds = [props.GetItemAsObject(i).GetBounds() for i in range(props.GetNumberOfItems())]
    extents = [sorted(b[2 * axis + 1] - b[2 * axis] for axis in range(3)) for b in bounds]
    flat = [i for i, extent in enumerate(extents) if extent[0] <= 1e-9 * extent[2]]
    return props.GetItemAsObject(max(flat, key=lambda i: extents[i][1] * extents[i][2]))


def measure(scene, technique, parameters):
    """Visibility, and which pixels show the floor."""
    renderer, window = vtkRenderer(), vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(400, 400)
    window.AddRenderer(renderer)
    if not vtkShadowScenes.Build(scene, renderer):
        sys.exit(2)
    shadows = vtkShadowTechniques.Create(technique)
    for name, value in parameters.items():
        shadows.SetParameter(name, value)
    renderer.SetPass(shadows)
    window.Render()
    data = shadows.GetVisibility(0).GetPointData()
    visibility = vtk_to_numpy(data.GetArray("Visibility")).astype(float)
    receivers = vtk_to_numpy(data.GetArray("Receiver")) > 0
    vtkShadowPass.SetReceiving(find_floor(renderer), False)
    window.Render()
    others = vtk_to_numpy(shadows.GetVisibility(0).GetPointData().GetArray("Receiver")) > 0
    renderer.SetPass(None)
    return visibility, receivers & ~others


def main():
    for scene in sys.argv[1:] or ["blocker", "bunny", "basic"]:
        truth, floor = measure(scene, "ray-traced", {"samples": "1024"})
        penumbra = floor & (truth > 0.02) & (truth < 0.98)
        for technique, parameters in CONTESTANTS:
            error = measure(scene, technique, parameters)[0] - truth
            print(f"{scene:8} {' '.join([technique, *parameters.values()]):18}"
                  f" RMSE {numpy.sqrt((error[floor] ** 2).mean()):.4f}"
                  f", in the penumbra {numpy.sqrt((error[penumbra] ** 2).mean()):.4f}"
                  f", bias {error[floor].mean():+.4f}", flush=True)


if __name__ == "__main__":
    main()
