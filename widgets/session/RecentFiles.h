#pragma once

#include <QObject>
#include <QStringList>

namespace mien {

/// The files that were opened or saved last, the newest first; remembered from one start to the next.
/// @sa Remembered
class RecentFiles : public QObject {
  Q_OBJECT
 public:
  static constexpr int most = 10;

  explicit RecentFiles(QObject* parent);

  const QStringList& files() const { return files_; }

 public slots:
  void add(const QString& fileName);
  void remove(const QString& fileName);
  void clear();

 signals:
  void changed();

 private:
  void keep();

  QStringList files_;
};

}  // namespace mien
