#include "LevelsOfDetail.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "CompactFace.h"
#include "CurveModes.h"
#include "FaceBand.h"
#include "FaceSample.h"
#include "MeshCleaning.h"
#include "MeshCode.h"
#include "MeshSeries.h"
#include "NumberText.h"
#include "RadialSkin.h"
#include "SurfaceSamples.h"
#include "TriangleTree.h"
#include "vtkSMPTools.h"

namespace mien {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
constexpr int faceRows = 112, faceColumns = 80;  // of the faces that are measured: cells of about 2 mm
constexpr double skinDepth = 1.0;                // mm; deeper points of a scan are hidden behind its skin
constexpr int fewestLevelTriangles = 8;

struct Way {
  double rms = 0.0, maximum = 0.0;
};

/// Looks at the wish to stop a few times in a second; false when it was stopped.
bool measureWay(const SurfaceSamples& samples, const TriangleTree& mesh, const Progress& progress, Way& way) {
  constexpr std::size_t pointsPerSlab = 1 << 14;
  const std::size_t count = samples.points.size();
  std::vector<double> squared(count);
  for (std::size_t begin = 0; begin < count; begin += pointsPerSlab) {
    const std::size_t end = std::min(count, begin + pointsPerSlab);
    vtkSMPTools::For(static_cast<vtkIdType>(begin), static_cast<vtkIdType>(end), [&](vtkIdType first, vtkIdType last) {
      for (vtkIdType i = first; i < last; ++i) squared[i] = mesh.nearest(samples.points[i]).squared;
    });
    if (!goesOn(progress, static_cast<double>(end) / static_cast<double>(count))) return false;
  }
  double sum = 0.0, area = 0.0;
  way = count == 0 ? Way{undefined, undefined} : Way{};
  for (std::size_t i = 0; i < count; ++i) {
    sum += samples.areas[i] * squared[i];
    area += samples.areas[i];
    way.maximum = std::max(way.maximum, std::sqrt(squared[i]));
  }
  if (count > 0) way.rms = std::sqrt(sum / area);
  return true;
}

/// A face as triangles, patch by patch; what has no area is left out.
TriangleMesh meshOf(const FaceSample& sample) {
  const int columns = sample.columnCount();
  std::vector<Eigen::RowVector3i> triangles;
  TriangleMesh mesh;
  mesh.vertices.resize(sample.rowCount() * columns, 3);
  const auto add = [&](int a, int b, int c) {
    const Eigen::RowVector3d p = mesh.vertices.row(a), q = mesh.vertices.row(b), r = mesh.vertices.row(c);
    if ((q - p).cross(r - p).norm() > 1e-9) triangles.emplace_back(a, b, c);
  };
  for (int row = 0; row < sample.rowCount(); ++row)
    for (int column = 0; column < columns; ++column)
      mesh.vertices.row(row * columns + column) = sample.point(row, column).transpose();
  for (int patch = 0; patch < FaceLayout::patchCount; ++patch)
    for (int row = sample.firstRow(patch); row + 1 < sample.firstRow(patch + 1); ++row)
      for (int column = 0; column < columns; ++column) {
        const int a = row * columns + column, b = row * columns + (column + 1) % columns;
        add(a, a + columns, b);
        add(b, a + columns, b + columns);
      }
  mesh.triangles.resize(static_cast<int>(triangles.size()), 3);
  for (std::size_t i = 0; i < triangles.size(); ++i) mesh.triangles.row(static_cast<int>(i)) = triangles[i];
  return mesh;
}

/// Triangles that reach into the part of the head that the face covers, on the vertices they use.
TriangleMesh coveredPart(const TriangleMesh& scan, const FaceBand& band) {
  std::vector<Eigen::Vector3i> kept;
  for (int t = 0; t < scan.triangles.rows(); ++t) {
    const auto reaches = [&](int corner) { return band.contains(scan.vertices.row(scan.triangles(t, corner)), 0.0); };
    if (reaches(0) || reaches(1) || reaches(2)) kept.emplace_back(scan.triangles.row(t));
  }
  return withTriangles(scan.vertices, kept);
}

/// The whole comparison: what stays the same for all levels, and the records so far.
class Comparison {
 public:
  Comparison(const FaceCurves& face, const TriangleMesh& scan, const DetailOptions& options, const Progress& progress)
      : face_(face),
        scan_(scan),
        options_(options),
        progress_(progress),
        band_(face.curves),
        toScan_(scan),
        scanFront_(scan, options.spacing,
                   [skin = std::make_shared<RadialSkin>(scan_, band_.axis()), this](const Eigen::Vector3d& p) {
                     const HeadAxis& axis = band_.axis();
                     return counts(p) && axis.radius(p) > skin->radius(axis.azimuth(p), p.y()) - skinDepth;
                   }) {}

  /// False when it was stopped.
  bool measure() {
    addScan();
    return addFaces() && addMeshes();
  }

