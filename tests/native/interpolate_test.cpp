#include "splinecore/fit/interpolate.hpp"

#include <cmath>
#include <limits>

#include "splinecore/base/errors.hpp"
#include "splinecore/fit/interpolate_patch.hpp"
#include "support.hpp"

namespace splinecore {

namespace {

using namespace testing;

std::vector<glm::dvec3> helix(std::size_t count) {
  std::vector<glm::dvec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 0.3 * static_cast<double>(i) + 0.1 * std::sin(static_cast<double>(i * i));
    points.emplace_back(std::cos(t), std::sin(t), 0.2 * t);
  }
  return points;
}

}  // namespace

TEST(Interpolate, PassesThroughItsPointsInEveryDegree) {
  for (int degree = 1; degree <= 9; ++degree) {
    for (const Closing closing : {Closing::open, Closing::closed}) {
      for (const std::size_t count : {std::size_t{11}, std::size_t{40}, std::size_t{203}}) {
        const std::vector<glm::dvec3> points = helix(count);
        InterpolationOptions options;
        options.degree = degree;
        options.closing = closing;
        const auto [curve, error] =
            interpolate(points, parameters_of(points, Parameterization::centripetal, closing), options);
        EXPECT_EQ(curve.points().size(), count);
        EXPECT_LT(error, 1e-9) << degree << " " << count;
      }
    }
  }
}

TEST(Interpolate, GivenKnotsThatLieElsewhereAreSolvedAsWell) {
  const std::vector<glm::dvec3> points = helix(30);
  std::vector<double> parameters;
  for (int i = 0; i < 30; ++i) parameters.push_back(i);
  InterpolationOptions options;
  options.knots.assign(4, 0.0);
  for (int i = 0; i < 26; ++i) options.knots.push_back(0.5 + 1.12 * i);
  options.knots.insert(options.knots.end(), 4, 29.0);
  EXPECT_LT(interpolate(points, parameters, options).error, 1e-11);
}

TEST(Interpolate, RefusesWhatCannotBe) {
  std::vector<glm::dvec3> points = helix(6);
  const std::vector<double> parameters = parameters_of(points, Parameterization::chordal);
  InterpolationOptions options;
  options.degree = 6;
  EXPECT_THROW(interpolate(points, parameters, options), InvalidShape);
  EXPECT_THROW(interpolate(points, std::span(parameters).first(5)), InvalidShape);
  points[2].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(interpolate(points, parameters), InvalidShape);
}

TEST(InterpolatePatch, PassesThroughItsGrid) {
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 12; ++i) {
    for (int j = 0; j < 10; ++j) points.emplace_back(i, j, std::sin(0.5 * i * j));
  }
  const PointGrid grid{points, 12, 10};
  for (int degree = 1; degree <= 9; ++degree) {
    FitDirection u;
    u.parameters = parameters_of(grid, Axis::u, Parameterization::chordal);
    u.degree = degree;
    FitDirection v;
    v.closing = Closing::closed;
    v.parameters = parameters_of(grid, Axis::v, Parameterization::uniform, v.closing);
    v.degree = 10 - degree;
    const auto [patch, error] = interpolate(grid, u, v);
    EXPECT_EQ(patch.points().size(), points.size());
    EXPECT_LT(error, 1e-9) << degree;
  }
}

TEST(InterpolatePatch, RefusesGridsThatAreNone) {
  const std::vector<glm::dvec3> points = helix(12);
  EXPECT_THROW(parameters_of({points, 5, 3}, Axis::u, Parameterization::uniform), InvalidShape);
  EXPECT_THROW(parameters_of({points, 0, 0}, Axis::u, Parameterization::chordal), InvalidShape);
  FitDirection u;
  u.parameters = {0, 1, 2, 3};
  FitDirection v;
  v.parameters = {0, 1, 2};
  EXPECT_THROW(interpolate({points, 4, 3}, u, v), InvalidShape);
}

}  // namespace splinecore
