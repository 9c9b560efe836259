#pragma once

#include <QImage>
#include <QWidget>
#include <vector>

class QToolButton;

namespace mien {

/// Small pictures of the face at a few values of a; choosing one sets a.
class ThumbnailStrip : public QWidget {
  Q_OBJECT
 public:
  struct Picture {
    double a;
    QImage image;    ///< null where there is no surface
    QString reason;  ///< why
  };

  static constexpr int count = 5;
  static constexpr int side = 112;  ///< pixels of a picture's height

  explicit ThumbnailStrip(QWidget* parent = nullptr);

  void setPictures(const std::vector<Picture>& pictures);

 signals:
  void chosen(double a);

 private:
  std::vector<QToolButton*> buttons_;
  std::vector<Picture> pictures_;
};

}  // namespace mien
