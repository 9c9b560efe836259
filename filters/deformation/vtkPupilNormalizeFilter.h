/**
 * @class vtkPupilNormalizeFilter
 * @brief brings a face into pupil units, or back
 *
 * Input: points or a mesh with pupils (vtkPupilAlgorithm). Output: a copy whose points are in pupil units: the midpoint
 * of the pupils in the origin, rotated about z and scaled evenly so that the subject's left pupil is at (1, 0) and the
 * right at (-1, 0) [Obaid et al. 2009, section 3]; field array `Pupils` (2 x 3) there, and `OriginalPupils` (2 x 3),
 * where they were. Normals and the field array
 * `HeadRotation` turn along; other arrays stay. Inverse: takes such data back; the pupils it goes back to are
 * those set by hand, else `OriginalPupils`. Points are double. A face that stands on its head is only turned round:
 * images with y downwards must be mirrored before. Errors: those of vtkPupilAlgorithm, a point that is not finite, no
 * original pupils to go back to.
 * @sa vtkPupilAlgorithm
 */
#ifndef vtkPupilNormalizeFilter_h
#define vtkPupilNormalizeFilter_h

#include "MienDeformationModule.h"
#include "vtkPupilAlgorithm.h"

class MIENDEFORMATION_EXPORT vtkPupilNormalizeFilter : public vtkPupilAlgorithm {
 public:
  static vtkPupilNormalizeFilter* New();
  vtkTypeMacro(vtkPupilNormalizeFilter, vtkPupilAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Back from pupil units to the face's own place and unit. Default off. */
  vtkSetMacro(Inverse, bool);
  vtkGetMacro(Inverse, bool);
  vtkBooleanMacro(Inverse, bool);
  ///@}

 protected:
  vtkPupilNormalizeFilter() = default;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  vtkPupilNormalizeFilter(const vtkPupilNormalizeFilter&) = delete;
  void operator=(const vtkPupilNormalizeFilter&) = delete;

  bool Inverse = false;
};

#endif
