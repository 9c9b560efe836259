#include <unistd.h>

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QSpinBox>
#include <QToolButton>
#include <algorithm>
#include <atomic>
#include <iostream>
#include <streambuf>

#include "AnimationPlayer.h"
#include "FAPText.h"
#include "FaceModel.h"
#include "LiveMotion.h"
#include "MotionField.h"
#include "StudioFixture.h"
#include "VectorPanel.h"

namespace {

/// A pipe that a stream is written to.
class LiveStream : public StudioFixture {
 protected:
  LiveStream() {
    int ends[2] = {-1, -1};
    EXPECT_EQ(pipe(ends), 0);
    output_ = ends[0];
    input_ = ends[1];
    window->playStream(output_);
  }
  ~LiveStream() override {
    window.reset();  // its thread reads the pipe
    endStream();
    ::close(output_);
  }
  void send(const std::string& text) {
    EXPECT_EQ(write(input_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  void endStream() {
    if (input_ >= 0) ::close(input_);
    input_ = -1;
  }
  /// Frames that close the left lid.
  static std::string lids(int first, int last) {
    std::string text;
    for (int frame = first; frame <= last; ++frame)
      text += maskText({19}) + "\n" + std::to_string(frame) + " " + std::to_string(20 * frame) + "\n";
    return text;
  }
  int frames() { return window->model().frameCount(); }

 private:
  int output_ = -1, input_ = -1;
};

TEST_F(LiveStream, FramesAreShownAsTheyCome) {
  drawViews();
  send("2.1 live 25 0\n" + lids(0, 0));
  ASSERT_TRUE(waitUntil([this] { return frames() == 1; }));
  EXPECT_EQ(find<QLabel>("timelineTitle")->text(), "Live stream");
  send(lids(1, 2));
  ASSERT_TRUE(waitUntil([this] { return frames() == 3 && window->model().frameIndex() == 2; }));
  settle();
  EXPECT_GT(largestDisplacement(), 0.1);
  EXPECT_EQ(find<QSpinBox>("timelineFrame")->value(), 3);
  EXPECT_EQ(window->model().shownFAP(19), 40.0);
  send(maskText({19}) + "\n3 ");
  settle();
  EXPECT_EQ(frames(), 3) << "half a line is no frame yet";
  send("600\n");
  ASSERT_TRUE(waitUntil([this] { return frames() == 4; }));
  endStream();
  ASSERT_TRUE(waitUntil([this] { return message().contains("4 frames"); })) << message().toStdString();
}

TEST_F(LiveStream, ManyAtOnceShowTheNewest) {
  std::vector<int> shown;
  QObject::connect(&window->model(), &mien::FaceModel::updated, [&] { shown.push_back(window->model().frameIndex()); });
  send("2.1 live 25 0\n" + lids(0, 0));
  ASSERT_TRUE(waitUntil([this] { return frames() == 1; }));
  send(lids(1, 30));
  ASSERT_TRUE(waitUntil([this] { return frames() == 31 && window->model().frameIndex() == 30; }));
  EXPECT_FALSE(window->player().isPlaying());
  EXPECT_EQ(window->player().rangeEnd(), 30);
  settle();
  EXPECT_EQ(window->model().shownFAP(19), 600.0);
  EXPECT_TRUE(std::is_sorted(shown.begin(), shown.end())) << "never backwards";
  EXPECT_LT(shown.size(), 31u) << "those in between are left out";
}

TEST_F(LiveStream, AFirstBatchOfManyIsNotPlayedAgain) {
  send("2.1 live 25 0\n" + lids(0, 29));
  ASSERT_TRUE(waitUntil([this] { return frames() == 30 && window->model().frameIndex() == 29; }));
  for (int first = 30; first < 90; first += 15) {
    send(lids(first, first + 14));
    ASSERT_TRUE(waitUntil([&] { return frames() == first + 15 && window->model().frameIndex() == first + 14; }));
  }
  endStream();
  ASSERT_TRUE(waitUntil([this] { return message().contains("90 frames"); })) << message().toStdString();
  EXPECT_EQ(window->model().frameIndex(), 89);
  window->player().play();
  EXPECT_TRUE(window->player().isPlaying()) << "all of it can be played when it has ended";
  EXPECT_EQ(window->player().rangeEnd(), 89);
}

TEST_F(LiveStream, WhoGoesBackStaysThereUntilTheNewestIsShownAgain) {
  send("2.1 live 25 0\n" + lids(0, 9));
  ASSERT_TRUE(waitUntil([this] { return window->model().frameIndex() == 9; }));
  window->player().setRange(2, 5);
  window->model().showFrame(4);
  send(lids(10, 12));
  ASSERT_TRUE(waitUntil([this] { return frames() == 13; }));
  EXPECT_EQ(window->model().frameIndex(), 4);
  EXPECT_EQ(window->player().rangeEnd(), 5) << "an end that was set stays";
  window->model().showFrame(12);
  send(lids(13, 14));
  EXPECT_TRUE(waitUntil([this] { return window->model().frameIndex() == 14; }));
}

TEST_F(LiveStream, AFAPWithoutSurfaceThatComesLaterIsSaidOnce) {
  send("2.1 live 25 0\n" + lids(0, 1));
  ASSERT_TRUE(waitUntil([this] { return frames() == 2; }));
  EXPECT_EQ(message(), "");
  send(maskText({19, 23}) + "\n2 40 50\n");
  ASSERT_TRUE(waitUntil([this] { return message().contains("FAP 23 (eyeballs)"); })) << message().toStdString();
  find<QToolButton>("messageClose")->click();
  send(maskText({19, 23}) + "\n3 40 60\n");
  ASSERT_TRUE(waitUntil([this] { return frames() == 4; }));
  EXPECT_EQ(message(), "");
}

/// Says when somebody reads it.
class Watched : public std::streambuf {
 public:
  std::atomic<bool> wasRead{false};

 protected:
  int_type underflow() override {
    wasRead = true;
    return traits_type::eof();
  }
};

TEST_F(LiveStream, OtherPipelinesDoNotReadStandardInput) {
  Watched input;
  std::streambuf* usual = std::cin.rdbuf(&input);
  send("2.1 live 25 0\n" + lids(0, 9));
  ASSERT_TRUE(waitUntil([this] { return window->model().frameIndex() == 9; }));
  find<QAction>("vectorsDockAction")->trigger();
  auto* panel = find<mien::VectorPanel>("vectorPanel");
  const auto most = [panel] {
    return panel->motion().result().field ? panel->motion().result().field->magnitudes().maxCoeff() : 0.0;
  };
  EXPECT_TRUE(waitUntil([&] { return most() > 0.1; }, 30000)) << panel->motion().result().fault.toStdString();
  const double present = largestDisplacement();
  EXPECT_NEAR(most(), present, 0.05 * present);
  EXPECT_EQ(panel->motion().result().request.moved.fapValues.at(19), 180.0);
  find<QToolButton>("vectorsPin")->click();
  EXPECT_TRUE(waitUntil([&] { return most() < 1e-9; }, 30000));
  find<QComboBox>("vectorsAgainst")->setCurrentIndex(1);
  EXPECT_TRUE(waitUntil([&] { return most() > 1e-3 && most() < 0.5 * present; }, 30000)) << "against the frame before";
  window.reset();
  std::cin.rdbuf(usual);
  EXPECT_FALSE(input.wasRead);
}

TEST_F(LiveStream, AWrongLineIsToldAndTheFramesStay) {
  send("2.1 live 25 0\n" + lids(0, 1) + "0 1 2\n");
  ASSERT_TRUE(waitUntil([this] { return message().startsWith("standard input:6:"); })) << message().toStdString();
  EXPECT_EQ(frames(), 2);
}

TEST_F(LiveStream, AnotherFileEndsIt) {
  send("2.1 live 25 0\n" + lids(0, 1));
  ASSERT_TRUE(waitUntil([this] { return frames() == 2; }));
  ASSERT_TRUE(window->openAnimation(writeLids(11, 5)));
  send(lids(2, 3));
  settle();
  QTest::qWait(300);
  EXPECT_EQ(frames(), 11);
}

TEST_F(LiveStream, TheWindowMayCloseWhileItIsOpen) {
  send("2.1 live 25 0\n" + lids(0, 1));
  window.reset();
  SUCCEED();
}

}  // namespace
