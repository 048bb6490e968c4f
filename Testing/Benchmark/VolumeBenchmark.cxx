// What shadow volumes add to a frame, by the ways of counting, beside a map.
//
//   softshadowsVolumeBenchmark [scene=huge [size=700 [frames=21]]]

#include "EntryTable.h"

namespace
{
const std::vector<EntryTable::Entry> Entries = {
  { "no shadows", nullptr, {} },
  { "map-hard", "map-hard", {} },
  { "volume-hard", "volume-hard", {} },
  { "volume-hard, z-fail", "volume-hard", { { "counting", "z-fail" } } },
  { "volume-hard, xor", "volume-hard", { { "counting", "xor" } } },
  { "volume-soft, 16", "volume-soft", { { "samples", "16" } } },
};
}

int main(int argc, char* argv[])
{
  return EntryTable::Main(argc, argv, Entries);
}
