#include "ConsoleMessages.h"

#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

namespace mien {

namespace {

std::string& kept() {
  static std::string text;
  return text;
}

class KeepingWindow : public vtkOutputWindow {
 public:
  static KeepingWindow* New();
  vtkTypeMacro(KeepingWindow, vtkOutputWindow);
  void DisplayText(const char* text) override { kept() += text; }
};

vtkStandardNewMacro(KeepingWindow);

}  // namespace

void keepConsoleMessages() {
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  const vtkNew<KeepingWindow> window;
  vtkOutputWindow::SetInstance(window);
}

const std::string& consoleMessages() {
  return kept();
}

}  // namespace mien
