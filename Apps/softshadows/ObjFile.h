// SPDX-License-Identifier: BSD-3-Clause
// What vtkOBJReader of VTK 9.1 does not see: points that are no numbers.

#ifndef ObjFile_h
#define ObjFile_h

#include <cstdio>
#include <memory>
#include <string>

/**
 * A Wavefront OBJ file, fit for vtkOBJReader: that reader gives a point such as "v nan 0 0" the
 * coordinates of another point. Here a file that has such points is copied with coordinates too
 * large to be used, which the mesh's preparation recognizes and counts; any other is read itself.
 */
class ObjFile
{
public:
  explicit ObjFile(const std::string& path);

  /** Where to read it. */
  const std::string& GetPath() const { return this->Path; }

private:
  struct Close
  {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::string Path;
  std::unique_ptr<std::FILE, Close> Copy; // has no name, so that nothing stays behind
};

#endif
