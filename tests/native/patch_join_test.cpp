#include "splinecore/patch/join.hpp"

#include <array>
#include <glm/geometric.hpp>

#include "splinecore/measure/seam.hpp"
#include "splinecore/patch/bezier_patch.hpp"
#include "splinecore/patch/panels.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

constexpr int kRounds = 1000;
constexpr std::array kSmoothness{PatchSmoothness::c0, PatchSmoothness::g1, PatchSmoothness::c1, PatchSmoothness::g2,
                                 PatchSmoothness::c2};

Axis other(Axis axis) { return axis == Axis::u ? Axis::v : Axis::u; }

NurbsPatch bilinear(glm::dvec3 origin, glm::dvec3 a, glm::dvec3 b) {
  return BezierPatch::make(2, 2, {glm::dvec4(origin, 1.0), glm::dvec4(origin + b, 1.0), glm::dvec4(origin + a, 1.0),
                                  glm::dvec4(origin + a + b, 1.0)})
      .nurbs();
}

const NurbsPatch kGround = bilinear({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
const NurbsPatch kWall = bilinear({1, 0, 0}, {0, 0, 1}, {0, 1, 0});

/// Degrees 1 to 9 and one to three spans in both directions, of which that across the side is not periodic.
NurbsPatch joinable(Random& random, Border side, Weights weights) {
  const auto kind = [&](bool is_across) {
    const int ends = integer(random, 0, is_across ? 1 : 2);
    return Kind{integer(random, 1, 9), integer(random, ends == 2 ? 2 : 1, 3), static_cast<Ends>(ends), weights};
  };
  const Kind u = kind(axis_of(side) == Axis::u);
  return random_patch(random, u, kind(axis_of(side) == Axis::v));
}

/// S and its first derivatives across and along, at a part of the way along a side.
struct Place {
  glm::dvec3 point;
  glm::dvec3 across;
  glm::dvec3 along;
};

Place place_at(const NurbsPatch& patch, Border side, double share, double way) {
  const Axis axis = axis_of(side);
  const Interval across = patch.knot_vector(axis).domain();
  const Interval along = patch.knot_vector(other(axis)).domain();
  const double edge = is_at_end(side) ? across.end : across.start;
  const double there = along.start + share * along.length();
  const bool is_u = axis == Axis::u;
  const double u = is_u ? edge : there;
  const double v = is_u ? there : edge;
  const Side inward = is_at_end(side) ? Side::left : Side::right;
  std::array<glm::dvec3, 4> values;
  derivatives(patch, {&u, 1}, {&v, 1}, 1, std::span(&values[0].x, 12),
              {is_u ? inward : Side::right, is_u ? Side::right : inward});
  const double sign = is_at_end(side) ? way : -way;
  return {values[0], sign * values[is_u ? 2 : 1], values[is_u ? 1 : 2]};
}

TEST(PatchJoin, TheSecondGoesOnWithTheDerivativeOfTheFirst) {
  const PatchJoin join = joined_patches(kGround, Border::u_end, kWall, Border::u_start, PatchSmoothness::c1);
  EXPECT_EQ(join.first, kGround);
  EXPECT_EQ(join.first_error, 0.0);
  EXPECT_EQ(join.second.points()[0], glm::dvec4(1, 0, 0, 1));
  EXPECT_EQ(join.second.points()[2], glm::dvec4(1.5, 0, 0, 1));
  EXPECT_EQ(join.second.points()[4], glm::dvec4(1, 0, 1, 1));
  EXPECT_FALSE(join.reversed);
}

TEST(PatchJoin, BothMoveHalfOfTheWay) {
  const NurbsPatch apart = bilinear({2, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const PatchJoin join =
      joined_patches(kGround, Border::u_end, apart, Border::u_start, PatchSmoothness::c0, JoinMoves::both);
  EXPECT_EQ(join.first.points()[2], glm::dvec4(1.5, 0, 0, 1));
  EXPECT_EQ(join.second.points()[0], glm::dvec4(1.5, 0, 0, 1));
  EXPECT_NEAR(join.first_error, 0.5, 0.01);
  EXPECT_NEAR(join.second_error, 0.5, 0.01);
}

TEST(PatchJoin, AThousandPairsShareTheirTangentPlanesAndDerivatives) {
  Random random(501);
  for (int round = 0; round < kRounds; ++round) {
    const auto side_a = static_cast<Border>(round % 4);
    const auto side_b = static_cast<Border>(round / 4 % 4);
    const auto weights = static_cast<Weights>(integer(random, 0, 1));
    const NurbsPatch a = joinable(random, side_a, weights);
    const NurbsPatch b = joinable(random, side_b, weights);
    const PatchSmoothness smoothness = kSmoothness[round % 5];
    const PatchJoin join = joined_patches(a, side_a, b, side_b, smoothness, static_cast<JoinMoves>(round % 3));
    for (int i = 0; i < 5; ++i) {
      const double share = real(random, 0.0, 1.0);
      const Place on_a = place_at(join.first, side_a, share, 1.0);
      const Place on_b = place_at(join.second, side_b, join.reversed ? 1.0 - share : share, -1.0);
      const double size = std::max(size_of(join.first), size_of(join.second));
      // The parameter itself is rounded; on a narrow span the side is run along fast.
      EXPECT_LE(largest(on_a.point - on_b.point), 1e-13 * (size + glm::length(on_a.along) + glm::length(on_b.along)));
      if (smoothness == PatchSmoothness::c0) continue;
      const glm::dvec3 normal = glm::normalize(glm::cross(on_a.across, on_a.along));
      const glm::dvec3 of_b = glm::normalize(glm::cross(on_b.across, on_b.along));
      EXPECT_LE(glm::length(normal - (join.reversed ? -of_b : of_b)), 1e-9) << round;
      if (smoothness != PatchSmoothness::c1 && smoothness != PatchSmoothness::c2) continue;
      EXPECT_LE(largest(on_a.across - on_b.across), 1e-9 * (largest(on_a.across) + size)) << round;
    }
  }
}

TEST(PatchJoin, MeasuredContinuityIsThatAskedFor) {
  Random random(502);
  int doubtful = 0;  // where the surface is so steep and its spans so short that rounding shows in second derivatives
  for (int round = 0; round < kRounds; ++round) {
    const auto side_a = static_cast<Border>(round % 4);
    const auto side_b = static_cast<Border>(round / 4 % 4);
    const NurbsPatch a = joinable(random, side_a, Weights::positive);
    const NurbsPatch b = joinable(random, side_b, Weights::positive);
    for (const PatchSmoothness smoothness : kSmoothness) {
      const PatchJoin join = joined_patches(a, side_a, b, side_b, smoothness, static_cast<JoinMoves>(round % 3));
      const bool is_parametric = smoothness == PatchSmoothness::c1 || smoothness == PatchSmoothness::c2;
      const bool is_second = smoothness == PatchSmoothness::g2 || smoothness == PatchSmoothness::c2;
      const int wanted = smoothness == PatchSmoothness::c0 ? 0 : is_second ? 2 : 1;
      const SeamContinuity found = seam_continuity(join.first, side_a, join.second, side_b);
      if ((is_parametric ? found.c : found.g) >= wanted) continue;
      ++doubtful;
      EXPECT_EQ(wanted, 2) << round << " " << static_cast<int>(smoothness);
    }
  }
  EXPECT_LE(doubtful, kRounds / 200);
}

TEST(PatchJoin, ASetOfBothSharesTheEdge) {
  const PatchJoin join = joined_patches(kGround, Border::v_end, kWall, Border::u_end, PatchSmoothness::g1);
  const std::vector<AnyPatch> both{join.first, join.second};
  const auto edges = shared_edges(PatchSet::of(both, true));
  EXPECT_TRUE(std::ranges::any_of(edges, [](const SharedEdge& edge) {
    return edge.first == Border::v_end && edge.second == Border::u_end && edge.first_patch != edge.second_patch;
  }));
}

TEST(PatchJoin, RefusesWhatIsNoEdge) {
  const NurbsPatch fan = bilinear({0, 0, 0}, {1, 0, 0}, {0, 0, 0});
  const auto join = [](const NurbsPatch& a, Border side, PatchSmoothness smoothness) {
    return joined_patches(a, side, kWall, Border::u_start, smoothness);
  };
  EXPECT_THROW(join(fan, Border::u_end, PatchSmoothness::c0), InvalidShape);
  const NurbsPatch flat = bilinear({0, 0, 0}, {0, 0, 0}, {0, 1, 0});
  EXPECT_THROW(join(flat, Border::u_end, PatchSmoothness::g1), InvalidShape);
  EXPECT_NO_THROW(join(flat, Border::u_end, PatchSmoothness::c1));
  Random random(503);
  const Kind closed{2, 4, Ends::periodic, Weights::one};
  const NurbsPatch ring = random_patch(random, closed, {2, 2, Ends::clamped, Weights::one});
  EXPECT_THROW(join(ring, Border::u_start, PatchSmoothness::c0), InvalidShape);
  EXPECT_NO_THROW(join(ring, Border::v_start, PatchSmoothness::c0));
}

TEST(SeamContinuity, OfTwoSidesOfABoxIsARightAngle) {
  const SeamContinuity found = seam_continuity(kGround, Border::u_end, kWall, Border::u_start);
  EXPECT_NEAR(found.angle, std::acos(0.0), 1e-15);
  EXPECT_EQ(found.c, 0);
  EXPECT_EQ(found.g, 0);
  EXPECT_EQ(found.parameters.size(), found.points.size());
  EXPECT_EQ(found.parameters.size(), found.gaps.size());
}

TEST(SeamContinuity, IsMeasuredAtThePlacesThatAreGiven) {
  const std::vector<double> places{0.0, 0.5};
  const SeamContinuity found = seam_continuity(kGround, Border::u_end, kWall, Border::u_start, 1e-8, places);
  EXPECT_EQ(found.parameters, places);
  EXPECT_EQ(found.points[1], glm::dvec3(1.0, 0.5, 0.0));
  const std::vector<double> outside{2.0};
  EXPECT_THROW(seam_continuity(kGround, Border::u_end, kWall, Border::u_start, 1e-8, outside), InvalidShape);
  EXPECT_THROW(seam_continuity(kGround, Border::u_end, kWall, Border::u_start, -1.0), InvalidShape);
}

}  // namespace
}  // namespace splinecore
