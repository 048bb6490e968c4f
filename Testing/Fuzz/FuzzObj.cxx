// SPDX-License-Identifier: BSD-3-Clause
// The copy that is made of an OBJ file needs no copy itself.

#include "FuzzFile.h"
#include "ObjFile.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const FuzzFile file(data, size);
  const ObjFile mended(file.GetPath());
  const ObjFile again(mended.GetPath());
  if (again.GetPath() != mended.GetPath())
  {
    std::abort();
  }
  return 0;
}
