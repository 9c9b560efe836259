#include "FaceThumbnail.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace mien {

namespace {

constexpr int oversampling = 2;  // pixels of the drawing per pixel of the picture, for smooth edges
constexpr double thumbnailMargin = 1.1;
constexpr double farAway = 4.0;  // of the face's height: a portrait lens, as in the views

/// Triangles with a depth and a light at each corner, nearest ones in front.
class DepthPainter {
 public:
  struct Corner {
    double x, y, depth, light;  // pixels, pixels, mm towards the viewer, 0 .. 1
  };

  DepthPainter(const QSize& size, const QColor& skin)
      : image_(size, QImage::Format_ARGB32_Premultiplied),
        depth_(size_t(size.width()) * size.height(), -1e300),
        skin_(skin) {
    image_.fill(Qt::transparent);
  }

  void triangle(const Corner& a, const Corner& b, const Corner& c) {
    const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if (!(std::abs(area) > 1e-12)) return;
    const auto span = [](double p, double q, double r, int end) {
      return std::pair<int, int>(std::clamp<double>(std::floor(std::min({p, q, r})), 0, end),
                                 std::clamp<double>(std::ceil(std::max({p, q, r})), 0, end));
    };
    const auto [left, right] = span(a.x, b.x, c.x, image_.width());
    const auto [top, bottom] = span(a.y, b.y, c.y, image_.height());
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x) {
        const double px = x + 0.5, py = y + 0.5;
        const double s = ((px - a.x) * (c.y - a.y) - (c.x - a.x) * (py - a.y)) / area;
        const double t = ((b.x - a.x) * (py - a.y) - (px - a.x) * (b.y - a.y)) / area;
        if (s < 0 || t < 0 || s + t > 1) continue;
        set(x, y, a.depth + s * (b.depth - a.depth) + t * (c.depth - a.depth),
            a.light + s * (b.light - a.light) + t * (c.light - a.light));
      }
  }

  const QImage& image() const { return image_; }

 private:
  void set(int x, int y, double depth, double light) {
    double& nearest = depth_[size_t(y) * image_.width() + x];
    if (depth <= nearest) return;
    nearest = depth;
    const auto part = [light](int color) { return std::clamp(static_cast<int>(color * light), 0, 255); };
    image_.setPixel(x, y, qRgb(part(skin_.red()), part(skin_.green()), part(skin_.blue())));
  }

  QImage image_;
  std::vector<double> depth_;
  QColor skin_;
};

/// Key from the upper left, as in the views; the side that is turned away is as light as the one turned to the viewer.
double lightOn(const SurfaceJet& jet) {
  static const Eigen::Vector3d key = Eigen::Vector3d(-0.45, 0.55, 0.8).normalized();
  Eigen::Vector3d normal = jet.su.cross(jet.sv);
  const double length = normal.norm();
  if (!(length > 0.0)) return 0.5;
  normal /= normal.z() < 0.0 ? -length : length;
  return 0.22 + 0.86 * std::max(0.0, normal.dot(key));
}

}  // namespace

void ThumbnailStyle::frame(const FaceCurves& face) {
  const auto& points = face.curves.points;
  const Eigen::Vector3d least = points.colwise().minCoeff(), most = points.colwise().maxCoeff();
  middle = 0.5 * (least + most);
  distance = farAway * (most.y() - least.y());
  low = high = seen(middle);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::Vector2d place = seen(points.row(i).transpose());
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
}

/// A surface that is no face may come as near as it likes.
Eigen::Vector2d ThumbnailStyle::seen(const Eigen::Vector3d& point) const {
  const double nearer = std::min(point.z() - middle.z(), 0.5 * distance);
  return middle.head<2>() + distance / (distance - nearer) * (point - middle).head<2>();
}

QImage faceThumbnail(const FaceSample& sample, const ThumbnailStyle& style) {
  const QSize drawn = style.size * oversampling;
  DepthPainter painter(drawn, style.skin);
  const Eigen::Vector2d extent = thumbnailMargin * (style.high - style.low), centre = 0.5 * (style.low + style.high);
  const double scale = std::min(drawn.width() / extent.x(), drawn.height() / extent.y());
  const int columns = sample.columnCount();
  std::vector<DepthPainter::Corner> corners;
  for (int row = 0; row < sample.rowCount(); ++row)
    for (int column = 0; column < columns; ++column) {
      const SurfaceJet jet = sample.jet(row, column);
      const Eigen::Vector2d at = scale * (style.seen(jet.s) - centre);
      corners.push_back({0.5 * drawn.width() + at.x(), 0.5 * drawn.height() - at.y(), jet.s.z(), lightOn(jet)});
    }
  for (int patch = 0; patch < FaceLayout::patchCount; ++patch)
    for (int row = sample.firstRow(patch); row + 1 < sample.firstRow(patch + 1); ++row)
      for (int column = 0; column < columns; ++column) {
        const int right = (column + 1) % columns;
        const auto &a = corners[row * columns + column], &b = corners[row * columns + right];
        const auto &c = corners[(row + 1) * columns + right], &d = corners[(row + 1) * columns + column];
        painter.triangle(a, b, c);
        painter.triangle(a, c, d);
      }
  return painter.image().scaled(style.size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

}  // namespace mien
