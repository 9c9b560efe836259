#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "FAPPlotFigure.h"
#include "SessionPart.h"

class QHBoxLayout;
class QLabel;
class QListWidget;
class QListWidgetItem;
class QTimer;

namespace mien {

class AnimationPlayer;
class FaceModel;
class FigureView;

/// How do the FAPs of the animation go over time? Those chosen in a list, which is the legend as well; the line is the
/// frame shown, and dragging it scrubs.
class FAPPlotPanel : public QWidget, public SessionPart {
  Q_OBJECT
 public:
  FAPPlotPanel(FaceModel* model, AnimationPlayer* player, QWidget* parent = nullptr);
  ~FAPPlotPanel() override;

  double shownBegin() const { return begin_; }  ///< s
  double shownEnd() const { return end_; }      ///< s

  nlohmann::json sessionState() const override;  ///< `faps`: those that the user has chosen; {} before that
  QString changeName() const override { return tr("plotted FAPs"); }
  void restoreSession(const nlohmann::json& state) override;

 protected:
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QWidget* controls();
  void connectAll();
  void followAnimation();
  void followGrowth();
  void listFAPs();
  void choose();
  void chooseSome();
  void select(const std::vector<int>& faps);
  void followChoice();
  void addChosen(QListWidgetItem* item);
  void followFrame();
  void followRange();
  void zoom(double time, double factor);
  void showTimes(double begin, double end);
  void draw();
  void drawSwatches();
  double duration() const;
  Figure fullFigure() const;
  std::string numbers() const;

  FaceModel* model_;
  AnimationPlayer* player_;
  FigureView* figure_;
  QListWidget* list_;
  QLabel* hint_;
  std::vector<PlottedFAP> chosen_;
  double begin_ = 0.0, end_ = 1.0;  ///< s
  double known_ = 0.0;              ///< s, of the animation when its FAPs were listed
  QTimer* growth_;
  bool outdated_ = true;
  std::optional<std::vector<int>> asked_;  ///< what the user has chosen, in the order of the list
};

}  // namespace mien
