#include "splinecore/build/primitives.hpp"

#include <functional>
#include <glm/geometric.hpp>
#include <limits>

#include "support.hpp"

namespace splinecore {

namespace {

using namespace testing;

struct Place {
  glm::dvec3 point;
  glm::dvec3 normal;
};

/// Points and normals on a grid of both domains, ends included.
std::vector<Place> places(const NurbsPatch& patch, int count = 41) {
  const auto steps = [&](Axis axis) {
    const Interval domain = patch.knot_vector(axis).domain();
    std::vector<double> at;
    for (int i = 0; i < count; ++i) at.push_back(domain.start + domain.length() * i / (count - 1));
    at.back() = domain.end;
    return at;
  };
  std::vector<glm::dvec3> points(count * count);
  std::vector<glm::dvec3> normals(count * count);
  evaluate_grid_with_normals(patch, steps(Axis::u), steps(Axis::v), std::span(&points[0].x, 3 * points.size()),
                             std::span(&normals[0].x, 3 * normals.size()));
  std::vector<Place> found;
  for (std::size_t i = 0; i < points.size(); ++i) found.push_back({points[i], normals[i]});
  return found;
}

const glm::dvec3 kCenter(1.0, -2.0, 0.5);
const glm::dvec3 kAxis(2.0, -1.0, 2.0);
const glm::dvec3 kUnit = kAxis / 3.0;

/// Height above the center and the rest of the way, across the axis.
struct Cylindrical {
  double height;
  glm::dvec3 out;
};

Cylindrical cylindrical(const glm::dvec3& point) {
  const glm::dvec3 v = point - kCenter;
  return {glm::dot(v, kUnit), v - glm::dot(v, kUnit) * kUnit};
}

constexpr double kExact = 4e-15;

}  // namespace

TEST(Primitives, EveryPointOfASphereHasItsRadiusAndItsNormalPointsOut) {
  for (const double radius : {1.0, 2.5, 1e-3}) {
    for (const auto& [point, normal] : places(sphere({0, 0, 0}, radius, kAxis))) {
      EXPECT_NEAR(glm::length(point) / radius, 1.0, kExact);
      EXPECT_LE(largest(normal - point / radius), 1e-14);
    }
  }
}

TEST(Primitives, EveryPointOfACylinderHasItsRadius) {
  for (const auto& [point, normal] : places(cylinder(kCenter, kAxis, 1.5, 4.0))) {
    const auto [height, out] = cylindrical(point);
    EXPECT_NEAR(glm::length(out), 1.5, kExact);
    EXPECT_LE(largest(normal - out / 1.5), 1e-14);
    EXPECT_TRUE(height > -kExact && height < 4.0 + kExact);
  }
}

TEST(Primitives, AConeNarrowsEvenlyUpToItsTip) {
  for (const double top : {0.0, 0.5, 3.0}) {
    for (const auto& [point, normal] : places(cone(kCenter, kAxis, 1.5, 4.0, top))) {
      const auto [height, out] = cylindrical(point);
      EXPECT_NEAR(glm::length(out), 1.5 + (top - 1.5) * height / 4.0, kExact);
      EXPECT_GE(glm::dot(normal, out), -kExact);
    }
  }
}

TEST(Primitives, EveryPointOfATorusHasTheDistanceOfItsTube) {
  for (const auto& [point, normal] : places(torus(kCenter, kAxis, 3.0, 1.25))) {
    const auto [height, out] = cylindrical(point);
    const glm::dvec3 from_tube = point - kCenter - 3.0 * glm::normalize(out);
    EXPECT_NEAR(glm::length(from_tube) / 1.25, 1.0, kExact);
    EXPECT_LE(largest(normal - from_tube / 1.25), 2e-14);
  }
}

TEST(Primitives, ADiscIsFlatWithTheAxisAsNormal) {
  for (const auto& [point, normal] : places(disc(kCenter, kAxis, 2.0))) {
    EXPECT_NEAR(cylindrical(point).height, 0.0, kExact);
    EXPECT_LE(largest(normal - kUnit), 1e-14);
  }
}

TEST(Primitives, APlaneIsWhatItsAxesSay) {
  const NurbsPatch patch = plane({1, 2, 3}, {2, 0, 0}, {1, 1, 0});
  EXPECT_EQ(point_at(patch, 1.0, 1.0), glm::dvec3(4, 3, 3));
  EXPECT_EQ(point_at(patch, 0.5, 0.25), glm::dvec3(2.25, 2.25, 3));
}

TEST(Primitives, ATurnBeginsAtItsStartAndRunsAsFarAsItsSweep) {
  const auto angle = [](const glm::dvec3& p) { return std::atan2(p.y, p.x); };
  const std::vector<std::function<NurbsPatch(Turn)>> makers{
      [](Turn turn) { return cylinder({0, 0, 0}, {0, 0, 1}, 2.0, 1.0, turn); },
      [](Turn turn) { return cone({0, 0, 0}, {0, 0, 1}, 2.0, 1.0, 1.0, turn); },
      [](Turn turn) { return sphere({0, 0, 0}, 2.0, {0, 0, 1}, turn); },
      [](Turn turn) { return torus({0, 0, 0}, {0, 0, 1}, 2.0, 1.0, turn); },
      [](Turn turn) { return disc({0, 0, 0}, {0, 0, 1}, 2.0, turn); }};
  for (const auto& make : makers) {
    for (const double sweep : {0.3, 1.7, -2.9}) {
      const NurbsPatch patch = make({0.2, sweep});
      EXPECT_FALSE(patch.knot_vector(Axis::u).periodic());
      const Interval u = patch.knot_vector(Axis::u).domain();
      EXPECT_NEAR(angle(point_at(patch, u.start, 0.75)), 0.2, 1e-15);
      EXPECT_NEAR(angle(point_at(patch, u.end, 0.75)), 0.2 + sweep, 1e-15);
    }
    EXPECT_TRUE(make({}).knot_vector(Axis::u).periodic());
  }
}

TEST(Primitives, TheEdgesOfASphereArePolesBitForBit) {
  const NurbsPatch patch = sphere(kCenter, 0.7, kAxis);
  for (int i = 0; i < patch.count(Axis::u); ++i) {
    EXPECT_EQ(glm::dvec3(patch.points()[5 * i]), glm::dvec3(patch.points()[0]));
    EXPECT_EQ(glm::dvec3(patch.points()[5 * i + 4]), glm::dvec3(patch.points()[4]));
  }
}

TEST(Primitives, WrongNumbersAreNamed) {
  const glm::dvec3 zero(0.0);
  const glm::dvec3 up(0.0, 0.0, 1.0);
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal([&] { sphere(zero, -1.0); }), "radius = -1 is not a positive length");
  EXPECT_EQ(refusal([&] { sphere(zero, 1.0, zero); }), "axis has no direction: its length is 0");
  EXPECT_EQ(refusal([&] { sphere({0, 0, inf}, 1.0); }), "center.z = inf is not finite");
  EXPECT_EQ(refusal([&] { cylinder(zero, up, 1.0, 0.0); }), "height = 0 is not a positive length");
  EXPECT_EQ(refusal([&] { cylinder(zero, up, inf, 1.0); }), "radius = inf is not a positive length");
  EXPECT_EQ(refusal([&] { cone(zero, up, -1.0, 1.0); }), "radius = -1 is not a length");
  EXPECT_EQ(refusal([&] { cone(zero, up, 0.0, 1.0); }), "radius and top_radius are both 0: the cone is a line");
  EXPECT_EQ(refusal([&] { torus(zero, up, 0.0, 1.0); }), "ring_radius = 0 is not a positive length");
  EXPECT_EQ(refusal([&] { torus(zero, up, 1.0, 1.0, {inf, 1.0}); }), "start = inf is not finite");
  EXPECT_EQ(refusal([&] { disc(zero, up, 1.0, {0.0, 6.3}); }), "sweep = 6.3 is zero or more than a whole turn");
  EXPECT_EQ(refusal([&] { plane(zero, up, zero); }), "axis_b has no direction: its length is 0");
  EXPECT_EQ(refusal([&] { plane(zero, up, -2.0 * up); }), "axis_b is parallel to axis_a: they span no plane");
}

}  // namespace splinecore
