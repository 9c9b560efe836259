/**
 * @class vtkFaceWarpMeshFilter
 * @brief where a face's features lie in its texture: the target mesh of a warp [S 4.2, Figure 3 c, d]
 *
 * Input: boundary curves as described in BoundaryCurveData.h, with feature points. Output: vtkStructuredGrid as
 * described in WarpMeshData.h, points at (v / 2 pi, u) of the width and height of the texture, which
 * `TextureCoordinates` of the surface then address. The places are those of FaceWarpLayout. Errors: curves that are no
 * face, or lack a feature point.
 * @sa vtkImageMeshWarpFilter vtkPDEFaceFilter
 */
#ifndef vtkFaceWarpMeshFilter_h
#define vtkFaceWarpMeshFilter_h

#include "MienTextureModule.h"
#include "vtkStructuredGridAlgorithm.h"

class MIENTEXTURE_EXPORT vtkFaceWarpMeshFilter : public vtkStructuredGridAlgorithm {
 public:
  static vtkFaceWarpMeshFilter* New();
  vtkTypeMacro(vtkFaceWarpMeshFilter, vtkStructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Whether the mesh has 19 x 21 points instead of the 7 x 7 of the paper. Default: off. */
  vtkSetMacro(Fine, bool);
  vtkGetMacro(Fine, bool);
  vtkBooleanMacro(Fine, bool);
  ///@}

  ///@{
  /** Width and height of the texture in pixels, 1 .. 32768. Default: 2048, 1024. */
  vtkSetVector2Macro(TextureSize, int);
  vtkGetVector2Macro(TextureSize, int);
  ///@}

 protected:
  vtkFaceWarpMeshFilter() = default;
  ~vtkFaceWarpMeshFilter() override = default;
  int FillInputPortInformation(int, vtkInformation*) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  vtkFaceWarpMeshFilter(const vtkFaceWarpMeshFilter&) = delete;
  void operator=(const vtkFaceWarpMeshFilter&) = delete;

  bool Fine = false;
  int TextureSize[2] = {2048, 1024};
};

#endif
