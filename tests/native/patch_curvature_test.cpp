#include "splinecore/measure/patch_curvature.hpp"

#include <glm/geometric.hpp>

#include "splinecore/build/primitives.hpp"
#include "support.hpp"

namespace splinecore {

namespace {

using namespace testing;

SurfaceCurvature curvature_at(const NurbsPatch& patch, double u, double v, PatchOptions options = {}) {
  SurfaceCurvature found;
  curvatures(patch, {&u, 1}, {&v, 1}, {&found, 1}, options);
  return found;
}

FundamentalForms forms_at(const NurbsPatch& patch, double u, double v) {
  FundamentalForms found;
  fundamental_forms(patch, {&u, 1}, {&v, 1}, {&found, 1});
  return found;
}

/// z = (a x² + b y²) / 2 over [-1, 1]².
NurbsPatch paraboloid(double a, double b) {
  const double square[3] = {1.0, -1.0, 1.0};
  std::vector<glm::dvec4> points;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) points.emplace_back(i - 1.0, j - 1.0, 0.5 * (a * square[i] + b * square[j]), 1.0);
  }
  return NurbsPatch::make(KnotVector::bezier(2), KnotVector::bezier(2), points);
}

}  // namespace

TEST(PatchCurvature, OfASphereAlsoAtItsPoles) {
  for (const double radius : {1.0, 3.0, 1e-100, 1e100}) {
    const NurbsPatch patch = sphere({0, 0, 0}, radius, {1, 2, 2});
    for (const double v : {0.0, 1e-3, 0.4, 1.0, 1.7, 2.0}) {
      for (const double u : {0.0, 0.3, 2.5, 3.99}) {
        const SurfaceCurvature found = curvature_at(patch, u, v);
        EXPECT_NEAR(found.gauss * radius * radius, 1.0, 1e-12);
        EXPECT_NEAR(found.mean * radius, -1.0, 1e-12);
        EXPECT_NEAR(found.principal[0] * radius, -1.0, 1e-12);
        EXPECT_NEAR(found.principal[1] * radius, -1.0, 1e-12);
        const glm::dvec3 point = point_at(patch, u, v) / radius;
        EXPECT_NEAR(glm::dot(found.directions[0], point), 0.0, 1e-12);
        EXPECT_LE(largest(glm::cross(found.directions[0], found.directions[1]) - point), 1e-12);
      }
    }
  }
}

TEST(PatchCurvature, OfATorus) {
  const NurbsPatch patch = torus({0, 0, 0}, {0, 0, 1}, 3.0, 1.0);
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const double u = real(random, 0, 4);
    const double v = real(random, 0, 4);
    const glm::dvec3 p = point_at(patch, u, v);
    const double distance = std::hypot(p.x, p.y);
    const SurfaceCurvature found = curvature_at(patch, u, v);
    EXPECT_NEAR(found.principal[1], -1.0, 1e-13);
    EXPECT_NEAR(found.principal[0], (3.0 - distance) / distance, 1e-13);
    EXPECT_NEAR(found.gauss, (distance - 3.0) / distance, 1e-13);
    EXPECT_LE(std::abs(glm::dot(found.directions[1], glm::dvec3(-p.y, p.x, 0))), 1e-12);
    EXPECT_NEAR(std::abs(glm::dot(found.directions[0], glm::dvec3(-p.y, p.x, 0) / distance)), 1.0, 1e-12);
  }
}

TEST(PatchCurvature, OfASaddleInItsMiddle) {
  const SurfaceCurvature found = curvature_at(paraboloid(3.0, -2.0), 0.5, 0.5);
  EXPECT_NEAR(found.gauss, -6.0, 1e-14);
  EXPECT_NEAR(found.mean, 0.5, 1e-14);
  EXPECT_NEAR(found.principal[0], 3.0, 1e-14);
  EXPECT_NEAR(found.principal[1], -2.0, 1e-14);
  EXPECT_LE(largest(found.directions[0] - glm::dvec3(1, 0, 0)), 1e-14);
  EXPECT_LE(largest(found.directions[1] - glm::dvec3(0, 1, 0)), 1e-14);
}

TEST(PatchCurvature, FormsOfAParaboloid) {
  const FundamentalForms forms = forms_at(paraboloid(3.0, -2.0), 0.75, 0.5);
  // x = 1/2, y = 0; S_u = (2, 0, 3), S_v = (0, 2, 0), S_uu = (0, 0, 12), S_vv = (0, 0, -8).
  const double z = 2.0 / std::sqrt(13.0);
  EXPECT_NEAR(forms.e, 13.0, 1e-13);
  EXPECT_NEAR(forms.f, 0.0, 1e-13);
  EXPECT_NEAR(forms.g, 4.0, 1e-13);
  EXPECT_NEAR(forms.l, 12.0 * z, 1e-13);
  EXPECT_NEAR(forms.m, 0.0, 1e-13);
  EXPECT_NEAR(forms.n, -8.0 * z, 1e-13);
}

static KnotVector divided(const KnotVector& knots, int exponent) {
  std::vector<double> divided(knots.knots().begin(), knots.knots().end());
  for (double& u : divided) u = std::scalbn(u, -exponent);
  return KnotVector::make(knots.degree(), std::move(divided), knots.periodic());
}

