#pragma once

#include <optional>
#include <string>

#include "MeasuredFace.h"
#include "ReportOptions.h"

namespace mien {

/// What `mien continuity`, `spectrum` and `sweep` find, for the commands and for the figures of the catalogue. The face
/// must be up to date. They throw a ValueFailure.

struct ContinuityChoice {
  std::string measure = "g1";  ///< in the chart: g0, g1, c1, g2, c2
  int samples = 400;           ///< per seam
};
Report continuityReport(const MeasuredFace& face, const ContinuityChoice& choice,
                        const ReportOptions& files = ReportOptions());

/// @param tolerance  mm, for the smallest N that comes that near
Report spectrumReport(const MeasuredFace& face, const std::optional<double>& tolerance);

struct SweepChoice {
  std::string range = "0.1:10:21log";  ///< values of a
  std::string referenceSmoothing = "1";
  std::string scan;  ///< mesh that distances are measured to; empty: none
};
Report sweepReport(const MeasuredFace& face, const SweepChoice& choice);

}  // namespace mien
