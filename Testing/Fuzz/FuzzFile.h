// SPDX-License-Identifier: BSD-3-Clause
// A file of any content, for what reads files by name.

#ifndef FuzzFile_h
#define FuzzFile_h

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include <sys/mman.h>
#include <unistd.h>

class FuzzFile
{
public:
  FuzzFile(const std::uint8_t* data, std::size_t size)
    : Descriptor(memfd_create("fuzz", 0))
  {
    if (this->Descriptor < 0 || write(this->Descriptor, data, size) < 0)
    {
      std::abort();
    }
  }
  ~FuzzFile() { close(this->Descriptor); }
  FuzzFile(const FuzzFile&) = delete;
  void operator=(const FuzzFile&) = delete;

  std::string GetPath() const { return "/proc/self/fd/" + std::to_string(this->Descriptor); }

private:
  int Descriptor;
};

#endif
