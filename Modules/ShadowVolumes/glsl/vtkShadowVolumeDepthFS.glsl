// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// The receivers' depth, from their positions, as the volumes are drawn with: see vtkShadowVolumes.
// Before everything where there is no receiver.

//VTK::Output::Dec

uniform sampler2DArray shadowReceivers;
uniform vec4 shadowDepthRow; // of the matrix from view to clip coordinates
uniform vec4 shadowWRow;

void main()
{
  vec4 receiverVC = texelFetch(shadowReceivers, ivec3(gl_FragCoord.xy, 0), 0);
  vec4 positionVC = vec4(receiverVC.xyz, 1.0);
  bool receives = receiverVC.w != 0.0 && !any(isnan(receiverVC)) && !any(isinf(receiverVC));
  gl_FragDepth = !receives ? 1.0
    : clamp(dot(shadowDepthRow, positionVC) / dot(shadowWRow, positionVC), 0.0, 1.0);
}
