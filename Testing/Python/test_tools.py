# SPDX-License-Identifier: BSD-3-Clause
"""An interactor's tools: what of them casts, and how to leave it out."""

from vtkmodules.vtkInteractionWidgets import vtkBoxRepresentation, vtkBoxWidget, vtkBoxWidget2, \
    vtkImplicitPlaneRepresentation, vtkImplicitPlaneWidget2, vtkLineRepresentation, vtkLineWidget, \
    vtkLineWidget2, vtkPlaneWidget, vtkSphereRepresentation, vtkSphereWidget2
from vtkmodules.vtkRenderingCore import vtkRenderWindowInteractor

from shadow_testing import Stage, TestCase, create, main, statistics, vss

BOUNDS = (-1.0, 1.0, -1.0, 1.0, 0.2, 2.2)


def without_shadow(widget, renderer):
    """As Documentation/what-casts.md has it."""
    own = (widget.GetHandleProperty(), widget.GetSelectedHandleProperty())
    for actor in renderer.GetActors():
        if actor.GetProperty() in own:
            vss.vtkShadowPass.SetCasting(actor, False)


class Tools(TestCase):
    def setUp(self):
        super().setUp()
        self.scene = Stage()
        self.scene.add_things()
        self.scene.add_light()
        self.interactor = vtkRenderWindowInteractor()
        self.interactor.SetRenderWindow(self.scene.window)
        self.shadows = create("map-hard")
        self.things = self.casters()

    def tearDown(self):
        self.scene.window.SetInteractor(None)
        super().tearDown()

    def casters(self):
        self.scene.render(self.shadows)
        return statistics(self.shadows)["counts"]["casters"]

    def enable(self, widget):
        widget.SetInteractor(self.interactor)
        widget.SetDefaultRenderer(self.scene.renderer)
        widget.On()

    def test_3d_widgets(self):
        for kind in (vtkBoxWidget, vtkPlaneWidget, vtkLineWidget):
            with self.subTest(kind.__name__):
                widget = kind()
                widget.PlaceWidget(BOUNDS)
                self.enable(widget)
                self.assertGreater(self.casters(), self.things, "handles are props as all others")
                without_shadow(widget, self.scene.renderer)
                self.assertEqual(self.casters(), self.things)
                widget.Off()
                widget.On()  # it keeps its actors
                self.assertEqual(self.casters(), self.things)
                widget.Off()

    def test_representations(self):
        for kind, representation in ((vtkBoxWidget2, vtkBoxRepresentation),
                                     (vtkLineWidget2, vtkLineRepresentation),
                                     (vtkSphereWidget2, vtkSphereRepresentation),
                                     (vtkImplicitPlaneWidget2, vtkImplicitPlaneRepresentation)):
            with self.subTest(kind.__name__):
                widget = kind()
                shown = representation()
                shown.PlaceWidget(BOUNDS)
                widget.SetRepresentation(shown)
                self.enable(widget)
                self.assertEqual(self.casters(), self.things)
                widget.Off()


if __name__ == "__main__":
    main()
