#include "MeshSeries.h"

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <algorithm>

#include "ScanMesh.h"

namespace mien {

namespace {

/// Hands the number of collapses on as progress, and the wish to stop to the decimater.
class Watch : public OpenMesh::Decimater::Observer {
 public:
  /// @param collapses  that there will be
  Watch(const Progress& progress, double collapses)
      : Observer(interval), progress_(progress), collapses_(std::max(1.0, collapses)) {}

  void begin() { before_ = last_; }
  void notify(std::size_t step) override {
    last_ = before_ + static_cast<double>(step);
    stopped_ = stopped_ || !goesOn(progress_, std::min(1.0, last_ / collapses_));
  }
  bool abort() const override { return stopped_; }

 private:
  static constexpr std::size_t interval = 500;  // collapses, about a millisecond

  const Progress& progress_;
  double collapses_, before_ = 0.0, last_ = 0.0;
  bool stopped_ = false;
};

}  // namespace

bool decimateInSteps(const TriangleMesh& mesh, const std::vector<int>& triangles,
                     const std::function<bool(const TriangleMesh&)>& take, const Progress& progress) {
  const QuietOpenMesh quiet;
  ScanMesh scan = toScanMesh(mesh);
  OpenMesh::Decimater::DecimaterT<ScanMesh> decimater(scan);
  OpenMesh::Decimater::ModQuadricT<ScanMesh>::Handle quadric;
  decimater.add(quadric);
  decimater.initialize();
  // a collapse takes two triangles away
  Watch watch(progress, triangles.empty() ? 0.0 : 0.5 * static_cast<double>(mesh.triangles.rows() - triangles.back()));
  decimater.set_observer(&watch);
  for (const int count : triangles) {
    watch.begin();
    decimater.decimate_to_faces(0, static_cast<size_t>(count));
    if (watch.abort()) return false;
    scan.garbage_collection();  // else the next step counts what is deleted as well; quadrics move along
    if (!take(toTriangleMesh(scan))) return false;
  }
  return true;
}

bool decimate(TriangleMesh& mesh, int triangles, const Progress& progress) {
  if (mesh.triangles.rows() <= triangles) return true;
  const auto take = [&mesh](const TriangleMesh& decimated) {
    mesh = decimated;
    return true;
  };
  return decimateInSteps(mesh, {triangles}, take, progress);
}

}  // namespace mien
