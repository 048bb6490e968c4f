// SPDX-License-Identifier: BSD-3-Clause
// The casting lights: shared by the injected code and the evaluation in screen space. Vectors end in
// their space: VC view, LC light (a map's texture coordinates). What `light` numbers are parts of lights
// (see vtkShadowLightPart).
//
// SHADOW_LIGHTS is their number. SHADOW_VISIBILITY is float, or vec3 where a light is textured.
// SHADOW_POSITION_ROUNDING is vtkShadowView::PositionRounding. SHADOW_HARD is defined where a light counts
// as its centre. A technique's GLSL may define SHADOW_TELLS_AWAY: then it finds no light itself where
// shadowFacesAway is true, and is not asked before.

// The pixel of the screen-space buffers. Their evaluation draws into the like of them; a prop may be
// drawn beside a window's origin, or by a delegate into a larger picture of the same view.
#ifdef SHADOW_INJECTED
uniform vec4 shadowToPixel; // scale, offset
#define SHADOW_PIXEL ivec2(floor(shadowToPixel.xy * gl_FragCoord.xy + shadowToPixel.zw))
#else
#define SHADOW_PIXEL ivec2(gl_FragCoord.xy)
#endif

uniform vec4 shadowLightPlaceVC[SHADOW_LIGHTS]; // position, w 1; or direction to it, w 0
uniform vec4 shadowLightUVC[SHADOW_LIGHTS];     // half axis; w: radius of a sphere, else 0
uniform vec4 shadowLightVVC[SHADOW_LIGHTS];     // half axis; w: 1 for a rectangle, else 0

// The receiver's prop casts too: then its own surface hides what lies behind it.
bool shadowSelf = true;

// What has been spent on this pixel: map reads, or rays.
float shadowCost = 0.0;

// What the positions of the receiver's prop are off by what VTK computes them with: see
// vtkShadowInjector::GetRounding.
float shadowPropRounding = 0.0;

// How far the receiver's position may be off: it was transformed and interpolated in 24-bit floats,
// over triangles that may reach far out of the picture. The depth stands for the distance.
float shadowRounding(vec3 positionVC)
{
  return max(abs(positionVC.z) * SHADOW_POSITION_ROUNDING, shadowPropRounding);
}

// The whole light lies behind the receiver's own surface.
bool shadowFacesAway(int light, vec3 positionVC, vec3 normalVC)
{
  vec4 placeVC = shadowLightPlaceVC[light];
  float height = dot(normalVC, placeVC.xyz - placeVC.w * positionVC);
#ifndef SHADOW_HARD
  vec2 extent = abs(vec2(dot(normalVC, shadowLightUVC[light].xyz),
    dot(normalVC, shadowLightVVC[light].xyz)));
  height += shadowLightUVC[light].w > 0.0 ? shadowLightUVC[light].w
    : (shadowLightVVC[light].w > 0.0 ? extent.x + extent.y : length(extent));
#endif
  return shadowSelf && height < 0.0;
}

// What is seen of a light once one more of its parts is known, which stands for a share of it.
SHADOW_VISIBILITY shadowAddPart(SHADOW_VISIBILITY ofLight, float share, SHADOW_VISIBILITY visibility)
{
  return ofLight - share * (1.0 - visibility);
}
