#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "ExpressionLibrary.h"

using namespace mien;

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ExpressionLibrary library;
  const std::string fault = library.parse(std::string(reinterpret_cast<const char*>(data), size));
  require(fault.empty() || library.expressions().empty());
  for (const ExpressionProfile& expression : library.expressions()) {
    FAPFrame frame;
    require(library.add(expression.name, 1.0, frame));
    for (const auto& [fap, value] : expression.values)
      require(fap >= FAPFrame::firstLowLevel && fap <= FAPFrame::count && std::isfinite(value));
  }
  return 0;
}
