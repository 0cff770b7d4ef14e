#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "splinecore/patch/isocurve.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

constexpr double kHalfRoot = std::numbers::sqrt2 / 2;

glm::dvec3 normal_at(const NurbsPatch& patch, double u, double v, PatchOptions options = {}) {
  glm::dvec3 point, normal;
  evaluate_grid_with_normals(patch, {&u, 1}, {&v, 1}, std::span(&point.x, 3), std::span(&normal.x, 3), options);
  return normal;
}

NurbsPatch bezier(int degree_u, int degree_v, std::vector<glm::dvec4> points) {
  return NurbsPatch::make(KnotVector::bezier(degree_u), KnotVector::bezier(degree_v), std::move(points));
}

/// A point (radius, height, weight) of a profile turned by a quarter about the z axis.
std::vector<glm::dvec4> turned(const std::vector<glm::dvec3>& profile) {
  std::vector<glm::dvec4> net;
  for (const glm::dvec3& p : profile) {
    net.insert(net.end(), {{p.x, 0, p.y, p.z}, {p.x, p.x, p.y, p.z * kHalfRoot}, {0, p.x, p.y, p.z}});
  }
  return net;
}

TEST(PatchNormals, OfRandomPatchesAreUnitVectorsAlongTheCrossProduct) {
  Random random(110);
  int curves = 0;
  for (int round = 0; round < 200; ++round) {
    const NurbsPatch patch = random_patch(random, Weights::positive);
    const double u = random_parameters(random, patch.knot_vector(Axis::u).domain(), 1)[0];
    const double v = random_parameters(random, patch.knot_vector(Axis::v).domain(), 1)[0];
    glm::dvec3 values[4];
    derivatives(patch, {&u, 1}, {&v, 1}, 1, {&values[0].x, 12});
    const glm::dvec3 expected = glm::cross(values[2], values[1]);
    if (patch.count(Axis::u) == 1 || patch.count(Axis::v) == 1) {
      // A single point around a period makes a curve, not a surface.
      EXPECT_TRUE(std::isnan(normal_at(patch, u, v).x)) << round;
      ++curves;
      continue;
    }
    // What rounding may have made of the product.
    const double noise = 1e-11 * glm::length(values[2]) * glm::length(values[1]) / glm::length(expected);
    EXPECT_LE(largest(normal_at(patch, u, v) - glm::normalize(expected)), noise) << round;
    EXPECT_NEAR(glm::length(normal_at(patch, u, v)), 1.0, 1e-14);
  }
  EXPECT_LE(curves, 10);
}

TEST(PatchNormals, OfASphereOctantPointToItsCenterAlsoAtThePole) {
  // u runs north and v runs east, so S_u x S_v points inwards.
  const NurbsPatch octant = bezier(2, 2, turned({{1, 0, 1}, {1, 1, kHalfRoot}, {0, 1, 1}}));
  for (int i = 0; i <= 16; ++i) {
    for (int j = 0; j <= 16; ++j) {
      const double u = i / 16.0, v = j / 16.0;
      EXPECT_LE(largest(normal_at(octant, u, v) + point_at(octant, u, v)), 1e-12) << u << " " << v;
    }
  }
}

TEST(PatchNormals, NearAPoleAgreeWithThoseAtThePole) {
  const NurbsPatch octant = bezier(2, 2, turned({{0, 1, 1}, {1, 1, kHalfRoot}, {1, 0, 1}}));
  for (const double u : {0.0, 1e-300, 1e-20, 1e-14, 1e-12, 1e-10, 1e-8}) {
    EXPECT_LE(largest(normal_at(octant, u, 0.3) - glm::dvec3(0, 0, 1)), 2e-8 + 2 * u) << u;
  }
}

