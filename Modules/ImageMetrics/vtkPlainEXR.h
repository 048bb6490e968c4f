// SPDX-License-Identifier: BSD-3-Clause
/**
 * EXR files of 32-bit floats in scan lines, without compression: visibility, where no library for
 * EXR is to be had. Not installed, not wrapped.
 */

#ifndef vtkPlainEXR_h
#define vtkPlainEXR_h

#include <string>
#include <vector>

class vtkImageData;

namespace vtkPlainEXR
{
/// Whether a file begins as an EXR file does.
bool IsOne(const std::string& path);

/// An image of 1 (channel Y), 3 or 4 components of floats or bytes.
std::vector<unsigned char> Encode(vtkImageData* image, const std::string& software);

/// Returns an empty string, or what went wrong.
std::string Decode(const std::vector<unsigned char>& file, vtkImageData* image);
}

#endif
