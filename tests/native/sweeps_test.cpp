#include "splinecore/build/sweeps.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <numbers>

#include "splinecore/conic/ellipse.hpp"
#include "support.hpp"

namespace splinecore {

namespace {

using namespace testing;

constexpr double kPi = std::numbers::pi;

/// Rodrigues: a vector turned about a unit axis.
glm::dvec3 rotated(const glm::dvec3& v, const glm::dvec3& axis, double angle) {
  return std::cos(angle) * v + std::sin(angle) * glm::cross(axis, v) +
         (1.0 - std::cos(angle)) * glm::dot(axis, v) * axis;
}

NurbsCurve segment(const glm::dvec3& a, const glm::dvec3& b) {
  return NurbsCurve::make(KnotVector::bezier(1), {{a, 1.0}, {b, 1.0}});
}

}  // namespace

TEST(Revolve, EveryPointIsTheCurvesPointTurned) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const NurbsCurve curve = random_curve(random, Weights::positive);
    const glm::dvec3 point = random_vector(random);
    const glm::dvec3 axis = glm::normalize(random_vector(random));
    const Turn turn{real(random, -9.0, 9.0), real(random, 0.1, 6.2) * (i % 2 == 0 ? 1.0 : -1.0)};
    const NurbsPatch patch = revolve(curve, point, 3.0 * axis, turn);
    const NurbsCurve ring = ellipse_arc({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, turn.start, turn.sweep);
    const double size = largest(point) + size_of(curve);
    for (const double v : random_parameters(random, curve.domain(), 4)) {
      const double u = real(random, ring.domain().start, ring.domain().end);
      const glm::dvec3 at = point_at(ring, u);
      const glm::dvec3 turned = point + rotated(point_at(curve, v) - point, axis, std::atan2(at.y, at.x));
      EXPECT_LE(largest(point_at(patch, u, v) - turned), 1e-13 * size);
    }
  }
}

TEST(Revolve, AWholeTurnIsPeriodicAndKeepsTheCurvesKnots) {
  Random random(4);
  for (const Ends ends : {Ends::clamped, Ends::unclamped, Ends::periodic}) {
    const NurbsCurve curve = random_curve(random, {3, 4, ends, Weights::any});
    const NurbsPatch patch = revolve(curve, {20, 0, 0}, {0, 1, 0});
    EXPECT_TRUE(patch.knot_vector(Axis::u).periodic());
    EXPECT_EQ(patch.count(Axis::u), 8);
    EXPECT_EQ(patch.knot_vector(Axis::v), curve.knot_vector());
  }
}

TEST(Revolve, ADirectionTurnsAsADirection) {
  const NurbsCurve half = NurbsCurve::make(KnotVector::bezier(2), {{0, -1, 0, 1}, {1, 0, 0, 0}, {0, 1, 0, 1}});
  const NurbsPatch sphere = revolve(half, {0, 0, 0}, {0, 1, 0});
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    EXPECT_NEAR(glm::length(point_at(sphere, real(random, 0, 4), real(random, 0, 1))), 1.0, 4e-16);
  }
}

TEST(Revolve, PointsOnAnObliqueAxisAreExactPoles) {
  const glm::dvec3 axis = glm::normalize(glm::dvec3(1, 2, 3));
  const glm::dvec3 base(0.1, 0.2, 0.3);
  const NurbsCurve curve = NurbsCurve::make(
      KnotVector::bezier(2), {{base + 0.7 * axis, 1.0}, {base + glm::dvec3(2, 0, 0), 0.5}, {base + 1e3 * axis, 2.0}});
  const NurbsPatch patch = revolve(curve, base, axis);
  for (int i = 0; i < patch.count(Axis::u); ++i) {
    EXPECT_EQ(glm::dvec3(patch.points()[3 * i]), glm::dvec3(curve.points()[0]));
    EXPECT_EQ(glm::dvec3(patch.points()[3 * i + 2]), glm::dvec3(curve.points()[2]));
  }
}

TEST(Revolve, RefusesWhatMakesNoSurface) {
  const NurbsCurve on_axis = segment({0, 0, 0}, {0, 0, 3});
  const NurbsCurve beside = segment({1, 0, 0}, {1, 0, 3});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal([&] { revolve(on_axis, {0, 0, 1}, {0, 0, 1}); }),
            "the curve lies on the axis: turning it makes no surface");
  EXPECT_EQ(refusal([&] { revolve(beside, {0, 0, 1}, {0, 0, 0}); }),
            "axis_direction has no direction: its length is 0");
  EXPECT_EQ(refusal([&] { revolve(beside, {0, nan, 1}, {0, 0, 1}); }), "axis_point.y = nan is not finite");
  EXPECT_EQ(refusal([&] { revolve(beside, {0, 0, 1}, {0, 0, 1}, {0.0, 0.0}); }),
            "sweep = 0 is zero or more than a whole turn");
  EXPECT_EQ(refusal([&] { revolve(beside, {0, 0, 1}, {0, 0, 1}, {0.0, 7.0}); }),
            "sweep = 7 is zero or more than a whole turn");
}

TEST(Extrude, EveryPointIsTheCurvesPointMoved) {
  Random random(6);
  for (int i = 0; i < 100; ++i) {
    const NurbsCurve curve = random_curve(random, Weights::positive);
    const glm::dvec3 vector = random_vector(random);
    const NurbsPatch patch = extrude(curve, vector);
    EXPECT_EQ(patch.knot_vector(Axis::u), curve.knot_vector());
    for (const double u : random_parameters(random, curve.domain(), 4)) {
      const double v = real(random, 0, 1);
      EXPECT_LE(largest(point_at(patch, u, v) - point_at(curve, u) - v * vector), 1e-13 * size_of(patch));
    }
  }
  EXPECT_EQ(refusal([&] { extrude(segment({0, 0, 0}, {1, 0, 0}), {0, 0, 0}); }),
            "vector has no direction: its length is 0");
}

TEST(Ruled, LiesOnTheSegmentsWithThePaceOfTheWeights) {
  Random random(7);
  for (int i = 0; i < 100; ++i) {
    const NurbsCurve a = random_curve(random, Weights::positive);
    const NurbsCurve b = random_curve(random, Weights::positive);
    const NurbsPatch patch = ruled(a, b);
    EXPECT_EQ(patch.knot_vector(Axis::u).domain(), a.domain());
    for (const double u : random_parameters(random, a.domain(), 4)) {
      const double at = b.domain().start + (u - a.domain().start) / a.domain().length() * b.domain().length();
      const double v = real(random, 0, 1);
      const glm::dvec4 h = (1.0 - v) * homogeneous_at(a, u) + v * homogeneous_at(b, at);
      EXPECT_LE(largest(point_at(patch, u, v) - glm::dvec3(h) / h.w), 1e-11 * size_of(patch));
    }
  }
}

TEST(Ruled, BetweenTwoCirclesOfEqualFormIsACone) {
  const NurbsPatch cone = ruled(circle({0, 0, 0}, 2.0, {0, 0, 1}), circle({0, 0, 2}, 1.0, {0, 0, 1}));
  Random random(8);
  for (int i = 0; i < 100; ++i) {
    const double v = real(random, 0, 1);
    const glm::dvec3 p = point_at(cone, real(random, 0, 4), v);
    EXPECT_NEAR(std::hypot(p.x, p.y), 2.0 - v, 1e-15);
    EXPECT_NEAR(p.z, 2.0 * v, 1e-15);
  }
}

}  // namespace splinecore
