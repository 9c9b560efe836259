#pragma once

#include <cstddef>
#include <string>

#include "Study.h"

namespace mien {

/// Text form of a study: a JSON object with `mien_study` (the version, 1) and, each with a default,
/// - `faces`: list of files of boundary curves, or "generic";
/// - `schemes`: list of names, or "all";
/// - `a`: number, list of numbers, or text as "0.1:10:21log";
/// - `harmonics`: list of whole numbers; `remainder`: true or false;
/// - `expressions`: list of texts, "neutral" or as "joy:0.6,surprise:0.4";
/// - `fap`: `file`, and `frames`: list of numbers as written in it, text as "10:50:5", or "all";
/// - `resolution`: rows and columns of the grid that is measured; `reference_a`: where departures are measured from;
/// - `measures`: list of names, or "all".
/// With neither `expressions` nor `fap` the faces are at rest. doc/studies.md explains it.
constexpr int studyVersion = 1;
constexpr std::size_t largestStudyText = 16 * 1024 * 1024;  ///< bytes

/// @param[out] line  of a fault in the JSON itself, 0 for none or any other
/// @return nothing, or one sentence that names the member at fault; the study is then as it was
std::string readStudy(const std::string& text, Study& study, int& line);

/// Everything written out, also what has its default: equal studies have equal texts.
std::string writeStudy(const Study& study);

}  // namespace mien
