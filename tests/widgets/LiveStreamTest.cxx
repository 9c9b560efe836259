#include <unistd.h>

#include <QLabel>
#include <QSpinBox>

#include "AnimationPlayer.h"
#include "FAPText.h"
#include "FaceModel.h"
#include "StudioFixture.h"

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

TEST_F(LiveStream, ManyAtOnceArePlayedAtTheirRate) {
  send("2.1 live 100 0\n" + lids(0, 29));
  ASSERT_TRUE(waitUntil([this] { return window->player().isPlaying(); }));
  ASSERT_TRUE(waitUntil([this] { return window->model().frameIndex() == 29 && !window->player().isPlaying(); }));
  EXPECT_FALSE(window->player().loops()) << "while the stream is open its end is not the end";
  endStream();
  ASSERT_TRUE(waitUntil([this] { return window->player().loops(); }));
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
