#include <vtkAlgorithm.h>
#include <vtkPolyData.h>

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QFile>
#include <QLabel>
#include <QMimeData>
#include <QRegularExpression>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QToolButton>
#include <QUrl>
#include <algorithm>
#include <cmath>

#include "CoefficientTable.h"
#include "DeformationChoice.h"
#include "ElidedLabel.h"
#include "ExportButton.h"
#include "FaceModel.h"
#include "FigureView.h"
#include "FitBar.h"
#include "NamedTables.h"
#include "RangeDelegate.h"
#include "StudioFixture.h"
#include "TableStatistics.h"

namespace {

class DeformationPanel : public StudioFixture {
 protected:
  DeformationPanel() {
    find<QAction>("deformationDockAction")->trigger();
    figure = find<mien::FigureView>("deformationFigure");
    cells = find<mien::CoefficientTable>("deformationCoefficients");
    EXPECT_TRUE(waitUntil([this] { return !cells->text().empty(); }));
  }

  std::vector<double> points() {
    std::vector<double> all;
    vtkPolyData* skin = surface();
    for (vtkIdType i = 0; i < skin->GetNumberOfPoints(); ++i) {
      const double* place = skin->GetPoint(i);
      all.insert(all.end(), place, place + 3);
    }
    return all;
  }

  static double rmsBetween(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(3.0 * sum / double(a.size()));
  }

  void choose(const QString& name) {
    auto* box = find<QComboBox>("deformationTable");
    const int row = box->findText(name);
    ASSERT_GE(row, 0) << name.toStdString();
    box->setCurrentIndex(row);
    settle();
  }

  void show(const char* expression) {
    window->model().change([&](mien::FaceState& state) {
      state.expressions.clear();
      state.expressions[expression] = 1.0;
    });
  }

  bool waitForName(const QString& name) {
    auto* label = find<QLabel>("deformationExpression");
    return waitUntil([&] { return label->isVisible() && label->text().startsWith("Nearest: " + name + ", "); });
  }

  QImage face() {
    settle();
    return find<QWidget>("faceView")->grab().toImage();
  }

  const mien::FaceDeformation& chosen() { return window->model().state().deformation; }

