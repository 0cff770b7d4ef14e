#include "star_filling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "expected_points.hpp"
#include "guided_points.hpp"
#include "star_rows.hpp"

namespace splinecore {

namespace {

std::vector<glm::dvec3> points_or_zero(const std::vector<std::optional<glm::dvec3>>& given) {
  std::vector<glm::dvec3> points;
  for (const auto& point : given) points.push_back(point.value_or(glm::dvec3(0.0)));
  return points;
}

/// Knots of patches among those that they are to have.
struct WideKnots {
  std::vector<KnotPair> kept;
  std::vector<std::array<std::vector<double>, 2>> left_out;  ///< of each patch, along u and v
};

/// Which inner knots are left out.
using IsLeftOut = std::vector<bool> (*)(const KnotVector& knots);

/// How many knots before the inner ones.
std::size_t order_of(const KnotVector& knots) { return static_cast<std::size_t>(knots.degree()) + 1; }

std::span<const double> inner_of(const KnotVector& knots) {
  return knots.knots().subspan(order_of(knots), knots.knots().size() - 2 * order_of(knots));
}

/// None where none are left out.
std::optional<WideKnots> without(const std::vector<KnotPair>& all, IsLeftOut is_left_out) {
  WideKnots made{all, std::vector<std::array<std::vector<double>, 2>>(all.size())};
  bool is_any = false;
  for (std::size_t k = 0; k < all.size(); ++k) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const KnotVector& knots = all[k][axis];
      const std::vector<bool> is_out = is_left_out(knots);
      const std::span<const double> inner = inner_of(knots);
      std::vector<double> kept(order_of(knots), knots.domain().start);
      std::vector<double>& out = made.left_out[k][axis];
      for (std::size_t i = 0; i < inner.size(); ++i) (is_out[i] ? out : kept).push_back(inner[i]);
      kept.insert(kept.end(), order_of(knots), knots.domain().end);
      if (!out.empty()) made.kept[k][axis] = KnotVector::make(knots.degree(), std::move(kept));
      is_any = is_any || !out.empty();
    }
  }
  return is_any ? std::optional(std::move(made)) : std::nullopt;
}

/// Those that make a span much shorter than the longest one, or a crease, of which how patches bend would say nothing: from both
/// ends on to the middle.
std::vector<bool> short_spans(const KnotVector& knots) {
  constexpr double kShort = 0.1;
  constexpr double kRounding = 1e-9;
  const Interval domain = knots.domain();
  double longest = 0.0;
  for (int i = 0; i < static_cast<int>(knots.spans().size()); ++i) longest = std::max(longest, knots.span_interval(i).length());
  const double least = (kShort - kRounding) * longest;
  const double middle = 0.5 * (domain.start + domain.end);
  const std::span<const double> inner = inner_of(knots);
  std::vector<bool> is_out(inner.size(), false);
  double low = domain.start;
  double high = domain.end;
  const auto thin_out = [&](std::size_t first, std::size_t behind, bool is_back) {
    double& last = is_back ? high : low;
    const double other = is_back ? low : high;
    int copies = 0;
    for (std::size_t n = first; n < behind; ++n) {
      const std::size_t i = is_back ? first + behind - 1 - n : n;
      const bool is_same = copies > 0 && inner[i] == last;
      is_out[i] = is_same ? copies >= knots.degree() - 1 : std::abs(inner[i] - last) < least || std::abs(other - inner[i]) < least;
      if (is_out[i]) continue;
      copies = is_same ? copies + 1 : 1;
      last = inner[i];
    }
  };
  const auto place = [&](double at) { return static_cast<std::size_t>(std::ranges::lower_bound(inner, at) - inner.begin()); };
  const std::size_t before = place(middle - 0.5 * least);
  const std::size_t behind = place(middle + 0.5 * least);
  thin_out(0, before, false);
  thin_out(behind, inner.size(), true);
  thin_out(before, behind, false);
  return is_out;
}

