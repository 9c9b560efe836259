#pragma once

#include <memory>
#include <string>
#include <vector>

#include "FaceCurves.h"
#include "StudyCases.h"

namespace mien {

/// The names of all measures of a case, which end in their units:
/// - those of a sweep (SmoothingSweep.h) but for the distance to a scan, by the same names;
/// - those of seams (SeamColumns.h) over all seams, `seam_..`, and where z > 50 mm, `frontal_seam_..`;
/// - of the Fourier modes: `remainder_rms_mm`, what modes 0 .. N leave of the surface; `mode1_energy_share`;
/// - `motion_rms_mm`, `motion_max_mm` from the same face at rest, the mean weighted with its area.
const std::vector<std::string>& caseMeasureNames();

/// Whether a name is one of them.
bool isCaseMeasure(const std::string& name);

/// What was measured on one case.
struct CaseValues {
  std::vector<double> values;  ///< in the order of the study's measures; NaN where there is none
  std::string reason;          ///< one sentence that says why there is no surface, or nothing
};

/// Measures cases that differ in a alone.
class CaseMeasures {
 public:
  /// @param first  any of the cases
  /// @param moved,neutral  its curves, and those at rest; everything must outlive this
  CaseMeasures(const Study& study, const StudyCase& first, const FaceCurves& moved, const FaceCurves& neutral);
  ~CaseMeasures();

  CaseValues measure(double smoothing) const;

 private:
  struct Internals;
  std::unique_ptr<Internals> Impl;
};

}  // namespace mien
