#pragma once

#include <QWidget>
#include <string>

class QComboBox;
class QSpinBox;

namespace mien {

class ValueSlider;

/// One of the two visemes that a face mixes: which, and how strong. For the first row its widgets are named
/// visemeName1, visemeSlider1 and visemePercent1.
class VisemeRow : public QWidget {
  Q_OBJECT
 public:
  /// @param number  from 1
  explicit VisemeRow(int number, QWidget* parent = nullptr);

  /// Without a signal. @param name  empty: none
  void show(const std::string& name, int percent);
  std::string name() const;  ///< empty: none

 signals:
  void chosen(const QString& name);  ///< by the user; empty: none
  void percentEdited(int percent);

 private:
  void build(int number);

  QComboBox* name_;
  ValueSlider* slider_;
  QSpinBox* percent_;
};

}  // namespace mien
