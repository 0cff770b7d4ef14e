#include "least_squares_options.hpp"

#include <cmath>
#include <string>

#include "splinecore/base/errors.hpp"

namespace splinecore {

void require_weights(std::span<const double> weights, std::size_t count) {
  if (weights.empty()) return;
  if (weights.size() != count) {
    throw InvalidShape("weights has " + std::to_string(weights.size()) + " values for " + std::to_string(count) +
                       " points");
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (weights[i] > 0.0 && std::isfinite(weights[i])) continue;
    throw InvalidShape("weights" + index_text(i) + " = " + text_of(weights[i]) + " is not a positive number");
  }
}

void require_smoothing(double smoothing) {
  if (smoothing >= 0.0 && std::isfinite(smoothing)) return;
  throw InvalidShape("smoothing = " + text_of(smoothing) + " is not a number from 0 on");
}

const char* and_smoothing(bool is_smoothed) noexcept { return is_smoothed ? " and this much smoothing" : ""; }

const char* without_swings(bool is_swinging) noexcept {
  return is_swinging ? " without swinging far from them in between" : "";
}

void require_corrections(int corrections) {
  constexpr int kMost = 1000;
  if (corrections >= 0 && corrections <= kMost) return;
  throw InvalidShape("corrections = " + std::to_string(corrections) + " is outside [0, " + std::to_string(kMost) + "]");
}

}  // namespace splinecore
