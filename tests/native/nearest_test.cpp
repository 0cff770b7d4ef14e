#include "splinecore/meet/nearest.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "splinecore/base/errors.hpp"

namespace {

using namespace splinecore;

TEST(Nearest, OnALineIsTheFootOrAnEnd) {
  const auto line = NurbsCurve::make(1, {0, 0, 2, 2}, {{0, 0, 0, 1}, {2, 0, 0, 1}});
  const std::array<glm::dvec3, 3> points{glm::dvec3(0.5, 3, 0), glm::dvec3(-1, 0, 0), glm::dvec3(5, 4, 0)};
  std::array<NearestOnCurve, 3> found;
  nearest(line, points, found);
  EXPECT_DOUBLE_EQ(found[0].parameter, 0.5);
  EXPECT_DOUBLE_EQ(found[0].distance, 3.0);
  EXPECT_EQ(found[1].parameter, 0.0);
  EXPECT_EQ(found[2].parameter, 2.0);
  EXPECT_EQ(found[2].distance, 5.0);
}

TEST(Nearest, OnASquareIsInsideOrOnASideOrACorner) {
  const auto square = NurbsPatch::make(KnotVector::bezier(1), KnotVector::bezier(1),
                                       {{0, 0, 0, 1}, {0, 1, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}});
  const std::array<glm::dvec3, 3> points{glm::dvec3(0.25, 0.5, 2), glm::dvec3(-1, 0.5, 0), glm::dvec3(2, 2, 1)};
  std::array<NearestOnPatch, 3> found;
  nearest(square, points, found);
  EXPECT_DOUBLE_EQ(found[0].u, 0.25);
  EXPECT_DOUBLE_EQ(found[0].distance, 2.0);
  EXPECT_EQ(found[1].u, 0.0);
  EXPECT_DOUBLE_EQ(found[1].v, 0.5);
  EXPECT_EQ(found[2].point, glm::dvec3(1, 1, 0));
  EXPECT_DOUBLE_EQ(found[2].distance, std::sqrt(3.0));
}

TEST(Nearest, OfEqualPlacesIsTheFirst) {
  // A half circle about the point.
  const auto arc = NurbsCurve::make(2, {0, 0, 0, 1, 1, 2, 2, 2},
                                    {{1, 0, 0, 1}, {1, 1, 0, std::sqrt(0.5)}, {0, 1, 0, 1}, {-1, 1, 0, std::sqrt(0.5)},
                                     {-1, 0, 0, 1}});
  const glm::dvec3 center(0.0);
  NearestOnCurve found;
  nearest(arc, {&center, 1}, {&found, 1});
  EXPECT_EQ(found.parameter, 0.0);
  EXPECT_NEAR(found.distance, 1.0, 1e-15);
}

TEST(Nearest, RefusesAPointThatIsNotFinite) {
  const auto line = NurbsCurve::make(1, {0, 0, 2, 2}, {{0, 0, 0, 1}, {2, 0, 0, 1}});
  const std::array<glm::dvec3, 2> points{glm::dvec3(0.0), glm::dvec3(std::numeric_limits<double>::quiet_NaN())};
  std::array<NearestOnCurve, 2> found;
  EXPECT_THROW(nearest(line, points, found), InvalidShape);
}

}  // namespace
