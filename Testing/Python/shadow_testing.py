# SPDX-License-Identifier: BSD-3-Clause
"""What the Python tests share: scenes, pictures as numpy arrays, and an ear for VTK's errors."""

import json
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, \
    vtkRenderWindow, vtkWindowToImageFilter

import vtksoftshadows as vss

vss.vtkShadowPass.SetAdvice(False)  # lights here are as they are meant

SIZE = (160, 120)  # not square, so that a transposed or stretched shadow shows

# A connection to the display that stays: an X server (Xvfb, without -noreset) starts anew when its
# last client goes, and a window that is opened just then finds none.
_display = vtkRenderWindow()
_display.SetOffScreenRendering(True)
_display.SetSize(8, 8)


def declared_names():
    techniques = vss.vtkShadowTechniques
    return [techniques.GetName(i) for i in range(techniques.GetNumberOfTechniques())]


def technique_names():
    """Not auto: it is one of the others, chosen in each new pass (Testing/Cxx/Automatic.cxx)."""
    return [name for name in declared_names() if name != "auto"]


def describe(technique):
    return json.loads(vss.vtkShadowTechniques.Describe(technique))


def has_parameter(technique, name):
    return any(parameter["name"] == name for parameter in describe(technique)["parameters"])


def family_names():
    """One technique of each family: of maps, planes, volumes and rays."""
    return list({name.split("-")[0]: name for name in technique_names()}.values())


def create(technique, **parameters):
    """A pass; a keyword has underscores where the parameter has hyphens."""
    shadows = vss.vtkShadowTechniques.Create(technique)
    for name, value in parameters.items():
        assert shadows.SetParameter(name.replace("_", "-"), str(value))
    return shadows


def create_fine(technique, **parameters):
    """A pass for lights without a size: fine maps, few samples, which are all the same, hard edges."""
    fine = {"resolution": 1024, "samples": 4, "antialias": "off"}
    parameters.update((name, value) for name, value in fine.items()
                      if has_parameter(technique, name))
    return create(technique, **parameters)


class Stage:
    """A renderer in a window of its own that nobody sees, to be filled."""

    def __init__(self, size=SIZE):
        _display.Render()
        self.renderer = vtkRenderer()
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)  # a pixel is one place: it is in shadow or not
        self.window.SetSize(*size)
        self.window.AddRenderer(self.renderer)

    def render(self, shadows=None):
        """Draw with a pass, or without; the picture, rows upwards, whole numbers 0 to 255."""
        self.renderer.SetPass(shadows)
        self.window.Render()
        return self.grab()

    def grab(self):
        """The picture that the window shows."""
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.ShouldRerenderOff()
        grab.Update()
        width, height = self.window.GetSize()
        pixels = vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars())
        return pixels.reshape(height, width, 3).astype(int)

    def add(self, source, color=(1, 1, 1), opacity=1):
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(*color)
        actor.GetProperty().SetAmbient(0.2)
        actor.GetProperty().SetDiffuse(0.8)
        actor.GetProperty().SetOpacity(opacity)
        self.renderer.AddActor(actor)
        return actor

    def add_floor(self, half_side=3):
        """A square in the plane z = 0."""
        plane = vtkPlaneSource()
        plane.SetOrigin(-half_side, -half_side, 0)
        plane.SetPoint1(half_side, -half_side, 0)
        plane.SetPoint2(-half_side, half_side, 0)
        return self.add(plane)

    def add_box(self, centre, size, **keywords):
        cube = vtkCubeSource()
        cube.SetCenter(*centre)
        cube.SetXLength(size[0])
        cube.SetYLength(size[1])
        cube.SetZLength(size[2])
        return self.add(cube, **{"color": (0.8, 0.5, 0.4), **keywords})

    def add_sphere(self, centre, radius):
        sphere = vtkSphereSource()
        sphere.SetCenter(*centre)
        sphere.SetRadius(radius)
        sphere.SetThetaResolution(32)
        sphere.SetPhiResolution(32)
        return self.add(sphere, color=(0.4, 0.6, 0.8))

    def add_things(self):
        """A box and a ball on a floor, seen from the front and above. Gives the floor."""
        floor = self.add_floor()
        self.add_box((-0.8, 0.3, 0.6), (1, 1, 1.2))
        self.add_sphere((0.9, -0.5, 1.3), 0.6)
        self.look_at((3.5, -6.5, 4.5), (0.2, 0.2, 0.3))
        return floor

    def add_light(self, position=(-2.5, -2, 5.5), positional=True):
        """One without a size, whose shadow is hard."""
        light = vtkLight()
        light.SetLightTypeToSceneLight()
        light.SetPositional(positional)
        light.SetConeAngle(180)
        light.SetPosition(*position)
        light.SetFocalPoint(0, 0, 0)
        self.renderer.AddLight(light)
        return light

    def look_at(self, position, focus=(0, 0, 0), angle=40):
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(*position)
        camera.SetFocalPoint(*focus)
        camera.SetViewUp(*((0, 1, 0) if position[:2] == focus[:2] else (0, 0, 1)))
        camera.SetViewAngle(angle)
        self.renderer.ResetCameraClippingRange()

    def covered(self, *hidden):
        """Pixels in which VTK draws something that is not one of these props."""
        for prop in hidden:
            prop.VisibilityOff()
        before = self.renderer.GetBackground()
        self.renderer.SetBackground(0, 0, 1)
        picture = self.render()
        self.renderer.SetBackground(before)
        for prop in hidden:
            prop.VisibilityOn()
        return (picture != (0, 0, 255)).any(axis=2)

    def to_picture(self):
        """The camera's matrix from places in the scene to places from -1 to 1 in the picture."""
        width, height = self.window.GetSize()
        matrix = vtkMatrix4x4()
        matrix.DeepCopy(self.renderer.GetActiveCamera().GetCompositeProjectionTransformMatrix(
            width / height, -1, 1))
        return np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])

    def rays(self):
        """The camera's position, and the direction of each pixel's ray."""
        width, height = self.window.GetSize()
        x, y = np.meshgrid((np.arange(width) + 0.5) / width * 2 - 1,
                           (np.arange(height) + 0.5) / height * 2 - 1)
        far = np.stack([x, y, np.ones_like(x), np.ones_like(x)], axis=-1)
        far = far @ np.linalg.inv(self.to_picture()).T
        position = np.array(self.renderer.GetActiveCamera().GetPosition())
        return position, far[..., :3] / far[..., 3:] - position

    def floor_points(self):
        """The point of the plane z = 0 that each pixel shows, or would."""
        return meet(*self.rays(), 0)


class Scene(Stage):
    """A built-in scene."""

    def __init__(self, name, size=SIZE):
        super().__init__(size)
        if not vss.vtkShadowScenes.Build(name, self.renderer):
            raise ValueError(name)
        self.light = self.renderer.GetLights().GetItemAsObject(0)

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


def meet(position, direction, height):
    """Where rays meet the plane z = height, NaN where they do not."""
    with np.errstate(divide="ignore", invalid="ignore"):
        t = (height - position[2]) / direction[..., 2]
    t = np.where(t > 0, t, np.nan)
    return position + t[..., None] * direction


def grown(mask, reach):
    """A mask, and all pixels that are so near to it."""
    height, width = mask.shape
    padded = np.pad(mask, reach)
    return np.any([padded[y:y + height, x:x + width]
                   for y in range(2 * reach + 1) for x in range(2 * reach + 1)], axis=0)


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