TEST(PatchNormals, AtTheKnobOfALidPointUp) {
  // A bicubic Bezier patch whose first row is one point and whose second row lies level with it.
  const double k = 4.0 / 3 * (std::numbers::sqrt2 - 1);
  std::vector<glm::dvec4> net;
  for (const auto& [radius, height] : {std::pair{0.0, 3.15}, {0.8, 3.15}, {0.0, 2.7}, {0.2, 2.55}}) {
    net.insert(net.end(), {{radius, 0, height, 1},
                           {radius, k * radius, height, 1},
                           {k * radius, radius, height, 1},
                           {0, radius, height, 1}});
  }
  const NurbsPatch lid = bezier(3, 3, net);
  for (int j = 0; j <= 8; ++j) EXPECT_LE(largest(normal_at(lid, 0, j / 8.0) - glm::dvec3(0, 0, 1)), 1e-12) << j;
  // The same edge at each of the other sides; the pole keeps the orientation of the faces.
  const auto [u, v] = std::pair{Axis::u, Axis::v};
  EXPECT_LE(largest(normal_at(reversed(lid, u), 1, 0.4) + glm::dvec3(0, 0, 1)), 1e-12);
  EXPECT_LE(largest(normal_at(swapped(lid), 0.4, 0) + glm::dvec3(0, 0, 1)), 1e-12);
  EXPECT_LE(largest(normal_at(reversed(swapped(lid), v), 0.4, 1) - glm::dvec3(0, 0, 1)), 1e-12);
}

TEST(PatchNormals, AtTheApexOfAConeAreThoseOfTheRuling) {
  const NurbsPatch cone = bezier(1, 2, turned({{0, 1, 1}, {1, 0, 1}}));
  for (int j = 0; j <= 8; ++j) {
    const double v = j / 8.0;
    EXPECT_LE(largest(normal_at(cone, 0, v) - normal_at(cone, 1, v)), 1e-12) << v;
    EXPECT_LE(largest(normal_at(reversed(cone, Axis::u), 1, v) + normal_at(cone, 1, v)), 1e-12) << v;
  }
}

TEST(PatchNormals, AtAnInnerApexAreTheLimitOfTheSideAskedFor) {
  // Two cones that meet in their common apex at u = 1.
  const NurbsPatch cones =
      NurbsPatch::make(KnotVector::clamped(1, 3), KnotVector::bezier(2), turned({{1, -1, 1}, {0, 0, 1}, {1, 1, 1}}));
  for (const double v : {0.0, 0.5, 1.0}) {
    EXPECT_LE(largest(normal_at(cones, 1, v, {.side_u = Side::left}) - normal_at(cones, 0.5, v)), 1e-12) << v;
    EXPECT_LE(largest(normal_at(cones, 1, v, {.side_u = Side::right}) - normal_at(cones, 1.5, v)), 1e-12) << v;
  }
}

TEST(PatchNormals, WhereTwoAdjacentEdgesHaveCollapsedAreTheLimitFromInside) {
  // S = (u v, u v^2, 0) has S_u x S_v = (0, 0, u v^2).
  const NurbsPatch flat =
      bezier(1, 2, {{0, 0, 0, 1}, {0, 0, 0, 1}, {0, 0, 0, 1}, {0, 0, 0, 1}, {0.5, 0, 0, 1}, {1, 1, 0, 1}});
  for (const auto& [u, v] : {std::pair{0.0, 0.0}, {0.0, 0.5}, {0.5, 0.0}, {0.0, 1.0}, {1.0, 0.0}}) {
    EXPECT_LE(largest(normal_at(flat, u, v) - glm::dvec3(0, 0, 1)), 1e-12) << u << " " << v;
  }
}

TEST(PatchNormals, OfRandomPatchesWithTwoCollapsedEdgesAreContinuousTowardsTheDiagonal) {
  Random random(111);
  for (int round = 0; round < 1000; ++round) {
    std::vector<glm::dvec4> net = random_points(random, 16, Weights::positive);
    for (int k = 1; k < 4; ++k) {
      for (const int i : {k, 4 * k}) net[i] = glm::dvec4(glm::dvec3(net[0]), net[i].w);
    }
    const NurbsPatch patch = bezier(3, 3, net);
    EXPECT_LE(largest(normal_at(patch, 0, 0) - normal_at(patch, 5e-6, 5e-6)), 1e-2) << round;
    EXPECT_NEAR(glm::length(normal_at(patch, 0, 0)), 1.0, 1e-14);
  }
}

