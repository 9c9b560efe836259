#include <gtest/gtest.h>

#include <QTest>
#include <QWidget>

#include "FaceModel.h"
#include "LiveUpdate.h"

namespace {

/// What a dock shows on the face follows it while the dock itself is hidden, and only then.
TEST(LiveUpdate, FollowsWhatIsSeen) {
  mien::FaceModel model(nullptr);
  QWidget dock;
  bool isOnFace = false;
  int refreshed = 0;
  new mien::LiveUpdate(
      &model, &dock, [&] { ++refreshed; }, [&] { return isOnFace; });
  const auto change = [&](double joy) {
    model.change([joy](mien::FaceState& state) { state.expressions["joy"] = joy; });
    EXPECT_TRUE(model.update());
    QTest::qWait(150);
  };
  change(0.2);
  EXPECT_EQ(refreshed, 0) << "nobody sees it";
  isOnFace = true;
  change(0.4);
  EXPECT_EQ(refreshed, 1);
  isOnFace = false;
  change(0.6);
  EXPECT_EQ(refreshed, 1);
  dock.show();
  QTest::qWait(150);
  EXPECT_EQ(refreshed, 2) << "what was missed is made up when the dock is shown";
}

}  // namespace
