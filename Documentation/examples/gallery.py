#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Ten ordinary scripts, each lit by one line: gallery.py FOLDER [NAME...] writes NAME.png of each.

Five are in the manner of VTK's own examples, five draw what scientists do. None of them sets a light.
"""

import pathlib
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonComputationalGeometry import vtkParametricBoy, \
    vtkParametricFigure8Klein, vtkParametricSuperToroid, vtkParametricTorus
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPlane, vtkPolyData, vtkQuadric
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkCutter, vtkGlyph3D, vtkMaskPoints, \
    vtkPolyDataNormals, vtkTubeFilter
from vtkmodules.vtkFiltersFlowPaths import vtkStreamTracer
from vtkmodules.vtkFiltersGeneral import vtkWarpScalar
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkFiltersModeling import vtkOutlineFilter
from vtkmodules.vtkFiltersSources import vtkArrowSource, vtkConeSource, vtkCubeSource, \
    vtkCylinderSource, vtkLineSource, vtkParametricFunctionSource, vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkImagingHybrid import vtkSampleFunction
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingAnnotation import vtkCubeAxesActor, vtkScalarBarActor
from vtkmodules.vtkRenderingCore import vtkActor, vtkGlyph3DMapper, vtkPolyDataMapper, vtkRenderer, \
    vtkRenderWindow, vtkWindowToImageFilter
import vtkmodules.vtkRenderingFreeType  # noqa: F401, for text

import vtksoftshadows


def show(renderer, source, color=None, mapper=None):
    """An actor of a filter's output or a data set: of one colour, or of its scalars."""
    mapper = mapper or vtkPolyDataMapper()
    if source is not None and source.IsA("vtkAlgorithm"):
        mapper.SetInputConnection(source.GetOutputPort())
    elif source is not None:
        mapper.SetInputData(source)
    actor = vtkActor()
    actor.SetMapper(mapper)
    if color:
        mapper.ScalarVisibilityOff()
        actor.GetProperty().SetColor(color)
    renderer.AddActor(actor)
    return actor


def look(renderer, position, up=(0, 0, 1), zoom=1.25):
    camera = renderer.GetActiveCamera()
    camera.SetPosition(position)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(up)
    renderer.ResetCamera()
    camera.Zoom(zoom)


def make_table(low, high):
    table = vtkLookupTable()
    table.SetHueRange(0.62, 0.03)
    table.SetSaturationRange(0.65, 0.75)
    table.SetTableRange(low, high)
    table.Build()
    return table


def make_image(values, low, high, name="value"):
    """Values as [z, y, x] in a box."""
    image = vtkImageData()
    size = values.shape[::-1]
    image.SetDimensions(size)
    image.SetOrigin(low)
    image.SetSpacing([(b - a) / max(1, n - 1) for a, b, n in zip(low, high, size)])
    array = numpy_to_vtk(values.astype(np.float32).ravel(), deep=True)
    array.SetName(name)
    image.GetPointData().SetScalars(array)
    return image


def cone(renderer):
    """A cone, as VTK's first tutorial draws it."""
    source = vtkConeSource()
    source.SetHeight(3)
    source.SetRadius(1)
    source.SetResolution(40)
    show(renderer, source, (0.95, 0.63, 0.35))
    look(renderer, (3, 3, 7), up=(0, 1, 0))


