#pragma once

#include <string>

namespace CLI {
class App;
}

namespace mien {

struct ScanReport;

/// The options of commands that measure scans: what the lengths of the file are in.
class ScanUnit {
 public:
  void addTo(CLI::App& command);

  /// Millimetres of one unit, 0 where it is to be recognised. Throws a ValueFailure for a unit or a scale that is none.
  double millimetres() const;

  /// Says on stderr which unit was taken, where it was recognised and is not mm.
  static void remark(const std::string& scan, const ScanReport& report);

 private:
  std::string units_, scale_;
};

}  // namespace mien
