# SPDX-License-Identifier: BSD-3-Clause
"""check_picture.py PICTURE...: each picture of the example shows soft shadows on the plane, and all
pictures are the same."""

import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader


def read(path):
    reader = vtkPNGReader()
    assert reader.CanReadFile(path), path
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1).astype(int)


def check(path):
    picture = read(path)
    height, width, _ = picture.shape
    assert (width, height) == (600, 400), picture.shape
    # The sphere's shadow lies on the plane to the right of it; the plane in front of it is lit.
    row = picture[190, :, 1]
    umbra = row[430:470].mean()
    lit = row[560:].mean()
    assert umbra < 0.4 * lit, (path, umbra, lit)
    # Its outer edge is a penumbra: many pixels wide, without a step.
    edge = row[470:560]
    between = (edge > umbra + 0.1 * (lit - umbra)) & (edge < lit - 0.1 * (lit - umbra))
    assert between.sum() >= 10, (path, between.sum())
    assert np.abs(np.diff(edge)).max() < 0.4 * (lit - umbra), path
    # No acne: where nothing stands in the way the plane is smooth.
    free = picture[20:100, 20:580, 1]
    assert np.abs(np.diff(free, axis=1)).max() <= 2, path
    print(f"{path}: umbra {umbra:.0f}, lit {lit:.0f}, penumbra {between.sum()} pixels")
    return picture


pictures = [check(path) for path in sys.argv[1:]]
for picture in pictures[1:]:
    assert (np.abs(picture - pictures[0]) > 4).mean() < 0.01, "the pictures differ"
