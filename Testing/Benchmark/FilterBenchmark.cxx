// What the filters of one map add to a frame, beside ray tracing, and what leaving out saves.
//
//   softshadowsFilterBenchmark [scene=huge [size=700 [frames=21]]]
//
// Medians of interleaved frames for which the camera moves, each ended by glFinish; then of frames
// for which the light moves.

#include "Contestant.h"

#include <cstdio>
#include <cstdlib>
#include <memory>

namespace
{
struct Entry
{
  const char* Name;
  const char* Technique; // nullptr: no shadows
  std::map<std::string, std::string> Parameters;
  bool Point = false; // the light has no size
};

const std::vector<Entry> Entries = {
  { "no shadows", nullptr, {} },
  { "ray-traced, 64 rays", "ray-traced", { { "samples", "64" } } },
  { "map-hard", "map-hard", {} },
  { "map-pcf, 7 x 7", "map-pcf", {} },
  { "map-pcf, 8 x 8", "map-pcf", { { "kernel", "8" } } },
  { "map-pcf, 8 x 8, no skipping", "map-pcf", { { "kernel", "8" }, { "skipping", "off" } } },
  { "map-blur", "map-blur", {} },
  { "map-jitter, 64", "map-jitter", {} },
  { "map-jitter, 64, no skipping", "map-jitter", { { "skipping", "off" } } },
  { "map-pcss, 64", "map-pcss", {} },
  { "map-pcss, 64, no skipping", "map-pcss", { { "skipping", "off" } } },
  { "map-pcss, 64, no midpoint", "map-pcss", { { "midpoint", "off" } } },
  { "map-pcss, 64, screen", "map-pcss", { { "evaluation", "screen" } } },
  { "map-hard, a point light", "map-hard", {}, true },
  { "map-pcss, a point light", "map-pcss", {}, true },
  { "map-combined, 32", "map-combined", {} },
  { "map-combined, 32, no skipping", "map-combined", { { "skipping", "off" } } },
};
}

int main(int argc, char* argv[])
{
  const std::string scene = argc > 1 ? argv[1] : "huge";
  const int size = argc > 2 ? std::atoi(argv[2]) : 700;
  const int frames = argc > 3 ? std::atoi(argv[3]) : 21;
  if (size < 16 || frames < 3)
  {
    std::fprintf(stderr, "usage: softshadowsFilterBenchmark [scene [size >= 16 [frames >= 3]]]\n");
    return 2;
  }
  std::vector<std::unique_ptr<Contestant>> contestants;
  std::vector<vtkSmartPointer<vtkShadowPass>> passes;
  for (const Entry& entry : Entries)
  {
    passes.push_back(entry.Technique ? MakePass(entry.Technique, entry.Parameters) : nullptr);
    contestants.push_back(
      std::make_unique<Contestant>(entry.Name, scene, size, passes.back().Get()));
    if (entry.Point)
    {
      vtkAreaLight::SafeDownCast(contestants.back()->Light)->SetShapeToPoint();
    }
  }
  for (int i = -2; i < frames; ++i)
  {
    for (auto& contestant : contestants)
    {
      const double camera = contestant->MoveCamera(i);
      const double moving = contestant->MoveLight(i);
      contestant->MoveCamera(i + 1); // settle
      if (i >= 0)
      {
        contestant->Camera.push_back(camera);
        contestant->Moving.push_back(moving);
      }
    }
  }
  const double base = Median(contestants[0]->Camera);
  const double baseMoving = Median(contestants[0]->Moving);
  const double rays = Median(contestants[1]->Camera) - base;
  std::printf(
    "%s, %d x %d: frame without shadows %.1f ms; added, and its share of what 64 rays add\n",
    scene.c_str(), size, size, base);
  for (const auto& contestant : contestants)
  {
    const double added = Median(contestant->Camera) - base;
    std::printf("  %-30s camera moves %7.1f ms  %6.3f   light moves %7.1f ms\n",
      contestant->Name.c_str(), added, added / rays, Median(contestant->Moving) - baseMoving);
  }
  return 0;
}
