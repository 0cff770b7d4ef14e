// Where shapes meet, and what is made of that. The module's tests ask for more; the sanitizers watch these.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>

#include "splinecore/base/errors.hpp"
#include "splinecore/build/blend.hpp"
#include "splinecore/build/contour.hpp"
#include "splinecore/build/corners.hpp"
#include "splinecore/build/curve_on_patch.hpp"
#include "splinecore/build/extend.hpp"
#include "splinecore/build/fillet.hpp"
#include "splinecore/build/helix.hpp"
#include "splinecore/build/join_curves.hpp"
#include "splinecore/build/offset.hpp"
#include "splinecore/build/part.hpp"
#include "splinecore/build/primitives.hpp"
#include "splinecore/build/touching_circle.hpp"
#include "splinecore/conic/arcs.hpp"
#include "splinecore/conic/ellipse.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/measure/length.hpp"
#include "splinecore/meet/intersections.hpp"
#include "splinecore/meet/sections.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using testing::integer;
using testing::Random;
using testing::real;

constexpr glm::dvec3 kUp(0.0, 0.0, 1.0);

NurbsCurve segment(const glm::dvec3& a, const glm::dvec3& b) {
  return NurbsCurve::make(1, {0, 0, 1, 1}, {glm::dvec4(a, 1.0), glm::dvec4(b, 1.0)});
}

NurbsCurve circle_at(double x, double radius = 1.0) { return circle({x, 0.0, 0.0}, radius, kUp); }

/// A clamped curve in the plane, some of its knots multiple, weights from one half to two.
NurbsCurve plane_curve(Random& random) {
  const int degree = integer(random, 1, 5);
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
  for (int span = 1; span < 5; ++span) {
    knots.insert(knots.end(), static_cast<std::size_t>(integer(random, 1, degree)), static_cast<double>(span));
  }
  knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, 5.0);
  std::vector<glm::dvec4> points;
  for (std::size_t i = static_cast<std::size_t>(degree) + 1; i < knots.size(); ++i) {
    points.emplace_back(real(random, -1, 1), real(random, -1, 1), 0.0, real(random, 0.5, 2));
  }
  return NurbsCurve::make(degree, std::move(knots), std::move(points));
}

double length_of(const NurbsCurve& curve) { return length(curve, curve.domain(), 1e-12).value; }

glm::dvec3 point_at(const NurbsCurve& curve, double u) {
  glm::dvec3 point;
  evaluate(curve, std::span(&u, 1), std::span(&point.x, 3));
  return point;
}

TEST(Intersections, OfCirclesThatCrossTouchAndAreOne) {
  EXPECT_EQ(intersections(circle_at(0), circle_at(1)).places.size(), 2U);
  const CurveIntersections touching = intersections(circle_at(0), circle_at(2));
  ASSERT_EQ(touching.places.size(), 1U);
  EXPECT_TRUE(touching.places[0].touches);
  EXPECT_LT(glm::distance(touching.places[0].point, glm::dvec3(1, 0, 0)), 1e-9);
  EXPECT_TRUE(intersections(circle_at(0), circle_at(2.01)).places.empty());
  const CurveIntersections same = intersections(circle_at(0), circle_at(0));
  EXPECT_TRUE(same.places.empty());
  ASSERT_EQ(same.overlaps.size(), 1U);
  EXPECT_EQ(same.overlaps[0].a, circle_at(0).domain());
}

TEST(Intersections, OfRandomCurvesAreOnBoth) {
  Random random(5);
  std::size_t count = 0;
  for (int i = 0; i < 60; ++i) {
    const NurbsCurve a = plane_curve(random);
    const NurbsCurve b = plane_curve(random);
    for (const CurveIntersection& place : intersections(a, b).places) {
      EXPECT_LT(glm::distance(point_at(a, place.a), point_at(b, place.b)), 1e-9);
      ++count;
    }
    for (const CurveIntersection& place : self_intersections(a).places) {
      EXPECT_LT(glm::distance(point_at(a, place.a), point_at(a, place.b)), 1e-9);
      EXPECT_LT(place.a, place.b);
    }
  }
  EXPECT_GT(count, 60U);
}