/// A random net whose row along one of the sides is one point.
NurbsPatch with_pole(Random& random, Border side, int degree_u, int degree_v, double scale) {
  const int rows = degree_u + 1, columns = degree_v + 1;
  std::vector<glm::dvec4> net = random_points(random, rows * columns, Weights::positive);
  const glm::dvec3 pole = random_vector(random);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const int across = axis_of(side) == Axis::u ? i : j;
      const int last = axis_of(side) == Axis::u ? degree_u : degree_v;
      glm::dvec4& p = net[i * columns + j];
      if (across == (is_at_end(side) ? last : 0)) p = glm::dvec4(pole, p.w);
      p = glm::dvec4(scale * glm::dvec3(p), p.w);
    }
  }
  return bezier(degree_u, degree_v, net);
}

TEST(PatchNormals, AtSidesThatArePointsAreTheLimitsFromInside) {
  Random random(118);
  constexpr double kStep = 1e-6;
  for (int round = 0; round < 400; ++round) {
    const auto side = static_cast<Border>(round % 4);
    const double scale = std::array{1.0, 1e-150, 1e150, 1e-9}[round / 4 % 4];
    const NurbsPatch patch = with_pole(random, side, integer(random, 1, 4), integer(random, 1, 4), scale);
    const double at = is_at_end(side) ? 1.0 : 0.0;
    const double inside = is_at_end(side) ? 1.0 - kStep : kStep;
    for (const double along : {0.2, 0.5, 0.9}) {
      const bool is_along_v = axis_of(side) == Axis::u;
      const glm::dvec3 limit = is_along_v ? normal_at(patch, at, along) : normal_at(patch, along, at);
      const glm::dvec3 near = is_along_v ? normal_at(patch, inside, along) : normal_at(patch, along, inside);
      EXPECT_NEAR(glm::length(limit), 1.0, 1e-14) << round;
      EXPECT_LE(largest(limit - near), 1e-2) << round;
    }
  }
}

TEST(PatchNormals, AtSidesThatArePointsAreTheSameAloneAndInAnyGrid) {
  Random random(119);
  const std::vector<double> line{0.0, 0.1, 0.25, 0.3, 0.5, 0.6, 0.7, 0.75, 0.8, 0.95, 1.0};
  const std::size_t n = line.size();
  for (int round = 0; round < 40; ++round) {
    const NurbsPatch patch = with_pole(random, static_cast<Border>(round % 4), 3, 1 + round / 4 % 4, 1.0);
    std::vector<double> points(3 * n * n), normals(3 * n * n), paired(3 * n * n), u, v;
    evaluate_grid_with_normals(patch, line, line, points, normals);
    for (std::size_t k = 0; k < n * n; ++k) {
      u.push_back(line[k / n]);
      v.push_back(line[k % n]);
    }
    evaluate_with_normals(patch, u, v, points, paired);
    std::vector<float> single_points(3 * n * n), single(3 * n * n);
    evaluate_grid_with_normals(patch, line, line, single_points, single);
    for (std::size_t k = 0; k < n * n; ++k) {
      const glm::dvec3 alone = normal_at(patch, u[k], v[k]);
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(normals[3 * k + axis], alone[axis]) << round << " " << u[k] << " " << v[k];
        EXPECT_EQ(static_cast<float>(alone[axis]), single[3 * k + axis]) << round;
        const bool is_pole = u[k] == 0.0 || u[k] == 1.0 || v[k] == 0.0 || v[k] == 1.0;
        if (is_pole) {
          EXPECT_EQ(paired[3 * k + axis], alone[axis]) << round;
        }
      }
    }
  }
}

TEST(PatchNormals, OfACurveBetweenTwoPolesAreNone) {
  // Both ends of u are one point each and the patch is a curve between them: no cone has a normal.
  const NurbsPatch spindle =
      bezier(2, 1, {{0, 0, 0, 1}, {0, 0, 0, 1}, {1, 1, 0, 1}, {1, 1, 0, 1}, {2, 0, 0, 1}, {2, 0, 0, 1}});
  for (const double u : {0.0, 0.5, 1.0}) EXPECT_TRUE(std::isnan(normal_at(spindle, u, 0.5).x)) << u;
}

