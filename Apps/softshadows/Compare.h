// SPDX-License-Identifier: BSD-3-Clause
// softshadows compare: the techniques against the ray-traced reference, or two pictures.

#ifndef Compare_h
#define Compare_h

#include "SceneOptions.h"
#include "Techniques.h"

#include <string>

namespace CLI
{
class App;
}

struct CompareOptions
{
  SceneOptions Scene;
  TechniqueOptions Parameters;
  std::string Techniques; // separated by commas; empty: all
  int ReferenceSamples = 1024;
  int Frames = 5;
  std::string Output;
  bool AsJson = false;
};

void DeclareCompare(CLI::App& app);

/** Draw a scene with each technique, and the reference; print errors and times. */
void CompareTechniques(const CompareOptions& options);

/** Compare a picture (the first of the models) with the one that it should be. */
void ComparePictures(const CompareOptions& options);

/** Whether a file is a picture, by its name. */
bool IsPicture(const std::string& path);

#endif
