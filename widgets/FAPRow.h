#pragma once

#include <QWidget>

class QDoubleSpinBox;
class QLabel;
class QToolButton;

namespace mien {

struct FAPDefinition;
class ValueSlider;

/// One FAP: name, slider, number, unit, what that is in mm, and reset.
/// Its slider, spin box and reset button are named fapSlider53, fapValue53 and fapReset53.
class FAPRow : public QWidget {
  Q_OBJECT
 public:
  FAPRow(const FAPDefinition& fap, double millimetresPerUnit, QWidget* parent = nullptr);

  int fap() const { return fap_; }
  double value() const;

  void setValue(double value);       ///< without a signal
  void setShownValue(double value);  ///< what the face shows, with animation and expression

 signals:
  void valueEdited(int fap, double value);

 private:
  void build(const FAPDefinition& fap);
  void display(double value);
  void edit(double value);

  int fap_;
  double millimetresPerUnit_;
  ValueSlider* slider_;
  QDoubleSpinBox* number_;
  QLabel* length_;
  QToolButton* reset_;
};

}  // namespace mien
