#include "ContactSheet.h"

#include <algorithm>
#include <cmath>

#include "Picture.h"
#include "vtkImageData.h"
#include "vtkImageResize.h"
#include "vtkNew.h"
#include "vtkStdString.h"
#include "vtkTextProperty.h"
#include "vtkTextRenderer.h"

namespace mien {

namespace {

constexpr int gap = 10, captionHeight = 22, captionSize = 11, dotsPerInch = 96;

vtkSmartPointer<vtkImageData> smaller(vtkImageData* picture) {
  int size[3];
  picture->GetDimensions(size);
  const double scale = std::min(1.0, static_cast<double>(ContactSheet::tileSide) / std::max(size[0], size[1]));
  vtkNew<vtkImageResize> resize;
  resize->SetInputData(picture);
  resize->SetOutputDimensions(std::max(1, static_cast<int>(std::lround(size[0] * scale))),
                              std::max(1, static_cast<int>(std::lround(size[1] * scale))), 1);
  resize->Update();
  return resize->GetOutput();
}

/// The image may be larger than the text, which begins at its lower left.
vtkSmartPointer<vtkImageData> textImage(const std::string& text, int& width) {
  vtkNew<vtkTextProperty> style;
  style->SetFontSize(captionSize);
  style->SetColor(0.25, 0.25, 0.28);
  auto image = vtkSmartPointer<vtkImageData>::New();
  int size[2];
  vtkTextRenderer::GetInstance()->RenderString(style.Get(), vtkStdString(text), image.Get(), size, dotsPerInch,
                                               vtkTextRenderer::Default);
  width = size[0];
  return image;
}

/// Draws an image of 3 or 4 components onto one of 3, its opacity honoured, cut off where it does not fit.
void paste(vtkImageData* image, int left, int bottom, vtkImageData* sheet) {
  int size[3], whole[3];
  image->GetDimensions(size);
  sheet->GetDimensions(whole);
  const int* extent = image->GetExtent();
  for (int y = 0; y < std::min(size[1], whole[1] - bottom); ++y)
    for (int x = 0; x < std::min(size[0], whole[0] - left); ++x) {
      const auto* from = static_cast<unsigned char*>(image->GetScalarPointer(extent[0] + x, extent[2] + y, extent[4]));
      auto* to = static_cast<unsigned char*>(sheet->GetScalarPointer(left + x, bottom + y, 0));
      const int opacity = image->GetNumberOfScalarComponents() == 4 ? from[3] : 255;
      for (int c = 0; c < 3; ++c)
        to[c] = static_cast<unsigned char>((from[c] * opacity + to[c] * (255 - opacity)) / 255);
    }
}

vtkSmartPointer<vtkImageData> whiteImage(int width, int height) {
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  std::fill(bytes, bytes + static_cast<size_t>(width) * height * 3, 255);
  return image;
}

}  // namespace

ContactSheet::ContactSheet(int frameCount) {
  const int count = std::min(frameCount, columns * rows);
  for (int i = 0; i < count; ++i)
    chosen_.push_back(count > 1 ? static_cast<int>(std::lround(static_cast<double>(i) * (frameCount - 1) / (count - 1)))
                                : 0);
}

bool ContactSheet::wants(int frame) const {
  return std::binary_search(chosen_.begin(), chosen_.end(), frame);
}

void ContactSheet::add(vtkImageData* picture, const std::string& caption) {
  tiles_.push_back({smaller(picture), caption});
}

void ContactSheet::write(const std::string& name) const {
  if (tiles_.empty()) return;
  int tile[3];
  tiles_.front().picture->GetDimensions(tile);
  const int count = static_cast<int>(tiles_.size());
  const int across = std::min(columns, count), down = (count + columns - 1) / columns;
  const int width = tile[0] + gap, height = tile[1] + captionHeight + gap;
  const auto sheet = whiteImage(gap + across * width, gap + down * height);
  for (int i = 0; i < count; ++i) {
    const int left = gap + i % columns * width, bottom = gap + (down - 1 - i / columns) * height;
    paste(tiles_[i].picture, left, bottom + captionHeight, sheet);
    int textWidth = 0;
    const auto text = textImage(tiles_[i].caption, textWidth);
    paste(text, left + std::max(0, (tile[0] - textWidth) / 2), bottom, sheet);
  }
  writePNG(sheet, name, {{"Software", "Mien " MIEN_VERSION}});
}

}  // namespace mien
