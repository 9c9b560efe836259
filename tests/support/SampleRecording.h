#pragma once

#include <Eigen/Geometry>
#include <sstream>

#include "DeformationTable.h"
#include "PointTable.h"
#include "RegionMap.h"

/// Markers on a lattice over the whole face, each moved by the map of its region: what a fit must find again. Between
/// the two states the head moves, turns about z and comes nearer.
class SampleRecording {
 public:
  enum class Axes { Millimetres, Pixels };  ///< with z and y up, or without z and y down

  explicit SampleRecording(const mien::DeformationTable& table) {
    const mien::FacialRegions regions = regionMap();
    add("pupil_left", {1.0, 0.0}, {1.0, 0.0}, 0);
    add("pupil_right", {-1.0, 0.0}, {-1.0, 0.0}, 0);
    for (double y = -4.0; y < 2.0; y += 0.2)
      for (double x = -2.4; x <= 2.4; x += 0.2) {
        const Eigen::Vector2d point(x + 0.03 * std::sin(40.0 * y), y);
        if (!regions.covers(point)) continue;
        const int region = regions.nearest(point);
        add("m" + std::to_string(rows_.size()), point, table.maps[region - 1].apply(point), region);
      }
  }

  std::string recording(Axes axes = Axes::Millimetres) const {
    const bool depth = axes == Axes::Millimetres;
    std::string text = depth ? "marker,neutral_x,neutral_y,neutral_z,expression_x,expression_y,expression_z\n"
                             : "marker,neutral_x,neutral_y,expression_x,expression_y\n";
    for (const Row& row : rows_)
      text += row.name + cells(row.before, axes, false) + cells(row.after, axes, true) + "\n";
    return text;
  }

  std::string state(bool after, Axes axes = Axes::Millimetres) const {
    std::string text = axes == Axes::Millimetres ? "marker,x,y,z\n" : "marker,x,y\n";
    for (const Row& row : rows_) text += row.name + cells(after ? row.after : row.before, axes, after) + "\n";
    return text;
  }

  std::string markerIn(int region, int skip = 0) const {
    for (const Row& row : rows_)
      if (row.region == region && skip-- == 0) return row.name;
    return {};
  }
  std::size_t size() const { return rows_.size(); }  ///< with both pupils

  static std::string cells(const Eigen::Vector2d& point, Axes axes, bool after) {
    const Eigen::Vector2d turned = Eigen::Rotation2Dd(after ? 0.05 : -0.08) * point;
    std::ostringstream text;
    text.precision(17);
    if (axes == Axes::Millimetres)
      text << "," << (after ? 33.0 : 31.0) * turned.x() + 2.0 << "," << (after ? 33.0 : 31.0) * turned.y() + 36.0
           << ",82.5";
    else
      text << "," << (after ? 210.0 : 180.0) * turned.x() + 640.0 << ","
           << 400.0 - (after ? 210.0 : 180.0) * turned.y();
    return text.str();
  }

 private:
  struct Row {
    std::string name;
    Eigen::Vector2d before, after;
    int region;
  };
  void add(const std::string& name, const Eigen::Vector2d& before, const Eigen::Vector2d& after, int region) {
    rows_.push_back({name, before, after, region});
  }
  std::vector<Row> rows_;
};
