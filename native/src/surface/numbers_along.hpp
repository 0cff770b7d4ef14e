#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "splinecore/surface/sweep.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A number that changes along a rail: a function with three derivatives that lies between those given beside it, before the first and behind the last constant, without a kink there.
class NumbersAlong {
 public:
  /// @param is_closed  behind the last comes the first again, at the end of the domain
  /// @throws InvalidShape unless there is a number, all are finite and above 0, and their parameters increase inside the domain
  NumbersAlong(std::span<const RailNumber> numbers, const Interval& domain, bool is_closed, const char* name);

  double at(double parameter) const;

  /// Beyond the ends of the domain too, without a kink there: straight on, and of closed rails round again.
  double beyond(double parameter) const;

  /// How fast that changes.
  double slope_beyond(double parameter) const;
  bool is_one() const;
  double largest() const;

  /// Where its fourth derivative jumps.
  std::vector<double> joints() const;

 private:
  /// Where between two numbers a parameter is.
  struct Part {
    std::size_t i;
    double length;
    double t;
  };
  Part part_at(double parameter) const;
  double slope_inside(double parameter) const;

  Interval domain_;
  bool is_closed_;
  std::vector<RailNumber> numbers_;
  std::vector<double> slopes_;
};

}  // namespace splinecore
#pragma GCC visibility pop
