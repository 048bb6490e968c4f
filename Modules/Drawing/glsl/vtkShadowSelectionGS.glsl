// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// Lets the pixels that are chosen through.

layout(points) in;
layout(points, max_vertices = 1) out;

in vec4 chosenTexel[];
flat in int chosenPixel[];

out vec4 selectedTexel;
flat out int selectedPixel;

void main()
{
  if (chosenPixel[0] >= 0)
  {
    selectedTexel = chosenTexel[0];
    selectedPixel = chosenPixel[0];
    EmitVertex();
    EndPrimitive();
  }
}
