#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""An ordinary VTK program, and the one line that gives it soft shadows: one_line.py picture.png"""

import sys

from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersModeling import vtkLinearExtrusionFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSuperquadricSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, \
    vtkRenderWindow, vtkWindowToImageFilter
from vtkmodules.vtkRenderingFreeType import vtkVectorText

import vtksoftshadows

# What is shown: letters that stand on a plane, a ring behind them.
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

plane = vtkPlaneSource()
plane.SetOrigin(-8, -8, 0)
plane.SetPoint1(8, -8, 0)
plane.SetPoint2(-8, 8, 0)

renderer = vtkRenderer()
renderer.SetBackground(0.85, 0.87, 0.90)
for source, color in ((standing, (0.20, 0.45, 0.80)), (ring, (0.90, 0.55, 0.20)),
                      (plane, (0.95, 0.95, 0.92))):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetAmbient(0.25)
    actor.GetProperty().SetDiffuse(0.75)
    renderer.AddActor(actor)

lamp = vtkLight()
lamp.PositionalOn()
lamp.SetConeAngle(180)  # on all sides
lamp.SetPosition(-4, -3, 5)
renderer.AddLight(lamp)

camera = renderer.GetActiveCamera()
camera.SetPosition(0.5, -6.2, 3.2)
camera.SetFocalPoint(0.5, 0.4, 0.45)
camera.SetViewUp(0, 0, 1)
renderer.ResetCameraClippingRange()

window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetSize(600, 400)
window.AddRenderer(renderer)

# The line. The radius is the lamp's: without, it is a point whose shadow is hard.
vtksoftshadows.enable(renderer, radius=0.4)

window.Render()
picture = vtkWindowToImageFilter()
picture.SetInput(window)
writer = vtkPNGWriter()
writer.SetInputConnection(picture.GetOutputPort())
writer.SetFileName(sys.argv[1])
writer.Write()