  std::string describeEmptiness() const {
    return scanFront_.points.empty()
               ? "the scan has no skin before z = " + numberText(options_.frontalThreshold) +
                     " mm between the first and the last curve; are scan and curves of one head, in mm?"
               : std::string();
  }

  const std::vector<DetailRecord>& records() const { return records_; }
  const std::string& fault() const { return fault_; }  ///< of what could not be stored

 private:
  bool counts(const Eigen::Vector3d& point) const {
    return point.z() > options_.frontalThreshold && band_.contains(point, options_.margin);
  }

  /// What follows are so many steps, and takes this part of the time.
  void beginPart(double from, double to, std::size_t steps) {
    part_ = partOf(progress_, from, to);
    steps_ = static_cast<double>(std::max<std::size_t>(1, steps));
    done_ = 0.0;
  }

  bool goOn() const { return goesOn(part_, std::min(1.0, done_ / steps_)); }

  bool add(DetailRecord record, const TriangleMesh& mesh) {
    const Progress step = partOf(part_, std::min(1.0, done_ / steps_), std::min(1.0, (done_ + 1.0) / steps_));
    const SurfaceSamples front(mesh, options_.spacing, [this](const Eigen::Vector3d& p) { return counts(p); });
    Way there, back;
    if (!measureWay(front, toScan_, partOf(step, 0.0, 0.5), there)) return false;
    if (!measureWay(scanFront_, TriangleTree(mesh), partOf(step, 0.5, 1.0), back)) return false;
    if (front.points.empty()) record.detail += ", nothing of it where distances count";
    record.rms = there.rms;
    record.maximum = there.maximum;
    record.backRMS = back.rms;
    record.backMaximum = back.maximum;
    records_.push_back(record);
    ++done_;
    return goOn();
  }

  void addScan() {
    DetailRecord record{"scan", std::to_string(scan_.triangles.rows()) + " triangles"};
    record.bytes = static_cast<long long>(plainMeshSize(scan_));
    record.triangles = scan_.triangles.rows();
    record.curvesRMS = undefined;
    records_.push_back(record);
  }

  bool addFace(const std::string& representation, const std::string& detail, long long bytes,
               const ClosedCurves& curves) {
    DetailRecord record{representation, detail, bytes};
    record.curvesRMS = std::sqrt((curves.points - face_.curves.points).rowwise().squaredNorm().mean());
    FaceCurves face = face_;
    face.curves = curves;
    const FaceSample sample(face, options_.surface, faceRows, faceColumns);
    return add(record, meshOf(sample));
  }

  bool addFaces() {
    const int k = face_.curves.pointsPerCurve;
    beginPart(0.0, facePart, static_cast<std::size_t>(1 + k / 2) + options_.tolerances.size());
    const auto sizeOf = [&](int modes) { return static_cast<long long>(modeNumberCount(k, modes) * sizeof(float)); };
    if (!addFace("PDE face", "K = " + std::to_string(k), sizeOf(k / 2), face_.curves)) return false;
    for (int n = 1; n <= k / 2; ++n)
      if (!addFace("modes", "N = " + std::to_string(n), sizeOf(n), firstModes(face_.curves, n))) return false;
    for (const double tolerance : options_.tolerances)
      if (!addCompact(tolerance)) return false;
    return true;
  }

  bool addCompact(double tolerance) {
    std::string bytes;
    CompactFace compact;
    fault_ = encodeCompactFace(face_, "", tolerance, bytes);
    if (fault_.empty()) fault_ = decodeCompactFace(bytes, compact);
    return fault_.empty() && addFace("compact face", numberText(tolerance) + " mm",
                                     static_cast<long long>(bytes.size()), compact.face.curves);
  }

  /// Bytes of the faces, largest first; those that hardly differ once.
  std::vector<double> sizes() const {
    std::vector<double> bytes;
    for (const DetailRecord& record : records_)
      if (record.triangles == 0) bytes.push_back(static_cast<double>(record.bytes));
    std::sort(bytes.rbegin(), bytes.rend());
    bytes.erase(
        std::unique(bytes.begin(), bytes.end(), [](double kept, double next) { return next > sizeShare * kept; }),
        bytes.end());
    return bytes;
  }

  /// A closed mesh has two triangles for each vertex: 12 bytes of coordinates for two, 6 of indices for each.
  bool addMeshes() {
    constexpr double bytesPerTriangle = 12.0;
    const TriangleMesh part = coveredPart(scan_, band_);
    std::vector<int> plain;
    for (const double bytes : sizes())
      plain.push_back(std::max(fewestLevelTriangles, static_cast<int>(bytes / bytesPerTriangle)));
    std::vector<Packed> packed;
    beginPart(facePart, 0.5 * (1.0 + facePart), plain.size());
    const auto take = [&](const TriangleMesh& mesh) {
      const bool further = addMesh("decimated mesh", static_cast<long long>(plainMeshSize(mesh)), mesh, mesh);
      const DetailRecord& record = records_.back();
      const double step = std::max(finestStep, record.rms);
      packed.push_back(
          {static_cast<double>(mesh.triangles.rows()), static_cast<double>(packedMeshSize(mesh, step)), record.rms});
      return further;
    };
    return decimateInSteps(part, plain, take, whileGoingOn()) && addPackedMeshes(part, packed);
  }

