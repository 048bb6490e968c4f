// SPDX-License-Identifier: BSD-3-Clause
// What users write into VTK's shaders (vtkShaderProperty) is drawn as without a pass, times the
// shadow.

#include "ShadowOracle.h"
#include "ShadowTest.h"

#include "vtkLight.h"
#include "vtkShaderProperty.h"

#include <algorithm>

namespace
{
struct Writing
{
  const char* Name;
  std::function<void(vtkShaderProperty*)> Apply; // to the floor
};

/** A replacement before or after the mapper's own. */
void Write(vtkShaderProperty* shader, const char* what, const char* by, bool first = true)
{
  shader->AddFragmentShaderReplacement(what, first, by, false);
}

const std::vector<Writing>& GetWritings()
{
  static const std::vector<Writing> writings = {
    { "instead of VTK's lighting",
      [](vtkShaderProperty* shader)
      {
        Write(shader, "//VTK::Light::Impl",
          "gl_FragData[0] = vec4(diffuseColor * lightColor0, opacity);\n");
      } },
    { "instead of VTK's lighting, which it leaves",
      [](vtkShaderProperty* shader)
      {
        Write(shader, "//VTK::Light::Impl",
          "if (gl_FragCoord.x > 0.0)\n"
          "  {\n"
          "    gl_FragData[0] = vec4(diffuseColor * lightColor0, opacity);\n"
          "    return;\n"
          "  }\n");
      } },
    { "after VTK's lighting",
      [](vtkShaderProperty* shader)
      {
        Write(shader, "//VTK::Light::Impl",
          "gl_FragData[0] = vec4(diffuseColor * lightColor0, opacity);\n", false);
      } },
    { "at the colour",
      [](vtkShaderProperty* shader)
      {
        Write(shader, "//VTK::Color::Impl",
          "//VTK::Color::Impl\n  diffuseColor = 0.5 + 0.5 * lightColor0;\n"
          "  ambientColor = 0.1 * lightColor0; // of lightColor0\n");
      } },
    { "in a function",
      [](vtkShaderProperty* shader)
      {
        Write(shader, "//VTK::Light::Dec",
          "//VTK::Light::Dec\nvec3 rim() { return 0.1 * lightColor0; }\n");
        Write(shader, "//VTK::Light::Impl", "//VTK::Light::Impl\n  gl_FragData[0].rgb += rim();\n",
          false);
      } },
    { "in a function that another calls at the colour",
      [](vtkShaderProperty* shader)
      {
        Write(shader, "//VTK::Light::Dec",
          "//VTK::Light::Dec\nvec3 rim() { return 0.1 * lightColor0; }\n"
          "vec3 rims(float n)\n{\n  if (n > 0.0)\n  {\n    return n * rim();\n  }\n"
          "  return vec3(0.0);\n}\n");
        Write(shader, "//VTK::Color::Impl", "//VTK::Color::Impl\n  ambientColor = rims(2.0);\n");
      } },
    { "by a macro",
      [](vtkShaderProperty* shader)
      {
        Write(shader, "//VTK::Light::Dec",
          "//VTK::Light::Dec\n#define GLOW(c) \\\n  ((c) * lightColor0)\n");
        Write(
          shader, "//VTK::Color::Impl", "//VTK::Color::Impl\n  ambientColor = GLOW(vec3(0.1));\n");
      } },
    { "VTK's lighting in a branch",
      [](vtkShaderProperty* shader)
      {
        Write(shader, "//VTK::Light::Impl",
          "if (mod(gl_FragCoord.x, 8.0) < 4.0)\n  {\n  //VTK::Light::Impl\n  }\n"
          "  else if (mod(gl_FragCoord.y, 8.0) < 4.0)\n"
          "    gl_FragData[0] = vec4(0.5 * lightColor0, opacity);\n"
          "  else\n"
          "    gl_FragData[0] = vec4(0.3 * lightColor0, opacity);\n");
      } },
    { "a variable of that name",
      [](vtkShaderProperty* shader)
      {
        Write(shader, "//VTK::Light::Impl",
          "vec3 lightColor0 = 0.5 * lightColor0;\n  //VTK::Light::Impl\n");
      } },
    { "a variable of that name, at the end",
      [](vtkShaderProperty* shader)
      {
        Write(shader, "//VTK::Light::Impl",
          "vec3 lightColor0 = lightColor0;\n"
          "  gl_FragData[0].rgb += 0.1 * lightColor0;\n  //VTK::Light::Impl\n",
          false);
      } },
    { "in place of a line of VTK's",
      [](vtkShaderProperty* shader)
      {
        Write(shader, "gl_FragData[0] = vec4(ambientColor + diffuse + specular, opacity);",
          "gl_FragData[0] = vec4(ambientColor + 0.5 * diffuse + specular, opacity);", false);
      } },
    { "derivatives and a normal of its own",
      [](vtkShaderProperty* shader)
      {
        Write(shader, "//VTK::UniformFlow::Impl",
          "vec3 xOfMine = dFdx(vertexVC.xyz);\n  vec3 yOfMine = dFdy(vertexVC.xyz);\n");
        Write(shader, "//VTK::Normal::Impl",
          "vec3 normalVCVSOutput = normalize(cross(xOfMine, yOfMine));\n");
      } },
    { "no normal",
      [](vtkShaderProperty* shader)
      {
        Write(shader, "//VTK::UniformFlow::Impl", "");
        Write(shader, "//VTK::Normal::Impl", "");
        Write(shader, "//VTK::Light::Impl",
          "gl_FragData[0] = vec4(diffuseColor * lightColor0, opacity);\n  //VTK::TCoord::Impl\n");
      } },
    { "another name for the position",
      [](vtkShaderProperty* shader)
      {
        Write(shader, "//VTK::PositionVC::Impl", "vec4 myPosition = vertexVCVSOutput;\n");
        Write(shader, "//VTK::UniformFlow::Impl", "");
        Write(shader, "//VTK::Normal::Impl", "");
        Write(shader, "//VTK::Light::Impl",
          "gl_FragData[0] = vec4(fract(myPosition.xyz) * lightColor0, opacity);\n");
      } },
    { "holes",
      [](vtkShaderProperty* shader)
      {
        Write(shader, "//VTK::Color::Impl",
          "//VTK::Color::Impl\n  if (mod(gl_FragCoord.x, 8.0) < 2.0) { discard; }\n");
        Write(shader, "//VTK::Light::Impl",
          "gl_FragData[0] = vec4(diffuseColor * lightColor0, opacity);\n");
      } },
    { "depth",
      [](vtkShaderProperty* shader)
      {
        Write(
          shader, "//VTK::Depth::Impl", "//VTK::Depth::Impl\n  gl_FragDepth = gl_FragCoord.z;\n");
      } },
    { "comments and conditions",
      [](vtkShaderProperty* shader)
      {
        Write(shader, "//VTK::Light::Dec",
          "// void main() { lightColor0 shadowFactor0\n//VTK::Light::Dec\n"
          "/* void main()\n   { lightColor0; */\n#ifdef NOT_DEFINED\n"
          "vec3 f() { return lightColor0; }\n"
          "#else\nvec3 f() { return 0.1 * lightColor0; } // lightColor0\n#endif\n");
        Write(shader, "//VTK::Color::Impl",
          "//VTK::Color::Impl\n#if 1\n  ambientColor = f();\n#endif // lightColor0\n");
      } },
    { "all of it",
      [](vtkShaderProperty* shader)
      {
        shader->SetFragmentShaderCode("//VTK::System::Dec\n//VTK::Output::Dec\n"
                                      "in vec4 vertexVCVSOutput;\n"
                                      "uniform vec3 lightColor0, another;\n"
                                      "void main(void)\n{\n"
                                      "  gl_FragData[0] = vec4(0.7 * lightColor0, 1.0);\n}\n");
      } },
  };
  return writings;
}

/** Floor, box and sphere, the writing on the floor. */
vtkLight* Stand(ShadowStage& stage, const Writing& writing)
{
  stage.AddFloor();
  auto* floor = vtkActor::SafeDownCast(stage.Renderer->GetViewProps()->GetItemAsObject(0));
  stage.AddBox({ -0.8, 0.3, 0.6 }, { 1.0, 1.0, 1.2 });
  stage.AddSphere({ 0.9, -0.5, 1.3 }, 0.6);
  stage.LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
  writing.Apply(floor->GetShaderProperty());
  return stage.AddLight(LightKind::Point);
}

/** As Control.Materials: lit is VTK's picture, dark VTK's with that light all but out, to 1/255. */
void CheckDrawing(
  const std::string& technique, const Writing& writing, const Parameters& parameters = {})
{
  ShadowStage stage;
  vtkLight* light = Stand(stage, writing);
  const std::string what = writing.Name;
  stage.Render();
  const Picture plain = stage.GetPicture();
  light->SetIntensity(1e-6);
  stage.Render();
  const Picture out = stage.GetPicture();
  light->SetIntensity(1.0);
  ShadowTest::CheckNoMessage(what + ", without a pass");
  stage.SetPass(technique, parameters);
  stage.Render();
  const Picture picture = stage.GetPicture();
  const Visibility visibility = stage.GetVisibility();
  ShadowTest::CheckNoMessage(what + ", with a pass");

  int worstLit = 0;
  int worstDark = 0;
  std::size_t lit = 0;
  std::size_t dark = 0;
  for (std::size_t i = 0; i < visibility.V.size(); ++i)
  {
    if (!visibility.Mask[i] || visibility.V[i] == 1.0f)
    {
      ++lit;
      worstLit = std::max(worstLit, picture.Difference(plain, i));
    }
    else if (visibility.V[i] == 0.0f)
    {
      ++dark;
      worstDark = std::max(worstDark, picture.Difference(out, i));
    }
  }
  ShadowTest::CheckAtLeast(static_cast<double>(lit), 5000.0, what + ", lit pixels");
  ShadowTest::CheckAtLeast(static_cast<double>(dark), 500.0, what + ", dark pixels");
  ShadowTest::CheckAtMost(worstLit, 1.0, what + ", lit: difference, of 255");
  ShadowTest::CheckAtMost(worstDark, 1.0, what + ", dark: difference, of 255");
}
}

