#pragma once

#include <span>
#include <string>
#include <vector>

#include "splinecore/build/drag.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// What of a shape may be moved, and what its point at a parameter and two derivatives there gain by it.
struct Movable {
  explicit Movable(std::size_t count);

  /// Let two move as one.
  void tie(int one, int other);
  /// Those that move with this one have the same.
  int leader(int i) const;

  std::vector<double> in_point;
  std::vector<double> in_first;
  std::vector<double> in_second;
  std::vector<double> measure;  // the length that stands for moving it by 1; 0 where none is known
  std::vector<char> is_fixed;

 private:
  mutable std::vector<int> leaders_;
};

/// For the point and the derivatives, as many as are chosen: how far each moves while that one moves by 1 and the others
/// stay.
using Motion = std::vector<std::vector<double>>;

/// The motion of the least sum of squares: a linear system of one to three equations, made orthogonal.
/// @param chosen  names of the derivatives that are chosen, for messages, none to two
/// @param where  of the point, for messages: "u = 0.5"
/// @throws InvalidShape for bad factors, or where too little may move.
Motion least_change(const Movable& movable, std::span<const char* const> chosen, const Following& following,
                    const std::string& where);

}  // namespace splinecore
#pragma GCC visibility pop
