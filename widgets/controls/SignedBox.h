#pragma once

#include <QDoubleSpinBox>
#include <QSpinBox>

#include "RealMinus.h"

namespace mien {

/// A field for a number that writes the minus sign of the labels and figures beside it (U+2212), and reads that of the
/// keyboard as well; and that takes a point and a comma for the decimal sign, whichever the language has: Qt takes the
/// other one for what groups digits, so that 2,5 would be 25. Box is QSpinBox or QDoubleSpinBox, Number what it holds.
template <class Box, class Number>
class SignedBox : public Box {
 public:
  using Box::Box;

  QString textFromValue(Number value) const override { return withRealMinus(Box::textFromValue(value)); }
  Number valueFromText(const QString& text) const override { return Box::valueFromText(typed(text)); }
  QValidator::State validate(QString& text, int& position) const override {
    QString read = typed(text);
    const QValidator::State state = Box::validate(read, position);
    text = withRealMinus(read);
    return state;
  }

 private:
  QString typed(QString text) const {
    for (const QChar sign : {'.', ','}) text.replace(sign, this->locale().decimalPoint());
    return text.replace(QChar(0x2212), '-');
  }
};

using SignedNumberBox = SignedBox<QDoubleSpinBox, double>;
using SignedWholeBox = SignedBox<QSpinBox, int>;

}  // namespace mien
