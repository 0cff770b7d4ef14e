#include "rounded_jet.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <limits>

#include "splinecore/basis/samples.hpp"

namespace splinecore {

namespace {

/// The largest weight beside the smallest that is one.
double ratio_of_weights(const NurbsCurve& curve) {
  double low = std::numeric_limits<double>::infinity();
  double high = 0.0;
  for (const glm::dvec4& p : curve.points()) {
    if (p.w == 0.0) continue;
    low = std::min(low, std::abs(p.w));
    high = std::max(high, std::abs(p.w));
  }
  return high > 0.0 ? high / low : 1.0;
}

/// What derivatives of a curve are made of: homogeneous points about one of them.
struct HomogeneousJet {
  std::vector<Rounded<glm::dvec3>> points;
  std::vector<Rounded<double>> weights;
};

/// Derivatives of points divided by weights.
std::vector<Rounded<glm::dvec3>> quotients(const HomogeneousJet& jet) {
  std::vector<Rounded<glm::dvec3>> found;
  const Rounded<double>& w = jet.weights[0];
  for (std::size_t k = 0; k < jet.points.size(); ++k) {
    Rounded<glm::dvec3> one = jet.points[k];
    double binomial = 1.0;
    for (std::size_t i = 1; i <= k; ++i) {
      binomial *= static_cast<double>(k + 1 - i) / static_cast<double>(i);
      const Rounded<double>& slope = jet.weights[i];
      const Rounded<glm::dvec3>& lower = found[k - i];
      one.value -= binomial * slope.value * lower.value;
      one.rounding += binomial * (std::abs(slope.value) * lower.rounding + slope.rounding * glm::length(lower.value));
    }
    one.value /= w.value;
    one.rounding = (one.rounding + w.rounding * glm::length(one.value)) / std::abs(w.value);
    found.push_back(one);
  }
  return found;
}

}  // namespace

SlowPlaces::SlowPlaces(const NurbsCurve& curve, const NearCurve& near) : near_(near.curve) {
  constexpr double kShare = 0x1p-18;
  slow_ = kShare * extent(near_.points()) * ratio_of_weights(near_);
  for (const glm::dvec4& p : curve.points()) {
    const auto scaled = [&](double x) { return std::ldexp(x, -near.placement.exponent); };
    points_.emplace_back(scaled(p.x), scaled(p.y), scaled(p.z));
  }
}

bool SlowPlaces::is_slow(const glm::dvec3& first, double span) const {
  return !(glm::length(first) * span > slow_);
}

std::vector<Rounded<glm::dvec3>> SlowPlaces::jet(double u, Side side, int order) const {
  const double rounding = 0x1p-50 * (near_.degree() + 1);
  Stencil stencil(near_.knot_vector(), order);
  stencil.move_to(u, side);
  const auto first = static_cast<std::size_t>(stencil.first());
  const std::size_t count = stencil.weights(0).size();
  const auto weight = [&](std::size_t j) { return near_.homogeneous_points()[first + j].w; };
  const auto point = [&](std::size_t j) { return points_[(first + j) % points_.size()]; };
  glm::dvec3 place(0.0);
  double sum = 0.0;
  for (std::size_t j = 0; j < count; ++j) {
    if (weight(j) == 0.0) continue;
    place += stencil.weights(0)[j] * weight(j) * point(j);
    sum += stencil.weights(0)[j] * weight(j);
  }
  place /= sum;
  glm::dvec3 origin(0.0);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < count; ++j) {
    const double distance = glm::distance(point(j), place);
    if (weight(j) == 0.0 || !(distance < least)) continue;
    least = distance;
    origin = point(j);
  }
  HomogeneousJet jet;
  for (int k = 0; k <= order; ++k) {
    Rounded<glm::dvec3> vector;
    Rounded<double> number;
    for (std::size_t j = 0; j < count; ++j) {
      const double share = stencil.weights(k)[j];
      const double w = weight(j);
      const glm::dvec3 p = w == 0.0 ? glm::dvec3(near_.homogeneous_points()[first + j]) : w * (point(j) - origin);
      vector.value += share * p;
      vector.rounding += rounding * std::abs(share) * glm::length(p);
      number.value += share * w;
      number.rounding += rounding * std::abs(share * w);
    }
    jet.points.push_back(vector);
    jet.weights.push_back(number);
  }
  return quotients(jet);
}

}  // namespace splinecore
