#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "PixelLine.h"

using mien::PixelLine;

namespace {

std::vector<double> meansOf(const std::vector<double>& pixels, const std::vector<double>& borders, int channels = 1) {
  std::vector<double> result((borders.size() - 1) * channels);
  PixelLine<double>(pixels.data(), static_cast<int>(pixels.size()) / channels, channels)
      .means(borders.data(), static_cast<int>(borders.size()) - 1, result.data());
  return result;
}

const std::vector<double> samplePixels = {3.0, -1.0, 4.0, 1.0, -5.0, 9.0, 2.0, 6.0};

}  // namespace

TEST(PixelLine, APixelKeepsItsValue) {
  const std::vector<double> means = meansOf(samplePixels, {0, 1, 2, 3, 4, 5, 6, 7, 8});
  for (std::size_t i = 0; i < samplePixels.size(); ++i) EXPECT_NEAR(means[i], samplePixels[i], 1e-14);
}

TEST(PixelLine, NothingIsLostHoweverTheLineIsCut) {
  const std::vector<double> borders = {0.0, 0.3, 0.31, 2.7, 2.9, 3.5, 7.2, 8.0};
  const std::vector<double> means = meansOf(samplePixels, borders);
  double sum = 0.0;
  for (std::size_t i = 0; i < means.size(); ++i) sum += means[i] * (borders[i + 1] - borders[i]);
  EXPECT_NEAR(sum, std::accumulate(samplePixels.begin(), samplePixels.end(), 0.0), 1e-13);
}

TEST(PixelLine, ReducingByWholeFactorsIsTheMean) {
  const std::vector<double> means = meansOf(samplePixels, {0, 4, 8});
  EXPECT_NEAR(means[0], 1.75, 1e-14);
  EXPECT_NEAR(means[1], 3.0, 1e-14);
}

TEST(PixelLine, EnlargingALineOfSmoothPixelsIsSecondOrder) {
  std::vector<double> errors;
  for (const int count : {20, 40}) {
    const double h = 1.0 / count;
    const auto exact = [&](double a, double b) {
      return (std::cos(3.0 * a * h) - std::cos(3.0 * b * h)) / (3.0 * h * (b - a));
    };
    std::vector<double> pixels;
    for (int i = 0; i < count; ++i) pixels.push_back(exact(i, i + 1.0));
    double largest = 0.0;
    for (double x = 2.0; x < count - 2.0; x += 0.23)
      largest = std::max(largest, std::abs(meansOf(pixels, {x, x + 0.2})[0] - exact(x, x + 0.2)));
    errors.push_back(largest);
  }
  // Where pixels meet the parabolas take the mean of both: h^2 f'' / 6 = 3.75e-3 too much for f'' = 9, h = 1 / 20.
  EXPECT_LT(errors[0], 3.75e-3);
  EXPECT_LT(errors[1], errors[0] / 3.5);
}

TEST(PixelLine, BeyondItsEndsItRepeatsThem) {
  const std::vector<double> means = meansOf({5.0, 5.0, 5.0, 7.0, 7.0, 7.0}, {-1e9, -8.0, 0.0, 6.0, 9.0, 1e9});
  EXPECT_NEAR(means[0], 5.0, 1e-12);
  EXPECT_NEAR(means[1], 5.0, 1e-12);
  EXPECT_NEAR(means[3], 7.0, 1e-12);
  EXPECT_NEAR(means[4], 7.0, 1e-12);
}

TEST(PixelLine, ChannelsDoNotMix) {
  for (const int channels : {1, 2, 3, 4, 5}) {
    std::vector<double> together;
    for (const double value : samplePixels)
      for (int c = 0; c < channels; ++c) together.push_back(c == channels - 1 ? value : 100.0 * c);
    const std::vector<double> borders = {0.2, 0.9, 3.3, 3.3, 6.0}, alone = meansOf(samplePixels, borders);
    const std::vector<double> means = meansOf(together, borders, channels);
    for (std::size_t i = 0; i < alone.size(); ++i) EXPECT_NEAR(means[i * channels + channels - 1], alone[i], 1e-13);
  }
}
