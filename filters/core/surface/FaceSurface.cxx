#include "FaceSurface.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

#include "SharedDerivatives.h"

namespace mien {

namespace {

/// The shared derivatives of every order at every rate, for all pieces of a face: [part][order - 1].
using DerivativeTable = std::vector<std::array<Eigen::MatrixXd, 2>>;

bool usesDerivative(const FaceScheme& scheme, int order) {
  for (const FaceScheme::Piece& piece : scheme.pieces)
    for (const Condition& condition : piece.conditions)
      if (condition.derivative == order) return true;
  return false;
}

std::shared_ptr<const DerivativeTable> derivativeTable(const FaceScheme& scheme, const FaceSurfaceOptions& options) {
  auto table = std::make_shared<DerivativeTable>(options.modes + 2);
  for (int order : {1, 2}) {
    if (!usesDerivative(scheme, order)) continue;
    for (int part = 0; part < options.modes + 2; ++part) {
      auto rates = options.smoothing;
      for (double& rate : rates) rate *= part;
      (*table)[part][order - 1] = options.derivativeStrength * sharedDerivatives(scheme.derivatives, order, rates);
    }
  }
  return table;
}

/// For every condition the combination of the 29 curves that it prescribes.
Eigen::MatrixXd boundaryData(const std::vector<Condition>& conditions, int patch,
                             const std::array<Eigen::MatrixXd, 2>& derivatives) {
  Eigen::MatrixXd data = Eigen::MatrixXd::Zero(conditions.size(), FaceLayout::curveCount);
  for (size_t i = 0; i < conditions.size(); ++i) {
    const int curve = FaceLayout::firstCurve[patch] + conditions[i].curve;
    if (conditions[i].derivative == 0)
      data(i, curve) = 1.0;
    else
      data.row(i) = derivatives[conditions[i].derivative - 1].row(curve);
  }
  return data;
}

SurfacePiece makePiece(const FaceScheme::Piece& recipe, int patch, double smoothing,
                       std::shared_ptr<const DerivativeTable> table) {
  SurfacePiece piece;
  piece.conditions = recipe.conditions;
  for (size_t i = 0; i < piece.conditions.size(); ++i) piece.conditions[i].curve = static_cast<int>(i);
  piece.smoothing = smoothing;
  piece.begin = recipe.begin;
  piece.end = recipe.end;
  piece.boundaryData = [conditions = recipe.conditions, patch, table](int part) {
    return boundaryData(conditions, patch, (*table)[part]);
  };
  return piece;
}

/// The next rows, as far as the piece's end; a row on a seam has gone to the piece above.
void dealRows(const RowLayout& layout, int patch, size_t& next, SurfacePiece& piece) {
  const auto& rows = layout.rows();
  piece.firstRow = static_cast<int>(next);
  for (; next < rows.size() && rows[next].patch == patch && rows[next].u <= piece.end; ++next)
    piece.u.push_back(rows[next].u);
}

std::string allSchemeNames() {
  std::string names;
  for (const FaceScheme& scheme : faceSchemes()) names += (names.empty() ? "" : ", ") + scheme.name;
  return names;
}

std::string number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string describeRateFault(const FaceSurfaceOptions& options, const FaceScheme& scheme) {
  const double a = *std::max_element(options.smoothing.begin(), options.smoothing.end());
  const double rate = a * (options.modes + 1);
  if (rate <= scheme.largestRate) return {};
  return "the " + scheme.name + " scheme loses all precision past a (N + 1) = " + number(scheme.largestRate) +
         ", and a = " + number(a) + ", N = " + number(options.modes) + " make " + number(rate) +
         "; choose a smaller a or N, or another scheme";
}

}  // namespace

bool FaceSurfaceOptions::operator==(const FaceSurfaceOptions& other) const {
  return scheme == other.scheme && smoothing == other.smoothing && modes == other.modes &&
         remainder == other.remainder && derivativeStrength == other.derivativeStrength;
}

std::string describeFault(const FaceSurfaceOptions& options, int pointsPerCurve) {
  const FaceScheme* scheme = findFaceScheme(options.scheme);
  if (!scheme) return "there is no scheme '" + options.scheme + "'; the schemes are " + allSchemeNames();
  for (const double a : options.smoothing)
    if (!(a > 0.0 && a <= FaceSurfaceOptions::largestSmoothing))
      return "a = " + number(a) + " is outside 0 < a <= " + number(FaceSurfaceOptions::largestSmoothing);
  if (options.modes < 0 || options.modes > pointsPerCurve / 2)
    return "N = " + number(options.modes) + " is outside 0 .. " + number(pointsPerCurve / 2) + " (curves have " +
           number(pointsPerCurve) + " points)";
  if (!(std::abs(options.derivativeStrength) <= FaceSurfaceOptions::largestStrength))
    return "the derivative strength " + number(options.derivativeStrength) + " is outside -" +
           number(FaceSurfaceOptions::largestStrength) + " .. " + number(FaceSurfaceOptions::largestStrength);
  return describeRateFault(options, *scheme);
}

std::vector<SurfacePiece> facePieces(const FaceSurfaceOptions& options, const RowLayout& layout) {
  const FaceScheme& scheme = *findFaceScheme(options.scheme);
  const auto table = derivativeTable(scheme, options);
  std::vector<SurfacePiece> pieces;
  size_t nextRow = 0;
  for (int patch = 0; patch < FaceLayout::patchCount; ++patch)
    for (const FaceScheme::Piece& recipe : scheme.pieces) {
      pieces.push_back(makePiece(recipe, patch, options.smoothing[patch], table));
      dealRows(layout, patch, nextRow, pieces.back());
    }
  return pieces;
}

}  // namespace mien
