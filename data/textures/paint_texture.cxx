/// Paints the texture that comes with Mien: a face from the front, drawn over the boundary curves of the generic face,
/// and its warp mesh. usage: paint_texture FOLDER   writes FOLDER/painted.png, FOLDER/painted.csv (19 x 21 points) and
/// FOLDER/painted_7x7.csv
///
/// Everything is drawn in mm as the face is seen from the front (x to the subject's left, y up); no other picture is
/// used.
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <random>

#include "BoundaryCurveData.h"
#include "FaceLayout.h"
#include "FaceWarpLayout.h"
#include "WarpMeshText.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace {

constexpr double pixelsPerMillimetre = 3.5;
constexpr int finer = 3;  // drawn larger by this and reduced: smooth edges
constexpr double left = -78.0, top = 120.0, width = 156.0, height = 204.0;  // of the picture, mm

using Random = std::mt19937;  // the same numbers everywhere, unlike the library's distributions

double uniform(Random& random, double low, double high) {
  return low + (high - low) * (random() / 4294967296.0);
}

QColor faded(QColor colour, double opacity) {
  colour.setAlphaF(std::clamp(opacity, 0.0, 1.0));
  return colour;
}

QPointF between(QPointF a, QPointF b, double share) {
  return a + share * (b - a);
}

/// One face on one picture.
class Painting {
 public:
  explicit Painting(const mien::FaceCurves& face)
      : face_(face), image_(size(finer), QImage::Format_RGB32), painter_(&image_) {
    image_.fill(edge);
    painter_.setRenderHint(QPainter::Antialiasing);
    painter_.scale(finer * pixelsPerMillimetre, -finer * pixelsPerMillimetre);
    painter_.translate(-left, -top);
  }

