#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""An ordinary VTK program, and the one line that gives it soft shadows: one_line.py picture.png"""

import sys

from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersModeling import vtkLinearExtrusionFilter
from vtkmodules.vtkFiltersSources import vtkSuperquadricSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, \
    vtkRenderWindow, vtkWindowToImageFilter
from vtkmodules.vtkRenderingFreeType import vtkVectorText

import vtksoftshadows

# What is shown: letters, and a ring behind them.
text = vtkVectorText()
text.SetText("VTK")
letters = vtkLinearExtrusionFilter()
letters.SetInputConnection(text.GetOutputPort())
letters.SetExtrusionTypeToVectorExtrusion()
letters.SetVector(0, 0, 0.35)
upright = vtkTransform()
upright.RotateX(90)
upright.Translate(-1.35, 0, -0.2)
standing = vtkTransformPolyDataFilter()
standing.SetInputConnection(letters.GetOutputPort())
standing.SetTransform(upright)

ring = vtkSuperquadricSource()
ring.ToroidalOn()
ring.SetThickness(0.25)
ring.SetPhiResolution(64)
ring.SetThetaResolution(64)
ring.SetScale(1.3, 1.3, 1.3)
ring.SetCenter(2.1, 1.2, 0.75)

renderer = vtkRenderer()
renderer.SetBackground(0.85, 0.87, 0.90)
for source, color in ((standing, (0.20, 0.45, 0.80)), (ring, (0.90, 0.55, 0.20))):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    renderer.AddActor(actor)

camera = renderer.GetActiveCamera()
camera.SetPosition(0.5, -6.2, 3.2)
camera.SetFocalPoint(0.5, 0.4, 0.45)
camera.SetViewUp(0, 0, 1)
renderer.ResetCamera()
camera.Zoom(1.4)

window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetSize(600, 400)
window.AddRenderer(renderer)

# The line: a large soft light, and a ground for the shadow. Without `lights`, those of the renderer cast.
vtksoftshadows.enable(renderer, lights="studio")

window.Render()
picture = vtkWindowToImageFilter()
picture.SetInput(window)
writer = vtkPNGWriter()
writer.SetInputConnection(picture.GetOutputPort())
writer.SetFileName(sys.argv[1])
writer.Write()
