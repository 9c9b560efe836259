#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "FaceOptions.h"
#include "FaceState.h"

namespace CLI {
class App;
}

class vtkPDEFaceAlgorithm;

namespace mien {

class FacePipeline;

/// A face as the measuring commands take it: its animated curves, and the schemes that are compared on them.
class MeasuredFace {
 public:
  MeasuredFace();
  ~MeasuredFace();

  /// The options of a face; --scheme takes a list or "all" as well.
  void addTo(CLI::App& command);

  /// The same without -a, for a command with an -a of its own.
  void addWithoutSmoothing(CLI::App& command);

  /// The resolution when none is given.
  void setDefaultResolution(int rows, int columns) { options_.setDefaultResolution(rows, columns); }

  /// Reads and checks everything: a FileFailure or a ValueFailure.
  void update();

  /// In place of options: this face in these schemes, read and checked.
  void set(const FaceState& state, const std::vector<std::string>& schemes);

  const FaceState& state() const;

  /// At least one.
  const std::vector<std::string>& schemes() const { return schemes_; }

  /// Connects a filter to the curves and gives it the face's parameters in that scheme.
  void connect(vtkPDEFaceAlgorithm* filter, const std::string& scheme) const;

  /// What follows from the state: "scheme", "a" (a number, or nine), "modes" (N), "remainder".
  nlohmann::ordered_json description(const std::string& scheme) const;

  /// For the notes of figures: "generic face, spline scheme, a = 1, N = 5 with remainder".
  std::string note(bool withSmoothing = true) const;

 private:
  void chooseSchemes();
  void updateCurves();

  FaceOptions options_;
  std::string scheme_;
  std::vector<std::string> schemes_;
  std::unique_ptr<FacePipeline> pipeline_;
};

}  // namespace mien
