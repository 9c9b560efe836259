#include "TriangleTree.h"

#include <algorithm>

namespace mien {

namespace {

constexpr int trianglesPerLeaf = 4;
constexpr double thinnest = 1e-24;  // twice the area over the longest edge, squared twice: rounding beyond that

using Vector = Eigen::Vector3d;

/// Share of b in the point of the line a b that is nearest.
double shareOnLine(const Vector& place, const Vector& a, const Vector& b) {
  const double length = (b - a).squaredNorm();
  return length > 0.0 ? std::clamp((place - a).dot(b - a) / length, 0.0, 1.0) : 0.0;
}

/// Shares of the corners in the nearest point of a triangle with area, by the region of its plane above which the place
/// lies [Ericson, Real-Time Collision Detection, 2005, 5.1.5].
Vector sharesOnFace(const Vector& place, const Vector& a, const Vector& b, const Vector& c) {
  const Vector ab = b - a, ac = c - a, ap = place - a, bp = place - b, cp = place - c;
  const double abA = ab.dot(ap), acA = ac.dot(ap), abB = ab.dot(bp), acB = ac.dot(bp), abC = ab.dot(cp),
               acC = ac.dot(cp);
  if (abA <= 0.0 && acA <= 0.0) return {1.0, 0.0, 0.0};
  if (abB >= 0.0 && acB <= abB) return {0.0, 1.0, 0.0};
  if (acC >= 0.0 && abC <= acC) return {0.0, 0.0, 1.0};
  const double ofC = abA * acB - abB * acA, ofB = abC * acA - abA * acC, ofA = abB * acC - abC * acB;
  if (ofC <= 0.0 && abA >= 0.0 && abB <= 0.0) return {-abB / (abA - abB), abA / (abA - abB), 0.0};
  if (ofB <= 0.0 && acA >= 0.0 && acC <= 0.0) return {-acC / (acA - acC), 0.0, acA / (acA - acC)};
  const double towardsC = acB - abB, towardsB = abC - acC;
  if (ofA <= 0.0 && towardsC >= 0.0 && towardsB >= 0.0)
    return {0.0, towardsB / (towardsC + towardsB), towardsC / (towardsC + towardsB)};
  const double sum = ofA + ofB + ofC;
  return {ofA / sum, ofB / sum, ofC / sum};
}

/// The same of a triangle without area: the nearest of its three edges.
Vector sharesOnLines(const Vector& place, const Vector (&corners)[3]) {
  Vector best = Vector::Zero();
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const double share = shareOnLine(place, corners[i], corners[j]);
    const double squared = (corners[i] + share * (corners[j] - corners[i]) - place).squaredNorm();
    if (squared >= nearest) continue;
    nearest = squared;
    best.setZero();
    best[i] = 1.0 - share;
    best[j] = share;
  }
  return best;
}

}  // namespace

TriangleTree::TriangleTree(const TriangleMesh& mesh) {
  faces_.reserve(static_cast<std::size_t>(mesh.triangles.rows()));
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    const Vector a = mesh.vertices.row(mesh.triangles(t, 0)), b = mesh.vertices.row(mesh.triangles(t, 1)),
                 c = mesh.vertices.row(mesh.triangles(t, 2));
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    faces_.push_back({a, b, c, t, (b - a).cross(c - a).squaredNorm() <= thinnest * longest * longest});
  }
  nodes_.reserve(faces_.size());
  if (!faces_.empty()) build(0, static_cast<int>(faces_.size()));
}

int TriangleTree::build(int begin, int end) {
  const int node = static_cast<int>(nodes_.size());
  Eigen::AlignedBox3d box, middles;
  for (int i = begin; i < end; ++i) {
    const Face& face = faces_[i];
    for (const Vector* corner : {&face.a, &face.b, &face.c}) box.extend(*corner);
    middles.extend(Vector(face.a + face.b + face.c));
  }
  nodes_.push_back({box, begin, end, -1});
  if (end - begin <= trianglesPerLeaf) return node;
  int axis = 0;
  middles.sizes().maxCoeff(&axis);
  const int middle = (begin + end) / 2;
  const auto along = [axis](const Face& face) { return face.a[axis] + face.b[axis] + face.c[axis]; };
  std::nth_element(faces_.begin() + begin, faces_.begin() + middle, faces_.begin() + end,
                   [&](const Face& one, const Face& other) {
                     return along(one) != along(other) ? along(one) < along(other) : one.triangle < other.triangle;
                   });
  build(begin, middle);
  const int second = build(middle, end);
  nodes_[node].second = second;
  return node;
}

void TriangleTree::look(const Face& face, const Vector& place, Nearest& best) {
  const Vector shares =
      face.isLine ? sharesOnLines(place, {face.a, face.b, face.c}) : sharesOnFace(place, face.a, face.b, face.c);
  const Vector point = shares[0] * face.a + shares[1] * face.b + shares[2] * face.c;
  const double squared = (point - place).squaredNorm();
  if (squared < best.squared) best = {face.triangle, point, shares, squared};
}

void TriangleTree::descend(int node, const Vector& place, Nearest& best) const {
  const Node& here = nodes_[node];
  if (here.second < 0) {
    for (int i = here.begin; i < here.end; ++i) look(faces_[i], place, best);
    return;
  }
  int near = node + 1, far = here.second;
  double toNear = nodes_[near].box.squaredExteriorDistance(place),
         toFar = nodes_[far].box.squaredExteriorDistance(place);
  if (toFar < toNear) {
    std::swap(near, far);
    std::swap(toNear, toFar);
  }
  if (toNear < best.squared) descend(near, place, best);
  if (toFar < best.squared) descend(far, place, best);
}

TriangleTree::Nearest TriangleTree::nearest(const Vector& place) const {
  Nearest best;
  if (!nodes_.empty()) descend(0, place, best);
  return best;
}

}  // namespace mien
