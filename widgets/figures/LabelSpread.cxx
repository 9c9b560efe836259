#include "LabelSpread.h"

#include <cstddef>

namespace mien {

namespace {

/// Labels that touch: they move as one.
struct Block {
  double start;  ///< mean of the wanted places, less what lies before each in the block
  int count;
};

}  // namespace

// With the gaps taken out of the places this is isotonic regression, solved by pooling neighbours that are out of
// order.
std::vector<double> spreadLabels(const std::vector<double>& wanted, double gap) {
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    blocks.push_back({wanted[i] - gap * i, 1});
    while (blocks.size() > 1 && blocks[blocks.size() - 2].start > blocks.back().start) {
      const Block last = blocks.back();
      blocks.pop_back();
      Block& pooled = blocks.back();
      pooled.start = (pooled.count * pooled.start + last.count * last.start) / (pooled.count + last.count);
      pooled.count += last.count;
    }
  }
  std::vector<double> places;
  for (const Block& block : blocks)
    for (int i = 0; i < block.count; ++i) places.push_back(block.start + gap * places.size());
  return places;
}

}  // namespace mien
