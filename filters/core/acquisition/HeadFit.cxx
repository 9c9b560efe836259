#include "HeadFit.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "MeshCleaning.h"
#include "PointTree.h"

namespace mien {

namespace {

using HeadPoints = Similarity::Points;

constexpr int rotationStarts = 300;  // none of all rotations is further than about 32 degrees from one of them
constexpr int coarseFacePoints = 220, coarseScanPoints = 5000, coarseSteps = 14;
constexpr int finalists = 12, middleFacePoints = 700, middleSteps = 20, fineSteps = 25;
constexpr double keptShare = 0.8;    // of the points, the nearer ones; hair, beards and holes are the rest
constexpr double farAway = 60.0;     // mm; a point without skin nearer than this counts so much
constexpr double sizeSpread = 0.12;  // standard deviation of the size of heads

/// Points with their outward normals.
struct Cloud {
  HeadPoints points, normals;

  Cloud every(Eigen::Index wanted) const {
    const Eigen::Index step = std::max<Eigen::Index>(1, points.rows() / wanted);
    Cloud some;
    const Eigen::Index count = (points.rows() + step - 1) / step;
    some.points.resize(count, 3);
    some.normals.resize(count, 3);
    for (Eigen::Index i = 0; i < count; ++i) {
      some.points.row(i) = points.row(i * step);
      some.normals.row(i) = normals.row(i * step);
    }
    return some;
  }
};

/// Even rotations by a spiral on the sphere of quaternions [Alexa 2022, super-Fibonacci spirals].
std::vector<Eigen::Matrix3d> evenRotations(int count) {
  const double phi = std::sqrt(2.0), psi = 1.533751168755204288118041;
  std::vector<Eigen::Matrix3d> rotations;
  for (int i = 0; i < count; ++i) {
    const double s = i + 0.5, r = std::sqrt(s / count), q = std::sqrt(1.0 - s / count);
    const double a = 2.0 * M_PI * s / phi, b = 2.0 * M_PI * s / psi;
    rotations.push_back(
        Eigen::Quaterniond(q * std::cos(b), r * std::sin(a), r * std::cos(a), q * std::sin(b)).toRotationMatrix());
  }
  return rotations;
}

/// The 24 ways in which files name their axes.
std::vector<Eigen::Matrix3d> axisRotations() {
  std::vector<Eigen::Matrix3d> rotations;
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 6; ++y) {
      const Eigen::Vector3d ex = (x % 2 ? -1.0 : 1.0) * Eigen::Vector3d::Unit(x / 2),
                            ey = (y % 2 ? -1.0 : 1.0) * Eigen::Vector3d::Unit(y / 2);
      if (x / 2 == y / 2) continue;
      Eigen::Matrix3d rotation;
      rotation << ex, ey, ex.cross(ey);
      rotations.push_back(rotation);
    }
  return rotations;
}

/// What a scan is asked while a face is moved over it.
class Target {
 public:
  explicit Target(Cloud cloud) : cloud_(std::move(cloud)), tree_(cloud_.points) {}

  const Cloud& cloud() const { return cloud_; }

  /// The nearest point whose skin looks the same way, or -1.
  int nearest(const Eigen::Vector3d& p, const Eigen::Vector3d& normal) const {
    const int found = tree_.nearest(p, farAway);
    return found >= 0 && cloud_.normals.row(found).dot(normal) > 0.2 ? found : -1;
  }

 private:
  Cloud cloud_;
  PointTree tree_;
};

/// Where the points of a face lie and what they met.
struct Meeting {
  Cloud moved;
  std::vector<int> partner;
  Eigen::VectorXd distance, weight;
  double score = 0.0;  ///< RMS over the kept share, those without a partner being far away
};

Meeting meet(const Cloud& face, const Similarity& motion, const Target& target, bool toPlane) {
  Meeting meeting;
  meeting.moved = {motion.applied(face.points), face.normals * motion.rotation.transpose()};
  const Eigen::Index n = face.points.rows();
  meeting.partner.resize(static_cast<size_t>(n));
  meeting.distance.setConstant(n, farAway);
  meeting.weight.setZero(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const int q = meeting.partner[i] = target.nearest(meeting.moved.points.row(i), meeting.moved.normals.row(i));
    if (q < 0) continue;
    const Eigen::RowVector3d way = target.cloud().points.row(q) - meeting.moved.points.row(i);
    meeting.distance[i] = toPlane ? std::abs(way.dot(target.cloud().normals.row(q))) : way.norm();
  }
  std::vector<double> sorted(meeting.distance.data(), meeting.distance.data() + n);
  const auto kept = static_cast<std::ptrdiff_t>(keptShare * static_cast<double>(n));
  std::nth_element(sorted.begin(), sorted.begin() + kept, sorted.end());
  double sum = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (meeting.distance[i] > sorted[kept]) continue;
    meeting.weight[i] = meeting.partner[i] >= 0 ? 1.0 : 0.0;
    sum += meeting.distance[i] * meeting.distance[i];
  }
  meeting.score = std::sqrt(sum / std::max<double>(1.0, static_cast<double>(kept)));
  return meeting;
}

