"""What the Python tests share: scenes, pictures as numpy arrays, and an ear for VTK's errors."""

import json
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

import vtksoftshadows as vss

SIZE = (160, 120)  # not square, so that a transposed or stretched shadow shows

# A connection to the display that stays: an X server (Xvfb, without -noreset) starts anew when its
# last client goes, and a window that is opened just then finds none.
_display = vtkRenderWindow()
_display.SetOffScreenRendering(True)
_display.SetSize(8, 8)


def technique_names():
    techniques = vss.vtkShadowTechniques
    return [techniques.GetName(i) for i in range(techniques.GetNumberOfTechniques())]


def describe(technique):
    return json.loads(vss.vtkShadowTechniques.Describe(technique))


def has_parameter(technique, name):
    return any(parameter["name"] == name for parameter in describe(technique)["parameters"])


def create(technique, **parameters):
    shadows = vss.vtkShadowTechniques.Create(technique)
    for name, value in parameters.items():
        assert shadows.SetParameter(name, str(value))
    return shadows


class Scene:
    """A built-in scene in a window of its own that nobody sees."""

    def __init__(self, name, size=SIZE):
        _display.Render()
        self.renderer = vtkRenderer()
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)  # a pixel is one place: it is in shadow or not
        self.window.SetSize(*size)
        self.window.AddRenderer(self.renderer)
        if not vss.vtkShadowScenes.Build(name, self.renderer):
            raise ValueError(name)
        self.light = self.renderer.GetLights().GetItemAsObject(0)

    def render(self, shadows=None):
        """Draw with a pass, or without; the picture, rows upwards, whole numbers 0 to 255."""
        self.renderer.SetPass(shadows)
        self.window.Render()
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.ShouldRerenderOff()
        grab.Update()
        width, height = self.window.GetSize()
        pixels = vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars())
        return pixels.reshape(height, width, 3).astype(int)

    def actors(self):
        """The ground's actor, and a list of all the others."""
        key = vss.vtkShadowScenes.GROUND()
        ground, others = None, []
        actors = self.renderer.GetActors()
        for i in range(actors.GetNumberOfItems()):
            actor = actors.GetItemAsObject(i)
            keys = actor.GetPropertyKeys()
            if keys and keys.Has(key):
                ground = actor
            else:
                others.append(actor)
        return ground, others


def array(image, name):
    width, height, _ = image.GetDimensions()
    values = vtk_to_numpy(image.GetPointData().GetArray(name))
    return values.reshape((height, width) + values.shape[1:])


def visibility(shadows, light=0):
    return array(shadows.GetVisibility(light), "Visibility")


def receivers(shadows, light=0):
    return array(shadows.GetVisibility(light), "Receiver") != 0


def statistics(shadows):
    return json.loads(shadows.GetStatistics())


class TestCase(unittest.TestCase):
    """Fails a test during which VTK reports something that the test did not expect."""

    def setUp(self):
        self.output = vtkStringOutputWindow()
        self.before = vtkOutputWindow.GetInstance()
        vtkOutputWindow.SetInstance(self.output)
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)  # what is expected is not printed
        self.heard = 0

    def tearDown(self):
        left = self.errors()
        vtkOutputWindow.SetInstance(self.before)
        self.assertEqual(left, "", "VTK reported what the test did not expect")

    def errors(self):
        """What VTK has reported since the last call."""
        text = self.output.GetOutput() or ""
        new = text[self.heard:]
        self.heard = len(text)
        return new


def main():
    unittest.main(verbosity=2)
