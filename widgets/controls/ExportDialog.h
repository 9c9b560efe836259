#pragma once

#include <QDialog>

#include "ExportOptions.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QTimer;

namespace mien {

class Exporter;

/// How a figure is to be written, with a preview: the one dialog for all that docks and views show. What is chosen is
/// remembered, but for the width, which suits each figure by itself.
/// @sa Remembered
class ExportDialog : public QDialog {
  Q_OBJECT
 public:
  ExportDialog(Exporter* exporter, QWidget* parent);

  static void ask(Exporter* exporter, QWidget* parent);

  ExportOptions options() const;
  QString ending() const;  ///< "svg", "pdf", "png" or "csv"

  /// @return whether it was written; the dialog is then closed
  bool save(const QString& fileName);

 private:
  void buildControls();
  QWidget* buttons();
  void chooseFile();
  void copy();
  void follow();
  void showPreview();
  void remember() const;

  Exporter* exporter_;
  QComboBox *format_, *theme_;
  QDoubleSpinBox *width_, *dots_;
  QCheckBox* transparent_;
  QLabel *preview_, *size_;
  QTimer* later_;
};

}  // namespace mien
