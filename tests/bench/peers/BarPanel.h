#pragma once

#include "PeerTimes.h"
#include "Plate.h"

/// "0.0466", three digits.
std::string timeText(double milliseconds);

/// "× 12.3", or nothing.
std::string ratioText(double ratio);

/// A group as horizontal bars on a logarithmic axis of ms, each with its number; a target is a mark across its bar.
mien::PlatePanel barPanel(const PeerGroup& group, double width);
