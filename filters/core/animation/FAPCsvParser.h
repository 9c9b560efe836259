#pragma once

#include <optional>
#include <string_view>

#include "FAPLineParser.h"
#include "FAPSequence.h"

namespace mien {

/// Reads FAP values as a table with a header (CommaReader.h), version 1:
///
///     # mien fap csv 1; fps=25; version=2.1; start=10:59:58:13.217; name=speech     all optional
///     frame,time,FAP1_viseme_select1,...,FAP51,FAP52
///     0,0,,...,-120,30
///
/// `frame` (a number, as in .fap; counted from 0 when missing) and `time` (s) are optional. The other columns are FAPs
/// as FAPColumn.h names them, in FAP units; an empty cell is a FAP that the frame does not set (0). The rate is `fps`,
/// else that of two or more times, else 25, with a warning; times that contradict `fps` are warned of as well. `start`
/// is the time code of the first frame (HH:MM:SS:FF at 60 per second), when it is known. Columns of other names are
/// left out, with a warning. Refused: a column given twice, no column of a FAP unless there is `frame` (neutral
/// frames), a cell that is no number, a FAP value beyond 1e6.
/// @return the error, and then `sequence` is as it was; or nothing
std::optional<FAPParseError> parseFAPCsv(std::string_view text, FAPSequence& sequence);

}  // namespace mien
