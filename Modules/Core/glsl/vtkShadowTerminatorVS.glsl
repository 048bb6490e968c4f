// SPDX-License-Identifier: BSD-3-Clause
// Injected into the vertex shader of props with normals: see vtkShadowTerminatorFS.glsl.

// Of a corner's tangent plane: its normal, as VTK gives it to the fragment shader, times the corner's
// place; and that normal's length.
out vec2 shadowTangentVSOutput;
