#pragma once

#include <vector>

#include "loft_sections.hpp"
#include "splinecore/surface/loft.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Parameters along v, and how fast points then run on average.
struct Pace {
  std::vector<double> parameters;
  double speed;

  double step_at(bool is_end) const {
    return is_end ? parameters.back() - *(parameters.end() - 2) : parameters[1] - parameters[0];
  }
};

/// By the distances of sections, on average along them.
/// @throws InvalidShape if two consecutive sections are equal
Pace pace_along(const LoftSections& sections, const LoftOptions& options);

}  // namespace splinecore
#pragma GCC visibility pop
