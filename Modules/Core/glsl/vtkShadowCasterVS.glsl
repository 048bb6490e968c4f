//VTK::System::Dec

// Draws the casters: see vtkShadowCasters. Each vertex names its caster; the caster's matrix lies
// in a texture buffer as three rows.

in vec3 vertexMC;
in float caster;

uniform samplerBuffer casterMatrices;
uniform mat4 WCToClip;

void main()
{
  int row = 3 * int(caster);
  vec4 positionMC = vec4(vertexMC, 1.0);
  vec4 positionWC = vec4(dot(texelFetch(casterMatrices, row), positionMC),
    dot(texelFetch(casterMatrices, row + 1), positionMC),
    dot(texelFetch(casterMatrices, row + 2), positionMC), 1.0);
  gl_Position = WCToClip * positionWC;
}