TEST(Intersections, WithPatchesAndPlanes) {
  const NurbsPatch ball = sphere({0, 0, 0}, 1.0);
  const PatchIntersections through = intersections(segment({0, 0, -2}, {0, 0, 2}), ball);
  ASSERT_EQ(through.places.size(), 2U);
  EXPECT_NEAR(through.places[0].t, 0.25, 1e-12);
  const PatchIntersections beside = intersections(segment({-1, 1, 0}, {1, 1, 0}), ball);
  ASSERT_EQ(beside.places.size(), 1U);
  EXPECT_TRUE(beside.places[0].touches);
  EXPECT_EQ(intersections(circle_at(0), Plane{}).overlaps.size(), 1U);
  EXPECT_EQ(intersections(circle_at(0), Plane{{0.5, 0, 0}, {0, 1, 0}, {0, 0, 1}}).places.size(), 2U);
  EXPECT_THROW(intersections(circle_at(0), Plane{}, -1.0), InvalidShape);
}

double whole_length(const Sections& found) {
  double sum = 0.0;
  for (const SectionCurve& one : found.curves) sum += length_of(one.curve);
  return sum;
}

TEST(Sections, OfASphereATorusAndCylinders) {
  const NurbsPatch ball = sphere({0, 0, 0}, 1.0);
  const Sections ring = sections(ball, Plane{{0, 0, 0.6}, {1, 0, 0}, {0, 1, 0}}, 1e-8);
  ASSERT_EQ(ring.curves.size(), 1U);
  EXPECT_TRUE(ring.curves[0].is_closed);
  EXPECT_NEAR(whole_length(ring), 1.6 * std::numbers::pi, 1e-5);
  const Sections touching = sections(ball, Plane{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}});
  EXPECT_TRUE(touching.curves.empty());
  EXPECT_EQ(touching.points.size(), 1U);
  const Sections viviani = sections(ball, cylinder({0.5, 0, -2}, kUp, 0.5, 4.0), 1e-8);
  EXPECT_EQ(viviani.curves.size(), 4U);
  EXPECT_NEAR(whole_length(viviani), 7.640395578, 1e-4);
  EXPECT_EQ(sections(cylinder({0, 0, -3}, kUp, 1.0, 6.0), cylinder({-3, 0, 0}, {1, 0, 0}, 1.0, 6.0)).curves.size(), 4U);
  EXPECT_EQ(sections(torus({0, 0, 0}, kUp, 3.0, 1.0), Plane{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}).curves.size(), 2U);
  EXPECT_TRUE(sections(ball, ball).are_one);
}

TEST(Offset, OfCirclesCornersAndCusps) {
  const std::vector<NurbsCurve> inner = offset(circle_at(0), 0.25);
  ASSERT_EQ(inner.size(), 1U);
  EXPECT_NEAR(length_of(inner[0]), 1.5 * std::numbers::pi, 1e-9);
  const auto square = NurbsCurve::make(1, {0, 0, 1, 2, 3, 4, 4},
                                       {{0, 0, 0, 1}, {2, 0, 0, 1}, {2, 2, 0, 1}, {0, 2, 0, 1}, {0, 0, 0, 1}});
  OffsetOptions trimmed;
  trimmed.trimmed = true;
  EXPECT_NEAR(length_of(offset(square, 0.5, trimmed)[0]), 4.0, 1e-9);
  EXPECT_NEAR(length_of(offset(square, -0.5)[0]), 8.0 + std::numbers::pi, 1e-9);
  EXPECT_EQ(offset(ellipse({0, 0, 0}, {2, 0, 0}, {0, 1, 0}), 0.8, trimmed).size(), 1U);
  EXPECT_THROW(offset(square, 1.5, trimmed), InvalidShape);
}