/// Of many knots every other one from both ends, as often as it is there; none where they are few enough to solve a star on them.
std::vector<bool> every_other(const KnotVector& knots) {
  constexpr int kMany = 28;
  const std::span<const double> inner = inner_of(knots);
  std::vector<bool> is_out(inner.size(), false);
  if (knots.count() <= kMany) return is_out;
  const int places = static_cast<int>(knots.spans().size()) - 1;
  int number = -1;
  for (std::size_t i = 0; i < inner.size(); ++i) {
    if (i == 0 || inner[i] != inner[i - 1]) ++number;
    is_out[i] = std::min(number, places - 1 - number) % 2 == 0;
  }
  return is_out;
}

/// Control points, by number, of patches of a star on fewer knots.
std::vector<glm::dvec3> refined_points(const Star& star, const std::vector<NurbsPatch>& patches, const WideKnots& wide) {
  std::vector<glm::dvec3> points(star.size(), glm::dvec3(0.0));
  for (std::size_t k = 0; k < star.count(); ++k) {
    const auto& [along_u, along_v] = wide.left_out[k];
    const NurbsPatch fine = refine(refine(patches[k], Axis::u, along_u), Axis::v, along_v);
    const std::size_t width = star.width(k, Axis::v);
    for (std::size_t i = 0; i < star.width(k, Axis::u); ++i) {
      for (std::size_t j = 0; j < width; ++j) points[star.at(k, i, j)] = glm::dvec3(fine.points()[i * width + j]);
    }
  }
  return points;
}

/// Lets sides that are there only nearly go straight on where spokes begin, as those of all knots do: there they are two parts.
void straighten_at_spokes(ClaimedStar& claimed) {
  const Star& star = claimed.star;
  for (std::size_t k = 0; k < star.inner_spokes(); ++k) {
    const std::size_t next = star.after(k);
    const std::size_t last = star.last(k, Axis::u);
    const std::size_t last_of_next = star.last(next, Axis::v);
    const double slope = end_slope(star.along(k, Axis::u));
    const double share = slope / (slope + end_slope(star.along(next, Axis::v)));
    for (std::size_t row = 0; row < star.last(k, Axis::v); ++row) {
      auto& spoke = claimed.points[star.at(k, last, row)];
      const auto& here = claimed.points[star.at(k, last - 1, row)];
      const auto& there = claimed.points[star.at(next, row, last_of_next - 1)];
      if (!spoke || !here || !there) break;
      spoke = share * *here + (1.0 - share) * *there;
    }
  }
}

}  // namespace

std::vector<NurbsPatch> ClaimedStar::patches() const { return patches_of(star, points_or_zero(points)); }

ClaimedStar claimed_star(const Hole& hole, std::vector<KnotPair> knots) {
  const Star star{std::move(knots), hole.share == 1.0, hole.continuity() + 1};
  std::vector<int> orders;
  for (const HoleSide& side : hole.sides) orders.push_back(side.continuity());
  const auto values = [&](std::size_t i, std::span<const double> s, int order) {
    return order == 0 ? hole.sides[i].points(s) : hole.sides[i].across(s, order);
  };
  return {star, claimed_points(hole, star, values, orders)};
}

std::vector<NurbsPatch> solved(const Hole& hole, const ClaimedStar& claimed, const HoleGuide* guide) {
  const Star& star = claimed.star;
  std::optional<WideKnots> wide = without(star.knots, short_spans);
  if (!wide) wide = without(star.knots, every_other);
  if (wide) {
    ClaimedStar wider = claimed_star(hole, wide->kept);
    straighten_at_spokes(wider);
    const std::vector<NurbsPatch> rough = solved(hole, wider, guide);
    return patches_of(star, nearest_star(star, claimed.points, refined_points(star, rough, *wide)));
  }
  std::vector<glm::dvec3> expected;
  if (guide) expected = guided_points(hole, star, *guide);
  if (!expected.empty()) return patches_of(star, solved_star(star, claimed.points, expected));
  const bool is_one = star.count() == 1;
  std::vector<NurbsPatch> patches = is_one ? claimed.patches() : patches_of(star, solved_star(star, claimed.points));
  expected = expected_points(hole, star, patches);
  return expected.empty() && !is_one ? patches : patches_of(star, solved_star(star, claimed.points, expected));
}

}  // namespace splinecore
