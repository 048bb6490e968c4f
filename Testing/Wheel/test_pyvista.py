# SPDX-License-Identifier: BSD-3-Clause
"""PyVista's plotters with soft shadows, as its gallery uses them: lights, PBR, SSAO, peeling, subplots.

With the wheel and PyVista installed, and no display.
"""

import gc
import os
import tempfile
import unittest

import numpy as np
import pyvista as pv

import vtksoftshadows
import vtksoftshadows.pyvista  # noqa: F401 gives plotters the component

SIZE = (240, 200)


def chain(renderer):
    """The passes of a renderer, outermost first, by their classes' names."""
    names = []
    step = renderer.GetPass()
    while step is not None:
        names.append(step.GetClassName())
        step = step.GetDelegatePass() if hasattr(step, "GetDelegatePass") else None
    return names


def sun():
    light = pv.Light(position=(1, -1, 3), light_type="scene light")
    light.positional = False
    return light


class Plotted(unittest.TestCase):
    def setUp(self):
        self.plotters = []

    def tearDown(self):
        for plotter in self.plotters:
            plotter.close()

    def plotter(self, **arguments):
        """A sphere above a plane, in one directional light."""
        plotter = pv.Plotter(off_screen=True, window_size=SIZE, lighting="none", **arguments)
        self.plotters.append(plotter)
        self.fill(plotter)
        return plotter

    def fill(self, plotter, **material):
        plotter.add_light(sun())
        plotter.add_mesh(pv.Sphere(radius=0.5, center=(0, 0, 0.8)), color="orange", **material)
        plotter.add_mesh(pv.Plane(i_size=5, j_size=5), color="white", **material)

    def check_shadow(self, plotter):
        """The last frame has umbra, penumbra and light, and is darker than without shadows."""
        seen = plotter.soft_shadows.visibility()
        self.assertLess(seen.min(), 0.05)
        self.assertEqual(seen.max(), 1.0)
        self.assertGreater(np.count_nonzero((seen > 0.1) & (seen < 0.9)), 10)

    def draw(self, plotter):
        plotter.render()
        return plotter.screenshot(return_img=True)

    def test_lights(self):
        plotter = self.plotter()
        plain = self.draw(plotter)
        shadows = plotter.soft_shadows.enable("map-pcss", angle=8)
        self.assertEqual(shadows.GetTechnique(), "map-pcss")
        shadowed = self.draw(plotter)
        self.check_shadow(plotter)
        self.assertLess(shadowed.mean(), plain.mean())
        plotter.soft_shadows.disable()
        self.assertTrue(np.array_equal(self.draw(plotter), plain))

    def test_positional_light_has_a_radius(self):
        plotter = self.plotter()
        plotter.remove_all_lights()
        plotter.add_light(pv.Light(position=(1, -1, 5), positional=True, cone_angle=90))
        plotter.soft_shadows.enable("map-pcss", radius=0.4)
        self.draw(plotter)
        self.check_shadow(plotter)

    def test_area_light(self):
        plotter = self.plotter()
        plotter.remove_all_lights()
        light = vtksoftshadows.pyvista.AreaLight((1, -1, 5), size=(0.8, 0.8), color="lightyellow")
        plotter.soft_shadows.add_light(light)
        plotter.soft_shadows.enable("ray-traced")
        self.draw(plotter)
        self.check_shadow(plotter)
        self.assertGreater(plotter.soft_shadows.visibility(light).max(), 0.99)
        with self.assertRaises(ValueError):
            vtksoftshadows.pyvista.AreaLight(radius=1, size=(1, 1))

    def test_passes_come_and_go(self):
        plotter = self.plotter()
        plotter.soft_shadows.enable("map-pcss", angle=8)
        for change in (
                lambda: plotter.enable_ssao(radius=0.3),
                lambda: plotter.enable_anti_aliasing("ssaa"),
                lambda: plotter.disable_ssao(),
                lambda: plotter.enable_eye_dome_lighting(),
                lambda: plotter.disable_eye_dome_lighting(),
                lambda: plotter.disable_anti_aliasing(),
                lambda: plotter.enable_depth_of_field(),
                lambda: plotter.disable_depth_of_field(),
                lambda: plotter.add_blurring(),
                lambda: plotter.remove_blurring()):
            change()
            self.draw(plotter)
            self.check_shadow(plotter)
            names = chain(plotter.renderer)
            ours = names.index("vtkPercentageCloserSoftShadowPass")
            self.assertIn(ours, (0, len(names) - 2), names)  # innermost, about what is shaded
        plotter.enable_ssao()
        plotter.soft_shadows.disable()
        self.assertEqual(chain(plotter.renderer)[-2:], ["vtkCameraPass", "vtkSequencePass"])

    def test_pbr(self):
        plotter = pv.Plotter(off_screen=True, window_size=SIZE, lighting="none")
        self.plotters.append(plotter)
        self.fill(plotter, pbr=True, metallic=0.2, roughness=0.5)
        plotter.soft_shadows.enable("map-pcf", angle=8)
        self.draw(plotter)
        self.check_shadow(plotter)

    def test_depth_peeling(self):
        plotter = self.plotter()
        plotter.add_mesh(pv.Cube(center=(1.5, 0, 0.6)), color="blue", opacity=0.4)
        plotter.enable_depth_peeling(8)
        plotter.soft_shadows.enable("map-pcss", angle=8)
        self.draw(plotter)
        self.check_shadow(plotter)

    def test_subplots(self):
        plotter = pv.Plotter(off_screen=True, window_size=(400, 200), lighting="none", shape=(1, 2))
        self.plotters.append(plotter)
        for column in range(2):
            plotter.subplot(0, column)
            self.fill(plotter)
        plotter.link_views()
        plotter.soft_shadows.enable("map-pcss", angle=8)
        image = self.draw(plotter)
        self.check_shadow(plotter)
        left, right = image[:, :196].mean(), image[:, 204:].mean()
        self.assertLess(right, left)
        plotter.subplot(0, 0)
        plotter.soft_shadows.enable("map-hard")
        self.draw(plotter)
        seen = plotter.soft_shadows.visibility()
        self.assertLess(np.mean((seen > 0) & (seen < 1)), 0.02)  # smooth edges alone

    def test_catchers(self):
        plotter = self.plotter()
        actor = plotter.soft_shadows.shadow_catcher(pv.Plane(center=(0, 0, -1), i_size=9, j_size=9))
        self.assertTrue(vtksoftshadows.vtkShadowPass.GetShadowCatcher(actor))
        floor = plotter.soft_shadows.add_floor()
        self.assertTrue(vtksoftshadows.vtkShadowPass.GetShadowCatcher(floor))
        plotter.soft_shadows.enable("map-pcss", angle=8)
        self.draw(plotter)
        self.check_shadow(plotter)

    def test_animation(self):
        plotter = self.plotter()
        plotter.soft_shadows.enable("map-pcss", angle=8)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "sphere.gif")
            try:
                plotter.open_gif(path)
            except ModuleNotFoundError:
                self.skipTest("PyVista writes GIF by imageio")
            frames = []
            for z in (0.8, 1.0, 1.2):
                plotter.actors[list(plotter.actors)[0]].position = (0, 0, z - 0.8)
                plotter.write_frame()
                frames.append(plotter.soft_shadows.visibility())
            self.assertGreater(np.abs(frames[0] - frames[-1]).max(), 0.5)
            plotter.mwriter.close()
            self.assertGreater(os.path.getsize(path), 1000)

    def test_scalar_bars_and_widgets(self):
        plotter = self.plotter()
        mesh = pv.Sphere(radius=0.4, center=(1.5, 0, 0.6))
        plotter.add_mesh(mesh, scalars=mesh.points[:, 2], show_scalar_bar=True)
        plotter.add_axes()
        plotter.show_bounds()
        plotter.add_text("soft shadows", font_size=8)
        plotter.soft_shadows.enable("map-pcss", angle=8)
        self.draw(plotter)
        self.check_shadow(plotter)

    def test_scale_and_theme(self):
        plotter = self.plotter(theme=pv.themes.DarkTheme())
        plotter.soft_shadows.enable("map-pcss", angle=8)
        image = plotter.screenshot(return_img=True, scale=2)
        self.assertEqual(image.shape[:2], (2 * SIZE[1], 2 * SIZE[0]))
        self.check_shadow(plotter)

    def test_headlight_gets_a_word(self):
        plotter = pv.Plotter(off_screen=True, window_size=SIZE, lighting="none")
        self.plotters.append(plotter)
        plotter.add_mesh(pv.Sphere())
        plotter.add_light(pv.Light(light_type="headlight"))
        shadows = plotter.soft_shadows.enable("map-hard")
        said = []
        shadows.AddObserver("WarningEvent", lambda *_: said.append(True))
        self.draw(plotter)
        self.assertEqual(len(said), 1)

    def test_closing_frees(self):
        def once():
            plotter = pv.Plotter(off_screen=True, window_size=SIZE, lighting="none")
            self.fill(plotter)
            plotter.soft_shadows.enable("map-pcss", angle=8)
            self.draw(plotter)
            plotter.soft_shadows.disable()
            self.draw(plotter)
            plotter.soft_shadows.enable("map-soft", angle=8)
            self.draw(plotter)
            plotter.close()

        def passes():
            gc.collect()
            return sum(issubclass(type(thing), vtksoftshadows.vtkShadowPass) for thing in gc.get_objects())

        once()
        before = passes()
        for _ in range(5):
            once()
        self.assertEqual(passes(), before)


if __name__ == "__main__":
    unittest.main()
