#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "splinecore/base/errors.hpp"

namespace splinecore {

/// Text that is no formula. The message ends with the place.
class FormulaError : public InvalidShape {
 public:
  FormulaError(const std::string& what, std::size_t position);

  /// The message without the place.
  const std::string& reason() const noexcept { return reason_; }

  /// The character, counted from 0, that the message is about.
  std::size_t position() const noexcept { return position_; }

 private:
  std::string reason_;
  std::size_t position_;
};

inline constexpr std::size_t kMaxFormulaLength = 10'000;

/// How deep parentheses, signs and powers may lie in one another.
inline constexpr int kMaxFormulaNesting = 200;

struct Program;

/// An expression of real variables that a user typed (lecture row S1).
///
/// Numbers, + - * / ^, parentheses, pi and e, names of variables and of constants of the caller's
/// own; ^ goes before a sign and is taken from the right: -t^2 is -(t^2), 2^3^2 is 2^9.
/// sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh (radians), exp, log and ln (natural),
/// log2 log10 sqrt cbrt abs sign floor, and of two arguments atan2(y, x) min max. Upper and
/// lower case differ. The text is parsed; nothing in it is ever run.
/// Immutable; copies share one state.
class Formula {
 public:
  using Constants = std::map<std::string, double>;

  /// @throws FormulaError where the text is no formula; InvalidShape if there is no variable, a name is
  ///         no name, is taken twice or is that of a function, of pi or of e, or a constant is not finite.
  static Formula make(std::string text, std::vector<std::string> variables, Constants constants = {});

  const std::string& text() const noexcept { return state_->text; }
  const std::vector<std::string>& variables() const noexcept { return state_->variables; }
  const Constants& constants() const noexcept { return state_->constants; }

  /// What the library's own functions run.
  const Program& program() const noexcept { return *state_->program; }

  friend bool operator==(const Formula& a, const Formula& b) noexcept;

 private:
  struct State {
    std::string text;
    std::vector<std::string> variables;
    Constants constants;
    std::shared_ptr<const Program> program;
  };

  explicit Formula(std::shared_ptr<const State> state) : state_(std::move(state)) {}
  std::shared_ptr<const State> state_;
};

/// A text in quotes as messages show it: unprintable bytes as \x.., a long one cut off.
std::string quoted(std::string_view text);

}  // namespace splinecore
