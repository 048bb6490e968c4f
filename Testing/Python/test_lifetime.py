# SPDX-License-Identifier: BSD-3-Clause
"""Windows that close, passes that come and go: nothing keeps what VTK alone would let go."""

import ctypes
import gc
import os
import unittest

from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkAssembly, vtkPolyDataMapper, vtkRenderWindow, \
    vtkTexture
from vtkmodules.vtkRenderingOpenGL2 import vtkCameraPass, vtkDepthPeelingPass, \
    vtkGaussianBlurPass, vtkLightsPass, vtkOpaquePass, vtkOpenGLFXAAPass, vtkRenderPassCollection, \
    vtkRenderStepsPass, vtkSequencePass, vtkSSAAPass, vtkSSAOPass

from shadow_testing import SIZE, Stage, TestCase, create, describe, family_names, has_parameter, \
    main, statistics, technique_names, visibility, vss

# Megabytes that the process may grow by in twenty windows, each with a mesh of about 5 MB, that are
# closed with the shadows on. A window that is kept would be 100 of them.
GROWTH = 12


def small(name):
    """Parameters of a technique that make it fast."""
    return {key: value for key, value in {"resolution": 256, "samples": 4}.items()
            if has_parameter(name, key)}


def resident():
    """Megabytes of the process in memory, without what the C library keeps for the next who ask."""
    gc.collect()
    trim = getattr(ctypes.CDLL(None), "malloc_trim", None)
    if trim:
        trim(0)
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2 ** 20


def total(shadows):
    return statistics(shadows)["bytes"]["total"]


