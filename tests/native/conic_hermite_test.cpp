#include "splinecore/conic/hermite_conic.hpp"

#include <glm/geometric.hpp>

#include "splinecore/conic/conic_arc.hpp"
#include "splinecore/conic/ellipse.hpp"
#include "splinecore/convert/to_bezier.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

/// Points of a curve at `count` steps a span.
std::vector<glm::dvec3> samples(const NurbsCurve& curve, int count) {
  std::vector<glm::dvec3> points;
  for (const BezierCurve& span : to_bezier(curve)) {
    for (int i = 0; i <= count; ++i) points.push_back(point_at(span.nurbs(), static_cast<double>(i) / count));
  }
  return points;
}

double distance_to(const std::vector<glm::dvec3>& chain, const glm::dvec3& p) {
  double nearest = glm::distance(chain[0], p);
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    const glm::dvec3 along = chain[i + 1] - chain[i];
    const double length = glm::dot(along, along);
    const double t = length == 0.0 ? 0.0 : std::clamp(glm::dot(p - chain[i], along) / length, 0.0, 1.0);
    nearest = std::min(nearest, glm::distance(p, chain[i] + t * along));
  }
  return nearest;
}

double farthest(const std::vector<glm::dvec3>& points, const std::vector<glm::dvec3>& chain) {
  double worst = 0.0;
  for (const glm::dvec3& p : points) worst = worse(worst, distance_to(chain, p));
  return worst;
}

TEST(ConicAsHermite, OfACircleIsNoFartherThanItSaysNorMuchNearer) {
  for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
    const auto [chain, error] = conic_as_hermite(circle({0, 0, 0}, 1, {0, 0, 1}), tolerance);
    EXPECT_LE(error, tolerance);
    double worst = 0.0;
    for (const glm::dvec3& p : samples(chain.nurbs(), 100)) worst = worse(worst, std::abs(glm::length(p) - 1));
    EXPECT_LE(worst, error + 4e-16);
    EXPECT_GE(worst, 0.5 * error);
  }
}

TEST(ConicAsHermite, FallsSixtyFourFoldWithEachHalving) {
  const auto error = [](int spans) {
    return conic_as_hermite(ellipse_arc({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0, 2, spans), 1.0).error;
  };
  for (const int spans : {2, 4, 8}) EXPECT_NEAR(error(spans) / error(2 * spans), 64, 8);
}

TEST(ConicAsHermite, ErrorBoundsTheDistanceBothWaysForManyConics) {
  Random random(570);
  for (int round = 0; round < 60; ++round) {
    const double w1 = round % 2 == 0 ? std::exp2(real(random, -6, 4)) : real(random, -0.9, 0.9);
    const NurbsCurve curve = conic_arc(random_vector(random), random_vector(random), random_vector(random), w1).nurbs();
    const auto [chain, error] = conic_as_hermite(curve, 0.05);
    const auto exact = samples(curve, 4000);
    const auto cubic = samples(chain.nurbs(), 4000 / static_cast<int>(chain.points().size()));
    // What the polylines themselves are off by.
    const double slack = 1e-4;
    EXPECT_LE(farthest(samples(chain.nurbs(), 20), exact), error + slack) << w1;
    EXPECT_LE(farthest(samples(curve, 200), cubic), error + slack) << w1;
  }
}

TEST(ConicAsHermite, OfAParabolaIsExact) {
  const auto [chain, error] = conic_as_hermite(conic_arc({0, 0, 0}, {1, 2, 0}, {2, 0, 0}, 1).nurbs(), 1e-300);
  EXPECT_EQ(error, 0.0);
  EXPECT_EQ(chain.points().size(), 2u);
  EXPECT_LE(largest(point_at(chain.nurbs(), 0.5) - glm::dvec3(1, 1, 0)), 1e-15);
}

TEST(ConicAsHermite, IsSmoothWhereTheConicIs) {
  const auto [chain, error] = conic_as_hermite(ellipse({0, 0, 0}, {5, 0, 0}, {0, 1, 0}), 1e-5);
  for (std::size_t i = 1; i + 1 < chain.points().size(); ++i) {
    EXPECT_LE(largest(chain.tangents()[i].incoming - chain.tangents()[i].outgoing), 1e-13 * 10);
  }
  EXPECT_EQ(chain.points().front(), chain.points().back());
}

TEST(ConicAsHermite, RefusesWhatItCannotDo) {
  const NurbsCurve arc = conic_arc({-1, 0, 0}, {0, 1, 0}, {1, 0, 0}, 0.5).nurbs();
  EXPECT_EQ(refusal([&] { conic_as_hermite(arc, 0); }), "tolerance = 0 is not a positive length");
  EXPECT_NE(refusal([&] { conic_as_hermite(arc, std::nan("")); }), "not refused");
  EXPECT_EQ(refusal([&] { conic_as_hermite(conic_arc({-1, 0, 0}, {0, 1, 0}, {1, 0, 0}, -2).nurbs(), 1); }),
            "the curve passes through infinity or has a gap: clip it by finite_arcs() first");
  EXPECT_NE(refusal([&] { conic_as_hermite(NurbsCurve::make(KnotVector::bezier(2), {{1, 0, 0, 0}, {0, 0, 0, 1}, {0, 1, 0, 0}}), 1); }),
            "not refused");
  EXPECT_NE(refusal([&] { conic_as_hermite(circle({0, 0, 0}, 1, {0, 0, 1}, EllipseForm::single), 1); }), "not refused");
  for (const double tolerance : {1e-20, 1e-60, 1e-300}) {
    EXPECT_THROW(conic_as_hermite(arc, tolerance), ToleranceNotReached);
  }
  const NurbsCurve far = conic_arc({-1e300, 0, 0}, {0, 1e300, 0}, {1e300, 0, 0}, 0.5).nurbs();
  EXPECT_NE(refusal([&] { conic_as_hermite(far, 1); }), "not refused");
}

}  // namespace
}  // namespace splinecore
