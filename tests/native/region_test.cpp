#include <cmath>
#include <glm/vec3.hpp>
#include <numbers>
#include <vector>

#include "splinecore/base/errors.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/measure/plane_moments.hpp"
#include "splinecore/region/region.hpp"
#include "support.hpp"

namespace {

using splinecore::NurbsCurve;
using splinecore::Region;
using splinecore::RegionOperation;

/// The circle about a point of the x-axis.
NurbsCurve circle(double x, double radius) {
  const double half = std::numbers::sqrt2 / 2.0;
  std::vector<glm::dvec4> points;
  for (const auto& [along, up] : std::vector<std::pair<double, double>>{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}}) {
    points.emplace_back(x + radius * along, radius * up, 0.0, points.size() % 2 == 0 ? 1.0 : half);
  }
  return NurbsCurve::make(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, points);
}

NurbsCurve rectangle(double x, double y, double width, double height) {
  return NurbsCurve::make(1, {0, 0, 1, 2, 3, 4, 4}, {{x, y, 0, 1}, {x + width, y, 0, 1}, {x + width, y + height, 0, 1}, {x, y + height, 0, 1}, {x, y, 0, 1}});
}

Region region(const std::vector<NurbsCurve>& curves) { return Region::of(curves); }

double area(const Region& of) { return splinecore::enclosed_area(of.outlines(), of.normal()).value; }

double area(const std::vector<NurbsCurve>& a, const std::vector<NurbsCurve>& b, RegionOperation operation) {
  return area(combined(region(a), region(b), operation));
}

}  // namespace

TEST(Region, TwoCirclesHaveALensInCommon) {
  const double lens = 2.0 * std::acos(0.5) - 0.5 * std::sqrt(3.0);
  const Region found = combined(region({circle(0, 1)}), region({circle(1, 1)}), RegionOperation::common);
  EXPECT_NEAR(area(found), lens, 1e-14);
  ASSERT_EQ(found.outlines().size(), 1U);
  const splinecore::Interval domain = found.outlines()[0].domain();
  const std::vector<double> ends{domain.start, domain.end};
  std::vector<glm::dvec3> points(2);
  splinecore::evaluate(found.outlines()[0], ends, std::span(&points[0].x, 6));
  EXPECT_EQ(points[0], points[1]);
}

TEST(Region, BordersInCommonAreDecided) {
  const NurbsCurve square = rectangle(0, 0, 2, 2);
  EXPECT_NEAR(area({square}, {reversed(square)}, RegionOperation::united), 4.0, 1e-14);
  EXPECT_NEAR(area({square}, {square}, RegionOperation::in_one), 0.0, 1e-14);
  EXPECT_NEAR(area({square}, {rectangle(2, 1, 1, 2)}, RegionOperation::united), 6.0, 1e-14);
  EXPECT_NEAR(area({square}, {rectangle(2, 1, 1, 2)}, RegionOperation::common), 0.0, 1e-14);
  EXPECT_NEAR(area({square, rectangle(0.5, 0.5, 1, 1)}, {rectangle(0.5, 0.5, 1, 1)}, RegionOperation::united), 4.0, 1e-14);
  EXPECT_NEAR(area({circle(0, 2)}, {circle(1, 1)}, RegionOperation::without), 3.0 * std::numbers::pi, 1e-13);
  EXPECT_EQ(combined(region({square}), region({rectangle(2, 0, 1, 2)}), RegionOperation::united).outlines().size(), 1U);
}

TEST(Region, OpenCurvesAndOtherPlanesAreRefused) {
  const NurbsCurve open = NurbsCurve::make(1, {0, 0, 1, 2, 2}, {{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}});
  EXPECT_THROW(Region::of({{open}}), splinecore::InvalidShape);
  EXPECT_THROW(Region::of({{rectangle(0, 0, 1, 1)}}, glm::dvec3(1, 0, 0)), splinecore::InvalidShape);
}

TEST(Region, SecondMomentsOfARingAreThoseOfItsCircles) {
  const Region ring = region({circle(3, 2), circle(3, 1)});
  const auto found = splinecore::plane_second_moments(ring.outlines(), ring.normal()).value;
  EXPECT_NEAR(found[0][0], 15.0 * std::numbers::pi / 4.0, 1e-12);
  EXPECT_NEAR(found[1][1], 15.0 * std::numbers::pi / 4.0, 1e-12);
  EXPECT_NEAR(splinecore::plane_centroid(ring.outlines(), ring.normal()).value.x, 3.0, 1e-14);
}
