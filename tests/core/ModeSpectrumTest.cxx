#include <gtest/gtest.h>

#include "EvenColumns.h"
#include "ModeSpectrum.h"
#include "PDESurface.h"
#include "RandomCurves.h"

using namespace mien;

namespace {

constexpr int rows = 56;

FaceSurfaceOptions withModes(int modes, bool remainder = true, const std::string& scheme = "spline") {
  FaceSurfaceOptions options;
  options.scheme = scheme;
  options.modes = modes;
  options.remainder = remainder;
  return options;
}

ModeSpectrum spectrumOf(const FaceSurfaceOptions& options, const FaceCurves& face, int columnCount = 40) {
  ModeSpectrum spectrum(options, RowLayout(rows, false), face.curves.pointsPerCurve, evenColumns(columnCount));
  EXPECT_EQ(spectrum.fault(), "");
  spectrum.setCurves(face.curves);
  return spectrum;
}

RowMajor<double> surfaceOf(const FaceSurfaceOptions& options, const FaceCurves& face, int columnCount = 40) {
  PDESurface<double> surface(facePieces(options, RowLayout(rows, false)),
                             HarmonicSplit(face.curves.pointsPerCurve, options.modes, options.remainder),
                             FaceLayout::curveCount, evenColumns(columnCount));
  surface.setCurves(face.curves);
  RowMajor<double> grid(rows, 3 * columnCount);
  surface.evaluate(0, 0, 0, {grid.data(), grid.rows(), grid.cols()});
  return grid;
}

double sum(const std::vector<ModeMeasures>& modes, double ModeMeasures::*value) {
  double total = 0.0;
  for (const ModeMeasures& mode : modes) total += mode.*value;
  return total;
}

}  // namespace

TEST(ModeSpectrum, ContributionsSumToTheSurface) {
  const FaceCurves face = randomFace();
  for (const FaceScheme& scheme : faceSchemes())
    for (const int modes : {0, 5, 20}) {
      const ModeSpectrum spectrum = spectrumOf(withModes(modes, true, scheme.name), face);
      RowMajor<double> total = spectrum.contribution(0);
      for (int part = 1; part < spectrum.partCount(); ++part) total += spectrum.contribution(part);
      const RowMajor<double> surface = surfaceOf(withModes(modes, true, scheme.name), face);
      EXPECT_LE((total - surface).cwiseAbs().maxCoeff(), 1e-12 * surface.cwiseAbs().maxCoeff())
          << scheme.name << " N " << modes;
    }
}

TEST(ModeSpectrum, PartialSumsAreTheSurfacesOfFewerModes) {
  const FaceCurves face = randomFace();
  const ModeSpectrum spectrum = spectrumOf(withModes(12), face);
  RowMajor<double> partial = RowMajor<double>::Zero(rows, 120);
  for (int n = 0; n <= 12; ++n) {
    partial += spectrum.contribution(n);
    EXPECT_LE((partial - surfaceOf(withModes(n, false), face)).cwiseAbs().maxCoeff(), 1e-12 * sizeOf(face.curves)) << n;
  }
}

TEST(ModeSpectrum, AContributionHasItsOwnFrequencyOnly) {
  const ModeSpectrum spectrum = spectrumOf(withModes(5), randomFace(), 120);
  const Eigen::VectorXd v = evenColumns(120);
  for (int n = 0; n <= 5; ++n) {
    const RowMajor<double> grid = spectrum.contribution(n);
    for (int frequency = 0; frequency <= 20; ++frequency) {
      double strength = 0.0;
      for (int i = 0; i < 120; ++i) strength += grid(17, 3 * i) * std::cos(frequency * v[i]) / 120.0;
      if (frequency != n) {
        EXPECT_NEAR(strength, 0.0, 1e-12) << n << " " << frequency;
      }
    }
  }
}

TEST(ModeSpectrum, EnergiesSumToOneAndDoNotDependOnTheColumnsOrTheOrigin) {
  FaceCurves face = randomFace();
  const auto few = spectrumOf(withModes(5), face, 9).measures(), many = spectrumOf(withModes(5), face, 300).measures();
  face.curves.points.rowwise() += Eigen::RowVector3d(1000.0, -2000.0, 500.0);
  const auto moved = spectrumOf(withModes(5), face).measures();
  ASSERT_EQ(few.size(), 7u);
  EXPECT_EQ(few.back().mode, "remainder");
  EXPECT_NEAR(sum(few, &ModeMeasures::energyShare), 1.0, 1e-14);
  for (size_t i = 0; i < few.size(); ++i) {
    EXPECT_NEAR(few[i].energyShare, many[i].energyShare, 1e-14);
    EXPECT_NEAR(few[i].rms, moved[i].rms, 1e-9);
    EXPECT_NEAR(few[i].energyShare, moved[i].energyShare, 1e-11);
    EXPECT_GE(few[i].energyShare, 0.0);
  }
}

