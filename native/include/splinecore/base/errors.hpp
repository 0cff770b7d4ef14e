#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace splinecore {

/// Bad input: the message names the argument, the first offending index and its value.
class InvalidShape : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// A point was asked for where the homogeneous weight is zero or the quotient overflows.
class PointAtInfinity : public std::domain_error {
 public:
  explicit PointAtInfinity(double u);
  PointAtInfinity(double u, double v);
};

/// Shortest text that reads back as the same double.
std::string text_of(double value);

/// A text as messages show it, valid UTF-8 whatever it was: unprintable bytes, and those of no character, as \x.. and
/// of one longer than `most` bytes the whole characters that fit, and "...".
std::string printable(std::string_view text, std::size_t most = std::string_view::npos);

/// "[3]" or, where the array has rows of row_length, "[1, 3]".
std::string index_text(std::size_t index, std::size_t row_length = 0);

}  // namespace splinecore
