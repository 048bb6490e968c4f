// SPDX-License-Identifier: BSD-3-Clause
// A receiver in a view of a light: see vtkLightViewVectors.
//
// A view, SHADOW_VIEW(view, vector), begins with the rows of the matrix from VC to the map ([0,1] in x, y
// and z after division: LC), the extent in VC at w = 1 of a texel along the map's x and y, times the depth
// scale (see vtkLightView), and values that are whoever's reads the view. The last three have the place
// that the view looks from in their fourth components.

// Where the map has the receiver, nearer to the light by as much as takes it above its plane by what its
// position may be off: only its depth changes. Behind the light, w is negative: the quotient of a tiny
// one lies far outside of the map. Maps have a clear border, so outside there is light. `height` is how
// far along the normal the light is.
vec3 shadowProjectReceiver(int view, vec3 positionVC, vec3 normalVC, out float height)
{
  vec4 receiverVC = vec4(positionVC, 1.0);
  vec4 depthRow = SHADOW_VIEW(view, 2);
  vec3 placeVC = vec3(SHADOW_VIEW(view, 4).w, SHADOW_VIEW(view, 5).w, SHADOW_VIEW(view, 6).w);
  float isPoint = SHADOW_VIEW(view, 3).xyz == vec3(0.0) ? 0.0 : 1.0;
  vec3 towardsVC = placeVC - isPoint * positionVC;
  height = dot(normalVC, towardsVC);
  // Lines and points have no plane; a plane that the light grazes is not left without end.
  float step = dot(normalVC, normalVC) * shadowRounding(positionVC) /
    max(abs(height), dot(abs(towardsVC), vec3(1.0 / 2048.0)));
  float depth =
    dot(depthRow, receiverVC) + step * (dot(depthRow.xyz, placeVC) + isPoint * depthRow.w);
  float w = max(dot(SHADOW_VIEW(view, 3), receiverVC), 1e-30);
  return vec3(
    dot(SHADOW_VIEW(view, 0), receiverVC), dot(SHADOW_VIEW(view, 1), receiverVC), depth) / w;
}