/// Points to points: converges from far away.
Similarity pointStep(const Cloud& face, const Meeting& meeting, const Target& target, const Similarity& motion) {
  HeadPoints to = meeting.moved.points;
  for (Eigen::Index i = 0; i < to.rows(); ++i)
    if (meeting.partner[i] >= 0) to.row(i) = target.cloud().points.row(meeting.partner[i]);
  Similarity next = fitSimilarity(motion.scale * face.points, to, meeting.weight, true);
  next.scale = motion.scale;
  return meeting.weight.sum() > 6.0 ? next : motion;
}

/// Points to tangent planes [Chen and Medioni 1992]: small turn, shift and change of size by linear least squares.
Similarity planeStep(const Meeting& meeting, const Target& target, const Similarity& motion) {
  Eigen::Matrix<double, 7, 7> system = Eigen::Matrix<double, 7, 7>::Zero();
  Eigen::Matrix<double, 7, 1> right = Eigen::Matrix<double, 7, 1>::Zero();
  const Eigen::RowVector3d middle = meeting.moved.points.colwise().mean();
  double weightSum = 0.0;
  for (Eigen::Index i = 0; i < meeting.weight.size(); ++i) {
    if (meeting.weight[i] == 0.0) continue;
    const Eigen::Vector3d p = (meeting.moved.points.row(i) - middle).transpose();
    const Eigen::Vector3d n = target.cloud().normals.row(meeting.partner[i]).transpose();
    Eigen::Matrix<double, 7, 1> row;
    row << p.cross(n), n, p.dot(n);
    const double gap = n.dot((target.cloud().points.row(meeting.partner[i]) - meeting.moved.points.row(i)).transpose());
    system += row * row.transpose();
    right += gap * row;
    weightSum += 1.0;
  }
  constexpr double noise = 3.0;  // mm, of a face against another
  const double prior = weightSum > 0.0 ? noise * noise / (sizeSpread * sizeSpread) : 1.0;
  system(6, 6) += prior;
  right[6] -= prior * std::log(motion.scale);
  system.diagonal().array() += 1e-9;
  const Eigen::Matrix<double, 7, 1> x = system.ldlt().solve(right);
  if (!x.allFinite()) return motion;
  const Eigen::Vector3d turn = x.head<3>();
  const Eigen::Matrix3d rotation =
      turn.norm() > 0.0 ? Eigen::AngleAxisd(std::min(turn.norm(), 0.3), turn.normalized()).toRotationMatrix()
                        : Eigen::Matrix3d::Identity();
  const double grown = std::clamp(motion.scale * (1.0 + x[6]), 0.7, 1.4) / motion.scale;
  const Eigen::Vector3d centre = middle.transpose();
  return {motion.scale * grown, rotation * motion.rotation,
          grown * (rotation * (motion.translation - centre)) + centre + x.segment<3>(3)};
}

/// Two guesses of where a head in this pose lies: in the middle of the scan, and at its upper end, where busts have it.
std::vector<Eigen::Vector3d> headPlaces(const HeadPoints& scan, const Eigen::Matrix3d& rotation) {
  constexpr double crownAbove = 115.0, headHeight = 240.0;  // mm above the middle of the head; from crown to neck
  const Eigen::Vector3d up = rotation.col(1), middle = scan.colwise().mean().transpose();
  const Eigen::VectorXd height = scan * up;
  const double top = height.maxCoeff();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int count = 0;
  for (Eigen::Index i = 0; i < scan.rows(); ++i)
    if (height[i] > top - headHeight) {
      sum += scan.row(i).transpose();
      ++count;
    }
  Eigen::Vector3d upper = sum / std::max(1, count);
  upper += (top - crownAbove - upper.dot(up)) * up;
  return {middle, upper};
}

struct Start {
  Similarity motion;
  double score;
};

/// What is left of the radii of a face when their smooth part, a quadratic over azimuth and height, is taken off.
Eigen::VectorXd reliefOf(const Eigen::VectorXd& depth, const Eigen::MatrixXd& basis) {
  return depth - basis * basis.colPivHouseholderQr().solve(depth);
}

