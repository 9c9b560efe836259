#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "MeshText.h"

namespace mien {

/// Collects the vertices and then the faces of a mesh file.
class MeshBuilder {
 public:
  void addVertex(const double (&place)[3]) { places_.insert(places_.end(), place, place + 3); }
  std::int64_t vertexCount() const { return static_cast<std::int64_t>(places_.size() / 3); }

  /// Splits the face around its first corner (from 0). `line` is 0 in binary files.
  void addPolygon(const std::vector<std::int64_t>& corners, std::int64_t line);

  /// Three corners that are vertices, which no polygon of the file needs to be.
  void addTriangle(std::int64_t a, std::int64_t b, std::int64_t c);

  /// Counts a polygon of so many corners.
  void count(std::size_t corners);

  /// Says in the end that the face counted next has a corner that is no vertex, whose number is as the file has it.
  void noteLost(std::int64_t corner, std::int64_t line);

  /// @return the first face with a corner that is no vertex; else nothing, and the mesh is in `read`
  std::optional<MeshFault> finish(MeshText& read) const;

 private:
  std::vector<double> places_;
  std::vector<int> corners_;
  PolygonCounts polygons_;
  std::int64_t faces_ = 0, lost_ = 0, lostCorner_ = 0, lostFace_ = 0, lostLine_ = 0;
};

}  // namespace mien
