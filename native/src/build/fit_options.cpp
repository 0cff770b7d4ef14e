#include "fit_options.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "splinecore/base/errors.hpp"

namespace splinecore {

void require_domain(const Interval& domain, const std::string& argument) {
  const std::string shown = argument + " = [" + text_of(domain.start) + ", " + text_of(domain.end) + "]";
  if (!std::isfinite(domain.start) || !std::isfinite(domain.end)) throw InvalidShape(shown + " is not finite");
  if (!(domain.start < domain.end)) throw InvalidShape(shown + " does not increase");
  if (!std::isfinite(domain.length())) throw InvalidShape(shown + " overflows: its length is not a finite number");
}

double measured_place(int k) noexcept {
  constexpr std::array kFirst{0.5, 1e-3, 1e-2, 1.0 - 1e-2, 1.0 - 1e-3};
  if (k < static_cast<int>(kFirst.size())) return kFirst[k];
  return std::fmod(k / std::numbers::phi, 1.0);
}

bool can_be_cut(const Interval& interval) noexcept {
  constexpr double kSteps = 4.0;
  constexpr double kSmallest = 1e-300;
  const double size = std::max(std::abs(interval.start), std::abs(interval.end));
  return interval.length() > std::max(kSmallest, kSteps * std::numeric_limits<double>::epsilon() * size);
}

}  // namespace splinecore
