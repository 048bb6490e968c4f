#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Panes whose shadows are as dark as they are opaque: translucent.py picture.png"""

import sys

from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, \
    vtkRenderWindow, vtkWindowToImageFilter

import vtksoftshadows

renderer = vtkRenderer()
renderer.SetBackground(0.85, 0.87, 0.90)


def add(source, color, opacity=1):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetOpacity(opacity)
    actor.GetProperty().SetAmbient(0.2)
    actor.GetProperty().SetDiffuse(0.8)
    renderer.AddActor(actor)


floor = vtkPlaneSource()
floor.SetOrigin(-12, -12, 0)
floor.SetPoint1(12, -12, 0)
floor.SetPoint2(-12, 12, 0)
add(floor, (0.95, 0.93, 0.90))

# Four panes from nearly clear to opaque, and a ball behind them.
for i, (opacity, color) in enumerate(((0.2, (0.2, 0.7, 0.9)), (0.45, (0.3, 0.8, 0.4)),
                                      (0.7, (0.9, 0.6, 0.2)), (1.0, (0.8, 0.25, 0.3)))):
    pane = vtkCubeSource()
    pane.SetCenter(1.25 * (i - 1.5), 0, 0.85)
    pane.SetXLength(0.95)
    pane.SetYLength(0.06)
    pane.SetZLength(1.7)
    add(pane, color, opacity)
ball = vtkSphereSource()
ball.SetCenter(-0.6, 1.4, 0.5)
ball.SetThetaResolution(48)
ball.SetPhiResolution(48)
add(ball, (0.95, 0.95, 0.95))

light = vtksoftshadows.vtkAreaLight()
light.SetPosition(-2.5, 6, 5.5)
light.SetRadius(0.4)
light.SetIntensity(0.7)
renderer.AddLight(light)
# From the eye, for the sides that the light does not reach.
fill = vtkLight()
fill.SetLightTypeToHeadlight()
fill.SetIntensity(0.4)
vtksoftshadows.vtkShadowPass.SetLightCasting(fill, False)
renderer.AddLight(fill)

# By default what is translucent casts nothing; "opaque" would have it cast as if it were opaque.
vtksoftshadows.enable(renderer, translucent_casters="weighted")
# So that surfaces behind each other are blended in order, whatever their order in the renderer.
renderer.UseDepthPeelingOn()

camera = renderer.GetActiveCamera()
camera.SetPosition(1.2, -6.6, 4.4)
camera.SetFocalPoint(0.1, -0.4, 0.4)
camera.SetViewUp(0, 0, 1)
renderer.ResetCameraClippingRange()
window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetMultiSamples(0)  # which peeling does without
window.SetSize(600, 400)
window.AddRenderer(renderer)
window.Render()

picture = vtkWindowToImageFilter()
picture.SetInput(window)
writer = vtkPNGWriter()
writer.SetInputConnection(picture.GetOutputPort())
writer.SetFileName(sys.argv[1])
writer.Write()
