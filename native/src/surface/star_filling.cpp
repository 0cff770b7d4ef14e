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

/// Sorts knots into those that are kept and those that are left out; none where all are kept.
/// @param is_kept  of a knot inside, and those kept before it
template <class IsKept>
std::optional<WideKnots> with_kept(const KnotVector& knots, const IsKept& is_kept) {
  const auto all = knots.knots();
  const auto order = static_cast<std::size_t>(knots.degree()) + 1;
  std::vector<double> kept(all.begin(), all.begin() + order);
  std::vector<double> left_out;
  for (std::size_t i = order; i + order < all.size(); ++i) (is_kept(all[i], kept) ? kept : left_out).push_back(all[i]);
  if (left_out.empty()) return {};
  kept.insert(kept.end(), all.end() - order, all.end());
  return WideKnots{KnotVector::make(knots.degree(), std::move(kept)), std::move(left_out)};
}

/// Without knots that make a span much shorter than others, or a crease, of which how patches bend would say nothing; none where
/// none do.
std::optional<WideKnots> without_short_spans(const KnotVector& knots) {
  constexpr double kShort = 0.1;
  double longest = 0.0;
  for (int i = 0; i < static_cast<int>(knots.spans().size()); ++i) longest = std::max(longest, knots.span_interval(i).length());
  const double least = kShort * longest;
  return with_kept(knots, [&](double knot, const std::vector<double>& kept) {
    const auto copies = std::ranges::count(kept, knot);
    return copies > 0 ? copies < knots.degree() - 1 : knot - kept.back() >= least && knots.knots().back() - knot >= least;
  });
}

/// Of many knots every other one from both ends, as often as it is there; none where they are few enough to solve a star on them.
std::optional<WideKnots> of_many(const KnotVector& knots) {
  constexpr int kMany = 28;
  if (knots.count() <= kMany) return {};
  const int inner = static_cast<int>(knots.spans().size()) - 1;
  int number = -1;
  double at = knots.domain().start;
  return with_kept(knots, [&](double knot, const auto&) {
    if (knot != at) ++number;
    at = knot;
    return std::min(number, inner - 1 - number) % 2 != 0;
  });
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

/// Lets sides that are there only nearly go straight on where spokes begin, as those of all knots do: there they are two parts.
void straighten_at_spokes(ClaimedStar& claimed) {
  const Star& star = claimed.star;
  const std::size_t last = star.width() - 1;
  for (std::size_t k = 0; k + (star.is_open ? 1 : 0) < star.count; ++k) {
    for (std::size_t row = 0; row < last; ++row) {
      auto& spoke = claimed.points[star.at(k, last, row)];
      const auto& here = claimed.points[star.at(k, last - 1, row)];
      const auto& there = claimed.points[star.at((k + 1) % star.count, row, last - 1)];
      if (!spoke || !here || !there) break;
      spoke = 0.5 * (*here + *there);
    }
  }
}

}  // namespace

StarKnots::StarKnots(const Hole& hole) : degree_(hole.continuity() == 2 ? 7 : 5), inner_(side_knots(hole, star_parts(hole), degree_)) {
  constexpr std::size_t kMostPoints = 0x1p21;
  std::size_t width = static_cast<std::size_t>(degree_) + 1;
  for (const SideKnot& knot : inner_) width += static_cast<std::size_t>(knot.copies);
  if (hole.sides.size() * width * width > kMostPoints) inner_.clear();
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
  constexpr int kMostSpans = 256;
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
  std::optional<WideKnots> wide = without_short_spans(star.knots);
  if (!wide) wide = of_many(star.knots);
  if (wide) {
    ClaimedStar wider = claimed_star(hole, wide->knots);
    straighten_at_spokes(wider);
    const std::vector<NurbsPatch> rough = solved(hole, wider, guide);
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
