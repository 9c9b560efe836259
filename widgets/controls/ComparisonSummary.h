#pragma once

#include <QLabel>
#include <QPointer>

namespace mien {

/// The numbers of a comparison and what they are of, "A to B: RMS 0.65, 95 % .., max .. mm": on one line, or where that
/// does not hold all of it on two or more, what they are of before the colon first. Nothing is left out. A twin has as
/// many lines, so that the views above both are equally high.
class ComparisonSummary : public QLabel {
  Q_OBJECT
 public:
  explicit ComparisonSummary(QWidget* parent = nullptr);

  void setTwin(ComparisonSummary* twin);
  void setSummary(const QString& summary);
  QString summary() const { return summary_; }

  QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QStringList lines(const QString& summary) const;
  int linesNeeded() const;
  void layOut();
  void takeHeight(int lines);

  QString summary_;
  QPointer<ComparisonSummary> twin_;
};

}  // namespace mien
