# SPDX-License-Identifier: BSD-3-Clause
"""The visibility that each technique finds, to be compared between two builds.

    python visibilities.py OUTPUT.npz             a scene, an array a technique
    python visibilities.py ONE.npz OTHER.npz      exits 1 where RMSE is above 0.004
"""

import sys

import numpy as np


def write(path):
    # As little as can differ between VTKs: boxes and a plane, no sphere's tessellation.
    import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
    from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkPlaneSource
    from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

    import vtksoftshadows

    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(300, 240)
    renderer = vtkRenderer()
    window.AddRenderer(renderer)
    floor = vtkPlaneSource()
    floor.SetOrigin(-3, -3, 0)
    floor.SetPoint1(3, -3, 0)
    floor.SetPoint2(-3, 3, 0)
    sources = [floor]
    for center, size in (((0, 0, 0.6), 0.8), ((1.3, 0.5, 0.3), 0.6), ((-1.2, 0.8, 1.1), 0.4)):
        cube = vtkCubeSource()
        cube.SetCenter(*center)
        cube.SetXLength(size)
        cube.SetYLength(size)
        cube.SetZLength(size)
        sources.append(cube)
    for source in sources:
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        renderer.AddActor(actor)
    light = vtksoftshadows.vtkAreaLight()
    light.SetShapeToRectangle()
    light.SetWidth(0.8)
    light.SetHeight(0.8)
    light.SetPosition(1.5, -2, 5)
    light.SetFocalPoint(0, 0, 0)
    light.SetPositional(True)
    light.SetConeAngle(90)
    renderer.AddLight(light)
    renderer.GetActiveCamera().SetPosition(0.5, -6, 5)
    renderer.GetActiveCamera().SetFocalPoint(0, 0, 0.3)
    renderer.GetActiveCamera().SetViewUp(0, 0, 1)
    renderer.ResetCameraClippingRange()
    vtksoftshadows.vtkShadowPass.SetAdvice(False)
    techniques = vtksoftshadows.vtkShadowTechniques
    found = {}
    for name in map(techniques.GetName, range(techniques.GetNumberOfTechniques())):
        vtksoftshadows.enable(renderer, name)
        window.Render()
        found[name] = vtksoftshadows.visibility(renderer, light)
        vtksoftshadows.disable(renderer)
    np.savez_compressed(path, **found)


def compare(one, other):
    one, other = np.load(one), np.load(other)
    if sorted(one) != sorted(other):
        print("other techniques:", sorted(set(one) ^ set(other)))
    failed = 0
    for name in sorted(set(one) & set(other)):
        rmse = float(np.sqrt(np.mean((one[name] - other[name]) ** 2)))
        failed += rmse > 0.004
        print(f"{name:20} RMSE {rmse:.5f}{'   too much' if rmse > 0.004 else ''}")
    return bool(failed)


if __name__ == "__main__":
    if len(sys.argv) == 2:
        write(sys.argv[1])
    elif len(sys.argv) == 3:
        sys.exit(compare(*sys.argv[1:]))
    else:
        sys.exit(__doc__)
