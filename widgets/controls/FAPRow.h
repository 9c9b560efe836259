#pragma once

#include <QWidget>

#include "FAPUnit.h"

class QDoubleSpinBox;
class QLabel;
class QToolButton;

namespace mien {

struct FAPDefinition;
class ValueSlider;

/// One FAP: name, slider, number, unit, what that is in mm or degrees, and reset.
/// Its slider, spin box and reset button are named fapSlider53, fapValue53 and fapReset53.
class FAPRow : public QWidget {
  Q_OBJECT
 public:
  FAPRow(const FAPDefinition& fap, double millimetresPerUnit, QWidget* parent = nullptr);

  int fap() const { return fap_; }
  double value() const;

  void setValue(double value);            ///< without a signal
  void setShownValue(double value);       ///< what the face shows, with animation and expression
  void setPartnerShown(bool shown);       ///< whether a mark tells that the FAP has a partner on the other side
  void setReason(const QString& whyNot);  ///< why the FAP cannot be set; empty: it can

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 signals:
  void valueEdited(int fap, double value);

 private:
  void build(const FAPDefinition& fap);
  void buildSlider(const FAPDefinition& fap);
  void buildNumber(const FAPDefinition& fap);
  void layOut();
  void display(double value);
  void explain(const QString& tip);
  void showTips();
  void edit(double value);

  int fap_;
  FAPUnit unit_;
  double millimetresPerUnit_;
  bool hasPartner_;
  bool isMoreShown_ = false;  ///< than is set here
  QString tip_;
  ValueSlider* slider_;
  QDoubleSpinBox* number_;
  QLabel *name_, *length_;
  QToolButton* reset_;
};

}  // namespace mien
