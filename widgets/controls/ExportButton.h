#pragma once

#include <QToolButton>

#include "Exporter.h"

namespace mien {

/// A button that writes what a dock shows, asking how.
class ExportButton : public QToolButton {
  Q_OBJECT
 public:
  ExportButton(const QString& objectName, FaceModel* model, Exporter::Drawing drawing,
               std::function<std::string()> numbers, QWidget* parent = nullptr);

  /// @sa Exporter::write
  bool write(const QString& fileName, const ExportOptions& options = ExportOptions()) const {
    return exporter_->write(fileName, options);
  }

 private:
  Exporter* exporter_;
};

}  // namespace mien
