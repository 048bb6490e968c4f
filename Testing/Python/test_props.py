# SPDX-License-Identifier: BSD-3-Clause
"""Kinds of props: each casts the shadow of what VTK draws, and is drawn as VTK draws it."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPlane, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkConeSource, vtkCubeSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkAssembly, vtkCompositeDataDisplayAttributes, \
    vtkGlyph3DMapper, vtkPolyDataMapper, vtkPropAssembly
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLSphereMapper, vtkOpenGLStickMapper

from shadow_testing import Stage, TestCase, create_fine, main, receivers, technique_names, \
    visibility, vss

try:  # until VTK 9.2 only this one has attributes of blocks; from 9.5 on it is gone
    from vtkmodules.vtkRenderingOpenGL2 import vtkCompositePolyDataMapper2 as BlockMapper
except ImportError:
    from vtkmodules.vtkRenderingCore import vtkCompositePolyDataMapper as BlockMapper

SIZE = (300, 300)


def points(centre, **arrays):
    """Three points in a row along x, with arrays."""
    places = vtkPoints()
    cells = vtkCellArray()
    for i in range(3):
        place = places.InsertNextPoint(centre[0] + 0.4 * (i - 1), centre[1], centre[2])
        cells.InsertNextCell(1, [place])
    data = vtkPolyData()
    data.SetPoints(places)
    data.SetVerts(cells)
    for name, values in arrays.items():
        values = numpy_to_vtk(np.array(values, np.float32), deep=True)
        values.SetName(name)
        data.GetPointData().AddArray(values)
    return data


def cube(centre, size):
    source = vtkCubeSource()
    source.SetCenter(*centre)
    source.SetXLength(size[0])
    source.SetYLength(size[1])
    source.SetZLength(size[2])
    source.Update()
    return source.GetOutput()


def actor_of(mapper):
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def cube_actor(centre, size):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(cube(centre, size))
    return actor_of(mapper)


def glyphs(at):
    """Cones along x, turned to directions and scaled by length."""
    cone = vtkConeSource()
    cone.SetHeight(0.5)
    cone.SetRadius(0.12)
    mapper = vtkGlyph3DMapper()
    mapper.SetInputData(points(at, along=[(0.2, 1, 1), (-1.5, 0, 0), (1, -1, -0.5)]))
    mapper.SetSourceConnection(cone.GetOutputPort())
    mapper.SetOrientationArray("along")
    mapper.SetScaleArray("along")
    mapper.SetScaleModeToScaleByMagnitude()
    return actor_of(mapper)


def spheres(at):
    mapper = vtkOpenGLSphereMapper()
    mapper.SetInputData(points(at, size=(0.2, 0.3, 0.15)))
    mapper.SetScaleArray("size")
    return actor_of(mapper)


def sticks(at):
    data = points(at, along=[(0, 0, 1), (0.6, 0.8, 0), (0.6, 0, 0.8)],
                  size=[(0.6, 0.1, 0), (0.7, 0.15, 0), (0.5, 0.08, 0)], color=(0.1, 0.5, 0.9))
    data.GetPointData().SetActiveScalars("color")
    mapper = vtkOpenGLStickMapper()
    mapper.SetInputData(data)
    mapper.SetOrientationArray("along")
    mapper.SetScaleArray("size")
    actor = actor_of(mapper)
    mapper.ScalarVisibilityOn()  # without colours VTK draws none
    return actor


def clipped(at):
    plane = vtkPlane()
    plane.SetOrigin(*at)
    plane.SetNormal(1, 0.4, 0)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(cube(at, (0.9, 0.9, 0.9)))
    mapper.AddClippingPlane(plane)
    return actor_of(mapper)


def blocks(at):
    """A block that is shown on the left, and a hidden one on the right."""
    data = vtkMultiBlockDataSet()
    data.SetBlock(0, cube((at[0] - 0.4, at[1], at[2]), (0.4, 0.5, 0.3)))
    data.SetBlock(1, cube((at[0] + 0.3, at[1], at[2]), (0.4, 0.3, 0.9)))
    mapper = BlockMapper()
    mapper.SetInputDataObject(data)
    attributes = vtkCompositeDataDisplayAttributes()
    attributes.SetBlockVisibility(data.GetBlock(1), False)
    mapper.SetCompositeDataDisplayAttributes(attributes)
    return actor_of(mapper)


def assembly(at):
    whole = vtkAssembly()
    for x in (-0.35, 0.35):
        whole.AddPart(cube_actor((x, 0, 0), (0.4, 0.3, 0.5)))
    whole.SetPosition(*at)
    whole.RotateZ(30)
    return whole


PROPS = {prop.__name__: prop for prop in (glyphs, spheres, sticks, clipped, blocks, assembly)}
PLACES = np.array([(1.7 * (i % 3 - 1), 1.8 * (i // 3) - 0.9, 0.9) for i in range(len(PROPS))])


class PropStage(Stage):
    """All of these props over a floor, and a light's place to look from."""

    light_place = (-0.5, -1, 6)

    def __init__(self):
        super().__init__(SIZE)
        self.floor = self.add_floor(4)
        for prop, place in zip(PROPS.values(), PLACES):
            self.renderer.AddViewProp(prop(place))
        self.light = self.add_light(self.light_place)

    def look_from_light(self):
        self.look_at(self.light_place, angle=50)

    def look_from_eye(self):
        self.look_at((1.5, -6, 6), angle=50)


