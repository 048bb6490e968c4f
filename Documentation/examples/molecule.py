#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Caffeine, of ball and stick imposters, with soft shadows: molecule.py picture.png"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersGeneral import vtkVertexGlyphFilter
from vtkmodules.vtkImagingCore import vtkImageResize
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, \
    vtkRenderWindow, vtkWindowToImageFilter
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLSphereMapper, vtkOpenGLStickMapper

import vtksoftshadows

# Element and place, in Angstrom.
ATOMS = """
N 1.31 -0.98 0.00   C 0.10 -1.63 0.00   O 0.05 -2.86 0.00   N -1.06 -0.87 0.00
C -0.97 0.51 0.00   O -1.97 1.22 0.00   C 0.30 1.10 0.00    C 1.40 0.31 0.00
N 0.70 2.43 0.00    C 2.05 2.36 0.00    N 2.50 1.11 0.00    C 2.53 -1.80 0.00
C -2.38 -1.53 0.00  C -0.17 3.60 0.00   H 2.68 3.24 0.00    H 3.40 -1.13 0.00
H 2.55 -2.43 0.89   H 2.55 -2.43 -0.89  H -3.15 -0.76 0.00  H -2.47 -2.15 0.89
H -2.47 -2.15 -0.89 H 0.43 4.50 0.00    H -0.80 3.59 0.89   H -0.80 3.59 -0.89
""".split()
COLORS = {"H": (240, 240, 240), "C": (75, 80, 90), "N": (50, 90, 220), "O": (220, 40, 40)}
RADII = {"H": 0.28, "C": 0.42, "N": 0.42, "O": 0.42}

elements = ATOMS[::4]
places = np.array([ATOMS[i::4] for i in (1, 2, 3)], float).T


def imposters(mapper, centres, colors, **arrays):
    """An actor of points that the mapper draws as what they stand for."""
    data = vtkPolyData()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.array(centres, np.float32), deep=True))
    data.SetPoints(points)
    for name, values in arrays.items():
        array = numpy_to_vtk(np.array(values, np.float32), deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    # The stick mapper draws nothing of points that have no colours.
    data.GetPointData().SetScalars(numpy_to_vtk(np.array(colors, np.uint8), deep=True))
    vertices = vtkVertexGlyphFilter()  # and knows no bounds of points without cells
    vertices.SetInputData(data)
    mapper.SetInputConnection(vertices.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.RotateX(70)  # stand it up, on the two hydrogens that are lowest
    actor.RotateZ(20)
    actor.GetProperty().SetSpecular(0.3)
    actor.GetProperty().SetSpecularPower(40)
    return actor


spheres = vtkOpenGLSphereMapper()
spheres.SetScaleArray("radius")
balls = imposters(spheres, places, [COLORS[e] for e in elements],
                  radius=[RADII[e] for e in elements])

pairs = [(i, j) for i in range(len(elements)) for j in range(i)
         if np.linalg.norm(places[i] - places[j]) < 1.6
         and not elements[i] == elements[j] == "H"]
sticks = vtkOpenGLStickMapper()
sticks.SetOrientationArray("along")
sticks.SetScaleArray("size")  # length, radius
rods = imposters(
    sticks, [(places[i] + places[j]) / 2 for i, j in pairs], [(170, 170, 175)] * len(pairs),
    along=[places[i] - places[j] for i, j in pairs],
    size=[(np.linalg.norm(places[i] - places[j]), 0.13, 0) for i, j in pairs])

renderer = vtkRenderer()
renderer.SetBackground(0.80, 0.84, 0.90)
for actor in balls, rods:
    renderer.AddActor(actor)
vtksoftshadows.enable(renderer, lights="studio")

camera = renderer.GetActiveCamera()
camera.SetPosition(1.5, -17, 8)
camera.SetFocalPoint(0.5, 0, -0.3)
camera.SetViewUp(0, 0, 1)
renderer.ResetCamera()
camera.Zoom(1.2)
window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetSize(1200, 800)  # halved below: a window's samples do not smooth imposters' edges
window.AddRenderer(renderer)
window.Render()

picture = vtkWindowToImageFilter()
picture.SetInput(window)
half = vtkImageResize()
half.SetInputConnection(picture.GetOutputPort())
half.SetOutputDimensions(600, 400, 1)
half.BorderOn()  # the mean of each four pixels
writer = vtkPNGWriter()
writer.SetInputConnection(half.GetOutputPort())
writer.SetFileName(sys.argv[1])
writer.Write()
