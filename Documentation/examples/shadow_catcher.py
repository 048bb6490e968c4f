#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A model and its shadow, with alpha, laid over another picture: shadow_catcher.py picture.png

Given a second name, the model and its shadow alone are written there, to be laid over anything.
"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonComputationalGeometry import vtkParametricFigure8Klein
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkParametricFunctionSource, vtkPlaneSource
from vtkmodules.vtkImagingCore import vtkImageBlend, vtkImageResize
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, \
    vtkRenderWindow, vtkWindowToImageFilter

import vtksoftshadows

WIDTH, HEIGHT = 1200, 800  # halved at the end: peeling goes without a window's samples


def make_background():
    """In the place of a photograph: a board of stripes below a wall that grows lighter."""
    y, x = np.mgrid[0:HEIGHT, 0:WIDTH] / HEIGHT
    depth = 1 / np.maximum(0.72 - y, 0.02)  # the board's stripes run to a vanishing point
    stripes = np.floor(((x - 0.75) * depth + 50) * 2.5) % 2
    grain = 0.04 * np.random.default_rng(1).standard_normal((HEIGHT, WIDTH))
    board = (0.75 + 0.15 * stripes + grain)[..., None] * (0.85, 0.66, 0.45)
    wall = (0.9 - 0.5 * (y - 0.6))[..., None] * (0.75, 0.85, 0.95)
    colors = (np.where((y < 0.66)[..., None], board, wall).clip(0, 1) * 255).astype(np.uint8)
    image = vtkImageData()
    image.SetDimensions(WIDTH, HEIGHT, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(colors.reshape(-1, 3), deep=True))
    return image


def write(port, path):
    writer = vtkPNGWriter()
    writer.SetInputConnection(port)
    writer.SetFileName(path)
    writer.Write()


def actor_of(source):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


model = vtkParametricFunctionSource()
model.SetParametricFunction(vtkParametricFigure8Klein())
model.SetUResolution(120)
model.SetVResolution(120)
body = actor_of(model)
body.SetScale(0.5)
body.SetPosition(0, 0, 0.52)
body.GetProperty().SetColor(0.75, 0.20, 0.25)
body.GetProperty().SetAmbient(0.25)
body.GetProperty().SetSpecular(0.4)
body.GetProperty().SetSpecularPower(30)

# Where the model stands. Of this plane nothing is seen but the shadow on it.
plane = vtkPlaneSource()
plane.SetOrigin(-9, -9, 0)
plane.SetPoint1(9, -9, 0)
plane.SetPoint2(-9, 9, 0)
catcher = actor_of(plane)
catcher.GetProperty().SetOpacity(0.8)  # not quite black
vtksoftshadows.vtkShadowPass.SetShadowCatcher(catcher, True)

renderer = vtkRenderer()
renderer.AddActor(body)
renderer.AddActor(catcher)
light = vtksoftshadows.vtkAreaLight()
light.SetPosition(-4, -3, 6)
light.SetRadius(0.7)
renderer.AddLight(light)
vtksoftshadows.enable(renderer)

# Alpha: a window that has it, a background that is clear, and the peeling that keeps it right.
renderer.SetBackgroundAlpha(0)
renderer.UseDepthPeelingOn()
window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetMultiSamples(0)
window.SetAlphaBitPlanes(1)
window.SetSize(WIDTH, HEIGHT)
window.AddRenderer(renderer)
camera = renderer.GetActiveCamera()
camera.SetPosition(0, -7, 3.4)
camera.SetFocalPoint(0.3, 0, 0.55)
camera.SetViewUp(0, 0, 1)
camera.SetViewAngle(32)
renderer.ResetCameraClippingRange()
window.Render()

grab = vtkWindowToImageFilter()
grab.SetInput(window)
grab.SetInputBufferTypeToRGBA()
grab.ReadFrontBufferOff()
blend = vtkImageBlend()
blend.AddInputData(make_background())
blend.AddInputConnection(grab.GetOutputPort())
half = vtkImageResize()
half.SetInputConnection(blend.GetOutputPort())
half.SetOutputDimensions(WIDTH // 2, HEIGHT // 2, 1)
half.BorderOn()  # the mean of each four pixels
write(half.GetOutputPort(), sys.argv[1])
if len(sys.argv) > 2:
    write(grab.GetOutputPort(), sys.argv[2])
