#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "ByteWriter.h"
#include "Checksum.h"
#include "CompactFace.h"
#include "EntropyCode.h"

using namespace mien;

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

/// A refusal is one sentence and leaves the face alone; what is accepted is a sound face that can be stored again.
void feed(std::string_view bytes) {
  CompactFace compact;
  compact.name = "before";
  const std::string fault = decodeCompactFace(bytes, compact);
  if (!fault.empty()) {
    require(compact.name == "before" && fault.size() < 300 && fault.find('\n') == std::string::npos);
    return;
  }
  require(describeFault(compact.face).empty());
  require(std::isfinite(compact.rmsError) && std::isfinite(compact.maximumError));
  std::string again;
  if (compact.face.curves.pointsPerCurve > 256) return;  // storing takes a while
  if (!encodeCompactFace(compact.face, compact.name, 1.0, again).empty()) return;
  CompactFace stored;
  require(decodeCompactFace(again, stored).empty());
  require(stored.rmsError <= 1.0001 && stored.face.features.size() == compact.face.features.size());
}

/// Behind a right checksum, which no fuzzer finds.
std::string closed(std::string_view checked) {
  ByteWriter start;
  start.byte(CompactFaceLimits::version);
  start.fixed32(checksumOf(checked));
  return "MIENZ" + start.bytes() + std::string(checked);
}

/// A sound header before content that is packed, so that the fuzzer reaches feature points, pupils and levels.
std::string packed(std::string_view content) {
  ByteWriter header;
  const int features = content.empty() ? 0 : content[0] & 7;
  header.byte(0);
  header.byte(content.size() % 2);
  for (int i = 0; i < 3; ++i) header.single(0.1f);
  header.whole(16);
  header.text("");
  header.whole(features);
  return closed(header.bytes() + packBytes(content.substr(content.empty() ? 0 : 1)));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  feed(bytes);
  feed(closed(bytes));
  feed(packed(bytes));
  return 0;
}
