# SPDX-License-Identifier: BSD-3-Clause
"""Ten ordinary scripts and one line: what the studio shows is right, never black and never burnt."""

import pathlib
import sys

import numpy as np

from shadow_testing import TestCase, main, technique_names, vss

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "Documentation" / "examples"))
import gallery  # noqa: E402
from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter  # noqa: E402

SIZE = (300, 225)


def grab(window):
    """The picture that the window shows, rows from the top."""
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.ShouldRerenderOff()
    grab.Update()
    pixels = vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars())
    return pixels.reshape(SIZE[1], SIZE[0], 3)[::-1].astype(int)


def receivers(renderer):
    image = vss.vtkShadowPass.FindOn(renderer).GetVisibility(0)
    values = vtk_to_numpy(image.GetPointData().GetArray("Receiver"))
    return values.reshape(SIZE[::-1])[::-1] != 0


class Gallery(TestCase):
    def test_ten_scripts(self):
        for name in gallery.SCENES:
            with self.subTest(name):
                renderer, window = gallery.make(name, SIZE)
                window.Render()
                plain = grab(window)
                # Facets: what rays are measured by, too.
                vss.enable(renderer, lights="studio", terminator="facets")
                window.Render()
                picture = grab(window)
                seen = receivers(renderer)
                shown = vss.visibility(renderer)
                black = np.mean(picture[seen].max(axis=1) <= 8)
                burnt = np.mean(picture[seen].min(axis=1) >= 255)
                shadow = np.mean(shown[seen] < 0.5)
                figures = f"{name}: black {black:.2%}, burnt {burnt:.2%}, in shadow {shadow:.0%}"
                self.assertLess(black, 0.01)
                self.assertLess(burnt, 0.01)
                self.assertGreater(shadow, 0.02)
                if "ray-traced" in technique_names():
                    vss.enable(renderer, "ray-traced", samples=64, terminator="facets")
                    window.Render()
                    error = (shown - vss.visibility(renderer))[seen]
                    figures += f", RMSE {np.sqrt(np.mean(error**2)):.3f}"
                    self.assertLess(np.sqrt(np.mean(error**2)), 0.05)
                print(figures, flush=True)
                vss.disable(renderer)
                window.Render()
                self.assertTrue((grab(window) == plain).all())


if __name__ == "__main__":
    main()
