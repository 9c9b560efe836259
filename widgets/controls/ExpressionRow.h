#pragma once

#include <QWidget>

class QPushButton;
class QSpinBox;

namespace mien {

class ValueSlider;

/// One expression of a mixture: its name, which chooses it alone, and how strong it is.
/// For joy they are named expression_joy, expressionSlider_joy and expressionPercent_joy.
class ExpressionRow : public QWidget {
  Q_OBJECT
 public:
  /// @param definition  what the expression looks like
  ExpressionRow(const QString& name, const QString& definition, QWidget* parent = nullptr);

  void setPercent(int percent);  ///< without a signal

 signals:
  void percentEdited(int percent);
  void chosenAlone(bool chosen);  ///< by a click on the name; false: the neutral face

 private:
  void build(const QString& name, const QString& definition);

  QPushButton* name_;
  ValueSlider* slider_;
  QSpinBox* percent_;
};

}  // namespace mien
