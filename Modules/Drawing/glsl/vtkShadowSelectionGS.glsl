// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
#extension GL_ARB_shader_bit_encoding : require

// Lets the pixels that are chosen through: of a vertex some, one after another.

layout(points) in;
layout(points, max_vertices = SHADOW_PIXELS) out;

ivec2 shadowSelectPixel = ivec2(0); // that is asked for

//SHADOW::Declarations

uniform sampler2DArray shadowReceivers;

flat in int firstPixel[];

out vec4 selectedTexel;
flat out int selectedPixel;

void main()
{
  ivec2 size = textureSize(shadowReceivers, 0).xy;
  int end = min(firstPixel[0] + SHADOW_PIXELS, size.x * size.y);
  for (int pixel = firstPixel[0]; pixel < end; ++pixel)
  {
    shadowSelectPixel = ivec2(pixel % size.x, pixel / size.x);
    vec4 texel = shadowFetchReceiver(shadowReceivers, shadowSelectPixel);
    if (shadowIsReceiver(texel) && shadowSelect(texel))
    {
      selectedTexel = texel;
      selectedPixel = pixel;
      EmitVertex();
      EndPrimitive();
    }
  }
}
