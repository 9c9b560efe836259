#include "DownwardOrder.h"

#include <vector>

namespace mien {

namespace {

/// Neighbouring curves that share one height.
struct Pool {
  double height;
  int curves;
};

/// Appends a height; while it lies above the pool before it, both become one with their mean height.
void append(std::vector<Pool>& pools, Pool next) {
  while (!pools.empty() && pools.back().height < next.height) {
    const Pool above = pools.back();
    pools.pop_back();
    const int curves = above.curves + next.curves;
    next = {(above.height * above.curves + next.height * next.curves) / curves, curves};
  }
  pools.push_back(next);
}

}  // namespace

void restoreDownwardOrder(ClosedCurves& curves) {
  std::vector<Pool> pools;
  for (int j = 0; j < curves.pointsPerCurve; ++j) {
    pools.clear();
    for (int c = 0; c < curves.count; ++c) append(pools, {curves.curve(c)(j, 1), 1});
    int c = 0;
    for (const Pool& pool : pools)
      for (int i = 0; i < pool.curves; ++i) curves.curve(c++)(j, 1) = pool.height;
  }
}

}  // namespace mien
