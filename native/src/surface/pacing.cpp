#include "pacing.hpp"

#include <algorithm>
#include <cstddef>
#include <glm/vec3.hpp>
#include <utility>

#include "splinecore/curve/evaluate.hpp"
#include "splinecore/fit/interpolate.hpp"

namespace splinecore {

namespace {

/// Slopes of the cubic spline through the values: what is added to the identity is periodic, where the curve is.
std::vector<double> smooth_slopes(const std::vector<double>& wanted, const std::vector<double>& given, bool is_periodic) {
  const std::size_t count = wanted.size() - (is_periodic ? 1 : 0);
  std::vector<glm::dvec3> added;
  for (std::size_t i = 0; i < count; ++i) added.emplace_back(given[i] - wanted[i], 0.0, 0.0);
  InterpolationOptions options;
  options.closing = is_periodic ? Closing::closed : Closing::open;
  options.degree = std::min(3, static_cast<int>(count) - 1);
  if (options.degree == 3 && !is_periodic) options.ends = FitEnds::not_a_knot;
  const NurbsCurve spline = interpolate(added, wanted, options).value;
  std::vector<double> values(6 * wanted.size());
  std::vector<double> at = wanted;
  derivatives(spline, at, 1, values);
  std::vector<double> slopes;
  for (std::size_t i = 0; i < wanted.size(); ++i) slopes.push_back(1.0 + values[6 * i + 3]);
  return slopes;
}

/// Harmonic means of the secants' slopes, which make no map that rises turn back.
std::vector<double> rising_slopes(const std::vector<double>& wanted, const std::vector<double>& given, bool is_periodic) {
  const std::size_t last = wanted.size() - 1;
  std::vector<double> secants;
  for (std::size_t i = 0; i < last; ++i) secants.push_back((given[i + 1] - given[i]) / (wanted[i + 1] - wanted[i]));
  const auto between = [](double a, double b) { return 2.0 * a * b / (a + b); };
  std::vector<double> slopes(last + 1);
  for (std::size_t i = 1; i < last; ++i) slopes[i] = between(secants[i - 1], secants[i]);
  slopes.front() = is_periodic ? between(secants.back(), secants.front()) : secants.front();
  slopes.back() = is_periodic ? slopes.front() : secants.back();
  return slopes;
}

}  // namespace

Pacing::Pacing(std::vector<double> wanted, std::vector<double> given, bool is_periodic)
    : wanted_(std::move(wanted)), given_(std::move(given)) {
  if (wanted_.size() > (is_periodic ? 3U : 2U)) slopes_ = smooth_slopes(wanted_, given_, is_periodic);
  is_smooth_ = !slopes_.empty() && rises();
  if (!is_smooth_) slopes_ = rising_slopes(wanted_, given_, is_periodic);
}

double Pacing::at(double u) const {
  const auto next = std::ranges::upper_bound(wanted_, u);
  const auto count = static_cast<std::ptrdiff_t>(wanted_.size());
  const std::ptrdiff_t i = std::clamp<std::ptrdiff_t>(next - wanted_.begin() - 1, 0, count - 2);
  const double length = wanted_[i + 1] - wanted_[i];
  const double t = (u - wanted_[i]) / length;
  const double s = 1.0 - t;
  const double value = given_[i] * s * s * (1.0 + 2.0 * t) + slopes_[i] * length * t * s * s +
                       given_[i + 1] * t * t * (3.0 - 2.0 * t) - slopes_[i + 1] * length * s * t * t;
  return std::clamp(value, given_[i], given_[i + 1]);
}

/// By the test of Fritsch and Carlson (1980), eq. 3.
bool Pacing::rises() const {
  constexpr double kMost = 3.0;
  for (std::size_t i = 0; i + 1 < wanted_.size(); ++i) {
    const double secant = (given_[i + 1] - given_[i]) / (wanted_[i + 1] - wanted_[i]);
    for (const double slope : {slopes_[i], slopes_[i + 1]}) {
      if (!(slope > 0.0 && slope < kMost * secant)) return false;
    }
  }
  return true;
}

}  // namespace splinecore
