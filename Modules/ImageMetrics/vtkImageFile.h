// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkImageFile
 * @brief   Reads and writes pictures and visibility as image files.
 *
 * The format follows from the file's extension: PNG, EXR, TIFF, BMP and whatever else OpenImageIO
 * knows (for writing: whatever it can encode in memory). Built without OpenImageIO it is these
 * four, through VTK, and EXR without compression. A file begins with its top row, a
 * vtkImageData with its bottom row: both functions flip, so that the first tuple is the bottom
 * left pixel.
 *
 * Values are stored as they are: nothing is converted between colour spaces, and alpha is neither
 * multiplied in nor divided out.
 *
 * An error is reported once, as a VTK error that names the file and the reason.
 */

#ifndef vtkImageFile_h
#define vtkImageFile_h

#include "vtkObject.h"
#include "vtkSoftShadowsImageMetricsModule.h" // For export macro
#include <string>                             // For paths

class vtkImageData;

class VTKSOFTSHADOWSIMAGEMETRICS_EXPORT vtkImageFile : public vtkObject
{
public:
  static vtkImageFile* New();
  vtkTypeMacro(vtkImageFile, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Read a file into an image of width x height x 1 pixels with origin 0 and spacing 1. Its active
   * point scalars, "ImageScalars", have 1 (grey), 2 (grey, alpha), 3 (RGB) or 4 (RGBA) components:
   * unsigned char for files of up to 8 bits a channel, else float (integers are scaled to [0,1]).
   *
   * Returns false and reports an error, with the image left as it was, when the file is missing,
   * damaged, of an unknown format, deep, a volume, or has more than 4 channels.
   */
  static bool Read(VTK_FILEPATH const std::string& path, vtkImageData* image);

  /**
   * Write an image's active point scalars, width x height x 1 pixels of 1 (grey), 3 (RGB) or 4
   * (RGBA) components, unsigned char, float or double. EXR stores 32-bit float, its single channel
   * is called Y. Float values are stored as 32-bit float where the format can (EXR, TIFF);
   * elsewhere (PNG, BMP) they are clamped to [0,1] and rounded to 8 bits, NaN giving 0.
   * `software`, unless empty, is put into the file's metadata as its maker, where the format has
   * room for it.
   *
   * Writing is atomic: a temporary file in the same folder is renamed when it is complete, so that
   * nobody ever sees half a file, and a failure leaves an older file of that name untouched.
   *
   * Returns false and reports an error, with nothing left behind, when the image is empty or of
   * another kind than above, the extension is unknown, the format cannot store that many
   * components, the folder does not exist, or the file cannot be written or is write-protected.
   */
  static bool Write(VTK_FILEPATH const std::string& path, vtkImageData* image,
    const std::string& software = std::string());

protected:
  vtkImageFile();
  ~vtkImageFile() override;

private:
  vtkImageFile(const vtkImageFile&) = delete;
  void operator=(const vtkImageFile&) = delete;
};

#endif
