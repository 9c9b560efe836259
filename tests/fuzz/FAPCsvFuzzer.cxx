#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "FAPCsvParser.h"
#include "FAPCsvWriter.h"
#include "FAPParser.h"
#include "FAPWriter.h"

using namespace mien;

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  FAPSequence sequence;
  sequence.name = "before";
  if (const auto error = parseFAPCsv(text, sequence)) {
    require(error->line >= 1 && !error->message.empty());
    require(sequence.name == "before" && sequence.frames.empty());
    return 0;
  }
  require(!sequence.frames.empty() && sequence.masks.size() == sequence.frames.size());
  require(std::isfinite(sequence.duration()));
  std::string table, file;
  require(writeFAPCsv(sequence, table).empty() && writeFAP(sequence, file).empty());
  FAPSequence again, fromFile;
  require(!parseFAPCsv(table, again) && again.masks == sequence.masks);
  require(!parseFAP(file, fromFile) && fromFile.frames.size() == sequence.frames.size());
  return 0;
}
