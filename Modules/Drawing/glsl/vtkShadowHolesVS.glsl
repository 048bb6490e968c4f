// SPDX-License-Identifier: BSD-3-Clause
// Of casters with holes, in the place of //VTK::ShadowHoles::Dec in their vertex shaders.

in vec3 shadowPlace; // texture coordinates, alpha

out vec3 shadowPlaceVSOutput;

void shadowPassPlace()
{
  shadowPlaceVSOutput = shadowPlace;
}
