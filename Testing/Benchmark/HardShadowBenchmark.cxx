// SPDX-License-Identifier: BSD-3-Clause
// map-hard beside VTK's own vtkShadowMapPass: same scenes, light, map resolution and run. And
// planar-hard beside map-hard, where all that receives is a floor.
//
//   softshadowsHardBenchmark [size=700 [frames=21]]
//
// Prints, for each scene, the time that shadows add to a frame while the camera moves and while the
// light moves (medians of interleaved frames, each ended by glFinish), and the error of the picture
// against a ray-traced point light. The light is a spot, because VTK's pass takes nothing else.

#include "Contestant.h"

#include "vtkLightCollection.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{
constexpr int Resolution = 1024;

double RMSE(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    const double difference = (a[i] - b[i]) / 255.0;
    sum += difference * difference;
  }
  return std::sqrt(sum / a.size());
}

/** Frames for which the camera moves, and those for which the light does, in turns. */
void Measure(const std::vector<Contestant*>& timed, int frames)
{
  for (int i = -3; i < frames; ++i)
  {
    for (Contestant* contestant : timed)
    {
      const double camera = contestant->MoveCamera(i);
      const double moving = contestant->MoveLight(i);
      if (i >= 0)
      {
        contestant->Camera.push_back(camera);
        contestant->Moving.push_back(moving);
      }
    }
  }
}

/** Print medians, and what all but the first add to it: while the camera moves, while the light does. */
std::vector<std::array<double, 2>> Report(const std::vector<Contestant*>& timed)
{
  const double base[] = { Median(timed[0]->Camera), Median(timed[0]->Moving) };
  std::vector<std::array<double, 2>> added;
  for (const Contestant* contestant : timed)
  {
    added.push_back({ Median(contestant->Camera) - base[0], Median(contestant->Moving) - base[1] });
    std::printf("  %-18s camera moves %6.1f ms, added %6.2f; light moves %6.1f ms, added %6.2f\n",
      contestant->Name.c_str(), Median(contestant->Camera), added.back()[0],
      Median(contestant->Moving), added.back()[1]);
  }
  return added;
}

/** Scenes whose only receiver is a floor, but for what shadows itself. */
[[maybe_unused]] void RunPlanar(const std::string& scene, int size, int frames)
{
  Contestant none("no shadows", scene, size, nullptr);
  const auto mapPass = MakePass("map-hard", { { "resolution", std::to_string(Resolution) } });
  const auto planarPass = MakePass("planar-hard", {});
  Contestant map("map-hard", scene, size, mapPass);
  Contestant planar("planar-hard", scene, size, planarPass);
  std::printf("%s, %d x %d, map %d\n", scene.c_str(), size, size, Resolution);
  Measure({ &none, &map, &planar }, frames);
  const auto added = Report({ &none, &map, &planar });
  std::printf(
    "  planar-hard adds %.2f of map-hard's when the camera moves, %.2f when the light moves\n",
    added[2][0] / added[1][0], added[2][1] / added[1][1]);
}

void Run(const std::string& scene, int size, int frames)
{
  Contestant none("no shadows", scene, size, nullptr);
  const auto vtkPass = MakeVTKShadowPass(Resolution);
  const auto ourPass = MakePass("map-hard", { { "resolution", std::to_string(Resolution) } });
  const auto referencePass = MakePass("ray-traced", { { "samples", "1" } });
  Contestant vtkOwn("vtkShadowMapPass", scene, size, vtkPass);
  Contestant ours("map-hard", scene, size, ourPass);
  Contestant reference("ray-traced", scene, size, referencePass);
  for (Contestant* contestant : { &none, &vtkOwn, &ours, &reference })
  {
    contestant->UseSpot(40.0);
  }
  const std::vector<Contestant*> timed = { &none, &vtkOwn, &ours };

  const auto truth = reference.Picture();
  std::printf("%s, %d x %d, map %d\n", scene.c_str(), size, size, Resolution);
  for (Contestant* contestant : timed)
  {
    std::printf("  %-18s picture RMSE against a ray-traced point light %.4f\n",
      contestant->Name.c_str(), RMSE(contestant->Picture(), truth));
  }
  Measure(timed, frames);
  const auto added = Report(timed);
  std::printf("  map-hard adds %.2f of VTK's when the camera moves, %.2f when the light moves\n",
    added[2][0] / added[1][0], added[2][1] / added[1][1]);
}
}

int main(int argc, char* argv[])
{
  const int size = argc > 1 ? std::atoi(argv[1]) : 700;
  const int frames = argc > 2 ? std::atoi(argv[2]) : 21;
  if (size < 16 || frames < 3)
  {
    std::fprintf(stderr, "usage: softshadowsHardBenchmark [size >= 16 [frames >= 3]]\n");
    return 2;
  }
  for (const char* scene : { "basic", "huge" })
  {
    Run(scene, size, frames);
  }
#ifdef SOFTSHADOWS_PLANAR_SHADOWS
  for (const char* scene : { "blocker", "bunny", "basic" })
  {
    RunPlanar(scene, size, frames);
  }
#endif
  return 0;
}