/// Correlation of the depths of the known face and of the scan as seen from the front, smooth parts taken off.
double reliefCorrelation(const Cloud& face, const Meeting& meeting, const Target& target, const Similarity& motion) {
  std::vector<int> used;
  for (Eigen::Index i = 0; i < meeting.weight.size(); ++i)
    if (meeting.partner[i] >= 0 && face.normals(i, 2) > 0.3) used.push_back(static_cast<int>(i));
  if (used.size() < 50) return 0.0;
  const Similarity back = motion.inverse();
  const auto n = static_cast<Eigen::Index>(used.size());
  Eigen::MatrixXd basis(n, 10);
  Eigen::VectorXd known(n), seen(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector3d p = face.points.row(used[i]),
                          q = back(target.cloud().points.row(meeting.partner[used[i]]).transpose());
    const Eigen::Vector3d m = back.rotation * target.cloud().normals.row(meeting.partner[used[i]]).transpose();
    const double x = p.x() / 60.0, y = p.y() / 80.0;
    basis.row(i) << 1, x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y;
    known[i] = p.z();
    // the tangent plane of the scan, at the place of the point of the face
    seen[i] = m.z() > 0.2 ? std::clamp(q.z() - (m.x() * (p.x() - q.x()) + m.y() * (p.y() - q.y())) / m.z(),
                                       p.z() - 25.0, p.z() + 25.0)
                          : q.z();
  }
  const Eigen::VectorXd a = reliefOf(known, basis), b = reliefOf(seen, basis);
  const double norms = a.norm() * b.norm();
  return norms > 0.0 ? a.dot(b) / norms : 0.0;
}

bool isBetter(const Start& a, const Start& b) {
  return a.score < b.score;
}

/// All starts after a few steps on few points, the best ones first; false when stopped.
bool tryAllStarts(const Cloud& face, const Target& target, std::vector<Start>& starts, const Progress& progress) {
  const Eigen::Vector3d headMiddle(0.0, 0.0, 25.0);
  std::vector<Eigen::Matrix3d> rotations = axisRotations();
  for (const Eigen::Matrix3d& rotation : evenRotations(rotationStarts)) rotations.push_back(rotation);
  for (size_t r = 0; r < rotations.size(); ++r) {
    if (!goesOn(progress, static_cast<double>(r) / static_cast<double>(rotations.size()))) return false;
    for (const Eigen::Vector3d& place : headPlaces(target.cloud().points, rotations[r])) {
      Similarity motion{1.0, rotations[r], place - rotations[r] * headMiddle};
      for (int step = 0; step < coarseSteps; ++step)
        motion = pointStep(face, meet(face, motion, target, false), target, motion);
      starts.push_back({motion, meet(face, motion, target, false).score});
    }
  }
  std::sort(starts.begin(), starts.end(), isBetter);
  return true;
}

/// Steps to tangent planes.
Similarity refined(const Cloud& face, const Target& target, Similarity motion, int steps) {
  for (int step = 0; step < steps; ++step) motion = planeStep(meet(face, motion, target, false), target, motion);
  return motion;
}

/// The best of a few starts on more points; among equally near ones that whose relief agrees, as a face fits a neck
/// quite well.
bool chooseStart(const Cloud& face, const Target& target, std::vector<Start>& starts, const Progress& progress) {
  starts.resize(std::min<size_t>(finalists, starts.size()));
  for (size_t s = 0; s < starts.size(); ++s) {
    if (!goesOn(progress, static_cast<double>(s) / static_cast<double>(starts.size()))) return false;
    starts[s].motion = refined(face, target, starts[s].motion, middleSteps);
    const Meeting end = meet(face, starts[s].motion, target, false);
    starts[s].score = end.score * (2.0 - reliefCorrelation(face, end, target, starts[s].motion));
  }
  std::sort(starts.begin(), starts.end(), isBetter);
  return true;
}

}  // namespace

std::string fitHead(const FaceTemplate& face, const TriangleMesh& mesh, HeadFit& fit, const Progress& progress) {
  const Cloud whole{face.mesh.vertices, face.normals}, scan{mesh.vertices, outwardNormals(mesh)};
  std::vector<Start> starts;
  if (!tryAllStarts(whole.every(coarseFacePoints), Target(scan.every(coarseScanPoints)), starts,
                    partOf(progress, 0.0, 0.6)))
    return "stopped";
  const Target target(scan);
  if (!chooseStart(whole.every(middleFacePoints), target, starts, partOf(progress, 0.6, 0.95))) return "stopped";
  const Similarity motion = refined(whole, target, starts.front().motion, fineSteps);
  const Meeting end = meet(whole, motion, target, true);
  fit = {motion, end.score / motion.scale, reliefCorrelation(whole, end, target, motion)};
  return goesOn(progress, 1.0) ? std::string() : "stopped";
}

}  // namespace mien
