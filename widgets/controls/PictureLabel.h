#pragma once

#include <QImage>
#include <QLabel>

namespace mien {

/// A picture as large as its place allows, in its own proportions.
class PictureLabel : public QLabel {
  Q_OBJECT
 public:
  explicit PictureLabel(QWidget* parent = nullptr);

  void setPicture(const QImage& picture);
  const QImage& picture() const { return picture_; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  QSize sizeHint() const override { return {240, 120}; }

 private:
  QImage picture_;
};

}  // namespace mien
