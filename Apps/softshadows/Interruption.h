// Ctrl-C during long work that has something to show for what was done.

#ifndef Interruption_h
#define Interruption_h

#include <csignal>

/** While it lives, the first SIGINT or SIGTERM is noted instead of ending the command; the next ends it. */
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
  struct sigaction Interrupt = {};
  struct sigaction Terminate = {};
};

#endif
