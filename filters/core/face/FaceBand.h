#pragma once

#include <vector>

#include "FaceCurves.h"
#include "HeadAxis.h"

namespace mien {

/// The part of a head that a face covers: all around it, between the heights of its first and its last curve.
class FaceBand {
 public:
  explicit FaceBand(const ClosedCurves& curves);

  /// Whether a point lies between the curves, further than `margin` (mm) from both; a negative margin widens the band.
  bool contains(const Eigen::Vector3d& point, double margin) const;

  const HeadAxis& axis() const { return axis_; }

 private:
  struct Edge {
    std::vector<double> azimuths, heights;  ///< ascending azimuths, one turn and a little more
    double heightAt(double azimuth) const;
  };
  Edge edgeOf(const ClosedCurves& curves, int curve) const;

  HeadAxis axis_;
  Edge top_, bottom_;
};

}  // namespace mien
