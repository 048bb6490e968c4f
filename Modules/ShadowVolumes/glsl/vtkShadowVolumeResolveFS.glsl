// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// Takes a sample's weight away where its volumes lie: the stencil test, or wide counts, say where.

//VTK::Output::Dec

uniform vec3 shadowWeight;
#ifdef SHADOW_WIDE
uniform sampler2DArray shadowCounts;
#endif

void main()
{
#ifdef SHADOW_WIDE
  if (abs(texelFetch(shadowCounts, ivec3(gl_FragCoord.xy, 0), 0).r) < 0.5)
  {
    discard;
  }
#endif
  gl_FragData[0] = vec4(-shadowWeight, 0.0);
}
