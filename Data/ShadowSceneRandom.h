// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ShadowSceneRandom
 * @brief   Pseudo-random numbers that are the same on every machine.
 *
 * The standard fixes what std::mt19937 yields, but not what its distributions make of it; so the
 * mapping to numbers is done here.
 */

#ifndef ShadowSceneRandom_h
#define ShadowSceneRandom_h

#include <random>

class ShadowSceneRandom
{
public:
  explicit ShadowSceneRandom(unsigned int seed)
    : Engine(seed)
  {
  }

  /**
   * A number in [low, high).
   */
  double Between(double low, double high)
  {
    return low + (high - low) * (static_cast<double>(this->Engine()) / 4294967296.0);
  }

  /**
   * A number out of 0 ... count - 1.
   */
  int Index(int count) { return static_cast<int>(this->Between(0.0, count)); }

private:
  std::mt19937 Engine;
};

#endif
