// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// The texels that a triangle touches, as deep as the nearest of it in each: see
// vtkVirtualCoarseGS.glsl.

uniform float shadowSide;

flat in vec3 shadowEdge0;
flat in vec3 shadowEdge1;
flat in vec3 shadowEdge2;
flat in vec3 shadowPlane;
flat in vec2 shadowRange;

void main()
{
  gl_FragDepth = gl_FragCoord.z;
  if (shadowRange.x <= shadowRange.y)
  {
    vec3 placeDC = vec3(2.0 * gl_FragCoord.xy / shadowSide - 1.0, 1.0);
    if (dot(shadowEdge0, placeDC) < 0.0 || dot(shadowEdge1, placeDC) < 0.0 ||
      dot(shadowEdge2, placeDC) < 0.0)
    {
      discard;
    }
    gl_FragDepth = clamp(clamp(dot(shadowPlane, placeDC), shadowRange.x, shadowRange.y), 0.0, 1.0);
  }
}
