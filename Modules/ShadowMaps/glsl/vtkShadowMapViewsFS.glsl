// SPDX-License-Identifier: BSD-3-Clause
// The views of depth maps, SHADOW_VIEW_VECTORS vectors each: see vtkLightViewFS.glsl, and
// vtkLightSightFS.glsl for look-ups around a point. Of the fixed values, weight of the view's sample.
//
// SHADOW_FEW_VIEWS is defined to their number where they are few: what loops over them unrolls where the
// light is a constant. A light's views are those from SHADOW_FIRST_VIEW to before SHADOW_END_OF_VIEWS.

uniform sampler2DArrayShadow shadowMaps;
#ifdef SHADOW_FEW_VIEWS
uniform vec4 shadowViews[SHADOW_VIEW_VECTORS * SHADOW_FEW_VIEWS];
const int shadowFirstLayer = 0;
#define SHADOW_VIEW(view, vector) shadowViews[SHADOW_VIEW_VECTORS * (view) + (vector)]
#else
uniform samplerBuffer shadowViews;
uniform int shadowFirstView[SHADOW_LIGHTS];
uniform int shadowViewCount[SHADOW_LIGHTS];
uniform int shadowFirstLayer; // the view that layer 0 holds
#define SHADOW_FIRST_VIEW(light) shadowFirstView[light]
#define SHADOW_END_OF_VIEWS(light) (shadowFirstView[light] + shadowViewCount[light])
#define SHADOW_VIEW(view, vector) texelFetch(shadowViews, SHADOW_VIEW_VECTORS * (view) + (vector))
#endif
