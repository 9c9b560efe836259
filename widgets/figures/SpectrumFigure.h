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

/// What a panel of the figure shows of the modes.
enum class SpectrumPart {
  Length,  ///< RMS of each mode, mm
  Energy,  ///< share of each mode
  Missing  ///< what the sum up to each mode lacks, mm
};

/// What each mode adds to a surface: length, share of the energy, and what partial sums lack.
///
/// @param tolerance  mm, drawn as a line across what sums lack
/// @param parts      a panel for each, in this order
Figure spectrumFigure(const std::vector<SchemeSpectrum>& spectra, const std::optional<double>& tolerance,
                      const std::vector<SpectrumPart>& parts = {SpectrumPart::Length, SpectrumPart::Energy,
                                                                SpectrumPart::Missing});

}  // namespace mien
