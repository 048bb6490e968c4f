// SPDX-License-Identifier: BSD-3-Clause
// What look-ups around a receiver are past: blockers at one depth, or at two.
//
// At one depth all that lies in front of the receiver hides a point of the light. At two, a point has a
// look-up past either: it is hidden by what lies beyond the border between them where the far depth has it,
// and by what lies before the border where the near one has it. Where the near one is covered by what is
// far, the map does not know; then the share of what it knows there counts.

struct shadowLayers
{
  float reach;     // of the only depth, or of that near the receiver: see shadowReach
  float reference; // there: see shadowReference
  float narrowing; // how much (0 to 1) blockers have to lie within twice the pyramid from receiver to light
  float farReach;  // of that near the light; 0 with one depth
  float border;    // the depth between both
};

shadowLayers shadowOneLayer(shadowKernel kernel, float delta)
{
  float reach = shadowReach(kernel, delta);
  return shadowLayers(reach, shadowReference(kernel, shadowExtent(kernel, reach)), 0.0, 0.0, 0.0);
}

// Distance of the point (s, t) from the light's middle: 1 on its border.
float shadowSize(shadowKernel kernel, vec2 st)
{
  return kernel.square ? max(abs(st.x), abs(st.y)) : length(st);
}

float shadowCompare(shadowKernel kernel, float depth, float reference, vec2 offsetLC)
{
  return texture(shadowMaps, vec4(kernel.receiverLC.xy + offsetLC, kernel.layer,
    min(depth, shadowReferenceAt(kernel, reference, offsetLC))));
}

// Look-ups for the light's point (s, t). Sums: what is lit; of what lies near what is known, and what of it
// hides; and what would be lit, but is not known.
void shadowTake(shadowKernel kernel, shadowLayers layers, vec2 st, inout vec4 sums)
{
  // Twice: of a mean's blockers most lie within its own pyramid, and slanted ones on either side of it.
  float tilted = dot(st, kernel.tilt);
  float nearer = layers.reach * max(0.5 * shadowSize(kernel, st) - tilted, 0.0) / max(1.0 - tilted, 0.25);
  float reference = min(layers.reference, kernel.receiverLC.z - layers.narrowing * nearer);
  if (layers.farReach == 0.0)
  {
    sums.x += shadowLookUp(kernel, reference, layers.reach, st);
    shadowCost += 1.0;
    return;
  }
  vec2 nearLC = shadowOffset(kernel, layers.reach, st);
  vec2 farLC = shadowOffset(kernel, layers.farReach, st);
  bool below = kernel.horizon.x + st.x * kernel.horizon.y + st.y * kernel.horizon.z < 0.0;
  float lit = below ? 0.0 : shadowCompare(kernel, layers.border, layers.reference, farLC);
  float known = shadowCompare(kernel, layers.border, layers.reference, nearLC);
  float hidden = max(known - shadowCompare(kernel, 1.0, reference, nearLC), 0.0);
  sums += vec4(lit * (1.0 - hidden), known, hidden, lit * (1.0 - known));
  shadowCost += 3.0;
}

float shadowGetLit(vec4 sums)
{
  return sums.x - sums.w * sums.z / max(sums.y, 1e-30);
}
