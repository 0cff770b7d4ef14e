#pragma once

#include <cmath>
#include <span>
#include <stdexcept>
#include <string>

#include "splinecore/base/approximation.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore::fuzz {

/// What the library must not do, and did.
class Finding : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

inline void demand(bool holds, const std::string& what) {
  if (!holds) throw Finding(what);
}

template <class Number>
void demand_finite(std::span<const Number> values, const std::string& what) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    demand(std::isfinite(values[i]), what + index_text(i) + " is " + std::to_string(values[i]));
  }
}

/// An error may be infinite, where one of two shapes runs off.
inline void demand_error(double error, const std::string& what) {
  demand(error >= 0.0, what + " has the error " + std::to_string(error));
}

/// What a verb may refuse with. Everything else, also of the standard library, is a finding.
template <class Action>
void attempt(Action action) {
  try {
    action();
  } catch (const InvalidShape&) {
  } catch (const PointAtInfinity&) {
  } catch (const ToleranceNotReached&) {
  }
}

}  // namespace splinecore::fuzz
