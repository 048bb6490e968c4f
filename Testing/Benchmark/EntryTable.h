// Techniques in one table: the same scene in windows of their own, frames interleaved.
//
// Medians of frames for which the camera moves, each ended by glFinish; then of frames for which the
// light moves.

#ifndef EntryTable_h
#define EntryTable_h

#include "Contestant.h"

#include <cstdio>
#include <cstdlib>
#include <memory>

namespace EntryTable
{
struct Entry
{
  const char* Name;
  const char* Technique; // nullptr: no shadows
  std::map<std::string, std::string> Parameters;
  bool Point = false; // the light has no size
};

/** The first entry draws no shadows, the second is what the others' added time is compared with. */
inline int Main(int argc, char* argv[], const std::vector<Entry>& entries)
{
  const std::string scene = argc > 1 ? argv[1] : "huge";
  const int size = argc > 2 ? std::atoi(argv[2]) : 700;
  const int frames = argc > 3 ? std::atoi(argv[3]) : 21;
  if (size < 16 || frames < 3)
  {
    std::fprintf(stderr, "usage: %s [scene [size >= 16 [frames >= 3]]]\n", argv[0]);
    return 2;
  }
  std::vector<std::unique_ptr<Contestant>> contestants;
  std::vector<vtkSmartPointer<vtkShadowPass>> passes;
  for (const Entry& entry : entries)
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
  const double second = Median(contestants[1]->Camera) - base;
  std::printf("%s, %d x %d: frame without shadows %.1f ms, %.1f when the light moves; added, its "
              "share of what "
              "%s adds, and the frame beside that without shadows\n",
    scene.c_str(), size, size, base, baseMoving, entries[1].Name);
  for (const auto& contestant : contestants)
  {
    const double added = Median(contestant->Camera) - base;
    const double addedMoving = Median(contestant->Moving) - baseMoving;
    std::printf("  %-30s camera moves %7.1f ms  %6.3f  %5.2f   light moves %7.1f ms  %5.2f\n",
      contestant->Name.c_str(), added, added / second, (base + added) / base, addedMoving,
      (baseMoving + addedMoving) / baseMoving);
  }
  return 0;
}
}

#endif
