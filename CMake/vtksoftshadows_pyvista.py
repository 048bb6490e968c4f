# SPDX-License-Identifier: BSD-3-Clause
"""Soft shadows for PyVista's plotters.

    import pyvista, vtksoftshadows.pyvista
    plotter = pyvista.Plotter()
    plotter.soft_shadows.enable("map-pcss", angle=3)

Importing this gives every plotter the component soft_shadows (PyVista 0.48 or newer; its entry point does
so without the import). It acts on the active subplot.
"""

import pyvista as _pyvista
from vtkmodules.vtkRenderingOpenGL2 import vtkCameraPass as _CameraPass

import vtksoftshadows as _softshadows

__all__ = ["AreaLight", "SoftShadows"]


class AreaLight(_softshadows.vtkAreaLight):
    """A light with an area, to be given to plotter.soft_shadows.add_light().

    position, focal_point   as pyvista.Light has them
    radius                  of a sphere, in world units
    size                    (width, height) of a rectangle, in the place of radius
    color, intensity        as pyvista.Light has them
    """

    def __init__(self, position=(0.0, 0.0, 1.0), focal_point=(0.0, 0.0, 0.0), radius=None, size=None,
                 color=None, intensity=1.0):
        if (radius is None) == (size is None):
            raise ValueError("an AreaLight has either a radius (a sphere) or a size (a rectangle)")
        self.SetLightTypeToSceneLight()
        self.SetPosition(*position)
        self.SetFocalPoint(*focal_point)
        self.SetPositional(True)
        self.SetConeAngle(90)
        self.SetIntensity(intensity)
        if color is not None:
            self.SetColor(*_pyvista.Color(color).float_rgb)
        if radius is not None:
            self.SetShapeToSphere()
            self.SetRadius(radius)
        else:
            self.SetShapeToRectangle()
            self.SetWidth(size[0])
            self.SetHeight(size[1])


class SoftShadows:
    """Soft shadows of a plotter: plotter.soft_shadows."""

    def __init__(self, plotter):
        self._plotter = plotter
        self._shadows = {}  # of each renderer

    def enable(self, technique=None, radius=None, quality=None, lights=None, angle=None,
               **parameters):
        """Give the active subplot soft shadows; returns the vtkShadowPass.

        The arguments are those of vtksoftshadows.enable. PyVista's lights are directional, unless they
        are positional: angle makes the shadows of the former soft, radius those of the latter.
        """
        renderer = self._plotter.renderer
        self._forget(renderer)
        shadows = _softshadows.enable(
            renderer, technique, radius, quality, lights, angle, **parameters)
        renderer.SetPass(shadows.GetDelegatePass())
        shadows.SetDelegatePass(None)
        place = _Place(shadows)
        place.take(renderer)
        # Whatever the user enables or disables, PyVista chains its own passes anew, and drops others.
        observer = renderer.AddObserver("StartEvent", lambda caller, _: place.take(caller))
        self._shadows[renderer] = place, observer
        return shadows

    def disable(self):
        """Take the shadows off the active subplot."""
        renderer = self._plotter.renderer
        self._forget(renderer)
        _softshadows.disable(renderer)

    def visibility(self, light=0):
        """What of a light is seen at the pixels of the last frame, 0 to 1, as an array of NumPy.

        light   itself, or its number: 0 is the first that casts
        """
        return _softshadows.visibility(self._plotter.renderer, light)

    def add_light(self, light):
        """Add an AreaLight; plotter.add_light() would take it for a plain one."""
        self._plotter.renderer.AddLight(light)
        return light

    def shadow_catcher(self, mesh, **arguments):
        """Show of something its shadow alone; returns the actor.

        mesh        a mesh, added as by plotter.add_mesh(mesh, **arguments); or an actor, such as
                    plotter.add_floor() returns
        """
        actor = mesh
        if not hasattr(mesh, "GetMapper"):
            actor = self._plotter.add_mesh(mesh, **arguments)
        _softshadows.vtkShadowPass.SetShadowCatcher(actor, True)
        return actor

    def add_floor(self, **arguments):
        """PyVista's floor, as a shadow catcher; returns the actor."""
        return self.shadow_catcher(self._plotter.add_floor(**arguments))

    def _forget(self, renderer):
        place, observer = self._shadows.pop(renderer, (None, None))
        if place is not None:
            renderer.RemoveObserver(observer)
            place.leave()

    def _release(self):
        for renderer in list(self._shadows):
            self._forget(renderer)
            _softshadows.disable(renderer)

    def __plotter_close__(self):
        self._release()
        self._plotter = None

    def __plotter_deep_clean__(self):
        self._release()


class _Place:
    """Where a pass stands in PyVista's chain: innermost, in the place of what is shaded."""

    def __init__(self, shadows):
        self.shadows = shadows
        self.camera = None  # PyVista's pass around it, and what that had there
        self.shaded = None

    def take(self, renderer):
        if _softshadows.vtkShadowPass.FindOn(renderer) is self.shadows:
            return
        self.leave()
        step = renderer.GetPass()
        while step is not None and not isinstance(step, _CameraPass):
            step = step.GetDelegatePass() if hasattr(step, "GetDelegatePass") else None
        if step is None:
            self.shadows.PutOn(renderer)
            return
        self.camera, self.shaded = step, step.GetDelegatePass()
        self.shadows.SetDelegatePass(self.shaded)
        step.SetDelegatePass(self.shadows)

    def leave(self):
        if self.camera is not None:
            self.camera.SetDelegatePass(self.shaded)
            self.shadows.SetDelegatePass(None)
            self.camera = self.shaded = None


if not any(entry.name == "soft_shadows" for entry in _pyvista.registered_plotter_components()):
    _pyvista.register_plotter_component("soft_shadows")(SoftShadows)
