// SPDX-License-Identifier: BSD-3-Clause
// Ctrl-C during long work that has something to show for what was done.

#ifndef Interruption_h
#define Interruption_h

#include <array>
#include <csignal>

/**
 * While it lives, the first SIGINT, SIGTERM or SIGHUP is noted instead of ending the command; another of
 * the same kind ends it. One that was ignored stays so.
 */
class Interruption
{
public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  void operator=(const Interruption&) = delete;

  /** Whether one has come since the first of these was made. */
  static bool IsAsked();

private:
  static constexpr std::array<int, 3> Signals = { SIGINT, SIGTERM, SIGHUP };
  struct sigaction Old[Signals.size()];
};

#endif
