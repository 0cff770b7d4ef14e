#include "splinecore/patch/distance.hpp"

#include <glm/geometric.hpp>

#include "splinecore/patch/degree.hpp"
#include "splinecore/patch/ends.hpp"
#include "splinecore/patch/removal.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

/// A lower bound of the largest distance, from a grid of points in every span.
double sampled_distance(const NurbsPatch& a, const NurbsPatch& b) {
  constexpr int kSteps = 20;
  const auto parameters = [&](Axis axis) {
    const KnotVector& knots = a.knot_vector(axis);
    std::vector<double> values{knots.domain().end};
    for (int span = 0; span < static_cast<int>(knots.spans().size()); ++span) {
      const Interval range = knots.span_interval(span);
      for (int i = 0; i < kSteps; ++i) values.push_back(range.start + range.length() * i / kSteps);
      values.push_back(range.end - 1e-9 * range.length());  // nearly the other limit of a gap
    }
    return values;
  };
  const auto u = parameters(Axis::u);
  const auto v = parameters(Axis::v);
  std::vector<glm::dvec3> on_a(u.size() * v.size());
  std::vector<glm::dvec3> on_b(on_a.size());
  evaluate_grid(a, u, v, std::span(&on_a[0].x, 3 * on_a.size()));
  evaluate_grid(b, u, v, std::span(&on_b[0].x, 3 * on_b.size()));
  double far = 0.0;
  for (std::size_t i = 0; i < on_a.size(); ++i) far = worse(far, glm::distance(on_a[i], on_b[i]));
  return far;
}

constexpr double kGrid = 1.1;  // 2 % of the bound, and what lies between samples

/// What evaluation may add to a distance.
double rounding_of(const NurbsPatch& patch) { return 1e-14 * size_of(patch); }

NurbsPatch positive_patch(Random& random, int most_degree) {
  const auto kind = [&] {
    return Kind{integer(random, 2, most_degree), integer(random, 1, 3), static_cast<Ends>(integer(random, 0, 2)),
                static_cast<Weights>(integer(random, 0, 1))};
  };
  const Kind u = kind();
  return random_patch(random, u, kind());
}

NurbsPatch shaken(Random& random, const NurbsPatch& patch, double size, bool with_weights) {
  std::vector<glm::dvec4> points(patch.points().begin(), patch.points().end());
  for (glm::dvec4& point : points) {
    point += glm::dvec4(random_vector(random, size), 0.0);
    if (with_weights) point.w *= std::exp2(real(random, -size, size) / 10.0);
  }
  return patch.with_points(std::move(points));
}

TEST(PatchDistance, OfABumpIsItsHeight) {
  std::vector<glm::dvec4> points;
  for (int i = 0; i < 9; ++i) points.emplace_back(i / 3, i % 3, 0, 1);
  const NurbsPatch flat = NurbsPatch::make(KnotVector::bezier(2), KnotVector::bezier(2), points);
  points[4].z = 4.0;
  const NurbsPatch bump = flat.with_points(points);
  EXPECT_GE(largest_distance(flat, bump), 1.0);
  EXPECT_LE(largest_distance(flat, bump), 1.02);
  EXPECT_EQ(largest_distance(flat, flat), 0.0);
  const NurbsPatch other = insert_knot(elevated(flat, Axis::v, 2), Axis::u, 0.3);
  EXPECT_LE(largest_distance(other, bump), 1.02);
  EXPECT_LE(largest_distance(other, flat), 1e-14);
}

TEST(PatchDistance, IsABoundAndNearTheTruth) {
  Random random(330);
  for (int round = 0; round < 200; ++round) {
    const NurbsPatch patch = positive_patch(random, 4);
    const NurbsPatch moved = shaken(random, patch, std::exp2(-integer(random, 0, 30)), round % 2 == 0);
    const double bound = largest_distance(patch, moved);
    const double far = sampled_distance(patch, moved);
    EXPECT_GE(bound + rounding_of(patch), far) << round;
    EXPECT_LE(bound, kGrid * far + rounding_of(patch)) << round;
    EXPECT_NEAR(largest_distance(unrolled(patch), moved), bound, 0.02 * bound + rounding_of(patch));
  }
}

