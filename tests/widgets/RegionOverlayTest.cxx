/// The numbers of the 16 regions on the face.
#include <vtkBillboardTextActor3D.h>
#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkFacialRegionFilter.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkStructuredGrid.h>

#include <Eigen/Core>
#include <QAction>
#include <QToolButton>
#include <cstdlib>
#include <set>
#include <vector>

#include "FaceModel.h"
#include "FaceView.h"
#include "StudioFixture.h"

namespace {

/// A region's number as it is seen: view coordinates, -1 .. 1 over the view.
struct SeenNumber {
  int region;
  Eigen::Vector3d place;
};

std::vector<SeenNumber> numbersIn(vtkRenderer* renderer) {
  std::vector<SeenNumber> numbers;
  vtkPropCollection* props = renderer->GetViewProps();
  for (int i = 0; i < props->GetNumberOfItems(); ++i) {
    auto* text = vtkBillboardTextActor3D::SafeDownCast(props->GetItemAsObject(i));
    if (!text || !text->GetVisibility()) continue;
    Eigen::Vector3d place(text->GetPosition());
    renderer->WorldToView(place.x(), place.y(), place.z());
    numbers.push_back({std::atoi(text->GetInput()), place});
  }
  return numbers;
}

/// The region that is seen at a place of the view: of the nearest point whose skin looks there.
int regionSeenAt(vtkRenderer* renderer, vtkPointSet* face, const Eigen::Vector3d& at) {
  vtkDataArray *regions = face->GetPointData()->GetArray("Region"), *normals = face->GetPointData()->GetNormals();
  const Eigen::Vector3d camera(renderer->GetActiveCamera()->GetPosition());
  double least = 1e300;
  int region = 0;
  for (vtkIdType i = 0; i < face->GetNumberOfPoints(); ++i) {
    Eigen::Vector3d place(face->GetPoint(i)), normal(normals->GetTuple3(i));
    if (normal.dot(camera - place) < 0.0) continue;
    renderer->WorldToView(place.x(), place.y(), place.z());
    const double distance = (place - at).head<2>().norm();
    if (distance >= least) continue;
    least = distance;
    region = static_cast<int>(regions->GetTuple1(i));
  }
  return region;
}

class RegionOverlay : public StudioFixture {
 protected:
  RegionOverlay() {
    find<QAction>("deformationDockAction")->trigger();
    QTest::mouseClick(find<QToolButton>("deformationRegions"), Qt::LeftButton);
    renderer = find<mien::FaceView>("faceView")->renderer();
  }

  void show(const std::string& expression) {
    window->model().change([&](mien::FaceState& state) {
      state.expressions.clear();
      if (!expression.empty()) state.expressions[expression] = 1.0;
    });
    drawViews();
    renderer->GetRenderWindow()->Render();
  }

  std::set<int> regionsSeen() {
    std::set<int> seen;
    for (const SeenNumber& number : numbersIn(renderer)) EXPECT_TRUE(seen.insert(number.region).second);
    return seen;
  }

  /// As one sees them, and all of each number.
  void expectOverTheirRegions(const std::string& when, const std::set<int>& which = {}) {
    vtkNew<vtkFacialRegionFilter> face;
    face->SetInputData(window->model().pipeline().grid());
    face->Update();
    auto* points = vtkPointSet::SafeDownCast(face->GetOutputDataObject(0));
    for (const SeenNumber& number : numbersIn(renderer)) {
      if (!which.empty() && !which.count(number.region)) continue;
      EXPECT_EQ(regionSeenAt(renderer, points, number.place), number.region) << when;
      EXPECT_LT(number.place.head<2>().cwiseAbs().maxCoeff(), 0.97) << when << " region " << number.region;
    }
  }

  vtkRenderer* renderer;
};

TEST_F(RegionOverlay, EveryRegionShowsItsNumberWithinTheView) {
  for (const char* expression : {"", "joy", "surprise"}) {
    show(expression);
    expectOverTheirRegions(expression);
    EXPECT_EQ(regionsSeen().size(), 16u) << expression;
  }
}

TEST_F(RegionOverlay, NumbersOfMirroredRegionsAreMirrored) {
  show("");
  const auto numbers = numbersIn(renderer);
  for (const auto& [right, left] : {std::pair(1, 2), {4, 5}, {6, 7}, {10, 11}, {14, 15}}) {
    Eigen::Vector3d places[2];
    for (const SeenNumber& number : numbers)
      if (number.region == right || number.region == left) places[number.region == left] = number.place;
    EXPECT_NEAR(places[0].x(), -places[1].x(), 0.03) << right;
    EXPECT_NEAR(places[0].y(), places[1].y(), 0.03) << right;
    EXPECT_GT(places[1].x(), places[0].x()) << "the subject's left is on the right";
  }
  for (const SeenNumber& number : numbers) {
    const std::set<int> midline = {3, 8, 9, 12, 13, 16};
    if (midline.count(number.region)) {
      EXPECT_NEAR(number.place.x(), 0.0, 0.03) << number.region;
    }
  }
}

TEST_F(RegionOverlay, NumbersFollowTheCamera) {
  show("");
  renderer->GetActiveCamera()->Azimuth(90.0);
  renderer->GetRenderWindow()->Render();
  const std::set<int> seen = regionsSeen();
  for (const int right : {1, 4, 6, 10, 14}) EXPECT_EQ(seen.count(right), 0u) << right << " is hidden by the face";
  for (const int left : {2, 5, 7, 11, 15}) EXPECT_TRUE(seen.count(left)) << left;
  expectOverTheirRegions("from the left", {2, 5, 7, 11, 15});  // a lip is narrow there
  QTest::mouseClick(find<QToolButton>("deformationRegions"), Qt::LeftButton);
  EXPECT_TRUE(regionsSeen().empty());
}

}  // namespace
