#include <gtest/gtest.h>

#include "PupilMarkers.h"

using namespace mien;

TEST(PupilMarkers, MarkersOnPupilsGivenByPlaceAreTakenOut) {
  MarkerOptions options;
  options.neutralPupils = options.expressionPupils = EyePupils{{31.0, 37.0, 0.0}, {-31.0, 37.0, 0.0}};
  MarkerTable table;
  ASSERT_EQ(table.parse("marker,neutral_x,neutral_y,expression_x,expression_y\n"
                        "left,31.2,37,31,37\nright,-31,36.8,-31,37\nlid,31,41,31,40\nmouth,0,-30,0,-32\n",
                        options),
            "");
  ASSERT_EQ(table.markers.size(), 4u);
  EXPECT_EQ(takeOutPupils(table), (std::vector<std::string>{"left", "right"}));
  ASSERT_EQ(table.markers.size(), 2u);
  EXPECT_EQ(table.markers[0].name, "lid") << "4 mm above the pupil is skin";
}
