#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "AnimationText.h"
#include "CaptureParser.h"

using namespace mien;

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

const FacialActionMap& bundledMap() {
  static const FacialActionMap map = [] {
    std::ifstream file(MIEN_FACS_MAP);
    FacialActionMap parsed;
    require(parsed.parse({std::istreambuf_iterator<char>(file), {}}).empty());
    return parsed;
  }();
  return map;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  recogniseAnimation(text, bundledMap());
  for (const CaptureKind kind : {CaptureKind::ActionUnits, CaptureKind::Blendshapes}) {
    FAPSequence sequence;
    sequence.name = "before";
    if (const auto error = parseCapture(text, kind, bundledMap(), sequence)) {
      require(error->line >= 1 && !error->message.empty());
      require(sequence.name == "before" && sequence.frames.empty());
      continue;
    }
    require(!sequence.frames.empty() && sequence.masks.size() == sequence.frames.size());
    require(std::isfinite(sequence.duration()));
    for (const FAPFrame& frame : sequence.frames)
      for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap) require(std::isfinite(frame.value(fap)));
  }
  return 0;
}
