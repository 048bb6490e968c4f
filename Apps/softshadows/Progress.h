// SPDX-License-Identifier: BSD-3-Clause
// How far long work has come, on a terminal.

#ifndef Progress_h
#define Progress_h

#include <boost/timer/progress_display.hpp>

#include <condition_variable>
#include <iostream>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

/** Counts steps on stderr; does nothing where that is no terminal. */
class Progress
{
public:
  Progress(const std::string& title, unsigned long steps);
  void Advance();

  static bool IsShown();

private:
  std::unique_ptr<boost::timer::progress_display> Display;
};

/** Tells on one line of stderr how long work will still take; does nothing where that is no terminal. */
class RemainingTime
{
public:
  /** Other work takes `later` seconds after it. */
  RemainingTime(const std::string& title, double later);
  ~RemainingTime();
  RemainingTime(const RemainingTime&) = delete;
  void operator=(const RemainingTime&) = delete;
  void Show(double seconds);

private:
  std::string Title;
  double Later;
};

/** Lets a display run for as long as work that reports nothing is expected to take. */
class ExpectedProgress
{
public:
  ExpectedProgress(const std::string& title, double expectedMilliseconds);
  ~ExpectedProgress();
  ExpectedProgress(const ExpectedProgress&) = delete;
  void operator=(const ExpectedProgress&) = delete;

private:
  std::mutex Mutex;
  std::condition_variable Woken;
  bool Done = false;
  std::thread Thread;
};

#endif
