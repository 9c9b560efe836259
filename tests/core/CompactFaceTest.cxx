#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "CompactFace.h"
#include "CompactFaceBytes.h"
#include "FaceLayout.h"
#include "RandomCurves.h"
#include "SyntheticFace.h"
#include "TextFile.h"

using namespace mien;

namespace {

using Bytes = CompactFaceBytes;

std::string encoded(const FaceCurves& face, double tolerance = 0.1, const std::string& name = "") {
  std::string bytes;
  EXPECT_EQ(encodeCompactFace(face, name, tolerance, bytes), "");
  return bytes;
}

CompactFace decoded(const std::string& bytes) {
  CompactFace compact;
  EXPECT_EQ(decodeCompactFace(bytes, compact), "");
  return compact;
}

double rmsBetween(const ClosedCurves& a, const ClosedCurves& b) {
  return std::sqrt((a.points - b.points).rowwise().squaredNorm().mean());
}

double largestBetween(const ClosedCurves& a, const ClosedCurves& b) {
  return (a.points - b.points).rowwise().norm().maxCoeff();
}

/// Refused in one sentence that leaves the face alone.
void expectRefused(const std::string& bytes, const std::string& word, const std::string& what) {
  CompactFace compact;
  compact.name = "the one before";
  const std::string fault = decodeCompactFace(bytes, compact);
  EXPECT_NE(fault.find(word), std::string::npos) << what << ": " << fault;
  EXPECT_GT(fault.size(), 20u) << what;
  EXPECT_EQ(fault.find('\n'), std::string::npos) << what;
  EXPECT_EQ(compact.name, "the one before") << what;
  EXPECT_EQ(compact.face.curves.count, 0) << what;
}

}  // namespace

TEST(CompactFace, ErrorsAreThoseItStatesAndWithinTheTolerance) {
  for (const FaceCurves& face : {SyntheticFace::make(), randomFace(), SyntheticFace::make(8), randomFace(34)})
    for (const double tolerance : {1e-6, 0.001, 0.1, 0.5, 2.0, 20.0}) {
      const CompactFace compact = decoded(encoded(face, tolerance));
      const double rms = rmsBetween(compact.face.curves, face.curves),
                   largest = largestBetween(compact.face.curves, face.curves);
      EXPECT_LE(rms, tolerance);
      EXPECT_GE(rms, 0.7 * std::min(tolerance, 2.0)) << "larger steps would have done at " << tolerance;
      EXPECT_LE(rms, compact.rmsError);
      EXPECT_NEAR(rms, compact.rmsError, 1e-6 * rms + 1e-9);
      EXPECT_LE(largest, compact.maximumError);
      EXPECT_NEAR(largest, compact.maximumError, 1e-6 * largest + 1e-9);
      EXPECT_EQ(describeFault(compact.face), "") << tolerance;
    }
}

TEST(CompactFace, ACoarserFaceTakesFewerBytes) {
  const FaceCurves face = SyntheticFace::make();
  std::size_t before = 1 << 20;
  for (const double tolerance : {0.01, 0.1, 0.5, 2.0}) {
    const std::size_t size = encoded(face, tolerance).size();
    EXPECT_LT(size, before) << tolerance;
    before = size;
  }
}

TEST(CompactFace, FeaturePointsAndPupilsComeBack) {
  FaceCurves face = SyntheticFace::make();
  face.features.push_back({"own mark", 3, 6.2831});
  face.features.push_back({"+8.1", 28, 0.0});
  const CompactFace compact = decoded(encoded(face, 0.5, "Žofie"));
  EXPECT_EQ(compact.name, "Žofie");
  ASSERT_EQ(compact.face.features.size(), face.features.size());
  for (std::size_t i = 0; i < face.features.size(); ++i) {
    EXPECT_EQ(compact.face.features[i].id, face.features[i].id);
    EXPECT_EQ(compact.face.features[i].curve, face.features[i].curve);
    EXPECT_NEAR(compact.face.features[i].v, face.features[i].v, M_PI / 65536) << face.features[i].id;
  }
  ASSERT_TRUE(compact.face.hasPupils);
  EXPECT_LE((compact.face.leftPupil - face.leftPupil).cwiseAbs().maxCoeff(), 0.00501);
  EXPECT_LE((compact.face.rightPupil - face.rightPupil).cwiseAbs().maxCoeff(), 0.00501);
  EXPECT_EQ(compact.face.feature("8.1")->v, M_PI);
  EXPECT_EQ(compact.face.feature("8.3")->v, 2.0 * M_PI - compact.face.feature("8.4")->v);
  face.hasPupils = false;
  EXPECT_FALSE(decoded(encoded(face)).face.hasPupils);
}

