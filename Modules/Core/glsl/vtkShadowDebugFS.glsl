//VTK::System::Dec

// Debug views that every technique has: see vtkShadowPass::SetDebugView.

//VTK::Output::Dec

uniform sampler2DArray shadowReceivers;
uniform sampler2DArray shadowBuffer;
uniform ivec2 shadowOrigin;
uniform int shadowLights;
uniform int shadowSlots[16]; // parts of one light have the same, and come one after another
uniform float shadowShares[16];
uniform int shadowView; // 0 visibility, 1 penumbra, 2 a quantity, such as the cost
uniform float shadowScale; // of the quantity: its white is 1

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) - shadowOrigin;
  vec3 visibility = vec3(1.0);
  vec3 ofLight = vec3(1.0);
  float most = 0.0;
  for (int i = 0; i < shadowLights; ++i)
  {
    vec4 texel = texelFetch(shadowBuffer, ivec3(pixel, i), 0);
    ofLight = i > 0 && shadowSlots[i] == shadowSlots[i - 1] ? ofLight : vec3(1.0);
    ofLight -= shadowShares[i] * (1.0 - SHADOW_DEBUG_SWIZZLE);
    visibility = min(visibility, ofLight);
    most = max(most, texel.r);
  }
  bool receiver = texelFetch(shadowReceivers, ivec3(pixel, 0), 0).w != 0.0;
  vec3 color = visibility;
  if (shadowView == 1)
  {
    float v = dot(visibility, vec3(1.0 / 3.0));
    color = v > 0.02 && v < 0.98 ? mix(vec3(0.1, 0.3, 1.0), vec3(1.0, 0.8, 0.1), v) : vec3(0.15 + 0.6 * v);
  }
  else if (shadowView == 2)
  {
    color = vec3(most * shadowScale);
  }
  gl_FragData[0] = vec4(receiver ? color : vec3(0.25, 0.2, 0.3), 1.0);
}