class Closing(TestCase):
    def count_gone(self, build, *arguments):
        """Builds, draws, and closes with the pass still set: how many objects, and how many went."""
        gone = []

        def once():
            stage, things = build(*arguments)
            for thing in [stage.window, stage.renderer, stage.renderer.GetActiveCamera(), *things]:
                # VTK gives observers no object with this event.
                thing.AddObserver("DeleteEvent", lambda caller, event: gone.append(event))
            stage.window.Render()
            stage.window.Finalize()
            return 3 + len(things)

        count = once()
        gc.collect()
        return count, len(gone)

    def check(self, build, *arguments):
        count, gone = self.count_gone(build, *arguments)
        self.assertEqual(gone, count)

    @staticmethod
    def build(name, wrap=None):
        stage = Stage()
        floor = stage.add_things()
        light = stage.add_light()
        shadows = vss.enable(stage.renderer, name, **small(name))
        if wrap:
            wrap(stage, shadows)
        mapper = floor.GetMapper()
        return stage, [shadows, light, floor, mapper, mapper.GetInputAlgorithm(), mapper.GetInput()]

    def test_everything_goes(self):
        for name in technique_names():
            with self.subTest(technique=name):
                self.check(self.build, name)

    def test_without_shadows_it_does(self):
        def build():
            stage = Stage()
            return stage, [stage.add_things(), stage.add_light()]
        self.check(build)

    def test_after_visibility_was_asked_for(self):
        def ask(stage, shadows):
            stage.window.Render()
            visibility(shadows)
        for name in technique_names():
            with self.subTest(technique=name):
                self.check(self.build, name, ask)

    def test_within_another_pass(self):
        def wrap(stage, shadows):
            ssao = vtkSSAOPass()
            ssao.SetDelegatePass(shadows)
            stage.renderer.SetPass(ssao)
        for name in family_names():
            with self.subTest(technique=name):
                self.check(lambda name: self.build(name, wrap), name)

    def test_by_a_debug_view_an_assembly_a_catcher_and_a_textured_light(self):
        def build(name):
            stage, things = self.build(name)
            shadows = things[0]
            assembly = vtkAssembly()
            parts = []
            for x in (-1, 1):
                source = vtkSphereSource()
                source.SetCenter(x, 0, 1)
                mapper = vtkPolyDataMapper()
                mapper.SetInputConnection(source.GetOutputPort())
                parts.append(vtkActor())
                parts[-1].SetMapper(mapper)
                assembly.AddPart(parts[-1])
            vss.vtkShadowPass.SetCasting(parts[0], False)
            stage.renderer.AddActor(assembly)
            catcher = stage.add_floor(5)
            vss.vtkShadowPass.SetShadowCatcher(catcher, True)
            image = vtkImageData()
            image.SetDimensions(4, 4, 1)
            image.AllocateScalars(VTK_UNSIGNED_CHAR, 3)
            image.GetPointData().GetScalars().Fill(200)
            texture = vtkTexture()
            texture.SetInputData(image)
            light = vss.vtkAreaLight()
            light.SetLightTypeToSceneLight()
            light.SetShapeToRectangle()
            light.SetPosition(1, -1, 5)
            light.SetTexture(texture)
            if describe(name)["lightShapes"]["textured"] != "unsupported":
                stage.renderer.AddLight(light)
            self.assertTrue(shadows.SetDebugView("visibility"))
            return stage, things + parts + [assembly, catcher, image, texture, light]
        for name in technique_names():
            with self.subTest(technique=name):
                self.check(build, name)
                self.errors()  # a technique may say that it does without a light

    @unittest.skipUnless(os.path.exists("/proc/self/statm"), "needs /proc to see the memory")
    def test_twenty_windows(self):
        def once(name):
            stage = Stage()
            plane = vtkPlaneSource()
            plane.SetOrigin(-3, -3, 0)
            plane.SetPoint1(3, -3, 0)
            plane.SetPoint2(-3, 3, 0)
            plane.SetResolution(250, 250)
            stage.add(plane)
            stage.add_sphere((0, 0, 1), 0.5)
            stage.look_at((3.5, -6.5, 4.5))
            stage.add_light()
            shadows = vss.enable(stage.renderer, name, **small(name))
            stage.window.Render()
            visibility(shadows)
            stage.window.Finalize()

        for name in ["map-pcss"] + family_names():
            with self.subTest(technique=name):
                for i in range(22):
                    if i == 2:
                        before = resident()
                    once(name)
                growth = resident() - before
                print(f"{name}: {growth:+.2f} MB after 20 windows")
                self.assertLess(growth, GROWTH)

    def test_opened_again(self):
        for name in technique_names():
            with self.subTest(technique=name):
                stage, things = self.build(name)
                shadows = things[0]
                stage.window.Render()
                first = stage.grab()
                held = total(shadows)
                self.assertGreater(held, 0)
                for _ in range(2):
                    stage.window.Finalize()
                    self.assertEqual(total(shadows), 0)
                    stage.window.Render()
                    self.assertTrue((stage.grab() == first).all())
                    self.assertEqual(total(shadows), held)

    def test_from_window_to_window(self):
        for name in family_names():
            with self.subTest(technique=name):
                stage, things = self.build(name)
                shadows = things[0]
                stage.window.Render()
                first = stage.grab()
                for _ in range(2):
                    old = stage.window
                    stage.window = vtkRenderWindow()
                    stage.window.SetOffScreenRendering(True)
                    stage.window.SetMultiSamples(0)
                    stage.window.SetSize(*SIZE)
                    old.RemoveRenderer(stage.renderer)
                    self.assertEqual(total(shadows), 0)
                    stage.window.AddRenderer(stage.renderer)
                    stage.window.Render()
                    self.assertTrue((stage.grab() == first).all())
                    del old
                    stage.window.Render()
                    self.assertTrue((stage.grab() == first).all())

    def test_off_screen_and_on(self):
        for name in family_names():
            with self.subTest(technique=name):
                stage, _ = self.build(name)
                if stage.window.IsA("vtkEGLRenderWindow"):
                    self.skipTest("EGL's windows are off screen")
                stage.window.Render()
                first = stage.grab()
                for on in (False, True):
                    stage.window.SetOffScreenRendering(on)
                    stage.window.Render()
                    stage.window.Render()
                    self.assertTrue((stage.grab() == first).all())


def in_delegate(kind):
    def wrap(inner):
        outer = kind()
        outer.SetDelegatePass(inner)
        return outer
    return wrap


def in_sequence(inner):
    """A camera and its steps, as PyVista has them."""
    passes = vtkRenderPassCollection()
    passes.AddItem(vtkLightsPass())
    passes.AddItem(inner)
    sequence = vtkSequencePass()
    sequence.SetPasses(passes)
    camera = vtkCameraPass()
    camera.SetDelegatePass(sequence)
    return camera


def in_several(inner):
    return in_delegate(vtkSSAAPass)(in_delegate(vtkOpenGLFXAAPass)(in_sequence(inner)))


def in_steps(inner):
    steps = vtkRenderStepsPass()
    steps.SetOpaquePass(inner)
    return steps


def in_peeling(inner):
    peeling = vtkDepthPeelingPass()
    peeling.SetTranslucentPass(inner)
    return peeling


WRAPS = {"ambient occlusion": in_delegate(vtkSSAOPass), "FXAA": in_delegate(vtkOpenGLFXAAPass),
         "blur": in_delegate(vtkGaussianBlurPass), "camera": in_delegate(vtkCameraPass),
         "supersampling": in_delegate(vtkSSAAPass), "sequence": in_sequence, "several": in_several}


