#include "PackedTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "Checksum.h"

namespace mien {

namespace {

using Coefficients = QuadraticMap::Coefficients;
constexpr int regionCount = DeformationTable::regionCount;
constexpr std::size_t headerBytes = 8 + 4 * sizeof(float);
constexpr char withUnknown = 3, version = 2, withoutChecksum = 1;
constexpr double largestNumber = 1e6;  // that a header may hold

// The centres of version 1; a later region map must not change what a file means.
constexpr std::array<std::array<double, 2>, regionCount> centres = {{{-0.9, 1.6},
                                                                     {0.9, 1.6},
                                                                     {0.0, 0.6},
                                                                     {-1.0, 0.35},
                                                                     {1.0, 0.35},
                                                                     {-1.5, -0.7},
                                                                     {1.5, -0.7},
                                                                     {0.0, -0.5},
                                                                     {0.0, -1.2},
                                                                     {-1.1, -1.6},
                                                                     {1.1, -1.6},
                                                                     {0.0, -2.0},
                                                                     {0.0, -2.6},
                                                                     {-1.0, -2.6},
                                                                     {1.0, -2.6},
                                                                     {0.0, -3.4}}};

/// The same polynomials with x + dx and y + dy put in for x and y.
Coefficients shifted(const Coefficients& c, double dx, double dy) {
  Coefficients result = c;
  for (int row = 0; row < 2; ++row) {
    result(row, 3) += 2.0 * c(row, 0) * dx + c(row, 1) * dy;
    result(row, 4) += c(row, 1) * dx + 2.0 * c(row, 2) * dy;
    result(row, 5) += c(row, 0) * dx * dx + c(row, 1) * dx * dy + c(row, 2) * dy * dy + c(row, 3) * dx + c(row, 4) * dy;
  }
  return result;
}

int degreeClass(int column) {
  return column < 3 ? 0 : column < 5 ? 1 : 2;
}

/// Displacements about the centres, and the largest of their coefficients by degree.
struct Local {
  std::array<Coefficients, regionCount> coefficients;
  std::array<double, 3> largest{};

  explicit Local(const DeformationTable& table) {
    for (int i = 0; i < regionCount; ++i) {
      coefficients[i] = shifted(table.maps[i].coefficients - QuadraticMap::identity(), centres[i][0], centres[i][1]);
      for (int k = 0; k < 12; ++k)
        largest[degreeClass(k % 6)] = std::max(largest[degreeClass(k % 6)], std::abs(coefficients[i](k / 6, k % 6)));
    }
  }