//------------------------------------------------------------------------------
// The three that users asked about, by all techniques.
SHADOW_TEST(Replacements, AreDrawnTimesTheShadow, Each)
{
  for (const char* name : { "instead of VTK's lighting", "at the colour", "in a function" })
  {
    CheckDrawing(
      technique, *std::find_if(GetWritings().begin(), GetWritings().end(),
                   [name](const Writing& writing) { return std::string(name) == writing.Name; }));
  }
}

//------------------------------------------------------------------------------
// All of them, forward and in screen space.
SHADOW_TEST(Replacements, OfEveryKind, Once)
{
  for (const char* evaluation : { "forward", "screen" })
  {
    for (const Writing& writing : GetWritings())
    {
      CheckDrawing("map-hard", writing, { { "evaluation", evaluation } });
    }
  }
}

//------------------------------------------------------------------------------
// What cannot be shadowed is drawn as VTK draws it, and said once; the others keep their shadows.
SHADOW_TEST(Replacements, ThatCannotBeAreSaidOnce, Once)
{
  const std::vector<std::pair<Writing, const char*>> writings = {
    { { "before the position",
        [](vtkShaderProperty* shader)
        {
          Write(shader, "//VTK::PositionVC::Impl",
            "vec3 early = lightColor0;\n  //VTK::PositionVC::Impl\n");
          Write(shader, "//VTK::Light::Impl", "gl_FragData[0] = vec4(0.5 * early, 1.0);\n");
        } },
      "position" },
    { { "no position",
        [](vtkShaderProperty* shader)
        {
          shader->SetFragmentShaderCode("//VTK::System::Dec\n//VTK::Output::Dec\n"
                                        "uniform vec3 lightColor0;\n"
                                        "void main()\n{\n"
                                        "  gl_FragData[0] = vec4(0.7 * lightColor0, 1.0);\n}\n");
        } },
      "vertexVC" },
    { { "a name of ours",
        [](vtkShaderProperty* shader)
        {
          Write(shader, "//VTK::Light::Dec",
            "//VTK::Light::Dec\nfloat shadowSee(float x) { return 0.5 * x; }\n");
          Write(shader, "//VTK::Color::Impl",
            "//VTK::Color::Impl\n  diffuseColor *= shadowSee(1.0);\n");
        } },
      "shadowSee" },
    { { "a macro in our names",
        [](vtkShaderProperty* shader) {
          Write(shader, "//VTK::Light::Dec", "//VTK::Light::Dec\n#define normalVC vec3(0.0)\n");
        } },
      "normalVC" },
    { { "a macro in the light's name",
        [](vtkShaderProperty* shader) {
          Write(shader, "//VTK::Light::Dec", "//VTK::Light::Dec\n#define lightColor0 vec3(0.7)\n");
        } },
      "lightColor0" },
  };
  for (std::size_t i = 0; i < 2 * writings.size(); ++i)
  {
    const auto& writing = writings[i / 2];
    const char* evaluation = i % 2 == 0 ? "forward" : "screen";
    ShadowStage stage;
    Stand(stage, writing.first);
    const std::string what = std::string(writing.first.Name) + ", " + evaluation;
    stage.Render();
    const Picture plain = stage.GetPicture();
    ShadowTest::CheckNoMessage(what + ", without a pass");
    stage.SetPass("map-hard", { { "evaluation", evaluation } });
    stage.Render();
    stage.Render();
    const Picture picture = stage.GetPicture();
    stage.GetVisibility();
    ShadowTest::CheckOneMessage(
      ShadowTest::Message::Warning, { "fragment shader", writing.second }, what);
    const ShadowOracle oracle(stage);
    auto* floor = vtkActor::SafeDownCast(stage.Renderer->GetViewProps()->GetItemAsObject(0));
    const auto mask = oracle.GetMask(floor);
    const auto inner = oracle.GetInner(1);
    int worst = 0;
    for (std::size_t pixel = 0; pixel < mask.size(); ++pixel)
    {
      worst = std::max(worst, inner[pixel] && mask[pixel] ? picture.Difference(plain, pixel) : 0);
    }
    ShadowTest::CheckAtMost(worst, 0.0, what + ": difference from VTK's picture");
  }
}

