#pragma once

#include <string>
#include <utility>
#include <vector>

#include "FAPFrame.h"

namespace mien {

/// One facial action of an expression, such as "brows down and together".
struct FacialAction {
  std::string name;
  std::vector<std::pair<int, double>> values;  ///< FAP number and value
};

/// One facial expression as FAP values at full intensity: a tree from the expression to facial actions to FAPs [S].
struct ExpressionProfile {
  std::string name;        ///< "joy"
  int select = 0;          ///< the number that FAP 2 selects it by, 1 .. 6
  std::string definition;  ///< what it looks like, in words
  std::vector<FacialAction> actions;
  std::vector<std::pair<int, double>> values;  ///< FAP number and value of all actions
};

/// Named expressions or visemes, read from JSON: {"format": "mien expressions" or "mien visemes", "version": 2,
/// "expressions": [{"name", "select", "definition", "actions": [{"name", "faps": {"53": 100, ...}}, ...]}, ...]}. In
/// place of "actions" an entry may have "faps", one action without a name; version 1 knew only these. A FAP stands in
/// one action of an expression.
class ExpressionLibrary {
 public:
  static constexpr int version = 2;

  /// Replaces the library; on a fault it stays as it was.
  /// @return nothing, or one sentence that names the expression and what is wrong with it
  std::string parse(const std::string& json);

  /// The line of the last fault where the text is no JSON; 0 for any other.
  int faultLine() const { return faultLine_; }

  const std::vector<ExpressionProfile>& expressions() const { return expressions_; }
  const ExpressionProfile* find(const std::string& name) const;  ///< or nullptr

  const ExpressionProfile* find(int select) const;  ///< by the number in FAP 1 or 2, or nullptr

  /// Adds intensity x values to a frame.
  /// @param intensity 0 (nothing) .. 1 (full); values outside are brought to the nearer end
  /// @return whether there is such an expression
  bool add(const std::string& name, double intensity, FAPFrame& frame) const;

 private:
  std::vector<ExpressionProfile> expressions_;
  int faultLine_ = 0;
};

}  // namespace mien
