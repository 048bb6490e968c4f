// Injected into the vertex shader of props with normals: see vtkShadowTerminatorFS.glsl.

out vec4 shadowTangentVCVSOutput; // a corner's tangent plane: unit normal, distance from VC's origin

vec4 shadowTangent(vec3 positionVC, vec3 normalVC)
{
  vec3 size = abs(normalVC);
  vec3 normal = normalVC / max(max(size.x, size.y), max(size.z, 1e-30));
  normal *= inversesqrt(max(dot(normal, normal), 1e-37));
  return vec4(normal, dot(normal, positionVC));
}
