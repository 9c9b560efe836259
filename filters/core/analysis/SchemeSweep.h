#pragma once

#include <memory>
#include <string>

#include "FaceCurves.h"
#include "SmoothingSweep.h"

namespace mien {

/// The surface options of a sweep in one scheme at one a.
FaceSurfaceOptions sweptSurface(const SmoothingSweepOptions& sweep, const std::string& scheme, double smoothing);

/// The surfaces of one scheme over a: one column of a smoothingSweep(), record by record.
class SchemeSweep {
 public:
  /// Makes the surfaces that the others are compared with, where a measure that is wanted needs them. `face` and
  /// `sweep` must outlive this.
  SchemeSweep(const FaceCurves& face, const SmoothingSweepOptions& sweep, const std::string& scheme);
  ~SchemeSweep();

  /// The measures at one a; several threads may ask at once.
  SweepRecord measure(double smoothing) const;

 private:
  struct Origins;
  const FaceCurves& face_;
  const SmoothingSweepOptions& sweep_;
  std::string scheme_;
  std::unique_ptr<Origins> origins_;  ///< none when nothing is compared
};

}  // namespace mien
