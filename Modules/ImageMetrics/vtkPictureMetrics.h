// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPictureMetrics
 * @brief   The difference of two shaded pictures, as an eye or a display sees it.
 *
 * Both images are width x height x 1 pixels, unsigned char or float, of 1 (grey), 3 (RGB) or 4
 * (RGBA) components in their active point scalars. Only colour channels are compared, alpha is
 * not: a picture with alpha can be compared with one without. Unsigned char 0..255 and float 0..1
 * mean the same, and the two may be mixed.
 *
 * Visibility is the better measure of a shadow technique: see vtkVisibilityMetrics.
 *
 * Figures are those of the last Update. Before it, and after one that failed, they are NaN and the
 * counts are 0.
 */

#ifndef vtkPictureMetrics_h
#define vtkPictureMetrics_h

#include "vtkObject.h"
#include "vtkSmartPointer.h"                  // For images
#include "vtkSoftShadowsImageMetricsModule.h" // For export macro
#include <string>                             // For GetJSON

class vtkImageData;

class VTKSOFTSHADOWSIMAGEMETRICS_EXPORT vtkPictureMetrics : public vtkObject
{
public:
  static vtkPictureMetrics* New();
  vtkTypeMacro(vtkPictureMetrics, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The picture to compare, and the one it should be. Default: none.
   */
  void SetReference(vtkImageData* reference);
  vtkImageData* GetReference();
  void SetImage(vtkImageData* image);
  vtkImageData* GetImage();
  ///@}

  ///@{
  /**
   * By how much a channel's byte may differ and still count as correct, 0 to 255. Default: 4.
   */
  vtkSetClampMacro(Tolerance, int, 0, 255);
  vtkGetMacro(Tolerance, int);
  ///@}

  ///@{
  /**
   * Difference that the difference image shows in full colour, > 0; 1 is black against white.
   * Default: 0.25.
   */
  vtkSetClampMacro(DifferenceScale, double, 1e-9, 1e9);
  vtkGetMacro(DifferenceScale, double);
  ///@}

  /**
   * Compare. Returns false and reports an error when a picture is missing, empty, or of another
   * kind than above, when sizes or numbers of colour channels differ, or when a colour is NaN or
   * infinite (the error tells how many).
   */
  bool Update();

  /**
   * Share of colour bytes (channel values, float ones clamped to [0,1] and rounded to 8 bits) that
   * differ by Tolerance at most, in percent, 0 to 100: the thesis's correctness.
   */
  vtkGetMacro(Correctness, double);

  ///@{
  /**
   * Root mean square, and largest absolute, difference of colour channels; 1 is black against
   * white.
   */
  vtkGetMacro(RMSE, double);
  vtkGetMacro(Maximum, double);
  ///@}

  /**
   * Peak signal to noise ratio for a peak of 1, -20 log10(RMSE), in dB. Infinite when the pictures
   * are equal.
   */
  vtkGetMacro(PSNR, double);

  /**
   * How many pixels the figures rest on.
   */
  vtkGetMacro(NumberOfPixels, vtkIdType);

  /**
   * All figures as a JSON object:
   *
   *     { "pixels": 4, "tolerance": 4, "correctness_percent": 75.0, "rmse": 0.1, "psnr_db": 20.0,
   *       "maximum": 0.2, "equal": false }
   *
   * JSON knows no infinity: of equal pictures "psnr_db" is null and "equal" true. Figures that are
   * not known (NaN) are null too.
   */
  std::string GetJSON();

  /**
   * Signed difference of the last Update, unsigned char RGB, as large as the pictures: white where
   * equal, ever bluer where the image is darker than the reference, ever redder where it is
   * brighter, by the channel that differs most. nullptr before Update and after one that failed.
   * Owned by this object; each Update makes a new one.
   */
  vtkImageData* GetDifferenceImage();

protected:
  vtkPictureMetrics();
  ~vtkPictureMetrics() override;

  vtkSmartPointer<vtkImageData> Reference;
  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkImageData> DifferenceImage;
  int Tolerance = 4;
  double DifferenceScale = 0.25;

  double Correctness;
  double RMSE;
  double PSNR;
  double Maximum;
  vtkIdType NumberOfPixels;

private:
  void Reset();
  std::string Compare();

  vtkPictureMetrics(const vtkPictureMetrics&) = delete;
  void operator=(const vtkPictureMetrics&) = delete;
};

#endif
