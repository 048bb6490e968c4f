# SPDX-License-Identifier: BSD-3-Clause
"""Small models for the tests of the command, sound and damaged ones, written as text."""

import base64
import json
import struct

CUBE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
QUADS = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
TRIANGLES = [t for q in QUADS for t in ((q[0], q[1], q[2]), (q[0], q[2], q[3]))]
NAN_CUBE = [("nan", 0, 0)] + CUBE[1:]
INFINITE_CUBE = [("inf", 0, 0)] + CUBE[1:]


def points_text(points, prefix=""):
    return "".join("%s%s %s %s\n" % ((prefix,) + tuple(p)) for p in points)


def faces_text(faces):
    return "".join("%d %s\n" % (len(f), " ".join(map(str, f))) for f in faces)


def obj(points=CUBE, faces=QUADS):
    lines = "".join("f " + " ".join(str(i + 1) for i in f) + "\n" for f in faces)
    return points_text(points, "v ") + lines


def stl(points=CUBE, faces=TRIANGLES):
    facet = "facet normal 0 0 0\nouter loop\n%sendloop\nendfacet\n"
    body = "".join(facet % points_text([points[i] for i in f], "vertex ") for f in faces)
    return "solid test\n" + body + "endsolid test\n"


def binary_stl():
    facets = b"".join(struct.pack("<12fH", 0, 0, 0, *[c for i in f for c in CUBE[i]], 0)
                      for f in TRIANGLES)
    return b"\0" * 80 + struct.pack("<I", len(TRIANGLES)) + facets


def ply(points=CUBE, faces=QUADS):
    header = ("ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\nproperty float y\n"
              "property float z\nelement face %d\nproperty list uchar int vertex_indices\n"
              "end_header\n" % (len(points), len(faces)))
    return header + points_text(points) + faces_text(faces)


def vtk(points=CUBE, faces=QUADS):
    size = sum(len(f) + 1 for f in faces)
    return ("# vtk DataFile Version 3.0\ntest\nASCII\nDATASET POLYDATA\nPOINTS %d float\n%s"
            "POLYGONS %d %d\n%s" % (len(points), points_text(points), len(faces), size,
                                    faces_text(faces)))


def grid_vtk():
    return ("# vtk DataFile Version 3.0\ntest\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 float\n%s"
            "CELLS 1 9\n8 0 1 2 3 4 5 6 7\nCELL_TYPES 1\n12\n" % points_text(CUBE))


def image_vtk():
    return ("# vtk DataFile Version 3.0\ntest\nASCII\nDATASET STRUCTURED_POINTS\n"
            "DIMENSIONS 2 2 1\nORIGIN 0 0 0\nSPACING 1 1 1\n")


def vtp(points=CUBE, faces=QUADS):
    corners = " ".join(str(i) for f in faces for i in f)
    offsets = [sum(len(f) for f in faces[:i + 1]) for i in range(len(faces))]
    array = '<DataArray type="%s" %s format="ascii">%s</DataArray>'
    return ('<?xml version="1.0"?><VTKFile type="PolyData" version="0.1" byte_order="LittleEndian">'
            '<PolyData><Piece NumberOfPoints="%d" NumberOfPolys="%d"><Points>%s</Points>'
            '<Polys>%s%s</Polys></Piece></PolyData></VTKFile>') % (
                len(points), len(faces),
                array % ("Float64", 'NumberOfComponents="3"', points_text(points)),
                array % ("Int64", 'Name="connectivity"', corners),
                array % ("Int64", 'Name="offsets"', " ".join(map(str, offsets))))


def gltf_parts(points=CUBE):
    positions = b"".join(struct.pack("<3f", *map(float, p)) for p in points)
    indices = b"".join(struct.pack("<3H", *t) for t in TRIANGLES)
    description = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.1, 0.1, 1]}}],
        "buffers": [{"byteLength": len(positions) + len(indices)}],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": len(positions)},
            {"buffer": 0, "byteOffset": len(positions), "byteLength": len(indices)}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3",
             "min": [0, 0, 0], "max": [1, 1, 1]},
            {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"}]}
    return description, positions + indices


def gltf(points=CUBE):
    description, data = gltf_parts(points)
    description["buffers"][0]["uri"] = ("data:application/octet-stream;base64," +
                                        base64.b64encode(data).decode())
    return json.dumps(description)


def glb():
    description, data = gltf_parts()
    text = json.dumps(description).encode()
    text += b" " * (-len(text) % 4)
    return (struct.pack("<4sIIII", b"glTF", 2, 28 + len(text) + len(data), len(text), 0x4E4F534A) +
            text + struct.pack("<II", len(data), 0x004E4942) + data)
