// SPDX-License-Identifier: BSD-3-Clause
// Keeps a reader that prints, crashes, finds no end or takes all memory on a damaged file from doing so
// in front of the user.

#ifndef ReaderGuard_h
#define ReaderGuard_h

#include <csignal>
#include <cstdio>
#include <memory>
#include <string>
#include <sys/resource.h>
#include <sys/time.h>

/**
 * While this lives, what is printed on stderr is kept back; a crash, or more processor time than a file
 * of this size can need, ends the program with one message that names the file, and exit code 1; more
 * memory than it can need is refused, as std::bad_alloc. VTK's readers do crash on truncated files, and
 * believe whatever counts and sizes stand in them. Nothing that has to be cleaned up may exist meanwhile.
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
  static constexpr int Signals[] = { SIGSEGV, SIGBUS, SIGFPE, SIGABRT, SIGPROF };
  static constexpr std::size_t StackSize = 65536;

  void LimitMemory(double fileSize);
  void LimitTime(double fileSize);

  struct sigaction Old[sizeof(Signals) / sizeof(Signals[0])];
  std::unique_ptr<char[]>
    Stack; // of the handler: a reader that calls itself too often has used up its own
  stack_t OldStack = {};
  struct rlimit OldMemory = {};
  struct itimerval OldTimer = {};
  std::FILE* Kept = nullptr;
};

#endif
