// SPDX-License-Identifier: BSD-3-Clause
// Keeps a reader that prints or crashes on a damaged file from doing so in front of the user.

#ifndef ReaderGuard_h
#define ReaderGuard_h

#include <csignal>
#include <cstdio>
#include <string>

/**
 * While this lives, what is printed on stderr is kept back, and a crash ends the program with the one
 * message that the file is damaged, and exit code 1. VTK's readers of PLY, legacy VTK and glTF do crash
 * on truncated files. Nothing that has to be cleaned up may exist meanwhile.
 */
class ReaderGuard
{
public:
  explicit ReaderGuard(const std::string& path);
  ~ReaderGuard();
  ReaderGuard(const ReaderGuard&) = delete;
  void operator=(const ReaderGuard&) = delete;

  /** The first line that was printed, or "". */
  std::string GetPrinted();

private:
  static constexpr int Signals[] = { SIGSEGV, SIGBUS, SIGFPE, SIGABRT };

  struct sigaction Old[sizeof(Signals) / sizeof(Signals[0])];
  std::FILE* Kept = nullptr;
};

#endif