  /// What the largest coefficients fit into.
  std::array<float, 3> steps(int bits) const {
    const double levels = (1 << (bits - 1)) - 1;
    std::array<float, 3> result{};
    // Rounded upwards, so that the largest coefficient stays within the integers.
    for (int k = 0; k < 3; ++k) result[k] = std::nextafter(static_cast<float>(largest[k] / levels), 1e30f);
    return result;
  }
};

void appendWord(std::string& bytes, std::uint32_t word) {
  for (int k = 0; k < 4; ++k) bytes += static_cast<char>(word >> (8 * k) & 0xff);
}

void appendFloat(std::string& bytes, float value) {
  std::uint32_t word;
  std::memcpy(&word, &value, sizeof word);
  appendWord(bytes, word);
}

std::uint32_t wordAt(const std::string& bytes, std::size_t at, int size) {
  std::uint32_t word = 0;
  for (int k = 0; k < size; ++k) word |= std::uint32_t(static_cast<unsigned char>(bytes[at + k])) << (8 * k);
  return word;
}

float floatAt(const std::string& bytes, std::size_t at) {
  const std::uint32_t word = wordAt(bytes, at, 4);
  float value;
  std::memcpy(&value, &word, sizeof value);
  return value;
}

std::string describeHeaderFault(const std::string& bytes) {
  if (!isPackedTable(bytes) || bytes.size() < headerBytes) return "it is no packed facial deformation table";
  if (bytes[4] != withUnknown && bytes[4] != version && bytes[4] != withoutChecksum)
    return "its version is " + std::to_string(int(bytes[4])) + "; this program knows versions 1 to 3";
  if (bytes[5] != 8 && bytes[5] != 16)
    return "it has " + std::to_string(int(bytes[5])) + " bits a coefficient; there are 8 and 16";
  if (bytes[4] != withUnknown && (bytes[6] || bytes[7])) return "bytes 6 and 7 are not 0; it is damaged";
  const std::size_t checked = headerBytes + 12 * regionCount * (bytes[5] / 8);
  const std::size_t expected = checked + (bytes[4] == withoutChecksum ? 0 : sizeof(std::uint32_t));
  if (bytes.size() != expected)
    return "it has " + std::to_string(bytes.size()) + " bytes where a table has " + std::to_string(expected) +
           "; it is damaged";
  if (expected > checked && wordAt(bytes, checked, 4) != checksumOf(std::string_view(bytes).substr(0, checked)))
    return "its checksum is wrong; it is damaged";
  for (int k = 0; k < 4; ++k) {
    const float value = floatAt(bytes, 8 + 4 * k);
    if (!(value >= 0.0f && value <= float(largestNumber)))
      return "its displacement or a step is no number from 0 to 1e6; it is damaged";
  }
  return {};
}

}  // namespace

std::string packTable(const DeformationTable& table, int bits) {
  const Local local(table);
  const std::array<float, 3> steps = local.steps(bits);
  std::string bytes = "MFDT";
  std::uint32_t unknown = 0;
  for (const int region : table.unknownRegions()) unknown |= 1u << (region - 1);
  bytes += {unknown ? withUnknown : version, static_cast<char>(bits), static_cast<char>(unknown & 0xff),
            static_cast<char>(unknown >> 8)};
  appendFloat(bytes, static_cast<float>(table.largestDisplacement));
  for (const float step : steps) appendFloat(bytes, step);
  for (const Coefficients& region : local.coefficients)
    for (int k = 0; k < 12; ++k) {
      const long value = std::lround(region(k / 6, k % 6) / steps[degreeClass(k % 6)]);
      for (int byte = 0; byte < bits / 8; ++byte) bytes += static_cast<char>(value >> (8 * byte) & 0xff);
    }
  appendWord(bytes, checksumOf(bytes));
  return bytes;
}

std::string describePacking(const DeformationTable& table, int bits) {
  const double levels = (1 << (bits - 1)) - 1;
  const Local local(table);
  for (const double largest : local.largest)
    if (!(largest / levels < largestNumber))
      return "it has coefficients too large for a packed table; write it as text (.csv)";
  return table.largestDisplacement <= largestNumber ? ""
                                                    : "its displacement is too large for a packed table; write it as "
                                                      "text (.csv)";
}

bool isPackedTable(const std::string& bytes) {
  return bytes.rfind("MFDT", 0) == 0;
}

std::string unpackTable(const std::string& bytes, DeformationTable& table) {
  const std::string fault = describeHeaderFault(bytes);
  if (!fault.empty()) return fault;
  const int size = bytes[5] / 8;
  DeformationTable result;
  result.largestDisplacement = floatAt(bytes, 8);
  if (const std::uint32_t unknown = wordAt(bytes, 6, 2)) {
    result.counts.emplace();
    for (int i = 0; i < regionCount; ++i) result.counts->at(i) = !(unknown >> i & 1u);
  }
  std::size_t at = headerBytes;
  for (int i = 0; i < regionCount; ++i) {
    Coefficients local;
    for (int k = 0; k < 12; ++k, at += size) {
      const std::uint32_t word = wordAt(bytes, at, size);
      const int value = size == 1 ? static_cast<std::int8_t>(word) : static_cast<std::int16_t>(word);
      local(k / 6, k % 6) = value * double(floatAt(bytes, 12 + 4 * degreeClass(k % 6)));
    }
    result.maps[i].coefficients = QuadraticMap::identity() + shifted(local, -centres[i][0], -centres[i][1]);
  }
  const std::string excess = result.describeExcess();
  if (!excess.empty()) return excess + "; it is damaged";
  table = result;
  return {};
}

namespace {

/// How far a map about its centre can be off at a distance from it.
double errorAt(const std::array<float, 3>& steps, double distance) {
  // x^2 + |xy| + y^2 is at most 1.5 d^2, |x| + |y| at most sqrt(2) d; both coordinates can be off at once.
  const double coordinate =
      0.5 * (1.5 * distance * distance * steps[0] + std::sqrt(2.0) * distance * steps[1] + steps[2]);
  return std::sqrt(2.0) * coordinate;
}

}  // namespace

double packingError(const DeformationTable& table, int bits, double reach) {
  return errorAt(Local(table).steps(bits), reach);
}

double packingError(const DeformationTable& table, int bits, const FacialRegions& regions) {
  constexpr double step = 0.05, aside = 4.0, below = -6.0, above = 4.0;  // pupil units, beyond any face's outline
  const std::array<float, 3> steps = Local(table).steps(bits);
  double largest = 0.0;
  for (double y = below; y <= above; y += step)
    for (double x = -aside; x <= aside; x += step) {
      const Eigen::Vector2d point(x, y);
      const double coverage = regions.outlineWeight(point);
      const Eigen::Vector2d followed = regions.followed(point);
      for (const double side : {-1.0, 0.0, 1.0}) {
        if (coverage == 0.0) continue;
        const FacialRegions::Weights weights = regions.weights(point, {side, 0.0});
        double error = 0.0;
        for (int i = 0; i < regionCount; ++i)
          if (weights[i] > 0.0)
            error += weights[i] * errorAt(steps, (followed - Eigen::Vector2d(centres[i][0], centres[i][1])).norm());
        largest = std::max(largest, coverage * error);
      }
    }
  return largest;
}

}  // namespace mien
