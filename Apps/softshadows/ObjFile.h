// SPDX-License-Identifier: BSD-3-Clause
// What vtkOBJReader of VTK 9.1 does not see: points that are no numbers, faces of several forms.

#ifndef ObjFile_h
#define ObjFile_h

#include <cstdio>
#include <memory>
#include <string>

/**
 * A Wavefront OBJ file, fit for vtkOBJReader. That reader gives a point such as "v nan 0 0" the
 * coordinates of another point, and leaves out faces without normals (or texture coordinates) in a file
 * that has some. Here such a file is copied: points that are no numbers get coordinates too large to be
 * used, which the mesh's preparation recognizes and counts; normals that not all faces have are left
 * out, to be computed for all alike, and so are texture coordinates, which nothing uses. Any other file
 * is read itself.
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
