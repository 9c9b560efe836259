#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "LandmarkTable.h"

using namespace mien;

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

void requireLine(const std::string& fault, const std::string& text) {
  const long line = std::strtol(fault.c_str(), nullptr, 10);
  require(line >= 1 && line <= std::count(text.begin(), text.end(), '\n') + 1);
  require(fault.size() > 10 && fault.size() < 400);
}

void requireSound(const LandmarkTable& table) {
  require(table.positions.points.allFinite());
  for (int i = 0; i < FaceLandmarks::count; ++i) {
    require(table.given[i] || landmarkName(i).empty());
    require(table.vertices[i] >= 0 && table.vertices[i] <= 1000000000);
  }
  LandmarkTable again;
  require(parseLandmarks(landmarkText(table.positions), again).empty());
  require(again.positions.points == table.positions.points);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  LandmarkTable table;
  table.vertices[3] = 77;
  const std::string fault = parseLandmarks(text, table);
  if (fault.empty()) {
    requireSound(table);
  } else {
    requireLine(fault, text);
    require(table.vertices[3] == 77);
  }
  FaceLandmarks picture;
  const std::string pictureFault = parsePictureLandmarks(text, picture);
  pictureFault.empty() ? require(picture.points.allFinite()) : requireLine(pictureFault, text);
  return 0;
}
