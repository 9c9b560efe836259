#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "EvenColumns.h"
#include "FaceSurface.h"
#include "PDESurface.h"
#include "RandomCurves.h"

using namespace mien;

namespace {

/// Points and normals of a surface.
struct Shown {
  RowMajor<float> s, normals;

  explicit Shown(int rows, int columns) : s(RowMajor<float>::Zero(rows, 3 * columns)), normals(s) {}

  void show(const PDESurface<float>& surface, long since = noVersion) {
    surface.evaluateWithNormals(0, {s.data(), s.rows(), s.cols()}, {normals.data(), s.rows(), s.cols()}, nullptr,
                                nullptr, since);
  }
};

PDESurface<float> faceOf(const std::string& scheme, int columns) {
  FaceSurfaceOptions options;
  options.scheme = scheme;
  return PDESurface<float>(facePieces(options, RowLayout(56, false)), HarmonicSplit(40, 5, true),
                           FaceLayout::curveCount, evenColumns(columns));
}

/// Some curves of one face among those of another.
ClosedCurves mixed(const FaceCurves& face, const FaceCurves& other, int first, int count) {
  ClosedCurves curves = face.curves;
  for (int c = first; c < first + count; ++c) curves.curve(c) = other.curves.curve(c);
  return curves;
}

}  // namespace

/// Grids of one strip of columns, of which B is kept, and of more, of which it is not.
class UnchangedPieces : public testing::TestWithParam<std::tuple<const char*, int>> {};

TEST_P(UnchangedPieces, ASurfaceOfManyChangesIsThatOfTheLastCurves) {
  const auto [scheme, columns] = GetParam();
  PDESurface<float> surface = faceOf(scheme, columns);
  Shown kept(56, columns), seldom(56, columns);
  FaceCurves now = randomFace(40, 1);
  long seldomHolds = noVersion;
  for (int step = 0; step < 24; ++step) {
    const long holds = step > 0 ? surface.version() : noVersion;
    if (step % 5 != 4) now.curves = mixed(now, randomFace(40, 2 + step), (7 * step) % 29, 1);
    surface.setCurves(now.curves);
    kept.show(surface, holds);
    if (step % 3 == 0) {
      seldom.show(surface, seldomHolds);
      seldomHolds = surface.version();
    }
    PDESurface<float> other = faceOf(scheme, columns);
    other.setCurves(now.curves);
    Shown whole(56, columns);
    whole.show(other);
    ASSERT_EQ(kept.s, whole.s) << step;
    ASSERT_EQ(kept.normals, whole.normals) << step;
    if (step % 3 == 0) {
      ASSERT_EQ(seldom.s, whole.s) << step << ": three versions at once";
    }
  }
}

TEST_P(UnchangedPieces, PiecesWithoutAChangeAreLeftAlone) {
  const auto [scheme, columns] = GetParam();
  PDESurface<float> surface = faceOf(scheme, columns);
  const FaceCurves face = randomFace(40, 1);
  surface.setCurves(face.curves);
  const long before = surface.version();
  Shown untouched(56, columns);
  untouched.s.setConstant(std::numeric_limits<float>::quiet_NaN());
  surface.setCurves(face.curves);
  untouched.show(surface, before);
  EXPECT_TRUE(untouched.s.array().isNaN().all()) << "the same curves";
  surface.setCurves(mixed(face, randomFace(40, 2), 27, 2));
  untouched.show(surface, before);
  const int lastPatch = 55 - 6, changed = static_cast<int>(untouched.s.row(55).array().isNaN().count());
  EXPECT_EQ(changed, 0) << "the last curve's row";
  if (std::string(scheme) != "spline") {
    EXPECT_TRUE(untouched.s.topRows(lastPatch - 1).array().isNaN().all());
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, UnchangedPieces,
                         testing::Combine(testing::Values("four-curve", "curvature", "spline"),
                                          testing::Values(41, 64, 65, 150)));
