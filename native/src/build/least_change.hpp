#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "splinecore/build/drag.hpp"

namespace splinecore {

/// What of a shape may be moved, and what its point at a parameter and the derivative there gain by it.
struct Movable {
  explicit Movable(std::size_t count);

  /// Let two move as one.
  void tie(int one, int other);
  /// Those that move with this one have the same.
  int leader(int i) const;

  std::vector<double> in_point;
  std::vector<double> in_tangent;
  std::vector<double> measure;  // the length that stands for moving it by 1; 0 where none is known
  std::vector<char> is_fixed;

 private:
  mutable std::vector<int> leaders_;
};

/// How far each moves while the point moves by 1 and the tangent stays, and the other way round.
struct Motion {
  std::vector<double> of_point;
  std::vector<double> of_tangent;  // empty where the tangent is free
};

/// The motion of the least sum of squares: a linear system of one or two equations, made orthogonal.
/// @param where  of the point, for messages: "u = 0.5"
/// @throws InvalidShape for bad factors, or where too little may move.
Motion least_change(const Movable& movable, bool has_tangent, const Following& following, const std::string& where);

}  // namespace splinecore
