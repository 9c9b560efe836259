/// A program of its own: it counts every allocation between two moments, of the libraries too.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>

#include "DataFile.h"
#include "FAPTable.h"
#include "FaceAnimator.h"
#include "FaceSurface.h"
#include "PDESurface.h"
#include "SyntheticFace.h"

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define MIEN_COUNTS_ALLOCATIONS
#endif

namespace {

std::atomic<long> allocations{0};

}  // namespace

#ifdef MIEN_COUNTS_ALLOCATIONS
// operator new, and what Eigen calls, all end here; only glibc has a second name for the originals. Sanitizers replace
// them themselves.
extern "C" {
void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void* __libc_memalign(size_t, size_t);

void* malloc(size_t size) {
  ++allocations;
  return __libc_malloc(size);
}
void* calloc(size_t count, size_t size) {
  ++allocations;
  return __libc_calloc(count, size);
}
void* realloc(void* old, size_t size) {
  ++allocations;
  return __libc_realloc(old, size);
}
void* aligned_alloc(size_t alignment, size_t size) {
  ++allocations;
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** out, size_t alignment, size_t size) {
  ++allocations;
  *out = __libc_memalign(alignment, size);
  return *out ? 0 : 12;  // ENOMEM
}
}
#endif

namespace {

using namespace mien;

/// Every FAP of the table moves, lips and lids press against each other.
FAPFrame strongFrame(const AnimationTable& table, int index) {
  FAPFrame frame;
  for (const AnimationEntry& entry : table.entries())
    frame.setValue(entry.fap, 600.0 * std::sin(0.37 * index + entry.fap));
  return frame;
}

/// Points and normals in single precision, written again for every frame.
struct FrameBuffers {
  explicit FrameBuffers(const PDESurface<float>& surface)
      : points(surface.rowCount(), 3 * surface.columnCount()), normals(points) {}
  static PDESurface<float>::Grid grid(RowMajor<float>& all) { return {all.data(), all.rows(), all.cols()}; }

  RowMajor<float> points, normals;
};

class FrameAllocation : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
#ifndef MIEN_COUNTS_ALLOCATIONS
    GTEST_SKIP() << "allocations are counted with glibc and without sanitizers only";
#endif
    ASSERT_EQ(table.parse(readDataFile("animation/animation_table.json")), "");
    ASSERT_EQ(animator.bind(SyntheticFace::make(), table), "");
  }

  AnimationTable table;
  FaceAnimator animator;
};

TEST(AllocationCount, SeesWhatEigenAndTheLibrariesAllocate) {
#ifndef MIEN_COUNTS_ALLOCATIONS
  GTEST_SKIP() << "allocations are counted with glibc and without sanitizers only";
#endif
  const long before = allocations;
  const Eigen::VectorXd vector = Eigen::VectorXd::Zero(1000);
  EXPECT_EQ(allocations - before, 1);
  const HarmonicSplit split(40, 5, true);
  const long between = allocations;
  EXPECT_GT(split.analysis().size() + vector.size(), 0);
  EXPECT_GT(allocations, between) << "made in the core's library";
}

TEST_P(FrameAllocation, NoneAfterTheFirstFrame) {
  FaceSurfaceOptions options;
  options.scheme = GetParam();
  const Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(41, 0.0, 2.0 * M_PI);
  PDESurface<float> surface(facePieces(options, RowLayout(56, false)), HarmonicSplit(40, 5, true),
                            FaceLayout::curveCount, v);
  FrameBuffers buffers(surface);
  int samples = 0;
  const auto show = [&](int index) {
    surface.setCurves(animator.animate(strongFrame(table, index)));
    surface.evaluateWithNormals(0, FrameBuffers::grid(buffers.points), FrameBuffers::grid(buffers.normals));
    samples += animator.contactSamples();
  };
  show(0);
  const long before = allocations;
  for (int index = 1; index <= 100; ++index) show(index);
  EXPECT_EQ(allocations - before, 0) << "in 100 frames";
  EXPECT_GT(samples, 100) << "lips and lids that touch belong to what is tested";
}

INSTANTIATE_TEST_SUITE_P(Schemes, FrameAllocation, testing::Values("four-curve", "curvature", "spline"));

}  // namespace
