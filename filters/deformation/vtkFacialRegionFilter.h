/**
 * @class vtkFacialRegionFilter
 * @brief tells which of the 16 facial regions each point belongs to
 *
 * Input: points or a mesh with pupils (vtkPupilAlgorithm). Output: a copy with the point arrays `Region` (int, 1 .. 16:
 * the nearest centre, or the point array `region` of the input where it is not 0), `RegionWeights` (float, 16
 * components, non-negative, sum 1: smooth), `RegionCoverage` (float, 1 on the face, 0 beyond its outline, behind
 * it, where the ears are, and on eyeballs) and `LipSide`, `LidSide` (float, 1 upper lip or lid, -1 lower, 0 far from
 * both and at the corners); field array `RegionName` (16 strings). Upper and lower lips and lids are told apart by the
 * side of the slit: the input's own `LipSide` and `LidSide` where it has them, by u on a PDE face, by distance along
 * the surface on a mesh with landmarks, by their number on points named landmarkNN; with none of these by place alone.
 * No weight crosses a slit [Obaid et al. 2009, figure 2; FacialRegions.h]. Errors: those of vtkPupilAlgorithm; points
 * or sides that are not finite.
 * @sa vtkPupilAlgorithm vtkFDTDeformationFilter
 */
#ifndef vtkFacialRegionFilter_h
#define vtkFacialRegionFilter_h

#include "MienDeformationModule.h"
#include "vtkPupilAlgorithm.h"

class MIENDEFORMATION_EXPORT vtkFacialRegionFilter : public vtkPupilAlgorithm {
 public:
  static vtkFacialRegionFilter* New();
  vtkTypeMacro(vtkFacialRegionFilter, vtkPupilAlgorithm);

 protected:
  vtkFacialRegionFilter() = default;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  vtkFacialRegionFilter(const vtkFacialRegionFilter&) = delete;
  void operator=(const vtkFacialRegionFilter&) = delete;
};

#endif
