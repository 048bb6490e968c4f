#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A light kit and a lamp, each with shadows of its own, or none: many_lights.py picture.png"""

import sys

from vtkmodules.vtkFiltersSources import vtkConeSource, vtkCylinderSource, vtkPlaneSource, \
    vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkLightKit, vtkPolyDataMapper, vtkRenderer, \
    vtkRenderWindow, vtkWindowToImageFilter

import vtksoftshadows
from vtksoftshadows import vtkShadowPass

renderer = vtkRenderer()
renderer.SetBackground(0.16, 0.17, 0.20)


def add(source, color):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    renderer.AddActor(actor)
    return actor


floor = vtkPlaneSource()
floor.SetOrigin(-12, -12, 0)
floor.SetPoint1(12, -12, 0)
floor.SetPoint2(-12, 12, 0)
add(floor, (0.85, 0.85, 0.85))
cone = vtkConeSource()
cone.SetDirection(0, 0, 1)
cone.SetHeight(1.6)
cone.SetCenter(-1.3, 0.2, 0.8)
cone.SetResolution(64)
add(cone, (0.85, 0.55, 0.25))
ball = vtkSphereSource()
ball.SetRadius(0.6)
ball.SetCenter(0.2, -0.3, 0.6)
ball.SetThetaResolution(64)
ball.SetPhiResolution(64)
add(ball, (0.80, 0.80, 0.85))
column = vtkCylinderSource()
column.SetHeight(1.8)
column.SetRadius(0.35)
column.SetResolution(64)
pillar = add(column, (0.35, 0.60, 0.45))
pillar.RotateX(90)
pillar.SetPosition(1.6, 0.5, 0.9)

# VTK's kit: a key light, a fill, a headlight and two at the back, which go with the camera. They
# come into the renderer in that order (headlight last); only the key is to cast.
kit = vtkLightKit()
kit.SetKeyLightIntensity(0.5)
kit.AddLightsToRenderer(renderer)
lights = renderer.GetLights()
for i in range(lights.GetNumberOfItems()):
    vtkShadowPass.SetLightCasting(lights.GetItemAsObject(i), i == 0)

# And two coloured lamps. The shadow of the second is lighter: a quarter of its light stays.
for position, color, attenuation in (((-5, 3, 4), (0.9, 0.35, 0.15), 1.0),
                                     ((4, 4, 3.5), (0.15, 0.35, 0.9), 0.75)):
    lamp = vtksoftshadows.vtkAreaLight()
    lamp.SetPosition(position)
    lamp.SetRadius(0.25)
    lamp.SetDiffuseColor(color)
    lamp.SetIntensity(0.7)
    lamp.SetShadowAttenuation(attenuation)
    renderer.AddLight(lamp)

vtksoftshadows.enable(renderer)
camera = renderer.GetActiveCamera()
camera.SetPosition(0, -6.5, 4.2)
camera.SetFocalPoint(0.1, -0.2, 0.5)
camera.SetViewUp(0, 0, 1)
renderer.ResetCameraClippingRange()
window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetSize(600, 400)
window.AddRenderer(renderer)
window.Render()

picture = vtkWindowToImageFilter()
picture.SetInput(window)
writer = vtkPNGWriter()
writer.SetInputConnection(picture.GetOutputPort())
writer.SetFileName(sys.argv[1])
writer.Write()
