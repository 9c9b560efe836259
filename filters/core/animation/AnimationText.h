#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "FAPLineParser.h"
#include "FAPSequence.h"
#include "FacialActionMap.h"

namespace mien {

/// The texts that hold an animation.
enum class AnimationFormat {
  FAP,          ///< .fap, FAPParser.h
  FAPCsv,       ///< FAP values as a table, FAPCsvParser.h
  ActionUnits,  ///< FACS action units as a table, CaptureParser.h
  Blendshapes,  ///< ARKit blendshapes as a table, CaptureParser.h
};

/// For people: "FAPs (.fap)", "FAPs (table)", "FACS action units", "ARKit blendshapes".
std::string_view nameOf(AnimationFormat format);

/// Which of them a text is, by its first line and its header: a table when a column is known, of the kind that most
/// columns are; else .fap. Nothing for a table without any column that is known.
std::optional<AnimationFormat> recogniseAnimation(std::string_view text, const FacialActionMap& map);

/// Reads an animation in a format, or the one recognised. @return the error, and then `sequence` is as it was
std::optional<FAPParseError> parseAnimation(std::string_view text, std::optional<AnimationFormat> format,
                                            const FacialActionMap& map, FAPSequence& sequence);

}  // namespace mien
