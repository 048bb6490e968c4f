#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A cone and a sphere over a plane, lit by an area light: soft_shadows.py picture.png"""

import sys

from vtkmodules.vtkFiltersSources import vtkConeSource, vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, \
    vtkRenderWindow, vtkWindowToImageFilter

import vtksoftshadows

cone = vtkConeSource()
cone.SetCenter(-0.7, 0.0, 0.6)
cone.SetHeight(1.2)
cone.SetDirection(0.0, 0.0, 1.0)
cone.SetResolution(60)

sphere = vtkSphereSource()
sphere.SetCenter(0.7, 0.0, 0.9)
sphere.SetThetaResolution(60)
sphere.SetPhiResolution(60)

plane = vtkPlaneSource()
plane.SetOrigin(-4.0, -4.0, 0.0)
plane.SetPoint1(4.0, -4.0, 0.0)
plane.SetPoint2(-4.0, 4.0, 0.0)

renderer = vtkRenderer()
renderer.SetBackground(0.85, 0.87, 0.90)
for source in cone, sphere, plane:
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer.AddActor(actor)

light = vtksoftshadows.vtkAreaLight()
light.SetPosition(-4.0, -2.0, 5.0)
light.SetRadius(0.5)
light.SetShadowAttenuation(0.8)  # not quite black
renderer.AddLight(light)

shadows = vtksoftshadows.vtkShadowTechniques.Create("map-pcss")
renderer.SetPass(shadows)

camera = renderer.GetActiveCamera()
camera.SetPosition(0.0, -7.0, 5.0)
camera.SetFocalPoint(0.0, 0.0, 0.5)
camera.SetViewUp(0.0, 0.0, 1.0)
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