TEST(PatchDistance, OfPatchesThatAreTheSameIsRounding) {
  Random random(331);
  for (int round = 0; round < 200; ++round) {
    const NurbsPatch patch = positive_patch(random, 9);
    const NurbsPatch other = clamped(elevated(patch, Axis::u), Axis::v);
    EXPECT_LE(largest_distance(patch, other), 1e-12 * size_of(patch)) << round;
  }
}

TEST(PatchDistance, IsInfiniteWhereOnePatchAloneRunsToInfinity) {
  std::vector<glm::dvec4> points{{0, 0, 0, 1}, {0, 1, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}};
  const NurbsPatch near = NurbsPatch::make(KnotVector::bezier(1), KnotVector::bezier(1), points);
  points[3].w = -1.0;
  EXPECT_EQ(largest_distance(near, near.with_points(points)), HUGE_VAL);
  EXPECT_LT(largest_distance(near.with_points(points), near.with_points(points)), 1e-12);
  points[0].x = 1e-3;
  EXPECT_LT(largest_distance(near.with_points(points), elevated(near.with_points(points), Axis::u)), 1e-10);
}

TEST(PatchRemoval, TellsHowFarThePatchMoved) {
  Random random(332);
  for (int round = 0; round < 150; ++round) {
    const NurbsPatch patch = positive_patch(random, 5);
    const Axis axis = round % 2 == 0 ? Axis::u : Axis::v;
    const double at = patch.knot_vector(axis).domain().middle();
    const NurbsPatch moved = shaken(random, insert_knot(patch, axis, at), 0.1, true);
    const auto [value, error] = remove_knot(moved, axis, at);
    const double far = sampled_distance(moved, value);
    EXPECT_GE(error + rounding_of(patch), far) << round;
    EXPECT_LE(error, kGrid * far) << round;
    EXPECT_THROW(remove_knot(moved, axis, at, 1, 0.5 * far), ToleranceNotReached);
    EXPECT_EQ(remove_knot(moved, axis, at, 1, 1.01 * error).value, value);
  }
}

TEST(PatchReduction, TellsHowFarThePatchMoved) {
  Random random(333);
  for (int round = 0; round < 100; ++round) {
    const NurbsPatch patch = positive_patch(random, 5);
    const Axis axis = round % 2 == 0 ? Axis::u : Axis::v;
    const auto [value, error] = reduced(patch, axis);
    const bool is_in_sight = std::ranges::all_of(value.points(), [](const auto& p) { return p.w > 0.0; });
    if (!is_in_sight) continue;
    const double far = sampled_distance(patch, value);
    EXPECT_GE(error + rounding_of(patch), far) << round;
    EXPECT_LE(error, kGrid * far + rounding_of(patch)) << round;
  }
}

TEST(PatchRemoval, OfAllKnotsLeavesThoseThatAreNeeded) {
  Random random(334);
  for (int round = 0; round < 60; ++round) {
    const Kind kind{integer(random, 2, 5), 3, Ends::clamped, static_cast<Weights>(round % 2)};
    const NurbsPatch patch = random_patch(random, kind, kind);
    const Interval domain = patch.knot_vector(Axis::u).domain();
    const NurbsPatch fine = refine(patch, Axis::u, random_parameters(random, domain, 3));
    const auto [value, error] = remove_knots(fine, Axis::u, 1e-9);
    EXPECT_EQ(value.knot_vector(Axis::u), patch.knot_vector(Axis::u)) << round;
    EXPECT_LE(error, 1e-9);
    if (patch.rational()) continue;
    EXPECT_EQ(remove_knots(patch, Axis::u, 1e9).value.knot_vector(Axis::u).spans().size(), 1U);
  }
}

}  // namespace
}  // namespace splinecore
