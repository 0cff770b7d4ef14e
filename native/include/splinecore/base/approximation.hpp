#pragma once

#include <stdexcept>
#include <string>

namespace splinecore {

/// A value that stands for another, and how far the two lie apart at most: a length in the units of
/// the points. 0 where nothing but rounding was lost.
template <class Value>
struct Approximation {
  Value value;
  double error = 0.0;
};

/// What was asked for cannot be had within the tolerance. Carries the error that it would have.
class ToleranceNotReached : public std::runtime_error {
 public:
  /// @param what  the sentence's beginning: "the knot cannot be removed"
  ToleranceNotReached(const std::string& what, double tolerance, double error);

  double error() const noexcept { return error_; }

  /// The same with both lengths in a unit of this length.
  ToleranceNotReached times(double unit) const { return {what_, unit * tolerance_, unit * error_}; }

 private:
  std::string what_;
  double tolerance_;
  double error_;
};

}  // namespace splinecore
