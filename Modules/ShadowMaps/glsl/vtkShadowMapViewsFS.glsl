// The views of depth maps: see vtkShadowMaps.
//
// A view is SHADOW_VIEW_VECTORS vectors: the rows of the matrix from VC to the map ([0,1] in x, y and
// z after division: LC), the extent in VC at w = 1 of the texels that one look-up can read, along the
// map's x and y, and the weight of the view's sample. The last three have the place that the view
// looks from in their fourth components. Five more follow for look-ups around a point: see
// vtkShadowMapKernelFS.glsl.
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

// The receiver as a view's map sees it. Bias without a knob: a plane that is moved along its normal
// by what it can rise within the texels of one look-up is in front of its own samples in the map, and
// not a hair more. A plane's depth over the map's texels grows by |n.x|, |n.y| times their extent at
// that distance, measured along its normal: so there is no slope to divide by.
vec4 shadowMoveReceiver(int view, vec3 positionVC, vec3 normalVC)
{
  float w = dot(SHADOW_VIEW(view, 3), vec4(positionVC, 1.0));
  float rise = abs(dot(normalVC, SHADOW_VIEW(view, 4).xyz)) +
    abs(dot(normalVC, SHADOW_VIEW(view, 5).xyz));
  return vec4(positionVC + (rise * w + shadowRounding(positionVC)) * normalVC, 1.0);
}

// Its place in the map. Behind the light, w is negative: the quotient of a tiny one lies far outside
// of the map. Maps have a clear border, so outside there is light.
vec3 shadowProject(int view, vec4 receiverVC)
{
  float w = max(dot(SHADOW_VIEW(view, 3), receiverVC), 1e-30);
  return vec3(dot(SHADOW_VIEW(view, 0), receiverVC), dot(SHADOW_VIEW(view, 1), receiverVC),
    dot(SHADOW_VIEW(view, 2), receiverVC)) / w;
}
