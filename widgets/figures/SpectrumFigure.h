#pragma once

#include <optional>

#include "Figure.h"
#include "ModeSpectrum.h"

namespace mien {

/// One scheme's measures of its modes.
struct SchemeSpectrum {
  std::string scheme;
  std::vector<ModeMeasures> modes;
};

/// What each mode adds to a surface: length, share of the energy, and what partial sums lack.
///
/// @param tolerance  mm, drawn as a line across the error
Figure spectrumFigure(const std::vector<SchemeSpectrum>& spectra, const std::optional<double>& tolerance);

}  // namespace mien
