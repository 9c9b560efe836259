#include "MeshCode.h"

#include <cmath>
#include <cstdint>
#include <deque>
#include <map>
#include <vector>

#include "ByteWriter.h"
#include "EntropyCode.h"

namespace mien {

namespace {

constexpr int none = -1;
constexpr int newVertex = 0, rim = 1;  // codes: a vertex whose position follows, an edge with nothing behind it

/// Walks a mesh and writes each triangle as seen from the one before it.
class MeshWalk {
 public:
  MeshWalk(const TriangleMesh& mesh, double step) : mesh_(mesh), step_(step), number_(mesh.vertices.rows(), none) {
    for (int t = 0; t < mesh.triangles.rows(); ++t)
      for (int i = 0; i < 3; ++i) atEdge_[{corner(t, i), corner(t, i + 1)}] = t;
    done_.assign(mesh.triangles.rows(), false);
    for (int t = 0; t < mesh.triangles.rows(); ++t)
      if (!done_[t]) walkFrom(t);
  }

  std::size_t packedSize() const {
    return packBytes(connections_.bytes()).size() + packBytes(positions_.bytes()).size();
  }

 private:
  struct Gate {
    int from, to, behind;  ///< the edge as the next triangle has it, and the vertex of this one that is not on it
  };

  int corner(int triangle, int i) const { return mesh_.triangles(triangle, i % 3); }

  Eigen::Vector3d steps(int vertex) const { return (mesh_.vertices.row(vertex).transpose() / step_).array().round(); }

  void walkFrom(int triangle) {
    Eigen::Vector3d expected = Eigen::Vector3d::Zero();
    for (int i = 0; i < 3; ++i) {
      write(corner(triangle, i), expected);
      expected = steps(corner(triangle, i));
    }
    finish(triangle, none);
    while (!gates_.empty()) {
      const Gate gate = gates_.front();
      gates_.pop_front();
      pass(gate);
    }
  }

  void pass(const Gate& gate) {
    const auto found = atEdge_.find({gate.from, gate.to});
    if (found == atEdge_.end()) return connections_.whole(rim);
    if (done_[found->second]) return;
    const int triangle = found->second;
    for (int i = 0; i < 3; ++i)
      if (corner(triangle, i) == gate.from) {
        write(corner(triangle, i + 2), steps(gate.from) + steps(gate.to) - steps(gate.behind));
        finish(triangle, i);
        return;
      }
  }

  /// @param entered  the edge through which the walk came, which leads nowhere
  void finish(int triangle, int entered) {
    done_[triangle] = true;
    for (int i = 0; i < 3; ++i)
      if (i != entered) gates_.push_back({corner(triangle, i + 1), corner(triangle, i), corner(triangle, i + 2)});
  }

  /// An old vertex by how many came after it, behind the two codes that stand for something else.
  void write(int vertex, const Eigen::Vector3d& expected) {
    if (number_[vertex] != none) return connections_.whole(rim + count_ - number_[vertex]);
    connections_.whole(newVertex);
    number_[vertex] = count_++;
    const Eigen::Vector3d differences = steps(vertex) - expected;
    for (const double difference : differences) positions_.signedWhole(std::llround(difference));
  }

  const TriangleMesh& mesh_;
  double step_;
  std::vector<int> number_;
  std::vector<bool> done_;
  std::map<std::pair<int, int>, int> atEdge_;
  std::deque<Gate> gates_;
  int count_ = 0;
  ByteWriter connections_, positions_;
};

}  // namespace

std::size_t plainMeshSize(const TriangleMesh& mesh) {
  const std::size_t vertices = mesh.vertices.rows(), triangles = mesh.triangles.rows();
  const std::size_t indexSize = vertices > (std::size_t(1) << 16) ? sizeof(std::uint32_t) : sizeof(std::uint16_t);
  return vertices * 3 * sizeof(float) + triangles * 3 * indexSize;
}

TriangleMesh roundedMesh(const TriangleMesh& mesh, double step) {
  TriangleMesh rounded = mesh;
  rounded.vertices = (mesh.vertices.array() / step).round() * step;
  return rounded;
}

std::size_t packedMeshSize(const TriangleMesh& mesh, double step) {
  return MeshWalk(mesh, step).packedSize();
}

}  // namespace mien
