#include "section_nearness.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "splinecore/base/pause.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

/// Even ones of a domain that begins at a parameter; of open curves with both ends.
std::vector<double> places_of(const NurbsCurve& curve, double begin, int count) {
  const Interval domain = curve.domain();
  const int steps = curve.periodic() ? count : count - 1;
  std::vector<double> parameters(count);
  for (int k = 0; k < count; ++k) parameters[k] = begin + domain.length() * k / steps;
  if (!curve.periodic()) parameters.back() = domain.end;
  return parameters;
}

double product(const std::vector<glm::dvec3>& a, const std::vector<glm::dvec3>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += glm::dot(a[i], b[i]);
  return sum;
}

std::vector<glm::dvec3> points_at(const NurbsCurve& curve, double begin, int count) {
  const std::vector<double> parameters = places_of(curve, begin, count);
  std::vector<glm::dvec3> points(parameters.size());
  evaluate(curve, parameters, {&points.front().x, 3 * points.size()});
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& p : points) middle += p / static_cast<double>(points.size());
  for (glm::dvec3& p : points) p -= middle;
  return points;
}

int places_for(const NurbsCurve& a, const NurbsCurve& b) {
  constexpr std::size_t kLeast = 128;
  constexpr std::size_t kOfSpan = 4;
  constexpr std::size_t kMost = 4096;
  const std::size_t spans = std::max(a.knot_vector().spans().size(), b.knot_vector().spans().size());
  return static_cast<int>(std::clamp(kOfSpan * spans, kLeast, kMost));
}

double cosine(double of_both, double of_first, double of_second) {
  const double size = std::sqrt(of_first) * std::sqrt(of_second);
  return size > 0.0 ? of_both / size : 0.0;
}

}  // namespace

SectionNearness::SectionNearness(const NurbsCurve& other, const NurbsCurve& curve)
    : curve_(curve), other_(points_at(other, other.domain().start, places_for(other, curve))), size_(product(other_, other_)) {}

double SectionNearness::at(double begin) const {
  const std::vector<glm::dvec3> own = points_at(curve_, begin, static_cast<int>(other_.size()));
  return cosine(product(other_, own), size_, product(own, own));
}

double SectionNearness::best() const {
  const int count = static_cast<int>(other_.size());
  const Interval domain = curve_.domain();
  const std::vector<glm::dvec3> points = points_at(curve_, domain.start, count);
  const auto turned = [&](int shift) {
    breathe(other_.size());
    double sum = 0.0;
    for (int k = 0; k < count; ++k) sum += glm::dot(other_[k], points[(k + shift) % count]);
    return sum;
  };
  int best = 0;
  double nearest = turned(0);
  for (int shift = 1; shift < count; ++shift) {
    const double one = turned(shift);
    if (one > nearest) best = shift;
    nearest = std::max(nearest, one);
  }
  const double step = domain.length() / count;
  double low = domain.start + (best - 1) * step;
  double high = domain.start + (best + 1) * step;
  for (int round = 0; round < 50; ++round) {
    const double middle = 0.5 * (low + high);
    (growth(middle) > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double SectionNearness::growth(double begin) const {
  const int count = static_cast<int>(other_.size());
  const std::vector<double> parameters = places_of(curve_, begin, count);
  const std::vector<glm::dvec3> own = points_at(curve_, begin, count);
  std::vector<double> values(6 * parameters.size());
  derivatives(curve_, parameters, 1, values);
  double of_both = 0.0;
  double of_own = 0.0;
  for (std::size_t k = 0; k < own.size(); ++k) {
    const glm::dvec3 way(values[6 * k + 3], values[6 * k + 4], values[6 * k + 5]);
    of_both += glm::dot(other_[k], way);
    of_own += glm::dot(own[k], way);
  }
  return of_both * product(own, own) - product(other_, own) * of_own;
}

}  // namespace splinecore