class Chain(TestCase):
    """enable() and disable() where a shadow pass stands within another."""

    def stage(self):
        stage = Stage()
        stage.add_things()
        stage.add_light()
        return stage

    def look(self, stage):
        stage.window.Render()
        return stage.grab()

    def test_replaced_where_it_stands(self):
        for name in technique_names():
            for what, wrap in WRAPS.items():
                if what != "ambient occlusion" and name != "map-pcss":
                    continue
                with self.subTest(technique=name, within=what):
                    stage = self.stage()
                    outer = wrap(create(name, **small(name)))
                    expected = stage.render(outer)
                    first = vss.vtkShadowPass.FindOn(stage.renderer)
                    second = vss.enable(stage.renderer, name, **small(name))
                    self.assertIsNot(second, first)
                    self.assertIs(vss.vtkShadowPass.FindOn(stage.renderer), second)
                    self.assertIs(stage.renderer.GetPass(), outer)
                    self.assertTrue((self.look(stage) == expected).all())
                    self.assertEqual(total(first), 0)
                    self.assertGreater(total(second), 0)

    def test_taken_off_where_it_stands(self):
        for what, wrap in WRAPS.items():
            for delegate in (None, vtkRenderStepsPass()):
                with self.subTest(within=what, delegate=delegate is not None):
                    stage = self.stage()
                    plain = wrap(delegate or vtkRenderStepsPass())
                    expected = stage.render(plain)
                    plain.ReleaseGraphicsResources(stage.window)
                    shadows = create("map-hard")
                    shadows.SetDelegatePass(delegate)
                    outer = wrap(shadows)
                    self.assertFalse((stage.render(outer) == expected).all())
                    vss.disable(stage.renderer)
                    self.assertIsNone(vss.vtkShadowPass.FindOn(stage.renderer))
                    self.assertIs(stage.renderer.GetPass(), outer)
                    self.assertTrue((self.look(stage) == expected).all())
                    self.assertEqual(total(shadows), 0)

    def test_the_delegate_goes_along(self):
        stage = self.stage()
        steps = vtkRenderStepsPass()
        shadows = vss.vtkShadowTechniques.Create("map-hard")
        shadows.SetDelegatePass(steps)
        stage.renderer.SetPass(in_delegate(vtkSSAOPass)(shadows))
        self.assertIs(vss.enable(stage.renderer, "map-pcss").GetDelegatePass(), steps)
        vss.disable(stage.renderer)
        self.assertIs(stage.renderer.GetPass().GetDelegatePass(), steps)

    def test_several_become_one(self):
        stage = self.stage()
        inner = create("map-hard")
        outer = create("map-hard")
        outer.SetDelegatePass(in_sequence(inner))
        stage.renderer.SetPass(outer)
        shadows = vss.enable(stage.renderer, "map-hard")
        expected = self.look(stage)
        self.assertEqual(self.errors(), "")
        vss.disable(stage.renderer)
        self.assertIsNone(vss.vtkShadowPass.FindOn(stage.renderer))
        self.assertTrue((stage.render(create("map-hard")) == expected).all())
        self.assertIsNot(shadows, outer)

    def test_as_a_step(self):
        for wrap in (in_steps, in_peeling):
            stage = self.stage()
            first = create("map-hard")
            outer = wrap(first)
            stage.renderer.SetPass(outer)
            second = vss.enable(stage.renderer, "map-hard")
            self.assertIs(vss.vtkShadowPass.FindOn(stage.renderer), second)
            self.assertIs(stage.renderer.GetPass(), outer)
            vss.disable(stage.renderer)
            self.assertIsNone(vss.vtkShadowPass.FindOn(stage.renderer))

    def test_put_on_twice(self):
        stage = self.stage()
        shadows = vss.enable(stage.renderer, "map-hard")
        expected = self.look(stage)
        shadows.PutOn(stage.renderer)
        self.assertIsNone(shadows.GetDelegatePass())
        self.assertTrue((self.look(stage) == expected).all())

    def test_what_bites_its_tail(self):
        stage = self.stage()
        shadows = vss.enable(stage.renderer, "map-hard")
        self.look(stage)
        ssao = in_delegate(vtkSSAOPass)(shadows)
        shadows.SetDelegatePass(ssao)
        self.assertIn("within", self.errors())
        self.assertIsNone(shadows.GetDelegatePass())
        shadows.SetDelegatePass(shadows)
        self.assertIn("itself", self.errors())
        # Closed from outside, where it cannot be seen: it says so, and ends.
        later = vtkSSAOPass()
        later.SetDelegatePass(vtkOpaquePass())
        shadows.SetDelegatePass(later)
        later.SetDelegatePass(shadows)
        self.look(stage)
        self.assertIn("its own delegate", self.errors())
        later.SetDelegatePass(None)


if __name__ == "__main__":
    main()
