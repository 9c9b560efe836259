#pragma once

#include <vector>

#include "ByteReader.h"
#include "ByteWriter.h"
#include "FaceCurves.h"

namespace mien {

/// Feature points in few bytes: the MPEG-4 name as one byte, curve and v as differences from the point before. v is a
/// multiple of 2 pi / 65536 (0.01 mm on a face); pi and mirrored pairs, v and 2 pi - v, stay exact.
void writeFeatures(const std::vector<FeaturePoint>& features, ByteWriter& bytes);

/// @param count  of the points, checked by the caller
/// @return whether all names, curves and v are those of a face
bool readFeatures(ByteReader& bytes, std::size_t count, std::vector<FeaturePoint>& features);

}  // namespace mien