  mien::FigureView* figure;
  mien::CoefficientTable* cells;
  QTemporaryDir folder;
};

TEST_F(DeformationPanel, ATableMovesTheFaceAndNoneBringsItBack) {
  const std::vector<double> rest = points();
  choose("Joy");
  EXPECT_EQ(chosen().table, "joy");
  EXPECT_GT(rmsBetween(points(), rest), 0.5);
  choose("None");
  EXPECT_EQ(points(), rest);
}

TEST_F(DeformationPanel, StrengthZeroIsTheNeutralFaceBitForBit) {
  const std::vector<double> rest = points();
  choose("Surprise");
  const double whole = rmsBetween(points(), rest);
  find<QSpinBox>("deformationPercent")->setValue(50);
  EXPECT_NEAR(rmsBetween(points(), rest), 0.5 * whole, 1e-4 * whole);
  EXPECT_EQ(find<QSlider>("deformationStrength")->value(), 50);
  find<QSlider>("deformationStrength")->setValue(0);
  EXPECT_EQ(points(), rest);
  EXPECT_EQ(find<QSpinBox>("deformationPercent")->value(), 0);
}

TEST_F(DeformationPanel, HardAndSmoothDiffer) {
  choose("Surprise");
  const std::vector<double> smooth = points();
  find<QCheckBox>("deformationBlend")->click();
  EXPECT_FALSE(chosen().smooth);
  EXPECT_GT(rmsBetween(points(), smooth), 0.01);
}

TEST_F(DeformationPanel, TheNeutralFaceHasNothingToFitOrName) {
  EXPECT_FALSE(find<QToolButton>("deformationUse")->isEnabled());
  EXPECT_FALSE(find<QLabel>("deformationExpression")->isVisible());
  EXPECT_TRUE(figure->figure().panels.empty());
}

TEST_F(DeformationPanel, EveryExpressionIsNamedByItsOwnMeanTable) {
  for (const char* name : {"Anger", "Disgust", "Fear", "Joy", "Sadness", "Surprise"}) {
    choose(name);
    EXPECT_TRUE(waitForName(QString(name).toLower())) << name;
  }
}

TEST_F(DeformationPanel, JoyIsFittedNamedAndUsedAgain) {
  const std::vector<double> rest = points();
  show("joy");
  ASSERT_TRUE(waitForName("joy"));
  const std::vector<double> joy = points();
  QTest::mouseClick(find<QToolButton>("deformationUse"), Qt::LeftButton);
  EXPECT_TRUE(window->model().state().expressions.empty());
  EXPECT_EQ(find<QComboBox>("deformationTable")->currentText(), "Fit 1");
  EXPECT_LT(rmsBetween(points(), joy), 0.5 * rmsBetween(rest, joy));
  EXPECT_TRUE(waitForName("joy"));
  EXPECT_EQ(message(), "");
}

TEST_F(DeformationPanel, APinnedFaceIsWhereFitsBegin) {
  show("surprise");
  ASSERT_TRUE(waitForName("surprise"));
  auto* pin = find<QToolButton>("deformationPin");
  QTest::keyClick(pin, Qt::Key_Space);
  EXPECT_TRUE(waitUntil([&] { return !find<QToolButton>("deformationUse")->isEnabled(); }));
  show("joy");
  EXPECT_TRUE(waitUntil([&] { return find<QToolButton>("deformationUse")->isEnabled(); }));
  QTest::keyClick(pin, Qt::Key_Space);
  EXPECT_TRUE(waitForName("joy"));
}

TEST_F(DeformationPanel, APinnedFaceKeepsItsTable) {
  choose("Joy");
  find<QSpinBox>("deformationPercent")->setValue(200);
  ASSERT_TRUE(waitForName("joy"));
  QTest::keyClick(find<QToolButton>("deformationPin"), Qt::Key_Space);
  auto* status = find<QLabel>("deformationStatus");
  EXPECT_TRUE(waitUntil([&] { return status->text().contains("The present face is A"); }))
      << status->text().toStdString();
  EXPECT_TRUE(status->text().startsWith("A: pinned: deformation table joy at 2.")) << status->text().toStdString();
  EXPECT_FALSE(find<QToolButton>("deformationUse")->isEnabled());
  choose("None");
  EXPECT_TRUE(waitUntil([&] { return status->text().contains("RMS"); }));
  EXPECT_FALSE(find<QToolButton>("deformationUse")->isEnabled()) << "one table at a time bends a face";
}

TEST_F(DeformationPanel, AFaceThatDoesNotMoveMarksNoCoefficient) {
  for (int i = 0; i < 192; ++i)
    EXPECT_FALSE(cells->item(i / 12, i % 12)->data(mien::RangeDelegate::outsideRole).toBool()) << i;
  EXPECT_EQ(cells->text().find("mean_"), std::string::npos);
}

TEST_F(DeformationPanel, TheBoundaryCurvesMoveWithTheFace) {
  choose("Surprise");
  const auto of = [this](vtkAlgorithm* curves) { return vtkPolyData::SafeDownCast(curves->GetOutputDataObject(0)); };
  vtkPolyData *rest = of(window->model().pipeline().curves()), *moved = of(window->model().pipeline().shownCurves());
  double largest = 0.0;
  for (vtkIdType i = 0; i < rest->GetNumberOfPoints(); ++i)
    largest = std::max(largest, std::abs(moved->GetPoint(i)[1] - rest->GetPoint(i)[1]));
  EXPECT_GT(largest, 15.0) << "mm; the jaw of a surprised face, whose surface goes down by 16.7";
}

TEST_F(DeformationPanel, ASavedFitIsATableAgain) {
  show("joy");
  ASSERT_TRUE(waitForName("joy"));
  auto* bar = find<QToolButton>("deformationSave")->parentWidget();
  auto* fit = qobject_cast<mien::FitBar*>(bar);
  ASSERT_NE(fit, nullptr);
  const QString name = folder.filePath("joy.csv");
  EXPECT_TRUE(fit->save(name));
  mien::DeformationTable table;
  EXPECT_EQ(mien::readNamedTable(name.toStdString(), table), "");
  EXPECT_GT(table.largestDisplacement, 0.05);
  QFile text(name);
  ASSERT_TRUE(text.open(QIODevice::ReadOnly));
  const QByteArray saved = text.readAll();
  EXPECT_EQ(saved.count('#'), 1) << "one line says what it is";
  EXPECT_FALSE(saved.left(saved.indexOf('\n')).contains('/'));
  EXPECT_FALSE(fit->save(folder.filePath("there_is_no_folder/joy.csv")));
  EXPECT_TRUE(message().contains("there_is_no_folder")) << message().toStdString();
}

TEST_F(DeformationPanel, AFileWithAFaultLeavesTheFaceAndSaysWhere) {
  choose("Joy");
  const std::vector<double> before = points();
  const QString name = folder.filePath("bad.csv");
  QFile file(name);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("region,a1\n1,0\n");
  file.close();
  auto* choice = qobject_cast<mien::DeformationChoice*>(find<QComboBox>("deformationTable")->parentWidget());
  ASSERT_NE(choice, nullptr);
  EXPECT_FALSE(choice->open(name));
  EXPECT_TRUE(message().contains("bad.csv:1")) << message().toStdString();
  EXPECT_EQ(points(), before);
  EXPECT_EQ(find<QComboBox>("deformationTable")->findData(name), -1);
}

TEST_F(DeformationPanel, ADroppedTableBendsTheFace) {
  const QString name = folder.filePath("mine.csv");
  ASSERT_TRUE(QFile::copy(QString(MIEN_TEST_DIR) + "/../data/deformation/fear.csv", name));
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(name)});
  QDragEnterEvent enter(QPoint(5, 5), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(find<QWidget>("deformationPanel"), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(5, 5), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(find<QWidget>("deformationPanel"), &drop);
  EXPECT_EQ(chosen().table, name.toStdString());
  EXPECT_EQ(find<QComboBox>("deformationTable")->currentText(), "mine");
}

TEST_F(DeformationPanel, RegionsAreShownOneStandsOutAndSkinEndsThem) {
  const QImage skin = face();
  auto* button = find<QToolButton>("deformationRegions");
  QTest::mouseClick(button, Qt::LeftButton);
  const QImage regions = face();
  EXPECT_NE(regions, skin);
  cells->setCurrentCell(11, 3);
  const QImage lip = face();
  EXPECT_NE(lip, regions);
  QTest::keyClick(cells, Qt::Key_Down);
  EXPECT_EQ(cells->chosenRegion(), 13);
  EXPECT_NE(face(), lip);
  QTest::mouseClick(find<QToolButton>("faceSkin"), Qt::LeftButton);
  EXPECT_FALSE(button->isChecked());
  EXPECT_EQ(face(), skin);
  QTest::keyClick(cells, Qt::Key_Return);
  EXPECT_TRUE(button->isChecked());
}

TEST_F(DeformationPanel, AStatusWithoutRoomEndsInDots) {
  show("joy");
  ASSERT_TRUE(waitForName("joy"));
  auto* status = find<mien::ElidedLabel>("deformationStatus");
  EXPECT_TRUE(
      QRegularExpression("^RMS 0\\.\\d{3} pu, up to 0\\.\\d{3} pu \\(region \\d+\\)$").match(status->text()).hasMatch())
      << status->text().toStdString();
  EXPECT_EQ(find<mien::ElidedLabel>("deformationOrigin")->text(), "A: the face at rest");
  status->resize(2000, status->height());
  EXPECT_EQ(status->shownText(), status->text());
  status->resize(150, status->height());
  EXPECT_TRUE(status->shownText().endsWith(QChar(0x2026))) << status->shownText().toStdString();
  EXPECT_TRUE(status->text().startsWith(status->shownText().chopped(1).trimmed()));
  EXPECT_LE(status->fontMetrics().horizontalAdvance(status->shownText()), 150);
  EXPECT_GT(status->shownText().size(), 8);
}

TEST_F(DeformationPanel, NumbersOutsideTheRangeAreRedAndBoldAndNoOthers) {
  choose("Smile");
  find<QComboBox>("deformationShown")->setCurrentIndex(1);
  find<QComboBox>("deformationMean")->setCurrentText("joy");
  const std::vector<int> outside = mien::outsideRange(*mien::namedTable("smile"), *mien::namedTable("joy"));
  ASSERT_FALSE(outside.empty());
  std::vector<int> marked;
  for (int i = 0; i < 192; ++i) {
    const QTableWidgetItem* cell = cells->item(i / 12, i % 12);
    EXPECT_EQ(cell->font().bold(), cell->data(mien::RangeDelegate::outsideRole).toBool()) << i;
    EXPECT_LT(QFontMetrics(cell->font()).horizontalAdvance(cell->text()), cells->columnWidth(i % 12) - 3) << i;
    if (cell->font().bold()) marked.push_back(i);
  }
  EXPECT_TRUE(std::includes(outside.begin(), outside.end(), marked.begin(), marked.end()));
  EXPECT_GT(4 * marked.size(), 3 * outside.size()) << "only what reads as the limit is not marked";
  const auto* detail = find<mien::ElidedLabel>("deformationDetail");
  EXPECT_EQ(detail->text().toStdString(),
            "Red and bold: outside mean \u00b1 sd of joy by 1 in the last decimal or more");
}

/// In a window of the usual size.
TEST_F(DeformationPanel, TheAnswerIsReadWholeAndItsBarsAreSeen) {
  window->resize(1280, 800);
  find<QAction>("actionWorkspace3")->trigger();
  show("surprise");
  ASSERT_TRUE(waitForName("surprise"));
  settle();
  const auto* answer = find<mien::ElidedLabel>("deformationExpression");
  EXPECT_EQ(answer->shownText(), answer->text());
  EXPECT_TRUE(answer->toolTip().contains("of the mean surprise table")) << answer->toolTip().toStdString();
  EXPECT_GE(figure->pixelOf(0, 0.0, 0.0).y() - figure->pixelOf(0, 0.0, 0.2).y(), 36.0);
}

TEST_F(DeformationPanel, AClickedBarChoosesItsRange) {
  show("joy");
  ASSERT_TRUE(waitForName("joy"));
  QTest::mouseClick(figure, Qt::LeftButton, Qt::NoModifier, figure->pixelOf(0, 5, 0).toPoint());
  EXPECT_EQ(find<QComboBox>("deformationMean")->currentText(), "surprise");
  QTest::keyClick(figure, Qt::Key_Left);
  EXPECT_EQ(find<QComboBox>("deformationMean")->currentText(), "sadness");
  EXPECT_EQ(*figure->marked(), 4.0);
}

TEST_F(DeformationPanel, WritesAndCopiesItsNumbers) {
  show("joy");
  ASSERT_TRUE(waitForName("joy"));
  auto* button = find<mien::ExportButton>("deformationExport");
  const QString name = folder.filePath("coefficients.csv");
  EXPECT_TRUE(button->write(name));
  QFile csv(name);
  ASSERT_TRUE(csv.open(QIODevice::ReadOnly));
  const QByteArray text = csv.readAll();
  EXPECT_EQ(text.count('\n'), 193);
  EXPECT_TRUE(text.startsWith("region,name,coefficient,value,mean_joy,sd,range\n1,right forehead,a1,"));
  EXPECT_TRUE(button->write(folder.filePath("expression.svg")));
  EXPECT_GT(QFile(folder.filePath("expression.svg")).size(), 2000);
  find<QAction>("deformationCopy")->trigger();
  EXPECT_EQ(QApplication::clipboard()->text().toUtf8(), text);
}

TEST_F(DeformationPanel, TheNeutralFaceIsWithoutATable) {
  choose("Anger");
  find<QAction>("actionNeutral")->trigger();
  settle();
  EXPECT_EQ(chosen().table, "");
  EXPECT_EQ(find<QComboBox>("deformationTable")->currentText(), "None");
}

TEST_F(DeformationPanel, EveryControlIsNamedExplainedAndReachedByKeyboard) {
  for (const char* name :
       {"deformationTable", "deformationOpen", "deformationStrength", "deformationPercent", "deformationBlend",
        "deformationRegions", "deformationExport", "deformationPin", "deformationUse", "deformationSave",
        "deformationShown", "deformationMean", "deformationCoefficients", "deformationFigure"}) {
    auto* control = find<QWidget>(name);
    EXPECT_FALSE(control->toolTip().isEmpty()) << name;
    EXPECT_TRUE(control->focusPolicy() & Qt::TabFocus) << name;
  }
}

}  // namespace
