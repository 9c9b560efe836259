#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QImage>
#include <QLabel>
#include <algorithm>
#include <cmath>

#include "BackgroundTask.h"
#include "FaceModel.h"
#include "StudioFixture.h"
#include "Theme.h"

namespace {

constexpr int width = 200, height = 125;

/// Of 255, over all channels. Another version of a font or of OpenGL changes about 1; a dock that is missing, a black
/// view or another theme 8 and more, as the test tells of its own pictures.
constexpr double tolerance = 2.5, leastApart = 6.0;

class WindowPicture : public StudioFixture {
 protected:
  ~WindowPicture() override { mien::Theme::apply(mien::Theme::Kind::Light, *qApp); }

  QImage small() {
    drawViews();
    if (QWidget* focus = QApplication::focusWidget()) focus->clearFocus();
    QTest::qWait(700);  // docks begin to compute in the background
    EXPECT_TRUE(waitUntil([&] { return isIdle(); }));
    settle();
    const QImage whole = window->grab().toImage();
    return coarse(whole.scaled(width, height, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
                      .convertToFormat(QImage::Format_RGB888));
  }

  bool isIdle() const {
    const auto tasks = window->findChildren<mien::BackgroundTask*>();
    return std::none_of(tasks.begin(), tasks.end(), [](const mien::BackgroundTask* task) { return task->isRunning(); });
  }

  void workspace(int number) { find<QAction>(QString("actionWorkspace%1").arg(number))->trigger(); }

  static double difference(const QImage& a, const QImage& b) {
    double sum = 0.0;
    for (int y = 0; y < height; ++y)
      for (int i = 0; i < 3 * width; ++i) sum += std::abs(a.constScanLine(y)[i] - b.constScanLine(y)[i]);
    return sum / (3.0 * width * height);
  }

  /// Sixteen steps a channel, for small files; in both pictures, so that what is equal stays equal.
  static QImage coarse(QImage image) {
    for (int y = 0; y < height; ++y)
      for (int i = 0; i < 3 * width; ++i)
        image.scanLine(y)[i] = static_cast<uchar>(17 * std::lround(image.constScanLine(y)[i] / 17.0));
    return image;
  }
};

TEST_F(WindowPicture, FiveStatesLookAsTheyDid) {
  std::vector<std::pair<const char*, QImage>> pictures;
  pictures.emplace_back("start", small());
  window->model().change([](mien::FaceState& state) { state.expressions["joy"] = 1.0; });
  workspace(2);
  pictures.emplace_back("surface", small());
  workspace(3);
  find<QComboBox>("deformationTable")->setCurrentIndex(find<QComboBox>("deformationTable")->findText("Surprise"));
  pictures.emplace_back("deform", small());
  workspace(4);
  find<QComboBox>("colorBy")->setCurrentText("Patches");
  pictures.emplace_back("acquire", small());
  find<QAction>("actionDark")->trigger();
  workspace(1);
  pictures.emplace_back("dark", small());
  const QDir folder(MIEN_TEST_DIR "/data/window");
  for (size_t i = 0; i < pictures.size(); ++i) {
    const auto& [name, picture] = pictures[i];
    const QString file = folder.filePath(QString("%1.png").arg(name));
    if (qEnvironmentVariableIsSet("MIEN_WRITE_WINDOW_PICTURES")) picture.save(file, "PNG", 0);
    const QImage expected = QImage(file).convertToFormat(QImage::Format_RGB888);
    ASSERT_EQ(expected.size(), picture.size()) << name;
    const double apart = difference(picture, expected);
    EXPECT_LT(apart, tolerance) << name;
    if (apart >= tolerance) picture.save(QDir::temp().filePath(QString("mien_window_%1.png").arg(name)));
    for (size_t other = 0; other < i; ++other)
      EXPECT_GT(difference(picture, pictures[other].second), leastApart) << name << " " << pictures[other].first;
  }
}

}  // namespace
