// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
#extension GL_ARB_shader_bit_encoding : require
#extension GL_ARB_explicit_attrib_location : require

// A fragment each tile of a picture: the box of its receivers in VC. See vtkShadowTiles.

//SHADOW::Declarations

uniform sampler2DArray shadowReceivers;

layout(location = 0) out vec4 shadowLow;
layout(location = 1) out vec4 shadowHigh;

void main()
{
  ivec2 first = ivec2(gl_FragCoord.xy) * SHADOW_TILE;
  ivec2 end = min(first + SHADOW_TILE, textureSize(shadowReceivers, 0).xy);
  vec3 low = vec3(3.0e38);
  vec3 high = vec3(-3.0e38);
  float count = 0.0;
  for (int y = first.y; y < end.y; ++y)
  {
    for (int x = first.x; x < end.x; ++x)
    {
      vec4 receiverVC = texelFetch(shadowReceivers, ivec3(x, y, 0), 0);
      if (shadowIsReceiver(receiverVC))
      {
        low = min(low, receiverVC.xyz);
        high = max(high, receiverVC.xyz);
        count += 1.0;
      }
    }
  }
  shadowLow = vec4(low, count);
  shadowHigh = vec4(high, count);
}
