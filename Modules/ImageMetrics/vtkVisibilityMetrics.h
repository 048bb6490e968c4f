// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVisibilityMetrics
 * @brief   The error of one light's visibility against a reference.
 *
 * Both images are width x height x 1 pixels of float visibility, 1 component or 3 (textured light),
 * 0 (umbra) to 1 (fully lit): the point-data array "Visibility" if there is one, else the active
 * scalars. They may have an unsigned char point-data array "Receiver", of 1 component: where it is
 * 0 the pixel shows no receiver and its visibility means nothing. Without that array all pixels
 * are receivers. Only pixels that are receivers in both images count.
 *
 * Errors are image - reference, in units of visibility. Penumbra pixels are receiver pixels whose
 * reference lies in PenumbraRange; of a coloured visibility, in at least one component. All
 * components of a pixel count, each as a value of its own.
 *
 * What a picture shows of an error is its product with N.L, the float point-data array "Cosine" of the
 * reference: weighted errors are root mean squares of that, over the root mean square of N.L itself, so
 * that the same error everywhere weighs as much as unweighted. Without the array they are the plain ones.
 *
 * Figures are those of the last Update. Before it, and after one that failed, they are NaN and the
 * counts are 0.
 */

#ifndef vtkVisibilityMetrics_h
#define vtkVisibilityMetrics_h

#include "vtkObject.h"
#include "vtkSmartPointer.h"                  // For images
#include "vtkSoftShadowsImageMetricsModule.h" // For export macro
#include <string>                             // For GetJSON

class vtkImageData;

class VTKSOFTSHADOWSIMAGEMETRICS_EXPORT vtkVisibilityMetrics : public vtkObject
{
public:
  static vtkVisibilityMetrics* New();
  vtkTypeMacro(vtkVisibilityMetrics, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The visibility to compare, and the one it should be. Default: none.
   */
  void SetReference(vtkImageData* reference);
  vtkImageData* GetReference();
  void SetImage(vtkImageData* image);
  vtkImageData* GetImage();
  ///@}

  ///@{
  /**
   * Reference visibility of penumbra pixels, from and to (both included), from <= to.
   * Default: 0.02 to 0.98.
   */
  vtkSetVector2Macro(PenumbraRange, double);
  vtkGetVector2Macro(PenumbraRange, double);
  ///@}

  ///@{
  /**
   * Difference of visibility that the difference image shows in full colour, > 0. Default: 0.25.
   */
  vtkSetClampMacro(DifferenceScale, double, 1e-9, 1e9);
  vtkGetMacro(DifferenceScale, double);
  ///@}

  /**
   * Compare. Returns false and reports an error when an image is missing, empty or not float of 1
   * or 3 components, when sizes or components differ, when no pixel is a receiver in both images,
   * or when a receiver pixel holds a value that is NaN or infinite (the error tells how many).
   */
  bool Update();

  ///@{
  /**
   * Over all receiver pixels, in units of visibility: root mean square error; bias (mean error,
   * positive when the image is brighter than the reference); 99th percentile (nearest rank) and
   * maximum of the absolute error; root mean square error as N.L weighs it.
   */
  vtkGetMacro(RMSE, double);
  vtkGetMacro(Bias, double);
  vtkGetMacro(P99, double);
  vtkGetMacro(Maximum, double);
  vtkGetMacro(WeightedRMSE, double);
  ///@}

  ///@{
  /**
   * The same over penumbra pixels alone; 0 when there are none.
   */
  vtkGetMacro(PenumbraRMSE, double);
  vtkGetMacro(PenumbraBias, double);
  vtkGetMacro(PenumbraP99, double);
  vtkGetMacro(PenumbraMaximum, double);
  vtkGetMacro(PenumbraWeightedRMSE, double);
  ///@}

  ///@{
  /**
   * How many pixels the figures rest on.
   */
  vtkGetMacro(NumberOfReceiverPixels, vtkIdType);
  vtkGetMacro(NumberOfPenumbraPixels, vtkIdType);
  ///@}

  /**
   * All figures as a JSON object:
   *
   *     { "receiver_pixels": 9, "rmse": 0.1, "bias": 0.0, "p99": 0.2, "maximum": 0.2,
   *       "weighted_rmse": 0.09,
   *       "penumbra": { "range": [0.02, 0.98], "pixels": 4,
   *                     "rmse": 0.15, "bias": 0.0, "p99": 0.2, "maximum": 0.2,
   *                     "weighted_rmse": 0.14 } }
   *
   * Figures that are not known (NaN) are null.
   */
  std::string GetJSON();

  /**
   * Signed difference of the last Update, unsigned char RGB, as large as the images: white where
   * equal, ever bluer where the image is darker than the reference, ever redder where it is
   * brighter, mid grey (128) where there is no receiver. Of a coloured visibility the component
   * that differs most is shown. nullptr before Update and after one that failed. Owned by this
   * object; each Update makes a new one.
   */
  vtkImageData* GetDifferenceImage();

protected:
  vtkVisibilityMetrics();
  ~vtkVisibilityMetrics() override;

  vtkSmartPointer<vtkImageData> Reference;
  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkImageData> DifferenceImage;
  double PenumbraRange[2] = { 0.02, 0.98 };
  double DifferenceScale = 0.25;

  double RMSE;
  double Bias;
  double P99;
  double Maximum;
  double WeightedRMSE;
  double PenumbraRMSE;
  double PenumbraBias;
  double PenumbraP99;
  double PenumbraMaximum;
  double PenumbraWeightedRMSE;
  vtkIdType NumberOfReceiverPixels;
  vtkIdType NumberOfPenumbraPixels;

private:
  void Reset();
  std::string Compare();

  vtkVisibilityMetrics(const vtkVisibilityMetrics&) = delete;
  void operator=(const vtkVisibilityMetrics&) = delete;
};

#endif
