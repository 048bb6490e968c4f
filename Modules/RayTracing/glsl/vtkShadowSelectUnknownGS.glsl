// SPDX-License-Identifier: BSD-3-Clause
// Of vtkShadowSelection: pixels that vtkShadowSeesAllFS.glsl has left open.

uniform sampler2DArray shadowKnown;
uniform int shadowLayer;

bool shadowSelect(vec4 receiverVC)
{
  return texelFetch(shadowKnown, ivec3(shadowSelectPixel, shadowLayer), 0).r < 0.0;
}
