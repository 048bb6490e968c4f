//VTK::System::Dec
#extension GL_ARB_shader_bit_encoding : require

// The receivers' depth, from their positions, as the volumes are drawn with: see vtkShadowVolumes.
// Before everything where there is no receiver.

//VTK::Output::Dec

uniform sampler2DArray shadowReceivers;
uniform mat4 shadowVCToClip;
uniform vec4 shadowEyeVC; // where lines of sight meet, w 1; or the direction to the viewer, w 0
uniform vec4 shadowDepthRow; // of the matrix from view to clip coordinates

//SHADOW::Declarations

// Volumes are counted on the pixel's ray. A receiver that rose from its facet (see
// vtkShadowTerminatorFS.glsl) lies beside it: then where the ray meets the plane through the receiver.
vec3 shadowOnRay(vec3 positionVC, vec3 normalVC)
{
  vec4 position = vec4(positionVC, 1.0);
  vec2 size = vec2(textureSize(shadowReceivers, 0).xy);
  vec2 ndc = 2.0 * gl_FragCoord.xy / size - 1.0;
  mat4 rows = transpose(shadowVCToClip);
  vec4 a = rows[0] - ndc.x * rows[3]; // the ray is where these two planes meet
  vec4 b = rows[1] - ndc.y * rows[3];
  vec2 off = -vec2(dot(a, position), dot(b, position));
  if (all(lessThan(abs(off) * size, vec2(0.25 * dot(rows[3], position)))))
  {
    return positionVC;
  }
  vec3 along = cross(a.xyz, b.xyz);
  vec3 step = (off.x * cross(b.xyz, along) + off.y * cross(along, a.xyz)) / dot(along, along);
  // Towards the viewer, whom the smooth normal need not face; not without end.
  vec3 towardsVC = shadowEyeVC.xyz - shadowEyeVC.w * positionVC;
  along = normalize(along) * (dot(along, towardsVC) < 0.0 ? -1.0 : 1.0);
  return positionVC + step - dot(normalVC, step) / max(dot(normalVC, along), 0.125) * along;
}

void main()
{
  vec4 receiverVC = texelFetch(shadowReceivers, ivec3(gl_FragCoord.xy, 0), 0);
  gl_FragDepth = 1.0;
  if (shadowIsReceiver(receiverVC))
  {
    vec3 normalVC = shadowUnpackReceiver(receiverVC.w).normalVC;
    vec4 positionVC = vec4(shadowOnRay(receiverVC.xyz, normalVC), 1.0);
    gl_FragDepth =
      clamp(dot(shadowDepthRow, positionVC) / (shadowVCToClip * positionVC).w, 0.0, 1.0);
  }
}