TEST(CompactFace, SymmetryAndClosedLipsStayToTheBit) {
  const CompactFace compact = decoded(encoded(SyntheticFace::make(), 0.5));
  const ClosedCurves& curves = compact.face.curves;
  EXPECT_EQ(ClosedCurves::Points(curves.curve(FaceLayout::upperLip)),
            ClosedCurves::Points(curves.curve(FaceLayout::lowerLip)));
  for (int c = 0; c < curves.count; ++c)
    for (int j = 0; j < 40; ++j) {
      const Eigen::RowVector3d here = curves.curve(c).row(j), there = curves.curve(c).row((40 - j) % 40);
      EXPECT_EQ(here, Eigen::RowVector3d(-there.x(), there.y(), there.z())) << c << " " << j;
    }
}

TEST(CompactFace, AnOpenMouthStaysOpen) {
  FaceCurves face = SyntheticFace::make();
  for (int j = 15; j <= 25; ++j)
    for (int c = FaceLayout::lowerLip; c < FaceLayout::curveCount; ++c)
      face.curves.curve(c)(j, 1) -= 10.0 - 2.0 * std::abs(j - 20);
  const CompactFace compact = decoded(encoded(face));
  const auto upper = compact.face.curves.curve(FaceLayout::upperLip),
             lower = compact.face.curves.curve(FaceLayout::lowerLip);
  EXPECT_NEAR(upper(20, 1) - lower(20, 1), 10.0, 1.0);
  EXPECT_LE(rmsBetween(compact.face.curves, face.curves), 0.1);
}

TEST(CompactFace, WhatIsStoredAgainStaysWithinBothTolerances) {
  const FaceCurves face = randomFace();
  const CompactFace once = decoded(encoded(face)), twice = decoded(encoded(once.face));
  EXPECT_LE(rmsBetween(twice.face.curves, face.curves), 0.2);
}

TEST(CompactFace, EveryCutIsRefused) {
  const std::string bytes = encoded(SyntheticFace::make(), 0.1, "name");
  for (std::size_t length = 0; length < bytes.size(); ++length)
    expectRefused(bytes.substr(0, length), "copy the file again", "cut to " + std::to_string(length));
  expectRefused(bytes + '\0', "checksum", "one byte more");
}

TEST(CompactFace, EveryChangeOfOneByteIsRefused) {
  const std::string bytes = encoded(SyntheticFace::make(), 0.1, "name");
  CompactFace compact;
  for (std::size_t i = 0; i < bytes.size(); ++i)
    for (int change = 1; change < 256; ++change) {
      std::string damaged = bytes;
      damaged[i] = static_cast<char>(damaged[i] ^ change);
      ASSERT_NE(decodeCompactFace(damaged, compact), "") << "byte " << i << " ^ " << change;
    }
}

TEST(CompactFace, HostileHeadersWithTheRightChecksumAreRefused) {
  const std::map<std::string, std::string> files = {
      {"unit", Bytes::with([](Bytes& f) { f.unit = 1; })},
      {"flags", Bytes::with([](Bytes& f) { f.flags = 2; })},
      {"no step", Bytes::with([](Bytes& f) { f.step = 0.0f; })},
      {"step is no number", Bytes::with([](Bytes& f) { f.step = NAN; })},
      {"endless step", Bytes::with([](Bytes& f) { f.step = INFINITY; })},
      {"negative error", Bytes::with([](Bytes& f) { f.rms = -1.0f; })},
      {"odd K", Bytes::with([](Bytes& f) { f.points = 41; })},
      {"K of 0", Bytes::with([](Bytes& f) { f.points = 0; })},
      {"huge K", Bytes::with([](Bytes& f) { f.points = std::uint64_t(1) << 40; })},
      {"huge count of features", Bytes::with([](Bytes& f) { f.features = std::uint64_t(1) << 62; })},
  };
  for (const auto& [what, bytes] : files) expectRefused(bytes, "holds is no face", what);
  expectRefused(CompactFaceBytes::with([](Bytes& f) { f.version = 2; }), "version 2", "version");
  EXPECT_EQ(decoded(CompactFaceBytes().bytes()).face.curves.pointsPerCurve, 40) << "the one all others differ from";
}

