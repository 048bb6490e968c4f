// SPDX-License-Identifier: BSD-3-Clause
// Reading polygon files, as actors ready to be drawn.

#ifndef Models_h
#define Models_h

#include "vtkActor.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace Models
{
/** The extensions that Read knows, for messages. */
std::string GetExtensions();

/**
 * Read a polygon file: OBJ, PLY, STL, VTP, VTU, VTS, VTK, glTF or GLB. Triangles with points that are not
 * finite are left out, with a warning; normals are computed where the file has none. Failure, which
 * names the file, where it cannot be read or no triangle is left.
 */
std::vector<vtkSmartPointer<vtkActor>> Read(const std::string& path);

/** All files that reading these takes: themselves, and what a glTF model refers to. */
std::vector<std::string> GetFiles(const std::vector<std::string>& paths);

/** An actor for a mesh: neutral grey, or its own colours where it has bytes of RGB. */
vtkSmartPointer<vtkActor> MakeActor(vtkPolyData* mesh);
}

#endif
