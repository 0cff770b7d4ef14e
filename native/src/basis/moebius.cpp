#include "moebius.hpp"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>

#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

/// u = t (b - a) + a is mapped to where t is reached under the new parameter.
class Map {
 public:
  Map(Interval domain, double rho) : domain_(domain), rho_(rho) {}

  bool is_beyond_pole(double u) const { return !(denominator(u) > 0.0); }

  double at(double u) const {
    if (u == domain_.start || u == domain_.end) return u;
    // From the nearer end, so that rounding is relative to the shorter way.
    const double late = rho_ * (domain_.end - u);
    const double early = u - domain_.start;
    return late < early ? domain_.end - late / denominator(u) : domain_.start + early / denominator(u);
  }

  /// What one factor of a polar form at u is multiplied by.
  double factor(double u) const { return rho_ / denominator(u); }

 private:
  double denominator(double u) const {
    if (u == domain_.start) return rho_;
    if (u == domain_.end) return 1.0;
    return (rho_ * (domain_.end - u) + (u - domain_.start)) / (domain_.end - domain_.start);
  }

  Interval domain_;
  double rho_;
};

void require_positive(double rho) {
  if (rho > 0.0 && std::isfinite(rho)) return;
  throw InvalidShape("rho = " + text_of(rho) + " is not positive: the map would not keep the curve");
}

}  // namespace

bool has_moebius_pole(const KnotVector& knots, double rho) {
  require_positive(rho);
  const Map map(knots.domain(), rho);
  return map.is_beyond_pole(knots.knots().front()) || map.is_beyond_pole(knots.knots().back());
}

MoebiusKnots moebius(const KnotVector& knots, double rho) {
  if (knots.periodic()) throw InvalidShape("the map does not repeat itself from one period to the next");
  require_positive(rho);
  const Map map(knots.domain(), rho);
  const auto old = knots.knots();
  std::vector<double> moved;
  for (const double u : old) {
    const double image = map.at(u);
    // Rounding may bring two neighbors out of order by an ulp.
    moved.push_back(moved.empty() ? image : std::max(image, moved.back()));
  }
  std::vector<double> factors(knots.count(), 1.0);
  for (int i = 0; i < knots.count(); ++i) {
    for (int j = 1; j <= knots.degree(); ++j) factors[i] *= map.factor(old[i + j]);
  }
  return {std::move(moved), std::move(factors)};
}

glm::dvec4 multiplied(const glm::dvec4& given, double factor, std::size_t index, std::size_t row_length) {
  const bool is_direction = given.w == 0.0;
  const glm::dvec4 point = is_direction ? factor * given : glm::dvec4(glm::dvec3(given), factor * given.w);
  const bool vanished = !is_direction && !std::isnormal(point.w);
  if (std::isfinite(factor) && !vanished) return point;
  throw InvalidShape("weights" + index_text(index, row_length) + " = " + text_of(given.w) + " times " +
                     text_of(factor) + " leaves the range of numbers");
}

}  // namespace splinecore