TEST(CompactFace, HostileContentWithTheRightChecksumIsRefused) {
  const std::map<std::string, std::string> files = {
      {"features that are not there", Bytes::with([](Bytes& f) { f.features = 1000; })},
      {"pupils that are not there", Bytes::with([](Bytes& f) {
         f.flags = 1;
         f.body = "\x02\x02";
       })},
      {"feature on curve 60", Bytes::with([](Bytes& f) {
         f.features = 1;
         f.body = "\x81\x78\x02";
       })},
      {"feature on curve -1", Bytes::with([](Bytes& f) {
         f.features = 1;
         f.body = "\x81\x01\x02";
       })},
      {"feature without a name", Bytes::with([](Bytes& f) {
         f.features = 1;
         f.body = std::string("\0\0\x02\x02", 4);
       })},
      {"feature of group 0", Bytes::with([](Bytes& f) {
         f.features = 1;
         f.body = "\x01\x02\x02";
       })},
      {"feature at v below 0", Bytes::with([](Bytes& f) {
         f.features = 1;
         f.body = "\x81\x02\x01";
       })},
  };
  for (const auto& [what, bytes] : files) expectRefused(bytes, "holds is no face", what);
}

TEST(CompactFace, HostilePackingWithTheRightChecksumIsRefused) {
  const std::map<std::string, std::string> files = {
      {"name longer than the file", Bytes::closed(1, std::string("\0\0"
                                                                 "0000"
                                                                 "0000"
                                                                 "0000"
                                                                 "\x28\xff\x7f",
                                                                 17))},
      {"packed bytes are none", Bytes::with([](Bytes& f) {
         f.packed = false;
         f.body = "no packed bytes";
       })},
      {"packed bytes end early", Bytes::with([](Bytes& f) {
         f.packed = false;
         f.body = packBytes("12345678").substr(0, 7);
       })},
      {"more levels than there are", Bytes::with([](Bytes& f) { f.body = std::string(29 * 40 * 3 + 1, '\x02'); })},
      {"sixteen megabytes of levels", Bytes::with([](Bytes& f) { f.body = std::string(std::size_t(1) << 24, '\0'); })},
      {"a level without an end", Bytes::with([](Bytes& f) { f.body = std::string(20, '\xff'); })},
      {"a level beyond all faces", Bytes::with([](Bytes& f) { f.body = std::string(8, '\xff') + '\x01'; })}};
  for (const auto& [what, bytes] : files) expectRefused(bytes, "holds is no face", what);
}

TEST(CompactFace, EveryFileOfTheMalformedFolderIsRefused) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(MIEN_TEST_DIR "/data/malformed/mienz")) {
    expectRefused(readTextFile(entry.path().string()), ";", entry.path().filename().string());
    ++files;
  }
  EXPECT_GE(files, 12);
}

TEST(CompactFace, WhatCannotBeStoredIsSaid) {
  std::string bytes = "before";
  const auto fault = [&](const FaceCurves& face, double tolerance, const std::string& name = "") {
    const std::string text = encodeCompactFace(face, name, tolerance, bytes);
    EXPECT_EQ(bytes, "before");
    return text;
  };
  const FaceCurves face = SyntheticFace::make();
  for (const double tolerance : {0.0, -1.0, 1e-7, 101.0, std::nan("")})
    EXPECT_NE(fault(face, tolerance).find("1e-06 to 100 mm"), std::string::npos) << tolerance;
  EXPECT_NE(fault(face, 0.1, std::string(256, 'x')).find("255 bytes"), std::string::npos);
  FaceCurves changed = face;
  changed.curves.points *= 1000.0;
  EXPECT_NE(fault(changed, 0.1).find("are they in mm?"), std::string::npos);
  changed = face;
  changed.curves.points(7, 1) = std::nan("");
  EXPECT_NE(fault(changed, 0.1).find("C1, point 7"), std::string::npos);
  changed = face;
  changed.features.push_back({"", 0, 0.0});
  EXPECT_NE(fault(changed, 0.1).find("feature point"), std::string::npos);
  EXPECT_NE(fault(FaceCurves(), 0.1).find("29 boundary curves"), std::string::npos);
}

TEST(CompactFace, LongCurvesAreStoredToo) {
  const FaceCurves face = randomFace(4096);
  EXPECT_LE(rmsBetween(decoded(encoded(face, 0.5)).face.curves, face.curves), 0.5);
}
