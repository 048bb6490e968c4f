// What the filters of one map add to a frame, beside ray tracing, and what leaving out saves.
//
//   softshadowsFilterBenchmark [scene=huge [size=700 [frames=21]]]
//
// Medians of interleaved frames for which the camera moves, each ended by glFinish; then of frames
// for which the light moves.

#include "EntryTable.h"

namespace
{
const std::vector<EntryTable::Entry> Entries = {
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
  return EntryTable::Main(argc, argv, Entries);
}
