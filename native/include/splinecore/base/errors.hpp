#pragma once

#include <stdexcept>
#include <string>

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
  explicit PointAtInfinity(const std::string& sentence) : std::domain_error(sentence) {}
};

/// Shortest text that reads back as the same double.
std::string text_of(double value);

/// "[3]" or, where the array has rows of row_length, "[1, 3]".
std::string index_text(std::size_t index, std::size_t row_length = 0);

}  // namespace splinecore