TEST(PatchNormals, AtAnApexWithDirectionsBesideItAreThoseOfTheCone) {
  // A half cone: the middle of its circle is a direction, a point of weight 0.
  const NurbsPatch cone =
      bezier(1, 2, {{0, 0, 1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, {1, 0, 0, 1}, {0, 1, 0, 0}, {-1, 0, 0, 1}});
  for (const double v : {0.1, 0.4, 0.8}) {
    EXPECT_LE(largest(normal_at(cone, 0.0, v) - normal_at(cone, 1e-7, v)), 1e-6) << v;
  }
}

bool is_none(const glm::dvec3& normal) { return std::isnan(normal.x) && std::isnan(normal.y) && std::isnan(normal.z); }

TEST(PatchNormals, OfAPatchThatIsACurveOrAPointAreNone) {
  const NurbsPatch line = bezier(1, 1, {{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 0, 0, 1}, {1, 0, 0, 1}});
  EXPECT_TRUE(is_none(normal_at(line, 0.5, 0.5)));
  const NurbsPatch point = bezier(1, 2, std::vector<glm::dvec4>(6, {1, 2, 3, 1}));
  EXPECT_TRUE(is_none(normal_at(point, 0.5, 0.25)));
  EXPECT_TRUE(is_none(normal_at(point, 0.0, 0.0)));
}

TEST(PatchNormals, OfARegularPatchAreRightAtEveryScale) {
  const std::vector<glm::dvec4> points{{0, 0, 0, 1}, {0, 1, 0.5, 2}, {1, 0, 0.25, 0.5}, {1, 1, 0, 1}};
  const NurbsPatch patch = bezier(1, 1, points);
  for (const double scale : {5e-308, 1e-170, 1e-150, 1e-80, 1e-30, 1e30, 1e80, 1e150, 1e300}) {
    std::vector<glm::dvec4> scaled = points;
    for (glm::dvec4& p : scaled) p = glm::dvec4(scale * glm::dvec3(p), p.w);
    const glm::dvec3 normal = normal_at(bezier(1, 1, scaled), 0.3, 0.6);
    EXPECT_LE(largest(normal - normal_at(patch, 0.3, 0.6)), 1e-14) << scale;
    EXPECT_NEAR(glm::length(normal), 1.0, 1e-15) << scale;
  }
}

TEST(PatchNormals, OfAThinStripFarAwayAreThoseThatItsPointsTell) {
  // A strip 2^-13 wide at 1e9, where points lie on a grid of 2^-23: three digits of the width.
  const double far = 1e9;
  const double wide = 0x1p-13;
  const NurbsPatch strip =
      bezier(1, 1, {{far, 0, 0, 1}, {far, 1, 0, 1}, {far + wide, 0, wide, 1}, {far + wide, 1, wide, 1}});
  const glm::dvec3 expected = glm::normalize(glm::cross(glm::dvec3(wide, 0, wide), glm::dvec3(0, 1, 0)));
  for (const double u : {0.0, 0.3, 1.0}) EXPECT_LE(largest(normal_at(strip, u, 0.7) - expected), 1e-12) << u;
}

TEST(PatchNormals, OfAStripAreRightOrNoneWhereItIsNoWiderThanRoundingOfItsLength) {
  const double u = 0.3, v = 0.6;
  const double cos = std::cos(0.7), sin = std::sin(0.7);
  const auto turned_over = [&](const glm::dvec3& p) {
    const glm::dvec3 rolled(cos * p.x - sin * p.y, sin * p.x + cos * p.y, p.z);
    return glm::dvec3(rolled.x * cos - rolled.z * sin, rolled.y, rolled.x * sin + rolled.z * cos);
  };
  int found = 0;
  for (const double wide : {1e-2, 1e-6, 1e-10, 1e-12, 1e-13, 1e-14, 1e-15, 1e-16, 1e-17, 1e-30, 1e-150, 1e-300}) {
    // S = (u, wide v, wide u v), also turned, so that its width is the difference of large coordinates.
    const std::array<glm::dvec3, 4> corners{{{0, 0, 0}, {0, wide, 0}, {1, 0, 0}, {1, wide, wide}}};
    const glm::dvec3 expected = glm::normalize(glm::dvec3(-wide * v, -u, 1));
    for (const bool is_turned : {false, true}) {
      std::vector<glm::dvec4> net;
      for (const glm::dvec3& p : corners) net.emplace_back(is_turned ? turned_over(p) : p, 1.0);
      const glm::dvec3 normal = normal_at(bezier(1, 1, net), u, v);
      const glm::dvec3 right = is_turned ? turned_over(expected) : expected;
      EXPECT_EQ(std::isnan(normal.x), wide < 1e-16 || (std::isnan(normal.x) && wide < 1e-13)) << wide;
      if (std::isnan(normal.x)) continue;
      EXPECT_LE(largest(normal - right), is_turned ? 1e-15 / wide : 1e-14) << wide;
      ++found;
    }
  }
  EXPECT_GE(found, 10);
}

TEST(PatchNormals, FarAwayWithWildWeightsAreThoseNearTheOrigin) {
  // Moved by a power of two by which no point is rounded.
  Random random(117);
  for (int round = 0; round < 200; ++round) {
    std::vector<glm::dvec4> net;
    for (int k = 0; k < 9; ++k) {
      const double weight = std::ldexp(1.0, integer(random, -7, 10));
      const auto grid = [&] { return std::ldexp(std::round(std::ldexp(real(random, -1.0, 1.0), 20)), -20); };
      net.emplace_back(k / 3 + 0.25 * grid(), k % 3 + 0.25 * grid(), grid(), weight);
    }
    std::vector<glm::dvec4> moved = net;
    for (glm::dvec4& p : moved) p.x += 0x1p27;
    for (const auto& [u, v] : {std::pair{0.5, 0.5}, {0.0, 1.0}, {0.9, 0.2}}) {
      EXPECT_LE(largest(normal_at(bezier(2, 2, moved), u, v) - normal_at(bezier(2, 2, net), u, v)), 1e-6) << round;
    }
  }
}

TEST(PatchNormals, DoNotDependOnTheSizeOfThePatchOrItsPlace) {
  const std::vector<glm::dvec4> points = turned({{1, 0, 1}, {1, 1, kHalfRoot}, {0, 1, 1}});
  const NurbsPatch octant = bezier(2, 2, points);
  for (const double scale : {1e-30, 1e-9, 1e9, 1e30}) {
    std::vector<glm::dvec4> scaled = points;
    for (glm::dvec4& p : scaled) p = glm::dvec4(scale * glm::dvec3(p), p.w);
    for (const double u : {0.0, 0.5, 1.0}) {
      EXPECT_LE(largest(normal_at(bezier(2, 2, scaled), u, 0.3) - normal_at(octant, u, 0.3)), 1e-12)
          << scale << " " << u;
    }
  }
  std::vector<glm::dvec4> far = points;
  for (glm::dvec4& p : far) p += glm::dvec4(1024, -4096, 512, 0);
  for (const double u : {0.0, 0.5, 1.0}) {
    EXPECT_LE(largest(normal_at(bezier(2, 2, far), u, 0.3) - normal_at(octant, u, 0.3)), 1e-10) << u;
  }
}

TEST(PatchNormals, AtAPoleFarFromTheOriginAreNotMadeOfRounding) {
  std::vector<glm::dvec4> points = turned({{1, 0, 1}, {1, 1, kHalfRoot}, {0, 1, 1}});
  for (glm::dvec4& p : points) p += glm::dvec4(1e5, 3e5, -2e5, 0);
  const NurbsPatch octant = bezier(2, 2, points);
  for (int j = 0; j <= 16; ++j) {
    EXPECT_LE(largest(normal_at(octant, 1, j / 16.0) + glm::dvec3(0, 0, 1)), 1e-6) << j;
  }
}

}  // namespace
}  // namespace splinecore
