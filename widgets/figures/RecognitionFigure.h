#pragma once

#include "Figure.h"
#include "TableRecognition.h"

namespace mien {

/// How much of a face's movement each expression leaves unexplained: the shortest bar is the nearest expression.
///
/// @param names  of the means that were compared, by RecognitionScore::expression
Figure recognitionFigure(const std::vector<std::string>& names, const std::vector<RecognitionScore>& scores);

}  // namespace mien
