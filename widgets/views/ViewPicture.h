#pragma once

#include <QImage>

namespace mien {

class RenderView;

/// What a view shows in any number of pixels, with lines, points and letters in proportion and smooth edges, in the
/// colours of the current theme. A background without opacity (Theme::viewTop, viewBottom) lets the page show through.
QImage viewPicture(RenderView* view, const QSize& pixels);

}  // namespace mien
