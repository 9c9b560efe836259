#include "OtherWindow.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>

namespace {

constexpr int leastWidth = 400;  // pixels: less are its helpers

qint64 processOf(Display* display, Window window) {
  Atom type = 0;
  int format = 0;
  unsigned long count = 0, left = 0;
  unsigned char* value = nullptr;
  XGetWindowProperty(display, window, XInternAtom(display, "_NET_WM_PID", False), 0, 1, False, XA_CARDINAL, &type,
                     &format, &count, &left, &value);
  const qint64 process = value && count == 1 ? static_cast<qint64>(*reinterpret_cast<unsigned long*>(value)) : 0;
  if (value) XFree(value);
  return process;
}

}  // namespace

OtherWindow::OtherWindow(qint64 process) : process_(process), display_(XOpenDisplay(nullptr)) {}

OtherWindow::~OtherWindow() {
  if (display_) XCloseDisplay(display_);
}

bool OtherWindow::isSought(unsigned long window) const {
  XWindowAttributes attributes;
  return processOf(display_, window) == process_ && XGetWindowAttributes(display_, window, &attributes) != 0 &&
         attributes.map_state == IsViewable && attributes.width >= leastWidth;
}

bool OtherWindow::isVisible() {
  if (!display_ || window_) return window_ != 0;
  Window root = 0, parent = 0, *all = nullptr;
  unsigned int count = 0;
  XQueryTree(display_, DefaultRootWindow(display_), &root, &parent, &all, &count);
  for (unsigned int i = 0; i < count && !window_; ++i)
    if (isSought(all[i])) window_ = all[i];
  if (all) XFree(all);
  return window_ != 0;
}

void OtherWindow::click(const QPoint& place) {
  XEvent event = {};
  event.xbutton.display = display_;
  event.xbutton.window = window_;
  event.xbutton.root = DefaultRootWindow(display_);
  event.xbutton.x = event.xbutton.x_root = place.x();
  event.xbutton.y = event.xbutton.y_root = place.y();
  event.xbutton.same_screen = True;
  event.xbutton.button = Button1;
  event.type = ButtonPress;
  XSendEvent(display_, window_, True, ButtonPressMask, &event);
  event.type = ButtonRelease;
  event.xbutton.state = Button1Mask;
  XSendEvent(display_, window_, True, ButtonReleaseMask, &event);
  XSync(display_, False);
}

/// There is no window manager to give it the keys.
void OtherWindow::pressAlt(char letter) {
  XSetInputFocus(display_, window_, RevertToParent, CurrentTime);
  XEvent event = {};
  event.xkey.display = display_;
  event.xkey.window = window_;
  event.xkey.root = DefaultRootWindow(display_);
  event.xkey.same_screen = True;
  event.xkey.state = Mod1Mask;
  event.xkey.keycode = XKeysymToKeycode(display_, static_cast<KeySym>(letter));
  event.type = KeyPress;
  XSendEvent(display_, window_, True, KeyPressMask, &event);
  event.type = KeyRelease;
  XSendEvent(display_, window_, True, KeyReleaseMask, &event);
  XSync(display_, False);
}
