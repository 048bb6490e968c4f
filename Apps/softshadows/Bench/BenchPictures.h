// SPDX-License-Identifier: BSD-3-Clause
// Pictures within the text of a page.

#ifndef BenchPictures_h
#define BenchPictures_h

#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;

namespace BenchPictures
{
///@{
/** A picture file in base64: PNG for drawings of few colours. Failure if it cannot be made. */
std::string EncodePNG(vtkImageData* picture);
std::string EncodeJPEG(vtkImageData* picture);
///@}

/** The picture, made smaller where it is wider than that. */
vtkSmartPointer<vtkImageData> Shrink(vtkImageData* picture, int width);
}

#endif