/// RMS length of a grid over v at 120 columns (exact up to harmonic 59) and over u by the trapezoid rule.
double rmsOf(const RowMajor<double>& grid) {
  const auto layout = RowLayout(rows, false).rows();
  double sum = 0.0;
  for (int row = 1; row < rows; ++row)
    sum += (layout[row].faceU - layout[row - 1].faceU) * 0.5 *
           (grid.row(row).squaredNorm() + grid.row(row - 1).squaredNorm()) / 120.0;
  return std::sqrt(sum);
}

TEST(ModeSpectrum, RMSAndErrorsAreThoseOfTheGrids) {
  const ModeSpectrum spectrum = spectrumOf(withModes(5), randomFace(), 120);
  const auto modes = spectrum.measures();
  RowMajor<double> rest = RowMajor<double>::Zero(rows, 360);
  for (int part = 6; part >= 0; --part) {
    EXPECT_NEAR(modes[part].cumulativeError, rmsOf(rest), 1e-11) << part;
    RowMajor<double> grid = spectrum.contribution(part);
    rest += grid;
    for (int i = 0; part == 0 && i < 120; ++i) grid.middleCols<3>(3 * i).rowwise() -= spectrum.centroid();
    EXPECT_NEAR(modes[part].rms, rmsOf(grid), 1e-11) << part;
    EXPECT_GE(modes[part].max, modes[part].rms) << part;
  }
}

// One row of the surface is a circle of radius 80 with a wave of 3 mm at n = 4 and of 0.5 mm at n = 9.
TEST(ModeSpectrum, KnownHarmonicsComeOutWithTheirAmplitude) {
  FaceCurves face = randomFace();
  for (int c = 0; c < FaceLayout::curveCount; ++c)
    for (int j = 0; j < 40; ++j) {
      const double v = 2.0 * M_PI * j / 40;
      face.curves.curve(c).row(j) << -80.0 * std::sin(v), 3.0 * std::cos(4 * v),
          -80.0 * std::cos(v) + 0.5 * std::sin(9 * v);
    }
  const auto modes = spectrumOf(withModes(10), face, 720).measures();
  EXPECT_NEAR(modes[0].rms, 0.0, 1e-12);
  // between curves the spline bends below the curves' own amplitude, the more the higher the rate
  EXPECT_NEAR(modes[1].rms, 80.0, 1e-1);
  EXPECT_LE(modes[1].max, 80.0 * 1.001);
  EXPECT_NEAR(modes[4].rms, 3.0 / std::sqrt(2.0), 0.03);
  EXPECT_NEAR(modes[4].max, 3.0, 0.01);
  EXPECT_NEAR(modes[9].max, 0.5, 0.01);
  EXPECT_NEAR(modes[2].rms, 0.0, 1e-12);
}

TEST(ModeSpectrum, RemainderVanishesWithAllModes) {
  const auto modes = spectrumOf(withModes(20), randomFace()).measures();
  ASSERT_EQ(modes.size(), 22u);
  EXPECT_EQ(modes.back().rms, 0.0);
  EXPECT_EQ(modes.back().max, 0.0);
  EXPECT_EQ(modes.back().energyShare, 0.0);
  EXPECT_EQ(modes[20].cumulativeError, 0.0);
  EXPECT_GT(modes[19].cumulativeError, 0.1);
}

TEST(ModeSpectrum, NamesTheSmallestNumberOfModesForATolerance) {
  const FaceCurves face = randomFace();
  const auto all = spectrumOf(withModes(20), face).measures();
  for (const double tolerance : {10.0, 2.0, 1.0, 0.5}) {
    const int n = smallestModeCount(all, tolerance);
    ASSERT_GE(n, 1);
    const RowMajor<double> whole = surfaceOf(withModes(20), face, 120);
    EXPECT_LE(rmsOf(surfaceOf(withModes(n, false), face, 120) - whole), tolerance);
    EXPECT_GT(rmsOf(surfaceOf(withModes(n - 1, false), face, 120) - whole), tolerance);
  }
  EXPECT_EQ(smallestModeCount(all, 0.0), 20);
  EXPECT_EQ(smallestModeCount(spectrumOf(withModes(5), face).measures(), 1e-3), -1);
}
