#include "knot_density.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "splinecore/basis/samples.hpp"

namespace splinecore {

namespace {

/// The highest derivatives of a curve's spans, one for each.
std::vector<glm::dvec4> highest_derivatives(const NurbsCurve& curve) {
  const KnotVector& knots = curve.knot_vector();
  const int degree = knots.degree();
  const auto points = curve.homogeneous_points();
  Stencil stencil(knots, degree);
  std::vector<glm::dvec4> found;
  for (int i = 0; i < static_cast<int>(knots.spans().size()); ++i) {
    stencil.move_to(knots.span_interval(i).start, Side::right);
    const auto first = static_cast<std::size_t>(stencil.first());
    glm::dvec4 sum(0.0);
    double weight = 0.0;
    for (std::size_t k = 0; k < stencil.weights(degree).size(); ++k) {
      sum += stencil.weights(degree)[k] * points[first + k];
      weight += stencil.weights(0)[k] * points[first + k].w;
    }
    found.push_back(sum / weight);
  }
  return found;
}

/// In each span the root of a derivative more than a curve has, by how those of its spans change, but over breaks.
std::vector<double> wants_of(const NurbsCurve& curve, std::span<const double> breaks) {
  const KnotVector& knots = curve.knot_vector();
  const std::vector<glm::dvec4> highest = highest_derivatives(curve);
  std::vector<double> wants(highest.size(), 0.0);
  for (std::size_t i = 0; i + 1 < highest.size(); ++i) {
    const Interval one = knots.span_interval(static_cast<int>(i));
    const Interval next = knots.span_interval(static_cast<int>(i) + 1);
    if (std::ranges::binary_search(breaks, one.end)) continue;
    const double change = glm::length(highest[i + 1] - highest[i]) / (0.5 * (one.length() + next.length()));
    const double want = std::pow(change, 1.0 / (knots.degree() + 1));
    for (const std::size_t k : {i, i + 1}) wants[k] = std::max(wants[k], want);
  }
  return wants;
}

}  // namespace

KnotDensity::KnotDensity(const Interval& domain) : places_{domain.start, domain.end}, wants_{1.0} { sum_up(); }

void KnotDensity::take(const NurbsCurve& curve, std::span<const double> breaks) {
  const KnotDensity before = *this;
  const std::vector<double> wants = wants_of(curve, breaks);
  std::vector<double> ends{places_.front(), places_.back()};
  std::vector<double> starts;
  for (std::size_t i = 0; i < wants.size(); ++i) {
    starts.push_back(curve.knot_vector().span_interval(static_cast<int>(i)).start);
    ends.push_back(starts.back());
  }
  if (!is_even()) ends.insert(ends.end(), places_.begin(), places_.end());
  std::ranges::sort(ends);
  const auto repeated = std::ranges::unique(ends);
  ends.erase(repeated.begin(), repeated.end());
  places_ = ends;
  wants_.clear();
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const auto span = std::ranges::upper_bound(starts, ends[i]) - starts.begin();
    const double own = wants[static_cast<std::size_t>(std::max<std::ptrdiff_t>(span - 1, 0))];
    const auto old = std::ranges::upper_bound(before.places_, ends[i]) - before.places_.begin() - 1;
    wants_.push_back(before.is_even() ? own : std::max(own, before.wants_[static_cast<std::size_t>(old)]));
  }
  sum_up();
}

void KnotDensity::sum_up() {
  constexpr double kEven = 0.25;
  sums_.assign(1, 0.0);
  for (std::size_t i = 0; i < wants_.size(); ++i) sums_.push_back(sums_.back() + wants_[i] * (places_[i + 1] - places_[i]));
  const double all = sums_.back();
  const double length = places_.back() - places_.front();
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    const double even = (places_[i] - places_.front()) / length;
    sums_[i] = all > 0.0 ? kEven * even + (1.0 - kEven) * sums_[i] / all : even;
  }
}

double KnotDensity::at(double place) const {
  const auto next = std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(places_, place) - places_.begin(), 1,
                                               static_cast<std::ptrdiff_t>(wants_.size()));
  const auto i = static_cast<std::size_t>(next - 1);
  const double part = std::clamp((place - places_[i]) / (places_[i + 1] - places_[i]), 0.0, 1.0);
  return std::lerp(sums_[i], sums_[i + 1], part);
}

double KnotDensity::place_of(double share) const {
  const auto next = std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(sums_, share) - sums_.begin(), 1,
                                               static_cast<std::ptrdiff_t>(wants_.size()));
  const auto i = static_cast<std::size_t>(next - 1);
  const double part = std::clamp((share - sums_[i]) / (sums_[i + 1] - sums_[i]), 0.0, 1.0);
  return std::lerp(places_[i], places_[i + 1], part);
}

std::vector<double> KnotDensity::parted(double from, double to, int pieces) const {
  std::vector<double> found;
  const double start = at(from);
  const double end = at(to);
  for (int k = 1; k < pieces; ++k) {
    const double place = is_even() ? from + (to - from) * k / pieces : place_of(std::lerp(start, end, static_cast<double>(k) / pieces));
    if (place > (found.empty() ? from : found.back()) && place < to) found.push_back(place);
  }
  return found;
}

}  // namespace splinecore
