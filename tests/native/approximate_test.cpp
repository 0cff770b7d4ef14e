#include "splinecore/fit/approximate.hpp"

#include <cmath>
#include <limits>

#include "splinecore/base/errors.hpp"
#include "splinecore/curve/distance.hpp"
#include "splinecore/fit/approximate_patch.hpp"
#include "splinecore/fit/fair.hpp"
#include "splinecore/fit/project.hpp"
#include "splinecore/fit/rebuild.hpp"
#include "support.hpp"

namespace splinecore {

namespace {

using namespace testing;

std::vector<glm::dvec3> ring(std::size_t count) {
  std::vector<glm::dvec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 6.2831853071795862 * static_cast<double>(i) / static_cast<double>(count);
    points.emplace_back(std::cos(t), std::sin(t), std::sin(2.0 * t));
  }
  return points;
}

}  // namespace

TEST(Approximate, ComesNearInEveryDegreeByCountAndWithinATolerance) {
  const std::vector<glm::dvec3> points = ring(300);
  for (int degree = 1; degree <= 9; ++degree) {
    for (const Closing closing : {Closing::open, Closing::closed}) {
      const auto parameters = parameters_of(points, Parameterization::chordal, closing);
      const auto [curve, error] = approximate(points, parameters, degree, 40, closing);
      EXPECT_EQ(curve.points().size(), 40u);
      EXPECT_LT(error, degree == 1 ? 0.05 : degree < 9 ? 0.005 : 0.006) << degree;
      ApproximationOptions options;
      options.corrections = 2;
      const auto near = approximate_within(points, parameters, degree, closing, 1e-2, points.size(), options);
      EXPECT_LE(near.error, 1e-2) << degree;
    }
  }
}

TEST(Approximate, SmoothingAndDerivativesAtTheEnds) {
  const std::vector<glm::dvec3> points = ring(100);
  ApproximationOptions options;
  options.smoothing = 1e-3;
  options.start = {{1, 0, 0}};
  options.end = {{0, 1, 0}, {0, 0, 1}};
  const auto parameters = parameters_of(points, Parameterization::uniform);
  const NurbsCurve curve = approximate(points, parameters, 4, 20, Closing::open, options).value;
  double found[6];
  const double start = curve.domain().start;
  derivatives(curve, {&start, 1}, 1, found);
  EXPECT_NEAR(found[3], 1.0, 1e-12);
  EXPECT_NEAR(found[4], 0.0, 1e-12);
}

TEST(Approximate, RefusesWhatCannotBe) {
  const std::vector<glm::dvec3> points = ring(30);
  const auto parameters = parameters_of(points, Parameterization::chordal);
  EXPECT_THROW(approximate(points, parameters, 3, 3), InvalidShape);
  EXPECT_THROW(approximate(points, parameters, 3, 31), InvalidShape);
  EXPECT_THROW(approximate(points, std::vector<double>(30, 0.0), 3, 9), InvalidShape);
  EXPECT_THROW(approximate_within(points, parameters, 3, Closing::open, 0.0, 30), InvalidShape);
  EXPECT_THROW(approximate_within(points, parameters, 3, Closing::open, 1e-9, 8), ToleranceNotReached);
  EXPECT_THROW(approximate_within(points, parameters, 3, Closing::open, 100.0, 3), InvalidShape);
  const auto around = parameters_of(points, Parameterization::chordal, Closing::closed);
  EXPECT_THROW(approximate_within(points, around, 5, Closing::closed, 100.0, 4), InvalidShape);
  EXPECT_EQ(approximate_within(points, around, 5, Closing::closed, 100.0, 5).value.points().size(), 5u);
  const PointGrid grid{points, 5, 6};
  const auto along = [&](std::size_t rows, std::size_t count) {
    NearDirection direction;
    for (std::size_t i = 0; i < rows; ++i) direction.parameters.push_back(static_cast<double>(i));
    direction.count = count;
    return direction;
  };
  EXPECT_THROW(approximate_within(grid, along(5, 4), along(6, 3), 100.0), InvalidShape);
  EXPECT_THROW(approximate_within(points, {}, NetSize{3, 3, 4, 3}, 100.0), InvalidShape);
  EXPECT_EQ(approximate_within(points, {}, NetSize{1, 1, 2, 2}, 100.0).value.points().size(), 4u);
  const std::vector<glm::dvec3> bad(30, glm::dvec3(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_THROW(approximate(bad, parameters, 3, 9), InvalidShape);
}

TEST(Project, GivesAParabolaBack) {
  const CurveFunction parabola = [](std::span<const double> u, std::span<glm::dvec3> points) {
    for (std::size_t i = 0; i < u.size(); ++i) points[i] = {u[i], u[i] * u[i], 0.0};
  };
  EXPECT_LT(project(parabola, KnotVector::clamped(2, 9)).error, 1e-13);
  EXPECT_LT(project(parabola, KnotVector::bezier(5), true).error, 1e-13);
}

TEST(Rebuild, SaysHowFarCurvesAndPatchesAre) {
  const auto points = ring(12);
  std::vector<glm::dvec4> net;
  for (const glm::dvec3& point : points) net.emplace_back(point, 1.0 + 0.1 * point.x);
  for (const bool periodic : {false, true}) {
    const KnotVector knots = periodic ? KnotVector::periodic_uniform(3, 12) : KnotVector::clamped(3, 12);
    const NurbsCurve curve = NurbsCurve::make(knots, net);
    const auto [made, error] = rebuild(curve, 4, 15, KeptEnds::tangents);
    EXPECT_EQ(error, largest_distance(curve, made));
    EXPECT_LT(error, 0.1);
    EXPECT_LE(rebuild_within(curve, 3, 1e-4, 1000).error, 1e-4);
    const std::size_t least = periodic ? 3 : 4;
    EXPECT_EQ(rebuild_within(curve, 3, 100.0, least).value.points().size(), least);
    EXPECT_THROW(rebuild_within(curve, 3, 100.0, least - 1), InvalidShape);
    EXPECT_LE(fair(curve, 0.01).error, 0.01);
    EXPECT_GT(fair(curve, 0.01).error, 0.005);
  }
  std::vector<glm::dvec4> grid;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 7; ++j) grid.emplace_back(i, j, std::sin(i * j), 1.0);
  }
  const NurbsPatch patch = NurbsPatch::make(KnotVector::clamped(3, 6), KnotVector::clamped(2, 7), grid);
  EXPECT_LT(rebuild(patch, {3, 6}, {2, 7}).error, 1e-12);
  EXPECT_THROW(rebuild(patch, {3, 3}, {2, 7}), InvalidShape);
  EXPECT_LE(fair(patch, 0.05).error, 0.05);
  EXPECT_GT(fair(patch, 0.05).error, 0.02);
  EXPECT_GT(rebuild(patch, {3, 4}, {2, 3}).error, 1e-2);
}

}  // namespace splinecore