//------------------------------------------------------------------------------
// A catcher whose lighting is the user's still is what its lights lack.
SHADOW_TEST(Replacements, OfACatcher, Each)
{
  ShadowStage stage;
  Stand(stage, GetWritings()[0]);
  auto* floor = vtkActor::SafeDownCast(stage.Renderer->GetViewProps()->GetItemAsObject(0));
  floor->VisibilityOff();
  stage.Render();
  const Picture without = stage.GetPicture();
  floor->VisibilityOn();
  vtkShadowPass::SetShadowCatcher(floor, true);
  stage.SetPass(technique);
  stage.Render();
  const Picture picture = stage.GetPicture();
  const Visibility visibility = stage.GetVisibility();
  ShadowTest::CheckNoMessage("catcher");
  const ShadowOracle oracle(stage);
  const auto mask = oracle.GetMask(floor);
  const auto inner = oracle.GetInner(1);
  int worstLit = 0;
  int worstDark = 0;
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    if (inner[i] && mask[i] && visibility.V[i] == 1.0f)
    {
      worstLit = std::max(worstLit, picture.Difference(without, i));
    }
    else if (inner[i] && mask[i] && visibility.V[i] == 0.0f)
    {
      worstDark =
        std::max<int>(worstDark, *std::max_element(&picture.RGB[3 * i], &picture.RGB[3 * i] + 3));
    }
  }
  ShadowTest::CheckAtMost(worstLit, 1.0, "lit: difference from what lies behind");
  ShadowTest::CheckAtMost(worstDark, 1.0, "dark: brightness");
}
