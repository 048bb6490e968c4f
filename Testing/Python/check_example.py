# SPDX-License-Identifier: BSD-3-Clause
"""check_example.py EXAMPLE PICTURE SHADOW_X SHADOW_Y LIT_X LIT_Y: an example of the documentation
runs, says no error, and draws a picture in which one place lies in shadow and the other does not.

Places are in pixels from the left and the top.
"""

import os
import subprocess
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader


def read(path):
    """Rows from the top."""
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars())
    return pixels.reshape(height, width, -1)[::-1]


example, path = sys.argv[1:3]
shadow, lit = np.array(sys.argv[3:7], int).reshape(2, 2)
if os.path.exists(path):
    os.remove(path)  # that of an older run
run = subprocess.run([sys.executable, example, path], capture_output=True, text=True, check=False)
assert (run.returncode, run.stderr) == (0, ""), run.stderr

picture = read(path)
assert picture.shape == (400, 600, 3), picture.shape
colors = len(np.unique(picture.reshape(-1, 3), axis=0))
dark, bright = [picture[y - 3:y + 4, x - 3:x + 4].mean() for x, y in (shadow, lit)]
print(f"{colors} colours, {dark:.0f} in shadow, {bright:.0f} beside it")
assert colors > 100, colors
assert dark < 0.8 * bright, (dark, bright)
