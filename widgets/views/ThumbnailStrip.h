#pragma once

#include <QImage>
#include <QWidget>
#include <vector>

class QToolButton;

namespace mien {

/// Small pictures of the face at a few values of a, fewer where there is no room; choosing one sets a.
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

  QSize sizeHint() const override;         ///< of all
  QSize minimumSizeHint() const override;  ///< of the first and the last

 signals:
  void chosen(double a);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showSome();

  std::vector<QToolButton*> buttons_;
  std::vector<Picture> pictures_;
};

}  // namespace mien