  struct Packed {
    double triangles, bytes, rms;
  };

  /// Triangles that pack into so many bytes, from what the plain meshes packed into: a power law between the nearest
  /// sizes.
  static double trianglesFor(double bytes, const std::vector<Packed>& known) {
    std::size_t i = 0;
    while (i + 2 < known.size() && known[i + 1].bytes > bytes) ++i;
    const Packed &more = known[i], &fewer = known[std::min(i + 1, known.size() - 1)];
    if (more.bytes <= fewer.bytes) return more.triangles * bytes / more.bytes;
    const double power = std::log(more.triangles / fewer.triangles) / std::log(more.bytes / fewer.bytes);
    return fewer.triangles * std::pow(bytes / fewer.bytes, power);
  }

  /// Coordinates are rounded to about the distance that decimation leaves, which falls with the number of triangles.
  bool addPackedMeshes(const TriangleMesh& part, const std::vector<Packed>& known) {
    std::vector<int> counts;
    for (const double bytes : sizes())
      counts.push_back(std::max(fewestLevelTriangles, static_cast<int>(trianglesFor(bytes, known))));
    beginPart(0.5 * (1.0 + facePart), 1.0, counts.size());
    const auto take = [&](const TriangleMesh& mesh) {
      const double triangles = static_cast<double>(mesh.triangles.rows());
      const Packed* nearest = &known.front();
      for (const Packed& one : known)
        if (std::abs(std::log(one.triangles / triangles)) < std::abs(std::log(nearest->triangles / triangles)))
          nearest = &one;
      const double step = std::max(finestStep, nearest->rms * nearest->triangles / triangles);
      return addMesh("packed mesh", static_cast<long long>(packedMeshSize(mesh, step)), mesh, roundedMesh(mesh, step));
    };
    return decimateInSteps(part, counts, take, whileGoingOn());
  }

  /// Decimation takes little of a step, but a step can be stopped in it.
  Progress whileGoingOn() const {
    return [this](double) { return goOn(); };
  }

  bool addMesh(const std::string& representation, long long bytes, const TriangleMesh& mesh,
               const TriangleMesh& shown) {
    if (records_.back().representation == representation && records_.back().triangles == mesh.triangles.rows()) {
      ++done_;
      return goOn();  // no edge could collapse
    }
    DetailRecord record{representation, std::to_string(mesh.triangles.rows()) + " triangles", bytes,
                        mesh.triangles.rows()};
    record.curvesRMS = undefined;
    return add(record, shown);
  }

  static constexpr double finestStep = 0.05;  // mm
  static constexpr double facePart = 0.4;     // of the time that all levels take
  static constexpr double sizeShare = 0.85;   // of one size, above which another needs no mesh of its own

  const FaceCurves& face_;
  const TriangleMesh& scan_;
  const DetailOptions& options_;
  const Progress& progress_;
  FaceBand band_;
  TriangleTree toScan_;
  SurfaceSamples scanFront_;
  Progress part_;
  double steps_ = 1.0, done_ = 0.0;
  std::vector<DetailRecord> records_;
  std::string fault_;
};

std::string describeFault(const DetailOptions& options) {
  if (options.tolerances.empty()) return "there is no tolerance; give at least one, such as 0.1 mm";
  for (const double tolerance : options.tolerances)
    if (!(tolerance >= CompactFaceLimits::finest && tolerance <= CompactFaceLimits::coarsest))
      return "a tolerance of " + numberText(tolerance) + " mm is not allowed; give " +
             numberText(CompactFaceLimits::finest) + " to " + numberText(CompactFaceLimits::coarsest) + " mm";
  if (!(options.spacing >= 0.1 && options.spacing <= 20.0))
    return "a spacing of " + numberText(options.spacing) + " mm is not allowed; give 0.1 to 20 mm";
  return {};
}

}  // namespace

std::string measureLevelsOfDetail(const FaceCurves& face, const TriangleMesh& scan, const DetailOptions& options,
                                  const Progress& progress, std::vector<DetailRecord>& records) {
  std::string fault = describeFault(options);
  if (fault.empty()) fault = describeFault(options.surface, face.curves.pointsPerCurve);
  if (!fault.empty()) return fault;
  Comparison comparison(face, scan, options, progress);
  fault = comparison.describeEmptiness();
  if (!fault.empty()) return fault;
  const bool whole = comparison.measure();
  if (whole) records = comparison.records();
  return comparison.fault();
}

}  // namespace mien
