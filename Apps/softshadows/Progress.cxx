// SPDX-License-Identifier: BSD-3-Clause
#include "Progress.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <unistd.h>

//------------------------------------------------------------------------------
bool Progress::IsShown()
{
  return isatty(STDERR_FILENO) != 0;
}

//------------------------------------------------------------------------------
Progress::Progress(const std::string& title, unsigned long steps)
{
  if (Progress::IsShown())
  {
    std::cerr << title << "\n";
    this->Display = std::make_unique<boost::timer::progress_display>(steps, std::cerr, "");
  }
}

//------------------------------------------------------------------------------
void Progress::Advance()
{
  if (this->Display && this->Display->count() < this->Display->expected_count())
  {
    ++*this->Display;
  }
}

//------------------------------------------------------------------------------
RemainingTime::RemainingTime(const std::string& title, double later)
  : Title(title)
  , Later(later)
{
}

//------------------------------------------------------------------------------
RemainingTime::~RemainingTime()
{
  if (Progress::IsShown())
  {
    std::cerr << std::endl;
  }
}

//------------------------------------------------------------------------------
void RemainingTime::Show(double seconds)
{
  if (Progress::IsShown())
  {
    const char* const toTheStartAndClear = "\r\033[K";
    const long left = std::lround(std::max(seconds, 0.0));
    std::cerr << toTheStartAndClear << this->Title << ": " << left << " s left";
    if (this->Later > 0.0)
    {
      std::cerr << ", of all " << left + std::lround(this->Later) << " s";
    }
    std::cerr << std::flush;
  }
}

//------------------------------------------------------------------------------
ExpectedProgress::ExpectedProgress(const std::string& title, double expectedMilliseconds)
{
  if (!Progress::IsShown())
  {
    return;
  }
  this->Thread = std::thread(
    [this, title, expectedMilliseconds]
    {
      constexpr int steps = 50;
      Progress progress(title, steps);
      const std::chrono::duration<double, std::milli> step(expectedMilliseconds / steps);
      std::unique_lock<std::mutex> lock(this->Mutex);
      int shown = 0;
      // The last step waits for the work itself.
      while (!this->Woken.wait_for(lock, step, [this] { return this->Done; }))
      {
        if (shown + 1 < steps)
        {
          progress.Advance();
          ++shown;
        }
      }
      for (; shown < steps; ++shown)
      {
        progress.Advance();
      }
    });
}

//------------------------------------------------------------------------------
ExpectedProgress::~ExpectedProgress()
{
  if (this->Thread.joinable())
  {
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Done = true;
    }
    this->Woken.notify_all();
    this->Thread.join();
  }
}