TEST(PatchCurvature, DoesNotDependOnTheScaleOfParameters) {
  Random random(7);
  const NurbsPatch patch = random_patch(random, Weights::positive);
  const Interval domain_u = patch.knot_vector(Axis::u).domain();
  const Interval domain_v = patch.knot_vector(Axis::v).domain();
  const double u = 0.3 * domain_u.start + 0.7 * domain_u.end;
  const double v = 0.6 * domain_v.start + 0.4 * domain_v.end;
  const SurfaceCurvature here = curvature_at(patch, u, v);
  const FundamentalForms forms = forms_at(patch, u, v);
  for (const auto& [by_u, by_v] : {std::pair{500, 500}, std::pair{-500, -500}, std::pair{700, 0}, std::pair{0, -600}}) {
    const NurbsPatch other =
        NurbsPatch::make(divided(patch.knot_vector(Axis::u), by_u), divided(patch.knot_vector(Axis::v), by_v),
                         {patch.points().begin(), patch.points().end()});
    const double there_u = std::scalbn(u, -by_u);
    const double there_v = std::scalbn(v, -by_v);
    const SurfaceCurvature there = curvature_at(other, there_u, there_v);
    EXPECT_NEAR(there.gauss / here.gauss, 1.0, 1e-12) << by_u << " " << by_v;
    EXPECT_NEAR(there.mean / here.mean, 1.0, 1e-12) << by_u << " " << by_v;
    if (std::abs(by_u) + std::abs(by_v) == 1000) {
      const FundamentalForms scaled = forms_at(other, there_u, there_v);
      EXPECT_NEAR(scaled.f / std::scalbn(forms.f, by_u + by_v), 1.0, 1e-12);
      EXPECT_NEAR(scaled.n / std::scalbn(forms.n, 2 * by_v), 1.0, 1e-12);
    } else if (by_u > 0) {
      EXPECT_EQ(refusal([&] { forms_at(other, there_u, there_v); }), "the first form is too large for a number");
    }
  }
}

TEST(PatchCurvature, ObeysTheWeingartenEquationsOfItsForms) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const NurbsPatch patch = random_patch(random, Weights::positive);
    if (std::min(patch.count(Axis::u), patch.count(Axis::v)) == 1) continue;  // periodic, and only a line
    const double u = real(random, patch.knot_vector(Axis::u).domain().start, patch.knot_vector(Axis::u).domain().end);
    const double v = real(random, patch.knot_vector(Axis::v).domain().start, patch.knot_vector(Axis::v).domain().end);
    const FundamentalForms f = forms_at(patch, u, v);
    const double determinant = f.e * f.g - f.f * f.f;
    if (determinant < 1e-3 * f.e * f.g) continue;
    const SurfaceCurvature found = curvature_at(patch, u, v);
    const double size = found.principal[0] * found.principal[0] + found.principal[1] * found.principal[1];
    EXPECT_NEAR(found.gauss, (f.l * f.n - f.m * f.m) / determinant, 1e-9 * size);
    EXPECT_NEAR(found.mean, 0.5 * (f.e * f.n - 2.0 * f.f * f.m + f.g * f.l) / determinant, 1e-9 * std::sqrt(size));
    EXPECT_NEAR(found.principal[0] * found.principal[1], found.gauss, 1e-12 * size);
  }
}

TEST(PatchCurvature, SwappingTurnsTheMeanOver) {
  Random random(3);
  const NurbsPatch patch = random_patch(random, Weights::positive);
  const double u = patch.knot_vector(Axis::u).domain().middle();
  const double v = patch.knot_vector(Axis::v).domain().middle();
  const SurfaceCurvature one = curvature_at(patch, u, v);
  const SurfaceCurvature other = curvature_at(swapped(patch), v, u);
  EXPECT_NEAR(one.gauss, other.gauss, 1e-10 * std::abs(one.gauss));
  EXPECT_NEAR(one.mean, -other.mean, 1e-10 * std::abs(one.principal[0]));
}

TEST(PatchCurvature, AtAPoleThatIsNoSmoothPointThereIsNone) {
  const NurbsPatch tip = cone({0, 0, 0}, {0, 0, 1}, 1.0, 1.0);
  EXPECT_TRUE(std::isnan(curvature_at(tip, 0.3, 1.0).gauss));
  EXPECT_NEAR(curvature_at(tip, 0.3, 0.5).gauss, 0.0, 1e-13);
  EXPECT_NEAR(curvature_at(tip, 0.3, 0.5).mean, -0.5 * std::sqrt(0.5) / 0.5, 1e-13);
  // Flat all around: all lines through the pole agree.
  EXPECT_EQ(curvature_at(disc({0, 0, 0}, {0, 0, 1}, 1.0), 0.3, 1.0).gauss, 0.0);
}

TEST(PatchCurvature, AnEllipsoidHasTwoCurvaturesAtItsPole) {
  const NurbsPatch ball = sphere({0, 0, 0}, 1.0);
  std::vector<glm::dvec4> points(ball.points().begin(), ball.points().end());
  for (glm::dvec4& p : points) p *= glm::dvec4(2.0, 3.0, 1.0, 1.0);
  const SurfaceCurvature found = curvature_at(ball.with_points(points), 0.4, 2.0);
  EXPECT_NEAR(found.principal[0], -1.0 / 9.0, 1e-13);
  EXPECT_NEAR(found.principal[1], -1.0 / 4.0, 1e-13);
  EXPECT_NEAR(std::abs(found.directions[0].y), 1.0, 1e-13);
}

}  // namespace splinecore
