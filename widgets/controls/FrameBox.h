#pragma once

#include <QSpinBox>
#include <optional>

namespace mien {

class FaceModel;

/// The frame of an animation by its number in the file, which is how the command line, figures and tables count it too;
/// behind it the number of the last. The value is the frame's place, from 1.
class FrameBox : public QSpinBox {
  Q_OBJECT
 public:
  FrameBox(FaceModel* model, QWidget* parent);

  void follow();  ///< another animation, or more of it

 protected:
  QString textFromValue(int value) const override;
  int valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& position) const override;

 private:
  std::optional<int> placeOf(const QString& text) const;

  FaceModel* model_;
};

}  // namespace mien
