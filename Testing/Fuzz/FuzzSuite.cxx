// SPDX-License-Identifier: BSD-3-Clause
// A suite of any content is a plan, or a failure in one line that names it.

#include "BenchPlan.h"
#include "Errors.h"
#include "FuzzFile.h"

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
  Messages::Install(); // as the command does: what VTK reports becomes a failure
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const FuzzFile file(data, size);
  try
  {
    BenchPlans::Load(file.GetPath());
  }
  catch (const Failure& failure)
  {
    if (std::string(failure.what()).find(file.GetPath()) == std::string::npos)
    {
      std::abort();
    }
  }
  Messages::TakeError();
  return 0;
}
