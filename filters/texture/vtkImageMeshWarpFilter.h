/**
 * @class vtkImageMeshWarpFilter
 * @brief warps an image so that the points of one mesh come to lie on those of another [S 4.2]
 *
 * Two-pass mesh warping (Wolberg, Digital Image Warping, 1990): rows, then columns, each resampled with the mean over
 * what a pixel covers; a mesh onto itself gives the image back. See MeshWarp and PixelLine.
 *
 * Input 0: vtkImageData of one slice, scalars of any type and number of components, each of which is warped alone.
 * Inputs 1 and 2: the source and the target mesh, vtkStructuredGrid as described in WarpMeshData.h, of the same size;
 * both are scaled to the images they lie on. Output: vtkImageData of the input's type, spacing 1 and origin 0. Any part
 * of it can be asked for. Progress and abort are honoured. Errors: no scalars, several slices, folded meshes, meshes of
 * two sizes; the output is then empty.
 * @sa vtkWarpMeshReader vtkFaceWarpMeshFilter
 */
#ifndef vtkImageMeshWarpFilter_h
#define vtkImageMeshWarpFilter_h

#include "MienTextureModule.h"
#include "vtkImageAlgorithm.h"

class vtkStructuredGrid;

class MIENTEXTURE_EXPORT vtkImageMeshWarpFilter : public vtkImageAlgorithm {
 public:
  static constexpr int LargestSide = 32768;  ///< of the output, pixels

  static vtkImageMeshWarpFilter* New();
  vtkTypeMacro(vtkImageMeshWarpFilter, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The mesh on the input image, and the mesh on the output that it is taken to. */
  void SetSourceMeshConnection(vtkAlgorithmOutput* mesh) { this->SetInputConnection(1, mesh); }
  void SetSourceMeshData(vtkStructuredGrid* mesh);
  void SetTargetMeshConnection(vtkAlgorithmOutput* mesh) { this->SetInputConnection(2, mesh); }
  void SetTargetMeshData(vtkStructuredGrid* mesh);
  ///@}

  ///@{
  /** Width and height of the output in pixels, 1 .. 32768; 0: that of the input. Default: 0, 0. */
  vtkSetVector2Macro(OutputSize, int);
  vtkGetVector2Macro(OutputSize, int);
  ///@}

  ///@{
  /**
   * What lies to the left and right of the target mesh. Off: the colours at the mesh's border are repeated. On: they go
   * over into each other around the closing column, as on a surface whose left and right border meet. Above and below
   * it colours are always repeated. Default: off.
   */
  vtkSetMacro(Closed, bool);
  vtkGetMacro(Closed, bool);
  vtkBooleanMacro(Closed, bool);
  ///@}

 protected:
  vtkImageMeshWarpFilter();
  ~vtkImageMeshWarpFilter() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  vtkImageMeshWarpFilter(const vtkImageMeshWarpFilter&) = delete;
  void operator=(const vtkImageMeshWarpFilter&) = delete;

  int OutputSize[2] = {0, 0};
  bool Closed = false;
};

#endif
