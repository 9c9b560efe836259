#include "RadialSkin.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

#include "Degree.h"

namespace mien {

namespace {

/// Signed area of the origin against the edge a b, twice.
double side(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// A hair of slack keeps rays from slipping between two triangles along their common edge.
constexpr double edgeSlack = 1e-12;

/// Distance along the ray where it meets a triangle, NaN when it does not. `across` holds (offset from the ray's
/// vertical plane, height above the ray) of the corners, `along` their distance along the ray.
double hit(const std::array<Eigen::Vector2d, 3>& across, const std::array<double, 3>& along) {
  const std::array<double, 3> w = {side(across[1], across[2]), side(across[2], across[0]), side(across[0], across[1])};
  const double sum = w[0] + w[1] + w[2];
  if (sum == 0.0) return std::numeric_limits<double>::quiet_NaN();
  double distance = 0.0;
  for (int i = 0; i < 3; ++i) {
    if (w[i] / sum < -edgeSlack) return std::numeric_limits<double>::quiet_NaN();
    distance += w[i] / sum * along[i];
  }
  return distance;
}

/// Most triangles of a bin lie wholly above or below a ray.
bool spansHeight(const TriangleMesh& mesh, int triangle, double y) {
  const double a = mesh.vertices(mesh.triangles(triangle, 0), 1), b = mesh.vertices(mesh.triangles(triangle, 1), 1),
               c = mesh.vertices(mesh.triangles(triangle, 2), 1);
  return std::min({a, b, c}) <= y && y <= std::max({a, b, c});
}

int binOf(double azimuth) {
  return static_cast<int>(std::floor(azimuth / degree));
}

}  // namespace

RadialSkin::RadialSkin(const TriangleMesh& mesh, const HeadAxis& axis) : mesh_(mesh), axis_(axis) {
  for (int t = 0; t < mesh.triangles.rows(); ++t) fileTriangle(t);
}

void RadialSkin::fileTriangle(int triangle) {
  const Eigen::Vector3i ids = mesh_.triangles.row(triangle);
  const double first = axis_.azimuth(mesh_.vertices.row(ids[0]));
  double low = first, high = first;
  for (int i = 1; i < 3; ++i) {
    const double a = first + std::remainder(axis_.azimuth(mesh_.vertices.row(ids[i])) - first, 2.0 * M_PI);
    low = std::min(low, a);
    high = std::max(high, a);
  }
  const bool surroundsAxis = high - low > M_PI;
  const int from = surroundsAxis ? 0 : binOf(low), to = surroundsAxis ? binCount - 1 : binOf(high);
  for (int bin = from; bin <= to; ++bin) bins_[(bin + 2 * binCount) % binCount].push_back(triangle);
}

double RadialSkin::radius(double azimuth, double y) const {
  double outermost = std::numeric_limits<double>::quiet_NaN();
  const double s = std::sin(azimuth), c = std::cos(azimuth);
  for (const int triangle : bins_[(binOf(std::remainder(azimuth, 2.0 * M_PI)) + binCount) % binCount]) {
    if (!spansHeight(mesh_, triangle, y)) continue;
    std::array<Eigen::Vector2d, 3> across;
    std::array<double, 3> along;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d p = mesh_.vertices.row(mesh_.triangles(triangle, i));
      across[i] = {(p.x() - axis_.x) * c - (p.z() - axis_.z) * s, p.y() - y};
      along[i] = (p.x() - axis_.x) * s + (p.z() - axis_.z) * c;
    }
    const double r = hit(across, along);
    if (r > 0.0 && !(r <= outermost)) outermost = r;
  }
  return outermost;
}

namespace {

constexpr int ringPoints = 24;

/// Skin around a place: offsets across and up (mm), and radii; nothing unless most of the ring has skin on all sides.
bool ringOf(const RadialSkin& skin, double azimuth, double y, double size, double width,
            std::vector<Eigen::Vector3d>& ring) {
  int sides[4] = {};
  for (int i = 0; i < ringPoints; ++i) {
    const double angle = 2.0 * M_PI * i / ringPoints, x = width * std::cos(angle), up = width * std::sin(angle);
    const double r = skin.radius(azimuth + x / size, y + up);
    if (!std::isfinite(r)) continue;
    ring.emplace_back(x, up, r);
    ++sides[4 * i / ringPoints];
  }
  return *std::min_element(sides, sides + 4) >= ringPoints / 4 - 2;
}

/// Value in the middle of the quadratic that fits best; with weights 1 / distance^power, near skin counts for more.
double quadraticMiddle(const std::vector<Eigen::Vector3d>& ring, int power) {
  Eigen::MatrixXd basis(ring.size(), 6);
  Eigen::VectorXd radii(ring.size());
  for (size_t i = 0; i < ring.size(); ++i) {
    const double x = ring[i].x(), y = ring[i].y();
    const double weight = std::pow(std::hypot(x, y), -power);
    basis.row(static_cast<Eigen::Index>(i)) << 1.0, x, y, x * x, x * y, y * y;
    basis.row(static_cast<Eigen::Index>(i)) *= weight;
    radii[static_cast<Eigen::Index>(i)] = weight * ring[i].z();
  }
  return basis.colPivHouseholderQr().solve(radii)[0];
}

}  // namespace

namespace {

constexpr double headRadius = 80.0;  // mm; turns widths into angles, no more
constexpr double ringStep = 1.5;     // mm

/// All skin within a width, where there is some on all sides at that width.
bool surroundingsOf(const RadialSkin& skin, double azimuth, double y, double width,
                    std::vector<Eigen::Vector3d>& surroundings) {
  if (!ringOf(skin, azimuth, y, headRadius, width, surroundings)) return false;
  for (double inner = ringStep; inner < width; inner += ringStep)
    ringOf(skin, azimuth, y, headRadius, inner, surroundings);
  return true;
}

}  // namespace

double RadialSkin::filledRadius(double azimuth, double y) const {
  const double direct = radius(azimuth, y);
  if (std::isfinite(direct)) return direct;
  constexpr double narrow = 15.0, widest = 36.0;
  constexpr int nearFirst = 3;
  for (double width = ringStep; width <= narrow; width += ringStep) {
    std::vector<Eigen::Vector3d> ring;
    if (!ringOf(*this, azimuth, y, headRadius, width, ring)) continue;
    for (int more = 1; more <= 2; ++more) ringOf(*this, azimuth, y, headRadius, width + more * ringStep, ring);
    return quadraticMiddle(ring, 0);
  }
  // Deep in a wide hole only its far side is all around; the skin beside it must not be forgotten over that.
  for (double width = narrow + ringStep; width <= widest; width += ringStep) {
    std::vector<Eigen::Vector3d> surroundings;
    if (surroundingsOf(*this, azimuth, y, width, surroundings)) return quadraticMiddle(surroundings, nearFirst);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

std::string describeFault(const TriangleMesh& mesh) {
  if (mesh.triangles.rows() == 0) return "the mesh has no triangles; a scan of a head's surface is needed";
  if (!mesh.vertices.allFinite()) return "the mesh has a vertex that is not a finite number";
  if (mesh.triangles.minCoeff() < 0 || mesh.triangles.maxCoeff() >= mesh.vertices.rows())
    return "a triangle uses a vertex that the mesh does not have";
  return {};
}

}  // namespace mien
