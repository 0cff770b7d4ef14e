#include "star_filling.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/sort_by.hpp"
#include "basis/selection.hpp"
#include "expected_points.hpp"
#include "guided_points.hpp"
#include "kink.hpp"
#include "star_rows.hpp"

namespace splinecore {

namespace {

std::vector<glm::dvec3> points_or_zero(const std::vector<std::optional<glm::dvec3>>& given) {
  std::vector<glm::dvec3> points;
  for (const auto& point : given) points.push_back(point.value_or(glm::dvec3(0.0)));
  return points;
}

/// The inner knots of all sides, as patches of a degree have them along their parts of these.
std::vector<SideKnot> side_knots(const Hole& hole, const std::vector<PartOfSide>& parts, int degree) {
  constexpr double kNegligibleKink = 1e-7;
  std::vector<SideKnot> all;
  for (const PartOfSide& part : parts) {
    const NurbsCurve& curve = hole.sides[part.side].curve();
    const KnotVector& knots = curve.knot_vector();
    for (const double knot : knots.knots()) {
      const double at = (knot - part.from) / (part.to - part.from);
      const int by_knots = knots.degree() - multiplicity(knots, knot);
      const int smooth = by_knots > 0 || kink_angle(curve, knot) <= kNegligibleKink ? std::max(1, by_knots) : 0;
      if (at > kSamePlace && at < 1.0 - kSamePlace && smooth < degree) all.push_back({at, degree - smooth});
    }
  }
  sort_by(all, [](const SideKnot& knot) { return knot.at; });
  std::vector<SideKnot> found;
  for (const SideKnot& one : all) {
    if (!found.empty() && one.at - found.back().at <= kSamePlace) {
      found.back().copies = std::max(found.back().copies, one.copies);
    } else {
      found.push_back(one);
    }
  }
  return found;
}

/// What a star is solved on first.
struct WideKnots {
  KnotVector knots;
  std::vector<double> left_out;
};

/// Without knots that make a span much shorter than others, or a crease, of which how patches bend would say nothing; none where
/// none do.
std::optional<WideKnots> without_short_spans(const KnotVector& knots) {
  constexpr double kShort = 0.1;
  double longest = 0.0;
  for (int i = 0; i < static_cast<int>(knots.spans().size()); ++i) longest = std::max(longest, knots.span_interval(i).length());
  const double least = kShort * longest;
  const auto all = knots.knots();
  const auto order = static_cast<std::size_t>(knots.degree()) + 1;
  std::vector<double> kept(all.begin(), all.begin() + order);
  std::vector<double> left_out;
  for (std::size_t i = order; i + order < all.size(); ++i) {
    const auto copies = std::ranges::count(kept, all[i]);
    const bool is_apart = copies > 0 ? copies < knots.degree() - 1 : all[i] - kept.back() >= least && all.back() - all[i] >= least;
    (is_apart ? kept : left_out).push_back(all[i]);
  }
  if (left_out.empty()) return {};
  kept.insert(kept.end(), all.end() - order, all.end());
  return WideKnots{KnotVector::make(knots.degree(), std::move(kept)), std::move(left_out)};
}

/// Control points, by number, of patches of a star on fewer knots.
std::vector<glm::dvec3> refined_points(const Star& star, const std::vector<NurbsPatch>& patches, std::span<const double> inserted) {
  std::vector<glm::dvec3> points(star.size(), glm::dvec3(0.0));
  for (std::size_t k = 0; k < star.count; ++k) {
    const NurbsPatch fine = refine(refine(patches[k], Axis::u, inserted), Axis::v, inserted);
    for (std::size_t i = 0; i < star.width(); ++i) {
      for (std::size_t j = 0; j < star.width(); ++j) points[star.at(k, i, j)] = glm::dvec3(fine.points()[i * star.width() + j]);
    }
  }
  return points;
}

}  // namespace

StarKnots::StarKnots(const Hole& hole) : degree_(hole.continuity() == 2 ? 7 : 5), inner_(side_knots(hole, star_parts(hole), degree_)) {
  constexpr int kMostCopies = 40;
  int copies = 0;
  for (const SideKnot& knot : inner_) copies += knot.copies;
  if (copies > kMostCopies) inner_.clear();
}

KnotVector StarKnots::with(int spans) const {
  std::vector<SideKnot> ends = inner_;
  ends.push_back({1.0, degree_ + 1});
  std::vector<double> knots(static_cast<std::size_t>(degree_) + 1, 0.0);
  for (const SideKnot& one : ends) {
    const double start = knots.back();
    for (int k = 1; k < spans; ++k) knots.push_back(start + (one.at - start) * k / spans);
    knots.insert(knots.end(), static_cast<std::size_t>(one.copies), one.at);
  }
  return KnotVector::make(degree_, std::move(knots));
}

bool StarKnots::are_all(int spans) const {
  constexpr int kForAngles = 8;
  return spans * (static_cast<int>(inner_.size()) + 1) >= kForAngles;
}

bool StarKnots::are_most(int spans) const {
  constexpr int kMostSpans = 64;
  return spans * (static_cast<int>(inner_.size()) + 1) >= kMostSpans;
}

std::vector<NurbsPatch> ClaimedStar::patches() const { return patches_of(star, points_or_zero(points)); }

ClaimedStar claimed_star(const Hole& hole, const KnotVector& knots) {
  const bool is_one = hole.share == 1.0;
  const Star star{knots, is_one ? 1 : hole.sides.size(), is_one, hole.continuity() + 1};
  std::vector<int> orders;
  for (const HoleSide& side : hole.sides) orders.push_back(side.continuity());
  const auto values = [&](std::size_t i, std::span<const double> s, int order) {
    return order == 0 ? hole.sides[i].points(s) : hole.sides[i].across(s, order);
  };
  return {star, claimed_points(hole, star, values, orders)};
}

std::vector<NurbsPatch> solved(const Hole& hole, const ClaimedStar& claimed, const HoleGuide* guide) {
  const Star& star = claimed.star;
  if (const auto wide = without_short_spans(star.knots)) {
    const std::vector<NurbsPatch> rough = solved(hole, claimed_star(hole, wide->knots), guide);
    return patches_of(star, nearest_star(star, claimed.points, refined_points(star, rough, wide->left_out)));
  }
  std::vector<glm::dvec3> expected;
  if (guide) expected = guided_points(hole, star, *guide);
  if (!expected.empty()) return patches_of(star, solved_star(star, claimed.points, expected));
  const bool is_one = star.count == 1;
  std::vector<NurbsPatch> patches = is_one ? claimed.patches() : patches_of(star, solved_star(star, claimed.points));
  expected = expected_points(hole, star, patches);
  return expected.empty() && !is_one ? patches : patches_of(star, solved_star(star, claimed.points, expected));
}

}  // namespace splinecore
