#include "star_knots.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "base/length.hpp"
#include "base/sort_by.hpp"
#include "kink.hpp"
#include "star_rows.hpp"

namespace splinecore {

namespace {

/// The inner knots of a part of a side, as a patch of a degree has them along it.
std::vector<SideKnot> side_knots(const HoleSide& side, const PartOfSide& part, int degree) {
  constexpr double kNegligibleKink = 1e-7;
  const NurbsCurve& curve = side.curve();
  const KnotVector& knots = curve.knot_vector();
  std::vector<SideKnot> found;
  for (const double knot : knots.knots()) {
    const double at = (knot - part.from) / (part.to - part.from);
    const int by_knots = knots.degree() - multiplicity(knots, knot);
    const int smooth = by_knots > 0 || kink_angle(curve, knot) <= kNegligibleKink ? std::max(1, by_knots) : 0;
    if (at > kSamePlace && at < 1.0 - kSamePlace && smooth < degree) found.push_back({at, degree - smooth});
  }
  return found;
}

/// Those that are one place as one, where the less smooth one is: the same from either end.
std::vector<SideKnot> without_copies(std::vector<SideKnot> all) {
  sort_by(all, [](const SideKnot& knot) { return knot.at; });
  std::vector<SideKnot> found;
  for (const SideKnot& one : all) {
    if (found.empty() || one.at - found.back().at > kSamePlace) {
      found.push_back(one);
      continue;
    }
    SideKnot& before = found.back();
    const bool is_inner = std::abs(one.at - 0.5) < std::abs(before.at - 0.5);
    if (one.copies > before.copies || (one.copies == before.copies && is_inner)) before = one;
  }
  return found;
}

/// What is asked of polynomials.
struct NearPolynomial {
  int degree;
  double tolerance;
};

/// The most that a part of a side is off the polynomial through as many places of a span as decide it, at places between them.
double distance_from_polynomial(const HoleSide& side, const PartOfSide& part, const Interval& span, int degree) {
  const int count = degree + 1;
  std::vector<double> at;
  for (int k = 0; k <= 2 * count; ++k) at.push_back(0.5 * (1.0 - std::cos(std::numbers::pi * k / (2.0 * count))));
  std::vector<double> s;
  for (const double t : at) s.push_back(part.from + (part.to - part.from) * (span.start + span.length() * t));
  const std::vector<glm::dvec3> points = side.points(s);
  double largest = 0.0;
  for (std::size_t i = 0; i < at.size(); i += 2) {  // the polynomial is through the odd ones
    glm::dvec3 sum(0.0);
    for (std::size_t k = 1; k < at.size(); k += 2) {
      double weight = 1.0;
      for (std::size_t l = 1; l < at.size(); l += 2) {
        if (l != k) weight *= (at[i] - at[l]) / (at[k] - at[l]);
      }
      sum += weight * points[k];
    }
    largest = std::max(largest, length_of(sum - points[i]));
  }
  return largest;
}

/// Adds the knots at which a span is halved, and halved again, until polynomials are near to what runs beside it.
void add_halvings(const Hole& hole, std::span<const PartOfSide> beside, const Interval& whole, const NearPolynomial& wanted,
                  std::vector<double>& knots) {
  constexpr double kShortest = 0x1p-40;
  constexpr std::size_t kMostKnots = 512;
  std::vector<Interval> left{whole};
  while (!left.empty() && knots.size() < kMostKnots) {
    const Interval span = left.back();
    left.pop_back();
    const auto is_off = [&](const PartOfSide& part) {
      return distance_from_polynomial(hole.sides[part.side], part, span, wanted.degree) > wanted.tolerance;
    };
    if (span.length() <= kShortest || std::ranges::none_of(beside, is_off)) continue;
    knots.push_back(span.middle());
    left.push_back({span.start, span.middle()});
    left.push_back({span.middle(), span.end});
  }
}

}  // namespace

StarKnots::StarKnots(const Hole& hole)
    : degree_(hole.continuity() == 2 ? 7 : 5),
      patches_(hole.share == 1.0 ? 1 : hole.sides.size()),
      inner_(std::max<std::size_t>(patches_, 2)) {
  constexpr std::size_t kMostPoints = 0x1p21;
  for (const PartOfSide& part : star_parts(hole)) {
    const Axis axis = axis_of(part.border) == Axis::u ? Axis::v : Axis::u;
    std::vector<SideKnot>& run = inner_[run_of(part.patch, axis)];
    const std::vector<SideKnot> own = side_knots(hole.sides[part.side], part, degree_);
    run.insert(run.end(), own.begin(), own.end());
  }
  for (std::vector<SideKnot>& run : inner_) run = without_copies(std::move(run));
  if (points() <= kMostPoints) return;
  for (std::vector<SideKnot>& run : inner_) run.clear();
}

std::size_t StarKnots::run_of(std::size_t patch, Axis axis) const {
  if (patches_ == 1) return static_cast<std::size_t>(axis);
  return axis == Axis::v ? patch : (patch + patches_ - 1) % patches_;
}

std::size_t StarKnots::points() const {
  const auto width = [&](std::size_t run) {
    auto sum = static_cast<std::size_t>(degree_) + 1;
    for (const SideKnot& knot : inner_[run]) sum += static_cast<std::size_t>(knot.copies);
    return sum;
  };
  std::size_t sum = 0;
  for (std::size_t k = 0; k < patches_; ++k) sum += width(run_of(k, Axis::u)) * width(run_of(k, Axis::v));
  return sum;
}

KnotVector StarKnots::of_run(std::size_t run, int spans) const {
  constexpr double kRounding = 1e-9;
  std::vector<SideKnot> ends = inner_[run];
  ends.push_back({1.0, degree_ + 1});
  std::vector<double> knots(static_cast<std::size_t>(degree_) + 1, 0.0);
  for (const SideKnot& one : ends) {
    const double start = knots.back();
    const int parts = static_cast<int>(std::max(1.0, std::ceil((one.at - start) * spans - kRounding)));
    for (int k = 1; k < parts; ++k) knots.push_back(start + (one.at - start) * k / parts);
    knots.insert(knots.end(), static_cast<std::size_t>(one.copies), one.at);
  }
  return KnotVector::make(degree_, std::move(knots));
}

std::vector<KnotPair> StarKnots::pairs_of(const std::vector<KnotVector>& runs) const {
  std::vector<KnotPair> made;
  for (std::size_t k = 0; k < patches_; ++k) made.push_back({runs[run_of(k, Axis::u)], runs[run_of(k, Axis::v)]});
  return made;
}

std::vector<KnotPair> StarKnots::with(int spans) const {
  std::vector<KnotVector> runs;
  for (std::size_t run = 0; run < inner_.size(); ++run) runs.push_back(of_run(run, spans));
  return pairs_of(runs);
}

std::vector<KnotPair> StarKnots::graded(const Hole& hole, int spans, double tolerance) const {
  std::vector<std::vector<PartOfSide>> beside(inner_.size());
  for (const PartOfSide& part : star_parts(hole)) {
    const Axis axis = axis_of(part.border) == Axis::u ? Axis::v : Axis::u;
    beside[run_of(part.patch, axis)].push_back(part);
  }
  std::vector<KnotVector> runs;
  for (std::size_t run = 0; run < inner_.size(); ++run) {
    const KnotVector even = of_run(run, spans);
    std::vector<double> knots(even.knots().begin(), even.knots().end());
    for (int i = 0; i < static_cast<int>(even.spans().size()); ++i) {
      add_halvings(hole, beside[run], even.span_interval(i), {degree_, tolerance}, knots);
    }
    std::ranges::sort(knots);
    runs.push_back(KnotVector::make(degree_, std::move(knots)));
  }
  return pairs_of(runs);
}

bool StarKnots::are_all(int spans) const {
  constexpr int kForAngles = 8;
  return spans >= kForAngles;
}

}  // namespace splinecore
