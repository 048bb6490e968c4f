// SPDX-License-Identifier: BSD-3-Clause
// What the C++ tests of modules share: checks that tell where and what, and count.

#ifndef ShadowTesting_h
#define ShadowTesting_h

#include <cmath>
#include <iostream>

namespace ShadowTesting
{
inline int Failures = 0;

#define CHECK(condition)                                                          \
  do                                                                              \
  {                                                                               \
    if (!(condition))                                                             \
    {                                                                             \
      std::cout << __FILE__ << ":" << __LINE__ << ": not true: " #condition "\n"; \
      ++ShadowTesting::Failures;                                                  \
    }                                                                             \
  } while (false)

#define CHECK_EQUAL(value, expected)                                                        \
  do                                                                                        \
  {                                                                                         \
    if (!((value) == (expected)))                                                           \
    {                                                                                       \
      std::cout << __FILE__ << ":" << __LINE__ << ": " #value " is " << (value) << ", not " \
                << (expected) << "\n";                                                      \
      ++ShadowTesting::Failures;                                                            \
    }                                                                                       \
  } while (false)

#define CHECK_NEAR(value, expected, tolerance)                                              \
  do                                                                                        \
  {                                                                                         \
    if (!(std::abs((value) - (expected)) <= (tolerance)))                                   \
    {                                                                                       \
      std::cout << __FILE__ << ":" << __LINE__ << ": " #value " is " << (value) << ", not " \
                << (expected) << "\n";                                                      \
      ++ShadowTesting::Failures;                                                            \
    }                                                                                       \
  } while (false)

/** What a test's main function returns. */
inline int Result()
{
  return Failures == 0 ? 0 : 1;
}
}

#endif
