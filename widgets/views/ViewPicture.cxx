#include "ViewPicture.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "RenderView.h"
#include "Theme.h"

namespace mien {

namespace {

constexpr int smoothing = 2;      // pixels drawn for each one, each way
constexpr int mostPixels = 8192;  // each way, which every OpenGL draws

/// A window that is larger for as long as this lives, with all that is measured in pixels in proportion.
class Enlarged {
 public:
  Enlarged(RenderView* view, const QSize& size)
      : renderer_(view->renderer()),
        window_(view->renderWindow()),
        camera_(view->camera()),
        size_(window_->GetSize()[0], window_->GetSize()[1]) {
    dotsPerInch_ = window_->GetDPI();
    const double free = static_cast<double>(view->freeHeight()) / std::max(1, view->height());
    const double factor = size.height() / std::max(1.0, free * size_.height());
    leaveOutFoot(free);
    smooth_ = renderer_->GetUseFXAA();
    resize(size, qRound(dotsPerInch_ * factor));
    widen(factor);
    renderer_->SetUseFXAA(false);
  }
  ~Enlarged() {
    for (const Widths& widths : widths_) {
      widths.property->SetLineWidth(widths.line);
      widths.property->SetPointSize(widths.point);
    }
    resize(size_, dotsPerInch_);
    renderer_->SetUseFXAA(smooth_);
    camera_->SetViewAngle(angle_);
    camera_->SetWindowCenter(centre_[0], centre_[1]);
  }
  Enlarged(const Enlarged&) = delete;
  Enlarged& operator=(const Enlarged&) = delete;

 private:
  struct Widths {
    vtkSmartPointer<vtkProperty> property;
    float line, point;
  };

  /// A figure has its key below the picture, not over it.
  void leaveOutFoot(double free) {
    angle_ = camera_->GetViewAngle();
    camera_->GetWindowCenter(centre_);
    camera_->SetViewAngle(360.0 / M_PI * std::atan(free * std::tan(angle_ * M_PI / 360.0)));
    camera_->SetWindowCenter(0.0, 0.0);
  }

  void resize(const QSize& size, int dotsPerInch) {
    window_->SetSize(size.width(), size.height());
    window_->SetDPI(dotsPerInch);
  }

  void widen(double factor) {
    vtkActorCollection* actors = renderer_->GetActors();
    for (int i = 0; i < actors->GetNumberOfItems(); ++i) {
      vtkProperty* property = vtkActor::SafeDownCast(actors->GetItemAsObject(i))->GetProperty();
      widths_.push_back({property, property->GetLineWidth(), property->GetPointSize()});
      property->SetLineWidth(static_cast<float>(factor * property->GetLineWidth()));
      property->SetPointSize(static_cast<float>(factor * property->GetPointSize()));
    }
  }

  vtkRenderer* renderer_;
  vtkRenderWindow* window_;
  vtkCamera* camera_;
  QSize size_;
  double angle_ = 0.0, centre_[2] = {0.0, 0.0};
  int dotsPerInch_;
  std::vector<Widths> widths_;
  bool smooth_;
};

QImage pixelsOf(vtkRenderWindow* window, const QSize& size) {
  vtkNew<vtkUnsignedCharArray> bytes;
  window->GetRGBACharPixelData(0, 0, size.width() - 1, size.height() - 1, 0, bytes);
  if (bytes->GetNumberOfTuples() < vtkIdType(size.width()) * size.height()) return {};
  const QImage upsideDown(bytes->GetPointer(0), size.width(), size.height(), 4 * size.width(), QImage::Format_RGBA8888);
  return upsideDown.mirrored();
}

}  // namespace

QImage viewPicture(RenderView* view, const QSize& pixels) {
  if (pixels.isEmpty()) return {};
  QSize drawn = smoothing * pixels;
  if (std::max(drawn.width(), drawn.height()) > mostPixels) drawn.scale(mostPixels, mostPixels, Qt::KeepAspectRatio);
  QImage image;
  view->makeCurrent();
  {
    const Enlarged enlarged(view, drawn);
    view->useTheme();
    view->renderer()->GradientBackgroundOff();  // which has no opacity of its own
    view->renderer()->SetBackgroundAlpha(Theme::current().viewTop.alphaF());
    view->renderWindow()->Render();
    image = pixelsOf(view->renderWindow(), drawn);
    view->renderer()->SetBackgroundAlpha(1.0);
  }
  view->doneCurrent();
  if (Theme::current().viewTop.alpha() == 255) image = image.convertToFormat(QImage::Format_RGB888);
  return image.scaled(pixels, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

}  // namespace mien
