# SPDX-License-Identifier: BSD-3-Clause
"""Among VTK's other features: what is lit is the picture that VTK draws with them, to 1/255."""

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkRenderingCore import vtkCellPicker, vtkHardwareSelector, vtkPropPicker, \
    vtkRenderer
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLFXAAPass, vtkRenderStepsPass, vtkSSAOPass

from shadow_testing import Stage, TestCase, create_fine, family_names, grown, main, \
    receivers, technique_names, visibility


class ComposedStage(Stage):
    def __init__(self, **keywords):
        super().__init__(**keywords)
        self.floor = self.add_things()
        self.light = self.add_light()

    def render_out(self, delegate=None):
        """The picture with the light all but out, which is that of the shadow."""
        self.light.SetIntensity(1e-6)  # quite out, VTK would shade by another shader
        picture = self.render(delegate)
        self.light.SetIntensity(1)
        return picture


class Composition(TestCase):
    def check(self, picture, plain, out, seen, receives=True, reach=0):
        """Where all within reach see the light, or none, the picture is that of no shadows or of
        no light."""
        lit = ~grown(seen < 1, reach)
        dark = ~grown((seen > 0) | ~receives, reach)
        self.assertGreater(lit.sum(), 0.3 * seen.size)
        self.assertGreater(dark.sum(), 0.01 * seen.size)
        self.assertLessEqual(np.abs(picture - plain)[lit].max(), 1)
        self.assertLessEqual(np.abs(picture - out)[dark].max(), 1)

    def check_stage(self, stage, name, delegate=None, reach=0):
        plain = stage.render(delegate)
        out = stage.render_out(delegate)
        shadows = create_fine(name)
        shadows.SetDelegatePass(delegate)
        for _ in range(2):  # what the first frame leaves behind must not spoil the second
            picture = stage.render(shadows)
            self.check(picture, plain, out, visibility(shadows), receivers(shadows), reach)
        stage.renderer.SetPass(None)
        if delegate:
            delegate.ReleaseGraphicsResources(stage.window)

    def test_features_of_the_renderer(self):
        for name in technique_names():
            for feature in ("SSAO", "FXAA"):
                with self.subTest(technique=name, feature=feature):
                    stage = ComposedStage()
                    sharp = stage.render()
                    getattr(stage.renderer, "SetUse" + feature)(True)
                    stage.renderer.SetSSAORadius(0.5)
                    stage.renderer.SetSSAOBias(0.01)
                    stage.renderer.SSAOBlurOn()
                    self.assertFalse(np.array_equal(stage.render(), sharp))
                    self.check_stage(stage, name, reach=3)

    def test_effects_as_the_delegate(self):
        for name in family_names():
            for effect in (vtkSSAOPass, vtkOpenGLFXAAPass):
                with self.subTest(technique=name, effect=effect.__name__):
                    delegate = effect()
                    delegate.SetDelegatePass(vtkRenderStepsPass())
                    if effect is vtkSSAOPass:
                        delegate.SetRadius(0.5)
                        delegate.SetBias(0.01)
                        delegate.BlurOn()
                    self.check_stage(ComposedStage(), name, delegate, reach=3)

    def test_two_viewports(self):
        # A pass for each renderer, which show the same things from two sides.
        eyes = ((3.5, -6.5, 4.5), (-4, -6, 5))
        for name in family_names():
            with self.subTest(technique=name):
                stage = ComposedStage(size=(240, 120))
                renderers = [stage.renderer, vtkRenderer()]
                stage.window.AddRenderer(renderers[1])
                renderers[1].AutomaticLightCreationOff()
                renderers[1].AddLight(stage.light)
                actors = stage.renderer.GetActors()
                for i in range(actors.GetNumberOfItems()):
                    renderers[1].AddActor(actors.GetItemAsObject(i))
                for i, (renderer, eye) in enumerate(zip(renderers, eyes)):
                    renderer.SetViewport(0.5 * i, 0, 0.5 * i + 0.5, 1)
                    renderer.GetActiveCamera().SetPosition(*eye)
                    renderer.GetActiveCamera().SetFocalPoint(0.2, 0.2, 0.3)
                    renderer.GetActiveCamera().SetViewUp(0, 0, 1)
                    renderer.ResetCameraClippingRange()
                pictures = []
                for intensity in (1, 1e-6):
                    stage.light.SetIntensity(intensity)
                    halves = []
                    for i in (0, 1):
                        # Alone: VTK 9.1 takes one renderer's lights for those of all that draw by
                        # the same shaders.
                        for j in (0, 1):
                            renderers[j].SetDraw(i == j)
                        stage.light.Modified()
                        halves.append(stage.render()[:, 120 * i:120 * i + 120])
                    pictures.append(halves)
                stage.light.SetIntensity(1)
                passes = [create_fine(name) for _ in eyes]
                for renderer, shadows in zip(renderers, passes):
                    renderer.DrawOn()
                    renderer.SetPass(shadows)
                for _ in range(2):
                    stage.window.Render()
                    picture = stage.grab()
                    for i in (0, 1):
                        self.check(picture[:, 120 * i:120 * i + 120], pictures[0][i],
                                   pictures[1][i], visibility(passes[i]), receivers(passes[i]))
                renderers[1].SetPass(None)

    def test_stereo(self):
        for name in technique_names():
            for eye in ("Left", "Right"):
                with self.subTest(technique=name, eye=eye):
                    stage = ComposedStage()
                    mono = stage.render()
                    getattr(stage.window, "SetStereoTypeTo" + eye)()
                    stage.window.StereoRenderOn()
                    self.assertGreater(np.abs(stage.render() - mono).max(), 50)
                    self.check_stage(stage, name)

    def test_resize(self):
        # After a change of size the picture is that of a new window.
        for name in technique_names():
            stage = ComposedStage()
            shadows = create_fine(name)
            stage.render(shadows)
            for size in ((210, 120), (97, 141), (160, 120)):
                with self.subTest(technique=name, size=size):
                    stage.window.SetSize(*size)
                    picture = stage.render(shadows)
                    fresh = ComposedStage(size=size)
                    other = create_fine(name)
                    np.testing.assert_array_equal(picture, fresh.render(other))
                    np.testing.assert_array_equal(visibility(shadows), visibility(other))

    def test_picking(self):
        # By rays and by hardware: the same props and cells as without shadows; the picture stays.
        def pick(stage):
            found = []
            for x in range(20, 160, 30):
                for y in range(15, 120, 30):
                    for picker in (vtkPropPicker(), vtkCellPicker()):
                        picker.Pick(x, y, 0, stage.renderer)
                        found.append(picker.GetActor())
                    found.append(picker.GetCellId())
            selector = vtkHardwareSelector()
            selector.SetRenderer(stage.renderer)
            selector.SetArea(0, 0, 159, 119)
            selector.SetFieldAssociation(vtkDataObject.FIELD_ASSOCIATION_CELLS)
            selection = selector.Select()
            cells = {}
            for i in range(selection.GetNumberOfNodes()):
                node = selection.GetNode(i)
                ids = node.GetSelectionList()
                cells[node.GetProperties().Get(node.PROP())] = {
                    ids.GetValue(k) for k in range(ids.GetNumberOfTuples())}
            return found, cells

        for name in technique_names():
            with self.subTest(technique=name):
                stage = ComposedStage()
                stage.render()
                expected, expected_cells = pick(stage)
                self.assertEqual(len(expected_cells), 3)
                self.assertGreaterEqual(len(set(map(id, filter(None, expected)))), 3)
                shadows = create_fine(name)
                picture = stage.render(shadows)
                found, cells = pick(stage)
                self.assertTrue(all(a is b or a == b for a, b in zip(found, expected)))
                self.assertEqual(cells, expected_cells)
                np.testing.assert_array_equal(stage.render(shadows), picture)


if __name__ == "__main__":
    main()
