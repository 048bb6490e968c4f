// SPDX-License-Identifier: BSD-3-Clause
/**
 * What reads and encodes image files for vtkImageFile: OpenImageIO, or VTK where that is not to be
 * had. Not installed, not wrapped.
 */

#ifndef vtkImageCodec_h
#define vtkImageCodec_h

#include <string>
#include <vector>

class vtkImageData;

namespace vtkImageCodec
{
/// Both return an empty string, or what went wrong. A file that cannot be read leaves the image.
std::string Read(const std::string& path, vtkImageData* image);

/// Encode an image of floats or bytes, with 1, 3 or 4 components, as the name's extension says.
std::string Encode(const std::string& name, vtkImageData* image, const std::string& software,
  std::vector<unsigned char>& encoded);
}

#endif