TEST(Arcs, ThroughPointsAndAlongTangents) {
  EXPECT_NEAR(length_of(arc_through({1, 0, 0}, {-1, 0, 0}, {0, 1, 0})), 1.5 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(length_of(arc_from_tangent({0, 0, 0}, {1, 0, 0}, {1, 1, 0})), 0.5 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(length_of(arc_about({0, 0, 0}, {1, 0, 0}, {0, -1, 0}, kUp)), 1.5 * std::numbers::pi, 1e-9);
}

TEST(Fillets, TouchBothCurves) {
  const std::vector<Fillet> found = fillets(segment({-2, 0, 0}, {2, 0, 0}), segment({0, -2, 0}, {0, 2, 0}), 0.5, kUp);
  ASSERT_EQ(found.size(), 4U);
  for (const Fillet& fillet : found) EXPECT_NEAR(length_of(fillet.arc), 0.25 * std::numbers::pi, 1e-9);
  EXPECT_THROW(fillets(circle_at(0), circle_at(3), 0.0, kUp), InvalidShape);
}

TEST(Blend, GoesOnStraight) {
  const NurbsCurve first = segment({0, 0, 0}, {1, 0, 0});
  const NurbsCurve second = segment({3, 0, 0}, {4, 0, 0});
  for (int continuity = 0; continuity <= 3; ++continuity) {
    const BezierCurve made = blend({first, true}, {second, false}, continuity);
    EXPECT_NEAR(length_of(made.nurbs()), 2.0, 1e-9);
  }
  EXPECT_THROW(blend({first, true}, {first, true}, 2), InvalidShape);
}

TEST(Make, PartsAndExtensionsOfRandomCurves) {
  Random random(23);
  for (int i = 0; i < 60; ++i) {
    const NurbsCurve curve = plane_curve(random);
    const Interval domain = curve.domain();
    const std::vector<NurbsCurve> pieces = parts(curve, {domain.start + 0.3 * domain.length(), domain.middle()});
    EXPECT_EQ(pieces.size(), 3U);
    try {
      for (const Extension how : {Extension::natural, Extension::arc, Extension::straight}) {
        EXPECT_GT(extended(curve, i % 2 == 0, 0.1, how).domain().length(), domain.length());
      }
    } catch (const InvalidShape&) {
    }
    const std::vector<NurbsCurve> whole = join_curves(pieces, 1e-9);
    EXPECT_LE(whole.size(), 3U);
  }
}

TEST(Make, CornersOfAContour) {
  const std::vector<glm::dvec3> corners{{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}};
  const std::vector<double> bulges{0.0, 0.5, 0.0, -0.25};
  const NurbsCurve shape = contour(corners, bulges, true, kUp);
  EXPECT_LT(length(rounded(shape, 0.3)).value, length(shape).value);
  EXPECT_LT(length(chamfered(shape, 0.3)).value, length(shape).value);
  EXPECT_THROW(rounded(shape, 30.0), InvalidShape);
  const CornerBetween made = filleted(segment({-1, 0, 0}, {1, 0, 0}), segment({0, -1, 0}, {0, 1, 0}), 0.25, {0.9, 0.9}, kUp);
  EXPECT_NEAR(length(made.bridge).value, 0.125 * std::numbers::pi, 1e-12);
}

TEST(Make, CurvesAboutAndOn) {
  HelixOptions options;
  options.turns = 3.0;
  const NurbsCurve coil = helix(circle_at(0.0, 5.0), options);
  EXPECT_GT(length(coil).value, 2.0 * std::numbers::pi * 5.0);
  const NurbsCurve image = segment({0.5, 0.5, 0.0}, {7.0, 1.5, 0.0});
  const NurbsCurve on = curve_on_patch(sphere({0, 0, 0}, 1.0, kUp), image, 0.5);
  const double u = on.domain().middle();
  glm::dvec3 point;
  evaluate(on, std::span(&u, 1), std::span(&point.x, 3));
  EXPECT_NEAR(glm::length(point), 1.5, 1e-5);
  const TouchingCircle touching =
      touching_circle({segment({0, 0, 0}, {4, 0, 0}), segment({0, 0, 0}, {0, 3, 0}), segment({4, 0, 0}, {0, 3, 0})},
                      {0.3, 0.3, 0.5}, kUp);
  EXPECT_NEAR(touching.radius, 1.0, 1e-12);
}

TEST(Meet, SurfacesThatTouchAlongACurve) {
  const Sections found = sections(sphere({0, 0, 0}, 1.0, kUp), cylinder({0, 0, -2}, kUp, 1.0, 4.0));
  ASSERT_EQ(found.curves.size(), 1U);
  EXPECT_EQ(found.curves[0].kind, SectionKind::touching);
  EXPECT_NEAR(length(found.curves[0].curve).value, 2.0 * std::numbers::pi, 1e-4);
}

TEST(Meet, SurfacesThatAreOneInAPartHaveItsBorder) {
  const Sections found = sections(plane({0, 0, 0}, {2, 0, 0}, {0, 2, 0}), plane({1, 1, 0}, {2, 0, 0}, {0, 2, 0}));
  EXPECT_TRUE(found.are_one);
  ASSERT_EQ(found.curves.size(), 4U);
  for (const SectionCurve& side : found.curves) EXPECT_EQ(side.kind, SectionKind::border);
}

}  // namespace
}  // namespace splinecore
