#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Hours of sun in a courtyard over a day, by visibility as data: shadow_as_data.py picture.png"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkPlaneSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

import vtksoftshadows

LATITUDE, DECLINATION = np.radians(50), np.radians(0)  # at the equinox, when days have 12 hours
STEP = 1 / 6
HOURS = np.arange(6 + STEP / 2, 18, STEP)


def direction_to_sun(hour):
    """x is east, y north, z up."""
    angle = np.radians(15 * (hour - 12))
    return np.array([
        -np.cos(DECLINATION) * np.sin(angle),
        np.cos(LATITUDE) * np.sin(DECLINATION)
        - np.sin(LATITUDE) * np.cos(DECLINATION) * np.cos(angle),
        np.sin(LATITUDE) * np.sin(DECLINATION)
        + np.cos(LATITUDE) * np.cos(DECLINATION) * np.cos(angle)])


renderer = vtkRenderer()


def add(source):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer.AddActor(actor)
    return actor


plane = vtkPlaneSource()
plane.SetOrigin(-30, -20, 0)
plane.SetPoint1(30, -20, 0)
plane.SetPoint2(-30, 20, 0)
add(plane)
for x, y, width, depth, height in ((-16, 9, 18, 8, 9), (-21, -2, 8, 14, 9), (10, 10, 12, 6, 14),
                                   (16, -8, 6, 6, 20), (-3, -12, 12, 4, 4)):
    house = vtkCubeSource()
    house.SetBounds(x - width / 2, x + width / 2, y - depth / 2, y + depth / 2, 0, height)
    add(house)

# The sun: a directional light of half a degree. Rays, since its shadows are to be right.
sun = vtksoftshadows.vtkAreaLight()
sun.PositionalOff()
sun.SetAngularDiameter(0.53)
renderer.AddLight(sun)
shadows = vtksoftshadows.enable(renderer, "ray-traced", samples=16)

# A plan: from right above, in parallel.
camera = renderer.GetActiveCamera()
camera.ParallelProjectionOn()
camera.SetParallelScale(20)
camera.SetPosition(0, 0, 100)
camera.SetViewUp(0, 1, 0)
renderer.ResetCameraClippingRange()
window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetMultiSamples(0)
window.SetSize(600, 400)
window.AddRenderer(renderer)

hours = 0
for hour in HOURS:
    to_sun = direction_to_sun(hour)
    sun.SetPosition(to_sun)
    sun.SetFocalPoint(0, 0, 0)
    window.Render()
    image = shadows.GetVisibility(sun)  # the share of the sun that each pixel sees
    visibility = vtk_to_numpy(image.GetPointData().GetArray("Visibility")).reshape(400, 600)
    hours = hours + visibility * STEP
    print(f"{int(hour):02}:{int(hour % 1 * 60):02}  {1 - visibility.mean():4.0%} in shadow")
print(f"{hours.mean():.1f} hours of sun on average, at least {hours.min():.1f}")

# From blue, no sun, to yellow, sun all day.
scale = np.array([(0.10, 0.12, 0.35), (0.45, 0.20, 0.55), (0.90, 0.40, 0.35), (1.00, 0.90, 0.40)])
share = hours / (len(HOURS) * STEP) * (len(scale) - 1)
colors = np.stack([np.interp(share, range(len(scale)), scale[:, i]) for i in range(3)], axis=-1)
picture = vtkImageData()
picture.SetDimensions(600, 400, 1)
picture.GetPointData().SetScalars(
    numpy_to_vtk((255 * colors).astype(np.uint8).reshape(-1, 3), deep=True))
writer = vtkPNGWriter()
writer.SetInputData(picture)
writer.SetFileName(sys.argv[1])
writer.Write()
