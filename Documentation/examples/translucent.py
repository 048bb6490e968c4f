#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Panes whose shadows are as dark as they are opaque: translucent.py picture.png"""

import sys

from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource
from vtkmodules.vtkImagingCore import vtkImageResize
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, \
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
    renderer.AddActor(actor)


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

# By default what is translucent casts nothing; "opaque" would have it cast as if it were opaque.
vtksoftshadows.studio(renderer, darkness=0.5, elevation=40, azimuth=170)  # from behind the panes
vtksoftshadows.enable(renderer, translucent_casters="weighted")
# So that surfaces behind each other are blended in order, whatever their order in the renderer.
renderer.UseDepthPeelingOn()

camera = renderer.GetActiveCamera()
camera.SetPosition(1.2, -6.6, 4.4)
camera.SetFocalPoint(0.1, -0.9, 0.4)
camera.SetViewUp(0, 0, 1)
renderer.ResetCameraClippingRange()
window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetMultiSamples(0)  # which peeling does without: twice as large then, and halved below
window.SetSize(1200, 800)
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