  QImage paint() {
    paintSkin();
    for (const double side : {-1.0, 1.0}) {
      paintEye(side);
      paintBrow(side);
      paintNostril(side);
    }
    paintLips();
    paintFreckles();
    painter_.end();
    const QImage reduced = image_.scaled(size(1), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    return withGrain(reduced);
  }

 private:
  const QColor skin{226, 182, 158}, edge{206, 160, 136}, red{196, 96, 84}, shade{132, 82, 66}, light{248, 218, 196};
  const QColor hair{66, 44, 33}, lash{38, 24, 20}, lip{176, 92, 88}, dark{92, 38, 36};

  static QSize size(int factor) {
    return {int(width * pixelsPerMillimetre) * factor, int(height * pixelsPerMillimetre) * factor};
  }

  /// Where a curve is, so many degrees of v from the midline towards the side.
  QPointF at(const char* curve, double degrees) const {
    const Eigen::Vector3d point = face_.curves.at(mien::FaceLayout::curveIndex(curve), M_PI * (1.0 + degrees / 180.0));
    return {point.x(), point.y()};
  }

  double degreesOf(const char* feature) const { return 180.0 * (face_.feature(feature)->v / M_PI - 1.0); }

  /// A soft spot of a colour, strongest in its middle.
  void glow(QPointF middle, double radiusX, double radiusY, const QColor& colour, double opacity) {
    painter_.save();
    painter_.translate(middle);
    painter_.scale(radiusX, radiusY);
    QRadialGradient gradient(0, 0, 1);
    for (int i = 0; i <= 8; ++i)
      gradient.setColorAt(i / 8.0, faded(colour, opacity * std::pow(std::cos(M_PI * i / 16.0), 2)));
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(gradient);
    painter_.drawEllipse(QPointF(0, 0), 1.0, 1.0);
    painter_.restore();
  }

  void stroke(const QPainterPath& path, const QColor& colour, double wide) {
    painter_.setBrush(Qt::NoBrush);
    painter_.setPen(QPen(colour, wide, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter_.drawPath(path);
  }

  /// A line without hard borders.
  void softStroke(const QPainterPath& path, const QColor& colour, double opacity, double wide) {
    constexpr int layers = 8;
    for (int i = 1; i <= layers; ++i) stroke(path, faded(colour, opacity / layers), wide * i / layers);
  }

  static QPainterPath through(const std::vector<QPointF>& points) {
    QPainterPath path(points.front());
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const QPointF before = points[i == 0 ? 0 : i - 1], after = points[std::min(i + 2, points.size() - 1)];
      path.cubicTo(points[i] + (points[i + 1] - before) / 6.0, points[i + 1] - (after - points[i]) / 6.0,
                   points[i + 1]);
    }
    return path;
  }

  void paintSkin() {
    glow({0, 24}, 84, 120, skin, 1.0);
    glow({0, 24}, 70, 104, skin, 0.9);
    glow({0, 84}, 48, 34, light, 0.35);
    for (const double side : {-1.0, 1.0}) {
      glow({side * 39, -1}, 30, 26, red, 0.24);
      glow({side * 30, 22}, 17, 7, shade, 0.16);
      glow({side * 31, 48}, 22, 9, shade, 0.12);
      glow({side * 34, 13}, 16, 8, light, 0.22);
      glow({side * 10, 38}, 8, 14, shade, 0.13);
      glow({side * 52, -40}, 18, 34, shade, 0.12);
    }
    glow({0, 4}, 17, 14, red, 0.24);
    glow({0, 22}, 5, 26, light, 0.28);
    glow({0, -17}, 5, 7, shade, 0.14);
    glow({0, -49}, 20, 6, shade, 0.22);
    glow({0, -64}, 20, 12, red, 0.16);
  }

  QPointF corner(const char* feature) const {
    const double v = degreesOf(feature);
    return between(at("C9", v), at("C10", v), 0.5);
  }

  /// The lid's edge from the inner to the outer corner.
  std::vector<QPointF> lid(const char* curve, double side) const {
    const char *inner = side > 0 ? "3.11" : "3.8", *outer = side > 0 ? "3.7" : "3.12";
    std::vector<QPointF> points = {corner(inner)};
    for (const double share : {0.15, 0.32, 0.5, 0.68, 0.85})
      points.push_back(at(curve, degreesOf(inner) + share * (degreesOf(outer) - degreesOf(inner))));
    points.push_back(corner(outer));
    // Next to the corners the curves of the face stay apart; lids do not.
    points[1] = between(points[1], between(points[0], points[2], 0.5), 0.55);
    points[5] = between(points[5], between(points[4], points[6], 0.5), 0.55);
    return points;
  }

  void paintEye(double side) {
    const std::vector<QPointF> upper = lid("C9", side), lower = lid("C10", side);
    QPainterPath opening = through(upper);
    opening.connectPath(through({lower.rbegin(), lower.rend()}));
    opening.closeSubpath();
    const QPointF middle =
        between(at("C9", degreesOf(side > 0 ? "3.1" : "3.2")), at("C10", degreesOf(side > 0 ? "3.3" : "3.4")), 0.46);
    softStroke(opening, shade, 0.34, 5.0);
    paintEyeball(opening, middle, upper, lower, side);
    std::vector<QPointF> crease;
    constexpr double above[] = {2.6, 3.9, 4.2, 4.2, 4.0, 3.2};
    for (int i = 1; i <= 6; ++i) crease.push_back(upper[i] + QPointF(0, above[i - 1]));
    softStroke(through(crease), shade, 0.5, 2.6);
    softStroke(through(lower), QColor(150, 84, 74), 0.6, 1.3);
    softStroke(through(upper), lash, 1.3, 2.0);
    paintLashes(upper, lower, side);
  }

  void paintEyeball(const QPainterPath& opening, QPointF middle, const std::vector<QPointF>& upper,
                    const std::vector<QPointF>& lower, double side) {
    painter_.save();
    painter_.setClipPath(opening);
    painter_.fillPath(opening, QColor(232, 226, 220));
    glow(lower[0] + QPointF(side * 1.0, 0), 3.4, 3.0, QColor(206, 120, 112), 0.9);
    glow(lower[6], 5.0, 4.0, QColor(196, 140, 126), 0.5);
    constexpr double iris = 5.7;
    glow(middle, iris * 1.16, iris * 1.16, QColor(40, 44, 46), 0.5);
    QRadialGradient colour(middle, iris);
    colour.setColorAt(0.0, QColor(120, 88, 48));
    colour.setColorAt(0.5, QColor(96, 104, 80));
    colour.setColorAt(0.84, QColor(74, 98, 98));
    colour.setColorAt(1.0, QColor(34, 46, 52));
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(colour);
    painter_.drawEllipse(middle, iris, iris);
    Random random(7);
    for (int i = 0; i < 90; ++i) {
      const double angle = uniform(random, 0.0, 2.0 * M_PI), begin = uniform(random, 2.2, 3.4),
                   end = uniform(random, 3.6, 5.3);
      const QPointF way(std::cos(angle), std::sin(angle));
      QPainterPath ray(middle + begin * way);
      ray.lineTo(middle + end * way);
      stroke(ray, faded(i % 2 ? QColor(190, 186, 140) : QColor(28, 36, 36), 0.22), 0.16);
    }
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(QColor(12, 10, 10));
    painter_.drawEllipse(middle, 2.3, 2.3);
    softStroke(through(upper).translated(0, -1.0), QColor(60, 40, 36), 0.75, 5.0);
    glow(middle + QPointF(-1.7, 2.0), 1.1, 1.1, Qt::white, 0.95);
    painter_.restore();
  }

  void paintLashes(const std::vector<QPointF>& upper, const std::vector<QPointF>& lower, double side) {
    Random random(11);
    const QPainterPath above = through(upper), below = through(lower);
    for (int i = 0; i < 74; ++i) {
      const bool up = i < 50;
      const double share = uniform(random, 0.12, 1.0);
      const QPointF root = (up ? above : below).pointAtPercent(share);
      const double length = (up ? 1.5 + 1.7 * share : 1.0) * uniform(random, 0.75, 1.1);
      const QPointF tip = root + length * QPointF(side * (share - 0.35) * 1.1, up ? 0.8 : -0.75);
      QPainterPath hairPath(root);
      hairPath.quadTo(between(root, tip, 0.5) + QPointF(side * 0.25, up ? -0.25 : 0.2), tip);
      stroke(hairPath, faded(lash, up ? 0.75 : 0.35), up ? 0.24 : 0.17);
    }
  }

  void paintBrow(double side) {
    Random random(3);
    const double inner = std::abs(degreesOf("4.1")), outer = std::abs(degreesOf("4.5"));
    const auto middle = [&](double share) {
      return at("C6", side * (inner + share * (outer - inner))) + QPointF(0, -1.2);
    };
    const auto half = [](double share) {
      return share < 0.55 ? 3.4 - 1.0 * share : 2.85 * (1.0 - share) / 0.45 * 0.8 + 0.57;
    };
    for (int i = 0; i <= 30; ++i) {
      const double share = i / 30.0;
      glow(middle(share), 3.4, 1.0 * half(share) + 0.8, hair, share < 0.06 || share > 0.96 ? 0.06 : 0.17);
    }
    for (int i = 0; i < 620; ++i) {
      const double share = std::sqrt(uniform(random, 0.0, 1.0)) * 0.25 + uniform(random, 0.0, 0.76),
                   across = uniform(random, -1.0, 1.0);
      const QPointF root = middle(share) + QPointF(0, across * half(share));
      const QPointF along = middle(std::min(1.0, share + 0.02)) - middle(share - 0.02);
      const double rise = (0.95 - 1.15 * share) - 0.45 * across,
                   length = uniform(random, 2.6, 4.6) * (1.0 - 0.45 * share);
      QPointF way = along / std::hypot(along.x(), along.y()) + QPointF(0, rise);
      way *= length / std::hypot(way.x(), way.y());
      QPainterPath hairPath(root - 0.5 * way);
      hairPath.quadTo(root + QPointF(0, 0.2), root + 0.5 * way);
      stroke(hairPath, faded(hair, uniform(random, 0.25, 0.6)), uniform(random, 0.16, 0.3));
    }
  }

  void paintNostril(double side) {
    glow({side * 6.6, -0.9}, 4.6, 2.4, QColor(70, 34, 28), 0.95);
    glow({side * 6.4, -1.3}, 3.2, 1.5, QColor(40, 18, 16), 0.9);
    softStroke(through({{side * 14.0, 7.4}, {side * 17.2, 3.4}, {side * 17.4, -0.8}, {side * 14.7, -3.8}}), shade,
               0.55, 3.0);
    softStroke(through({{side * 18.5, -2.5}, {side * 24.0, -14.0}, {side * 29.5, -26.0}}), shade, 0.20, 5.0);
    softStroke(through({{side * 3.6, -13.0}, {side * 4.6, -18.0}, {side * 5.4, -22.5}}), light, 0.28, 2.6);
  }

  std::vector<QPointF> lipCurve(const char* curve) const {
    const double mouth = degreesOf("8.3");
    std::vector<QPointF> points = {at("C22", -mouth)};
    for (int i = -6; i <= 6; ++i) {
      const double degrees = mouth * i / 7.0;
      points.push_back(at(curve, degrees));
    }
    points.push_back(at("C22", mouth));
    return points;
  }

  void paintLips() {
    const std::vector<QPointF> upper = lipCurve("C21"), line = lipCurve("C22"), lower = lipCurve("C23");
    const auto between2 = [&](const std::vector<QPointF>& a, const std::vector<QPointF>& b) {
      QPainterPath path = through(a);
      path.connectPath(through({b.rbegin(), b.rend()}));
      path.closeSubpath();
      return path;
    };
    const QPainterPath above = between2(upper, line), below = between2(line, lower);
    for (const QPainterPath& part : {above, below}) softStroke(part, lip, 0.5, 2.6);
    painter_.fillPath(above, faded(QColor(164, 80, 78), 0.82));
    painter_.fillPath(below, faded(QColor(184, 98, 92), 0.82));
    painter_.save();
    painter_.setClipPath(above.united(below));
    Random random(5);
    for (int i = 0; i < 150; ++i) {
      const double x = uniform(random, -22.0, 22.0), y = uniform(random, -41.0, -26.0), drift = 0.05 * x;
      QPainterPath wrinkle(QPointF(x, y));
      wrinkle.lineTo(x + drift, y - uniform(random, 1.0, 3.4));
      stroke(wrinkle, faded(i % 3 ? dark : light, 0.13), 0.3);
    }
    glow({0, -37.4}, 12, 3.0, QColor(238, 178, 168), 0.55);
    glow({0, -27.6}, 9, 2.2, QColor(206, 132, 124), 0.4);
    softStroke(through(line), dark, 0.7, 4.5);
    painter_.restore();
    softStroke(through(line), dark, 1.2, 1.3);
    for (const double side : {-1.0, 1.0}) glow(side > 0 ? line.back() : line.front(), 3.0, 2.2, dark, 0.5);
  }

  void paintFreckles() {
    Random random(17);
    painter_.setPen(Qt::NoPen);
    for (int i = 0; i < 420; ++i) {
      const double x = uniform(random, -52.0, 52.0), y = uniform(random, -20.0, 34.0);
      const double share = std::exp(-std::pow((std::abs(x) - 26.0) / 18.0, 2) - std::pow((y - 10.0) / 12.0, 2));
      const double radius = uniform(random, 0.25, 0.65);
      const bool onEye = std::abs(std::abs(x) - 31.0) < 15.0 && y > 27.0;
      if (uniform(random, 0.0, 1.0) > share || onEye) continue;
      glow({x, y}, 1.5 * radius, 1.3 * radius, QColor(150, 88, 60), 0.55);
    }
  }

  /// Skin is never even: blotches of a few mm, the same in all colours, that end before the sides, which are drawn out
  /// around the head.
  static QImage withGrain(const QImage& smooth) {
    QImage image = smooth;
    Random random(23);
    const QImage coarse = noise(random, 34, 44).scaled(image.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    const QImage medium = noise(random, 110, 144).scaled(image.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const double across = std::abs(2.0 * x / image.width() - 1.0),
                     inside = std::clamp((0.74 - across) / 0.3, 0.0, 1.0);
        const double change =
            inside * (0.034 * (qRed(coarse.pixel(x, y)) - 128) + 0.05 * (qRed(medium.pixel(x, y)) - 128));
        const QRgb p = image.pixel(x, y);
        const auto add = [&](int value) { return std::clamp(int(std::lround(value + change)), 0, 255); };
        image.setPixel(x, y, qRgb(add(qRed(p)), add(qGreen(p)), add(qBlue(p))));
      }
    return image;
  }

  static QImage noise(Random& random, int columns, int rows) {
    QImage image(columns, rows, QImage::Format_RGB32);
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < columns; ++x) {
        const int value = static_cast<int>(random() % 256);
        image.setPixel(x, y, qRgb(value, value, value));
      }
    return image;
  }

  const mien::FaceCurves& face_;
  QImage image_;
  QPainter painter_;
};

/// The mesh of the picture: it shows the generic face itself, so its places are where the face has them.
std::string meshText(const mien::FaceCurves& face, const QImage& picture, mien::FaceWarpLayout::Kind kind) {
  mien::FaceWarpLayout layout;
  layout.set(kind, face);
  return mien::writeWarpMesh(
      mien::frontMesh(layout, face, pixelsPerMillimetre, {left, top}, picture.width(), picture.height()));
}

}  // namespace

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  const QGuiApplication program(argc, argv);
  vtkNew<vtkBoundaryCurveReader> reader;
  reader->Update();
  mien::FaceCurves face;
  if (argc != 2 || !mien::readFaceCurves(reader->GetOutput(), face).empty()) {
    std::cerr << "usage: paint_texture FOLDER\n";
    return 2;
  }
  const std::string name = std::string(argv[1]) + "/painted";
  const QImage picture = Painting(face).paint();
  using Kind = mien::FaceWarpLayout::Kind;
  std::ofstream(name + ".csv") << meshText(face, picture, Kind::Fine);
  std::ofstream(name + "_7x7.csv") << meshText(face, picture, Kind::SevenBySeven);
  return picture.save(QString::fromStdString(name + ".png"), "PNG", 0) ? 0 : 1;
}
