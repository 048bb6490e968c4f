// SPDX-License-Identifier: BSD-3-Clause
// The virtual map of a light, which is one view of it or up to six: vtkLightViewFS.glsl and
// vtkLightSightFS.glsl. LC is the map, [0,1] in x, y and depth; a texel is the whole map. Of a view's
// free values, layer of the coarse map, and variance of the light's shape against that of its bounding
// square.

const int shadowMostViews = SHADOW_MOST_VIEWS;
uniform vec4 shadowViews[SHADOW_VIEW_VECTORS * shadowMostViews];
uniform int shadowViewCount;
#define SHADOW_VIEW(view, vector) shadowViews[SHADOW_VIEW_VECTORS * (view) + (vector)]