def parametric(renderer):
    """Parametric surfaces side by side."""
    for i, (function, color) in enumerate((
            (vtkParametricBoy(), (0.85, 0.45, 0.40)), (vtkParametricTorus(), (0.40, 0.62, 0.80)),
            (vtkParametricSuperToroid(), (0.55, 0.72, 0.45)),
            (vtkParametricFigure8Klein(), (0.90, 0.75, 0.40)))):
        source = vtkParametricFunctionSource()
        source.SetParametricFunction(function)
        source.SetUResolution(80)
        source.SetVResolution(80)
        source.SetWResolution(80)
        source.Update()
        actor = show(renderer, source, color)
        bounds = source.GetOutput().GetBounds()
        scale = 2 / max(b - a for a, b in zip(bounds[::2], bounds[1::2]))
        actor.SetScale(scale)
        actor.SetPosition(2.6 * (i % 2), -scale * bounds[2], 2.6 * (i // 2))
    look(renderer, (4, 7, 9), up=(0, 1, 0))


def spikes(renderer):
    """A ball with a spike at each of its points."""
    ball = vtkSphereSource()
    ball.SetThetaResolution(14)
    ball.SetPhiResolution(12)
    show(renderer, ball, (0.80, 0.82, 0.86))
    spike = vtkConeSource()
    spike.SetResolution(16)
    spike.SetRadius(0.16)
    spike.SetCenter(0.5, 0, 0)
    glyphs = vtkGlyph3D()
    glyphs.SetInputConnection(ball.GetOutputPort())
    glyphs.SetSourceConnection(spike.GetOutputPort())
    glyphs.SetVectorModeToUseNormal()
    glyphs.SetScaleModeToScaleByVector()
    glyphs.SetScaleFactor(0.25)
    show(renderer, glyphs, (0.75, 0.32, 0.28))
    look(renderer, (2, 2, 5), up=(0, 1, 0))


def quadric(renderer):
    """Surfaces of a quadric in its outline."""
    function = vtkQuadric()
    function.SetCoefficients(0.5, 1, 0.2, 0, 0.1, 0, 0, 0.2, 0, 0)
    sample = vtkSampleFunction()
    sample.SetSampleDimensions(50, 50, 50)
    sample.SetImplicitFunction(function)
    contours = vtkContourFilter()
    contours.SetInputConnection(sample.GetOutputPort())
    contours.GenerateValues(4, 0.2, 1.1)
    mapper = vtkPolyDataMapper()
    mapper.SetLookupTable(make_table(0.2, 1.1))
    mapper.UseLookupTableScalarRangeOn()
    show(renderer, contours, mapper=mapper)
    outline = vtkOutlineFilter()
    outline.SetInputConnection(sample.GetOutputPort())
    show(renderer, outline, (0.2, 0.2, 0.2))
    look(renderer, (4, 3, 5), up=(0, 1, 0), zoom=1.05)


def carpet(renderer):
    """A function of two variables as a surface."""
    plane = vtkPlaneSource()
    plane.SetResolution(150, 150)
    plane.SetOrigin(-10, -10, 0)
    plane.SetPoint1(10, -10, 0)
    plane.SetPoint2(-10, 10, 0)
    plane.Update()
    data = vtkPolyData()
    data.ShallowCopy(plane.GetOutput())
    data.GetPointData().Initialize()
    points = np.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
    radius = np.hypot(points[:, 0], points[:, 1])
    values = 4 * np.cos(radius) * np.exp(-radius / 6)
    data.GetPointData().SetScalars(numpy_to_vtk(values, deep=True))
    warp = vtkWarpScalar()
    warp.SetInputData(data)
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(warp.GetOutputPort())
    mapper = vtkPolyDataMapper()
    mapper.SetLookupTable(make_table(-3, 4))
    mapper.UseLookupTableScalarRangeOn()
    show(renderer, normals, mapper=mapper)
    look(renderer, (14, -22, 17))


def flow(renderer):
    """Isosurface, stream tubes, arrows, a coloured slice, scalar bar and axes."""
    axis = np.linspace(-1, 1, 64)
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    values = np.exp(-4 * ((x - 0.35)**2 + y**2 + z**2)) + \
        np.exp(-6 * ((x + 0.4)**2 + (y + 0.2)**2 + (z - 0.1)**2))
    image = make_image(values, (-1, -1, -1), (1, 1, 1), "density")
    velocity = np.stack([-y + 0.15 * x, x + 0.1 * np.sin(3 * z), 0.35 * np.cos(3 * x)], axis=-1)
    vectors = numpy_to_vtk(velocity.astype(np.float32).reshape(-1, 3), deep=True)
    vectors.SetName("velocity")
    image.GetPointData().SetVectors(vectors)
    table = make_table(0, 1.2)
    surface = vtkContourFilter()
    surface.SetInputData(image)
    surface.SetValue(0, 0.55)
    show(renderer, surface, (0.90, 0.80, 0.62))
    random = np.random.default_rng(5)
    places = vtkPoints()
    for place in random.uniform(-0.45, 0.45, (14, 3)):
        places.InsertNextPoint(place)
    seeds = vtkPolyData()
    seeds.SetPoints(places)
    lines = vtkStreamTracer()
    lines.SetInputData(image)
    lines.SetSourceData(seeds)
    lines.SetMaximumPropagation(6)
    lines.SetIntegrationDirectionToBoth()
    tubes = vtkTubeFilter()
    tubes.SetInputConnection(lines.GetOutputPort())
    tubes.SetRadius(0.02)
    tubes.SetNumberOfSides(12)
    plane = vtkPlane()
    plane.SetOrigin(0, 0, -0.97)
    plane.SetNormal(0, 0, 1)
    cut = vtkCutter()
    cut.SetInputData(image)
    cut.SetCutFunction(plane)
    for source in tubes, cut:
        mapper = vtkPolyDataMapper()
        mapper.SetLookupTable(table)
        mapper.UseLookupTableScalarRangeOn()
        show(renderer, source, mapper=mapper)
    some = vtkMaskPoints()
    some.SetInputData(image)
    some.SetOnRatio(6007)
    arrow = vtkArrowSource()
    arrow.SetTipResolution(16)
    arrow.SetShaftResolution(16)
    arrows = vtkGlyph3DMapper()
    arrows.SetSourceConnection(arrow.GetOutputPort())
    arrows.SetOrientationArray("velocity")
    arrows.SetScaleFactor(0.25)
    show(renderer, some, (0.30, 0.45, 0.35), arrows)
    bar = vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetTitle("density")
    bar.SetMaximumWidthInPixels(60)
    bar.SetPosition(0.88, 0.1)
    bar.SetHeight(0.5)
    bar.UnconstrainedFontSizeOn()
    axes = vtkCubeAxesActor()
    axes.SetBounds(-1, 1, -1, 1, -1, 1)
    axes.SetCamera(renderer.GetActiveCamera())
    for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty(),
                 *(axes.GetTitleTextProperty(i) for i in range(3)),
                 *(axes.GetLabelTextProperty(i) for i in range(3))):
        text.SetColor(0.1, 0.1, 0.1)
        text.SetFontSize(12)
    for lines in (axes.GetXAxesLinesProperty(), axes.GetYAxesLinesProperty(),
                  axes.GetZAxesLinesProperty()):
        lines.SetColor(0.1, 0.1, 0.1)
    renderer.AddViewProp(bar)
    renderer.AddActor(axes)
    look(renderer, (2.5, -4.5, 2.6), zoom=1.2)


def helix(renderer):
    """A double helix of balls and sticks."""
    turn = np.arange(24)
    colors = ((0.80, 0.35, 0.30), (0.35, 0.50, 0.75))
    for strand, color in enumerate(colors):
        angle = 0.55 * turn + np.pi * strand
        places = np.stack([np.cos(angle), np.sin(angle), 0.32 * turn], axis=-1)
        points = vtkPoints()
        points.SetData(numpy_to_vtk(places, deep=True))
        balls = vtkPolyData()
        balls.SetPoints(points)
        ball = vtkSphereSource()
        ball.SetRadius(0.28)
        ball.SetThetaResolution(32)
        ball.SetPhiResolution(32)
        mapper = vtkGlyph3DMapper()
        mapper.SetSourceConnection(ball.GetOutputPort())
        show(renderer, balls, color, mapper)
    for i in turn:
        angle = 0.55 * i
        line = vtkLineSource()
        line.SetPoint1(np.cos(angle), np.sin(angle), 0.32 * i)
        line.SetPoint2(-np.cos(angle), -np.sin(angle), 0.32 * i)
        stick = vtkTubeFilter()
        stick.SetInputConnection(line.GetOutputPort())
        stick.SetRadius(0.09)
        stick.SetNumberOfSides(16)
        show(renderer, stick, (0.85, 0.83, 0.78))
    look(renderer, (4, -14, 5), zoom=0.95)


def beam(renderer):
    """A bent beam of finite elements, with its edges."""
    size = (41, 7, 9)
    x, y, z = np.meshgrid(np.linspace(0, 8, size[0]), np.linspace(-0.6, 0.6, size[1]),
                          np.linspace(-0.8, 0.8, size[2]), indexing="ij")
    image = make_image((x * z).transpose(2, 1, 0), (0, -0.6, -0.8), (8, 0.6, 0.8))
    skin = vtkGeometryFilter()
    skin.SetInputData(image)
    skin.Update()
    data = vtkPolyData()
    data.DeepCopy(skin.GetOutput())
    points = np.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
    bend = -0.035 * points[:, 0]**2
    points[:, 0] += 0.07 * points[:, 0] * points[:, 2]
    points[:, 2] += bend + 2
    moved = vtkPoints()
    moved.SetData(numpy_to_vtk(points, deep=True))
    data.SetPoints(moved)
    mapper = vtkPolyDataMapper()
    mapper.SetLookupTable(make_table(-6, 6))
    mapper.UseLookupTableScalarRangeOn()
    actor = show(renderer, data, mapper=mapper)
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(0.2, 0.2, 0.25)
    wall = vtkCubeSource()
    wall.SetBounds(-0.6, 0, -1.8, 1.8, -0.3, 4)
    show(renderer, wall, (0.75, 0.75, 0.77))
    look(renderer, (7, -16, 7))


def nested(renderer):
    """A translucent surface around another one, as of skin and bone."""
    axis = np.linspace(-1.4, 1.4, 72)
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    outer = np.sqrt(x**2 + (0.8 * y)**2 + z**2) + 0.06 * np.sin(5 * x) * np.sin(5 * z)
    for level, color, opacity in ((1.0, (0.95, 0.78, 0.68), 0.35), (0.55, (0.95, 0.93, 0.86), 1)):
        values = outer if opacity < 1 else outer + 0.08 * np.sin(9 * y) * np.cos(8 * x)
        surface = vtkContourFilter()
        surface.SetInputData(make_image(values, (-1.4,) * 3, (1.4,) * 3))
        surface.SetValue(0, level)
        show(renderer, surface, color).GetProperty().SetOpacity(opacity)
    look(renderer, (3, -6, 3))


def bars(renderer):
    """Counts as bars."""
    random = np.random.default_rng(4)
    cells = np.arange(7)
    counts = 3 * np.exp(-((cells[:, None] - 3)**2 + (cells - 2.5)**2) / 6) + \
        0.4 * random.random((7, 7)) + 0.1
    table = make_table(0, 3.5)
    for i in cells:
        for j in cells:
            bar = vtkCubeSource() if (i + j) % 5 else vtkCylinderSource()
            height = counts[i, j]
            if bar.IsA("vtkCubeSource"):
                bar.SetBounds(i, i + 0.7, j, j + 0.7, 0, height)
                actor = show(renderer, bar, (1, 1, 1))
            else:
                bar.SetRadius(0.35)
                bar.SetHeight(height)
                bar.SetResolution(40)
                actor = show(renderer, bar, (1, 1, 1))
                actor.RotateX(90)
                actor.SetPosition(i + 0.35, j + 0.35, height / 2)
            color = [0.0, 0.0, 0.0]
            table.GetColor(height, color)
            actor.GetProperty().SetColor(color)
    look(renderer, (9, -14, 10), zoom=1.05)


SCENES = {scene.__name__: scene for scene in (
    cone, parametric, spikes, quadric, carpet, flow, helix, beam, nested, bars)}


def make(name, size=(600, 450)):
    """A scene in a window, without shadows."""
    renderer = vtkRenderer()
    renderer.SetBackground(0.93, 0.94, 0.96)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    SCENES[name](renderer)
    return renderer, window


def main():
    folder = pathlib.Path(sys.argv[1])
    for name in sys.argv[2:] or SCENES:
        renderer, window = make(name)
        vtksoftshadows.enable(renderer, lights="studio")  # the line
        window.Render()
        picture = vtkWindowToImageFilter()
        picture.SetInput(window)
        writer = vtkPNGWriter()
        writer.SetInputConnection(picture.GetOutputPort())
        writer.SetFileName(str(folder / f"{name}.png"))
        writer.Write()


if __name__ == "__main__":
    main()
