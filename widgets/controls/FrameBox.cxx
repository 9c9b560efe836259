#include "FrameBox.h"

#include <QLineEdit>
#include <QLocale>
#include <algorithm>

#include "FaceModel.h"

namespace mien {

namespace {

QString numberOf(const FAPSequence& motion, int place) {
  if (motion.frames.empty()) return QString::number(place);
  const int last = static_cast<int>(motion.frames.size()) - 1;
  return QString::number(motion.frames[std::clamp(place - 1, 0, last)].number, 'g', QLocale::FloatingPointShortest);
}

}  // namespace

FrameBox::FrameBox(FaceModel* model, QWidget* parent) : QSpinBox(parent), model_(model) {
  setKeyboardTracking(false);
  setAlignment(Qt::AlignRight);
  setButtonSymbols(QAbstractSpinBox::NoButtons);
  setToolTip(
      tr("Frame and last frame, by their numbers in the file (most begin with 0), as in figures, tables and mien"));
}

void FrameBox::follow() {
  const int count = model_->frameCount();
  setRange(1, std::max(1, count));
  setSuffix(count > 0 ? tr(" / %1").arg(numberOf(model_->motion(), count)) : QString());
  lineEdit()->setText(textFromValue(value()) + suffix());
}

QString FrameBox::textFromValue(int value) const {
  return numberOf(model_->motion(), value);
}

std::optional<int> FrameBox::placeOf(const QString& text) const {
  bool isNumber = false;
  const double number = text.section('/', 0, 0).trimmed().toDouble(&isNumber);
  const auto index = isNumber ? model_->motion().indexOfNumber(number) : std::nullopt;
  return index ? std::make_optional(static_cast<int>(*index) + 1) : std::nullopt;
}

/// Numbers may repeat in a file: that of the frame shown means this one.
int FrameBox::valueFromText(const QString& text) const {
  if (text.section('/', 0, 0).trimmed() == textFromValue(value())) return value();
  return placeOf(text).value_or(value());
}

/// A number that no frame has may become one by further digits; if not, the frame stays.
QValidator::State FrameBox::validate(QString& text, int&) const {
  const QString typed = text.section('/', 0, 0).trimmed();
  bool isNumber = false;
  typed.toDouble(&isNumber);
  if (!isNumber && !typed.isEmpty() && typed != "-") return QValidator::Invalid;
  return placeOf(text) ? QValidator::Acceptable : QValidator::Intermediate;
}

}  // namespace mien
