#include "CompactFace.h"

#include <cmath>

#include "ByteReader.h"
#include "ByteWriter.h"
#include "Checksum.h"
#include "CurveCoder.h"
#include "EntropyCode.h"
#include "FeatureCode.h"
#include "NumberText.h"

namespace mien {

namespace {

using Limits = CompactFaceLimits;

constexpr std::string_view magic = "MIENZ";
constexpr std::size_t checkedFrom = magic.size() + 1 + 4;  // version and checksum
constexpr std::uint8_t millimetres = 0, withPupils = 1;
constexpr double pupilStep = 0.01;  // mm

// -- Writing

struct Errors {
  double rms, maximum;
};

Errors errorsOf(const ClosedCurves& one, const ClosedCurves& other) {
  const Eigen::VectorXd distances = (one.points - other.points).rowwise().norm();
  return {std::sqrt(distances.squaredNorm() / static_cast<double>(distances.size())), distances.maxCoeff()};
}

/// A number that cannot be stored exactly is stated too large rather than too small.
float notBelow(double value) {
  const auto single = static_cast<float>(value);
  return single < value ? std::nextafter(single, INFINITY) : single;
}

/// Levels that come back within the tolerance, at a step near the largest that does.
CurveLevels levelsWithin(const ClosedCurves& curves, double tolerance) {
  const CurveCoder coder(curves.pointsPerCurve);
  const Eigen::VectorXd coefficients = coder.coefficients(curves);
  const auto levelsAt = [&](double step) {  // the step as the file keeps it
    return coder.levels(coefficients, static_cast<double>(static_cast<float>(step)));
  };
  const auto fits = [&](double step) { return errorsOf(coder.curves(levelsAt(step)), curves).rms <= tolerance; };
  double fine = tolerance, coarse = 2.0 * tolerance;
  while (!fits(fine)) fine *= 0.5;  // errors are at most 0.57 steps in each coordinate
  constexpr int doublings = 6, halvings = 12;
  for (int i = 0; i < doublings && fits(coarse); ++i) {
    fine = coarse;
    coarse *= 2.0;
  }
  for (int i = 0; i < halvings; ++i) {
    const double middle = std::sqrt(fine * coarse);
    (fits(middle) ? fine : coarse) = middle;
  }
  return levelsAt(fine);
}

void writePupil(const Eigen::Vector3d& pupil, ByteWriter& bytes) {
  for (const double coordinate : pupil) bytes.signedWhole(std::llround(coordinate / pupilStep));
}

std::string packedBody(const FaceCurves& face, const CurveLevels& levels) {
  ByteWriter body;
  writeFeatures(face.features, body);
  if (face.hasPupils) writePupil(face.leftPupil, body);
  if (face.hasPupils) writePupil(face.rightPupil, body);
  for (const std::int64_t level : levels.values) body.signedWhole(level);
  return packBytes(body.bytes());
}

std::string describeUnstorable(const FaceCurves& face, const std::string& name, double tolerance) {
  const int k = face.curves.pointsPerCurve;
  if (!(tolerance >= Limits::finest && tolerance <= Limits::coarsest))
    return "a tolerance of " + numberText(tolerance) + " mm is not allowed; give " + numberText(Limits::finest) +
           " to " + numberText(Limits::coarsest) + " mm";
  const std::string fault = describeFault(face);
  if (!fault.empty()) return fault;
  if (k > Limits::largestCurve)
    return "curves have " + std::to_string(k) + " points each; a compact face file holds at most " +
           std::to_string(Limits::largestCurve);
  if (face.curves.points.cwiseAbs().maxCoeff() > Limits::farthest)
    return "the curves lie further than " + numberText(Limits::farthest) + " mm from the origin; are they in mm?";
  if (name.size() > Limits::longestName)
    return "the name is longer than " + std::to_string(Limits::longestName) + " bytes; shorten it";
  if (face.features.size() > Limits::mostFeatures)
    return "there are more than " + std::to_string(Limits::mostFeatures) + " feature points";
  for (const FeaturePoint& feature : face.features)
    if (feature.id.empty() || feature.id.size() > Limits::longestId)
      return "the name of feature point " + inQuotes(feature.id) + " has not 1 to " +
             std::to_string(Limits::longestId) + " bytes";
  for (const Eigen::Vector3d& pupil : {face.leftPupil, face.rightPupil})
    if (face.hasPupils && !(pupil.cwiseAbs().maxCoeff() <= Limits::farthest))
      return "the pupils are no points near the face";
  return {};
}

// -- Reading

struct Header {
  std::uint8_t unit, flags;
  double step, rms, maximum;
  std::uint64_t points, features;
  std::string name;
};

Header readHeader(ByteReader& bytes) {
  Header header;
  header.unit = bytes.byte();
  header.flags = bytes.byte();
  header.step = bytes.single();
  header.rms = bytes.single();
  header.maximum = bytes.single();
  header.points = bytes.whole();
  header.name = bytes.text();
  header.features = bytes.whole();
  return header;
}

bool isSize(double value) {
  return std::isfinite(value) && value >= 0.0 && value <= Limits::farthest;
}

/// Whether a header with the right checksum is one that encodeCompactFace writes.
bool isSound(const Header& header) {
  return header.unit == millimetres && header.flags <= withPupils && isSize(header.step) && header.step > 0.0 &&
         isSize(header.rms) && isSize(header.maximum) && header.points >= Limits::smallestCurve &&
         header.points <= Limits::largestCurve && header.points % 2 == 0 && header.name.size() <= Limits::longestName &&
         header.features <= Limits::mostFeatures;
}

Eigen::Vector3d readPupil(ByteReader& bytes) {
  Eigen::Vector3d pupil;
  for (double& coordinate : pupil) coordinate = pupilStep * static_cast<double>(bytes.signedWhole());
  return pupil;
}

/// No level of a face is beyond what the largest coordinates give.
bool readLevels(ByteReader& bytes, std::size_t most, CurveLevels& levels) {
  while (bytes.good() && !bytes.rest().empty()) {
    levels.values.push_back(bytes.signedWhole());
    const auto size = std::abs(static_cast<double>(levels.values.back()));
    if (levels.values.size() > most || size > CurveCoder::largestLevel) return false;
  }
  return bytes.good();
}

bool readBody(std::string_view packed, const Header& header, CompactFace& compact) {
  constexpr std::size_t longestNumber = 9, longestFeature = Limits::longestId + 3 * longestNumber;
  const CurveCoder coder(static_cast<int>(header.points));
  const std::size_t most = coder.coefficientCount() * longestNumber + Limits::mostFeatures * longestFeature;
  std::string unpacked;
  if (!unpackBytes(packed, most, unpacked)) return false;
  ByteReader bytes(unpacked);
  FaceCurves& face = compact.face;
  if (!readFeatures(bytes, header.features, face.features)) return false;
  face.hasPupils = header.flags == withPupils;
  if (face.hasPupils) face.leftPupil = readPupil(bytes);
  if (face.hasPupils) face.rightPupil = readPupil(bytes);
  CurveLevels levels{header.step, {}};
  if (!readLevels(bytes, coder.coefficientCount(), levels)) return false;
  face.curves = coder.curves(levels);
  return true;
}

constexpr const char* advice = "; copy the file again or write it anew";

std::string describeContainerFault(std::string_view bytes) {
  if (!isCompactFace(bytes))
    return std::string("this is no compact face file (.mienz): it does not begin with MIENZ") + advice;
  if (bytes.size() <= checkedFrom) return std::string("the file ends within its header") + advice;
  ByteReader reader(bytes.substr(magic.size()));
  const int version = reader.byte();
  if (version != Limits::version)
    return "version " + std::to_string(version) + " of the format is not known, only " +
           std::to_string(Limits::version) + "; read the file with the program that wrote it";
  if (reader.fixed32() != checksumOf(bytes.substr(checkedFrom)))
    return std::string("the checksum is wrong: the file is damaged or cut off") + advice;
  return {};
}

}  // namespace

std::string encodeCompactFace(const FaceCurves& face, const std::string& name, double tolerance, std::string& bytes) {
  const std::string fault = describeUnstorable(face, name, tolerance);
  if (!fault.empty()) return fault;
  const CurveLevels levels = levelsWithin(face.curves, tolerance);
  const Errors errors = errorsOf(CurveCoder(face.curves.pointsPerCurve).curves(levels), face.curves);
  ByteWriter header;
  header.byte(millimetres);
  header.byte(face.hasPupils ? withPupils : 0);
  header.single(static_cast<float>(levels.step));
  header.single(notBelow(errors.rms));
  header.single(notBelow(errors.maximum));
  header.whole(face.curves.pointsPerCurve);
  header.text(name);
  header.whole(face.features.size());
  const std::string checked = header.bytes() + packedBody(face, levels);
  ByteWriter start;
  start.byte(Limits::version);
  start.fixed32(checksumOf(checked));
  bytes = std::string(magic) + start.bytes() + checked;
  return {};
}

bool isCompactFace(std::string_view bytes) {
  return bytes.substr(0, magic.size()) == magic;
}

std::string decodeCompactFace(std::string_view bytes, CompactFace& compact) {
  std::string fault = describeContainerFault(bytes);
  if (!fault.empty()) return fault;
  ByteReader reader(bytes.substr(checkedFrom));
  const Header header = readHeader(reader);
  CompactFace read;
  if (!reader.good() || !isSound(header) || !readBody(reader.rest(), header, read))
    return std::string("what it holds is no face, though its checksum is right") + advice;
  read.name = header.name;
  read.rmsError = header.rms;
  read.maximumError = header.maximum;
  fault = describeFault(read.face);
  if (fault.empty()) compact = std::move(read);
  return fault;
}

}  // namespace mien