def nearest_prop(places):
    """The number of the prop that is nearest to each place."""
    return np.argmin(np.linalg.norm(places[..., None, :] - PLACES, axis=-1), axis=-1)


class Props(TestCase):
    def test_cast_what_the_light_sees(self):
        # VTK's own picture, taken from the light, is the truth: what it shows covered of the floor
        # lies in shadow, and nothing else does. Pixels at an edge of that picture are left out.
        stage = PropStage()
        stage.look_from_light()
        hidden = stage.covered(stage.floor)
        to_light = stage.to_picture()
        stage.look_from_eye()
        covered = stage.covered(stage.floor)
        place = stage.floor_points()
        seen = np.concatenate([place, np.ones_like(place[..., :1])], axis=-1) @ to_light.T
        seen = np.floor((seen[..., :2] / seen[..., 3:] + 1) / 2 * SIZE).astype(int)
        inside = ((seen > 0) & (seen < np.array(SIZE) - 1)).all(axis=-1)
        inside &= ~covered & (np.abs(place[..., :2]) < 3.9).all(axis=-1)
        x, y = np.moveaxis(np.where(inside[..., None], seen, 1), -1, 0)
        around = sum(hidden[y + j, x + i].astype(int) for j in (-1, 0, 1) for i in (-1, 0, 1))
        decided = inside & ((around == 0) | (around == 9))
        # Which prop's shadow it is: by what the ray to the light meets at the props' height.
        which = nearest_prop(place + 0.15 * (np.array(stage.light_place) - place))
        self.assertGreater(decided.sum(), 10000)
        for name in technique_names():
            shadows = create_fine(name)
            stage.render(shadows)
            wrong = decided & receivers(shadows) & ((visibility(shadows) < 0.5) != (around == 9))
            for i, prop in enumerate(PROPS):
                with self.subTest(technique=name, prop=prop):
                    dark = (decided & (around == 9) & (which == i)).sum()
                    self.assertGreater(dark, 100)
                    # A texel, or the sides of a polyhedron that stands for a ball, may reach
                    # further.
                    self.assertLessEqual((wrong & (which == i)).sum(), 0.03 * dark)

    def test_are_drawn_as_vtk_draws_them(self):
        stage = PropStage()
        stage.look_from_eye()
        plain = stage.render()
        stage.light.SetIntensity(1e-6)  # quite out, VTK would shade by another shader
        out = stage.render()
        stage.light.SetIntensity(1)
        for name in technique_names():
            with self.subTest(technique=name):
                shadows = create_fine(name)
                picture = stage.render(shadows)
                seen = visibility(shadows)
                lit = ~receivers(shadows) | (seen == 1)
                dark = receivers(shadows) & (seen == 0)
                self.assertGreater(dark.sum(), 3000)
                self.assertLessEqual(np.abs(picture - plain)[lit].max(), 1)
                self.assertLessEqual(np.abs(picture - out)[dark].max(), 1)


class Assemblies(TestCase):
    def build(self, kind):
        stage = Stage(SIZE)
        floor = stage.add_floor(4)
        whole = kind()
        parts = [cube_actor((x, 0, 1), (0.6, 0.8, 0.5)) for x in (-1.2, 1.2)]
        for part in parts:
            whole.AddPart(part)
        stage.renderer.AddViewProp(whole)
        stage.add_light((0, 0, 6))
        stage.look_at((0, -6, 6), angle=50)
        uncovered = ~stage.covered(floor)
        left = stage.floor_points()[..., 0] < 0
        return stage, whole, parts, [uncovered & left, uncovered & ~left]

    def test_switches(self):
        # The switch of an assembly holds for all of its parts: VTK lends them its keys.
        for name in technique_names():
            for kind in (vtkAssembly, vtkPropAssembly):
                with self.subTest(technique=name, kind=kind.__name__):
                    stage, whole, parts, sides = self.build(kind)
                    shadows = create_fine(name)

                    def shadow():
                        stage.render(shadows)
                        return [int((visibility(shadows)[side] < 0.5).sum()) for side in sides]

                    both = shadow()
                    self.assertGreater(min(both), 500)
                    vss.vtkShadowPass.SetCasting(whole, False)
                    self.assertEqual(shadow(), [0, 0])
                    vss.vtkShadowPass.SetCasting(whole, True)
                    self.assertEqual(shadow(), both)
                    parts[0].VisibilityOff()
                    self.assertEqual(shadow(), [0, both[1]])

    def test_does_not_receive(self):
        for name in technique_names():
            with self.subTest(technique=name):
                stage, whole, _, _ = self.build(vtkAssembly)
                stage.add_box((-1, 0, 2.5), (0.5, 0.5, 0.1))  # casts on the left part
                plain = stage.render()
                floor = stage.covered(stage.renderer.GetActors().GetItemAsObject(0))
                vss.vtkShadowPass.SetReceiving(whole, False)
                picture = stage.render(create_fine(name))
                self.assertLessEqual(np.abs(picture - plain)[floor].max(), 1)


if __name__ == "__main__":
    main()
