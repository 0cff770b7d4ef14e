#include <limits>

#include "reference.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

/// Derivative k, l of the homogeneous patch, straight from the definition.
Point tensor_derivative(const NurbsPatch& patch, int k, int l, Real u, Real v) {
  const KnotVector& knots_u = patch.knot_vector(Axis::u);
  const KnotVector& knots_v = patch.knot_vector(Axis::v);
  const std::vector<Real> tu = all_knots(knots_u);
  const std::vector<Real> tv = all_knots(knots_v);
  Point sum(0.0L);
  for (int i = 0; i < knots_u.unrolled_count(); ++i) {
    const Real in_u = derivative(tu, i, knots_u.degree(), k, u);
    if (in_u == 0.0L) continue;
    for (int j = 0; j < knots_v.unrolled_count(); ++j) {
      const Point p(patch.points()[(i % knots_u.count()) * knots_v.count() + j % knots_v.count()]);
      const Real weight = p.w == 0.0L ? 1.0L : p.w;
      const Real factor = in_u * derivative(tv, j, knots_v.degree(), l, v);
      sum += factor * Point(weight * glm::vec<3, Real>(p), p.w);
    }
  }
  return sum;
}

NurbsPatch random_patch_of(Random& random, int degree_u, int degree_v, Weights weights) {
  const auto kind = [&](int degree) {
    return Kind{degree, integer(random, 1, 3), static_cast<Ends>(integer(random, 0, 2)), weights};
  };
  const Kind u = kind(degree_u);
  return random_patch(random, u, kind(degree_v));
}

TEST(EvaluatePatch, AgreesWithTheRecursionInLongDouble) {
  Random random(100);
  for (int degree_u = 1; degree_u <= 9; ++degree_u) {
    for (const int degree_v : {1, 3, 9}) {
      for (const Weights weights : {Weights::one, Weights::any}) {
        const NurbsPatch patch = random_patch_of(random, degree_u, degree_v, weights);
        const double u = random_parameters(random, patch.knot_vector(Axis::u).domain(), 1)[0];
        const double v = random_parameters(random, patch.knot_vector(Axis::v).domain(), 1)[0];
        const glm::dvec4 expected(tensor_derivative(patch, 0, 0, u, v));
        EXPECT_LE(largest(homogeneous_at(patch, u, v) - expected), 1e-14 * size_of(patch))
            << degree_u << " " << degree_v;
        const glm::dvec3 p = point_at(patch, u, v);
        EXPECT_LE(largest(expected.w * p - glm::dvec3(expected)), 1e-14 * size_of(patch) * (1.0 + largest(p)))
            << degree_u << " " << degree_v;
      }
    }
  }
}

TEST(EvaluatePatch, OfPositiveWeightsAgreesWithTheHomogeneousPoint) {
  Random random(101);
  for (int round = 0; round < 300; ++round) {
    const NurbsPatch patch = random_patch(random, round % 2 == 0 ? Weights::positive : Weights::one);
    const double u = random_parameters(random, patch.knot_vector(Axis::u).domain(), 1)[0];
    const double v = random_parameters(random, patch.knot_vector(Axis::v).domain(), 1)[0];
    const Point h = tensor_derivative(patch, 0, 0, u, v);
    EXPECT_LE(largest(point_at(patch, u, v) - glm::dvec3(glm::vec<3, Real>(h) / h.w)), 1e-13 * 10);
  }
}

TEST(EvaluatePatch, OnAGridAgreesWithPairsAndRoundsFloatsOnce) {
  Random random(102);
  for (int round = 0; round < 50; ++round) {
    const NurbsPatch patch = random_patch(random, Weights::positive);
    const auto u = random_parameters(random, patch.knot_vector(Axis::u).domain(), 4);
    const auto v = random_parameters(random, patch.knot_vector(Axis::v).domain(), 5);
    std::vector<double> grid(60), with_normals(60), normals(60);
    std::vector<float> floats(60), float_normals(60);
    evaluate_grid(patch, u, v, std::span(grid));
    evaluate_grid(patch, u, v, std::span(floats));
    evaluate_grid_with_normals(patch, u, v, std::span(with_normals), std::span(normals));
    EXPECT_EQ(grid, with_normals);
    evaluate_grid_with_normals(patch, u, v, std::span(floats), std::span(float_normals));
    for (int k = 0; k < 60; ++k) {
      EXPECT_EQ(floats[k], static_cast<float>(grid[k]));
      // A single point around a period makes a curve, which has no normals.
      EXPECT_TRUE(float_normals[k] == static_cast<float>(normals[k]) || std::isnan(normals[k]));
      EXPECT_EQ(std::isnan(float_normals[k]), std::isnan(normals[k]));
      EXPECT_NEAR(grid[k], point_at(patch, u[k / 15], v[k / 3 % 5])[k % 3], 1e-13 * 10);
    }
  }
}

TEST(PatchDerivatives, OfPolynomialPatchesAgreeWithTheDerivedRecursion) {
  Random random(103);
  for (int degree_u = 1; degree_u <= 9; ++degree_u) {
    for (const int degree_v : {1, 2, 5}) {
      const NurbsPatch patch = random_patch_of(random, degree_u, degree_v, Weights::one);
      const double u = random_parameters(random, patch.knot_vector(Axis::u).domain(), 1)[0];
      const double v = random_parameters(random, patch.knot_vector(Axis::v).domain(), 1)[0];
      glm::dvec3 values[9];
      derivatives(patch, {&u, 1}, {&v, 1}, 2, {&values[0].x, 27});
      for (int k = 0; k <= 2; ++k) {
        for (int l = 0; l <= 2; ++l) {
          const double size =
              sum_of_sizes(patch.knot_vector(Axis::u), k, u) * sum_of_sizes(patch.knot_vector(Axis::v), l, v) *
              size_of(patch);
          const glm::dvec3 expected(tensor_derivative(patch, k, l, u, v));
          EXPECT_LE(largest(values[3 * k + l] - expected), 1e-13 * size)
              << degree_u << " " << degree_v << " " << k << " " << l;
        }
      }
    }
  }
}

// x = 1 / ((1 + u)(1 + v)), whose derivative k, l is (-1)^(k+l) k! l! / ((1 + u)^(k+1) (1 + v)^(l+1)).
TEST(PatchDerivatives, OfARationalPatchFollowTheClosedForm) {
  const NurbsPatch patch =
      NurbsPatch::from_homogeneous(KnotVector::bezier(1), KnotVector::bezier(1),
                                   std::vector<glm::dvec4>{{1, 0, 0, 1}, {1, 0, 0, 2}, {1, 0, 0, 2}, {1, 0, 0, 4}});
  const double u = 0.25, v = 0.75;
  std::vector<double> values(3 * 49);
  derivatives(patch, {&u, 1}, {&v, 1}, 6, values);
  for (int k = 0; k <= 6; ++k) {
    for (int l = 0; l <= 6; ++l) {
      const double expected = std::pow(-1, k + l) * std::tgamma(k + 1) * std::tgamma(l + 1) /
                              (std::pow(1 + u, k + 1) * std::pow(1 + v, l + 1));
      EXPECT_NEAR(values[3 * (7 * k + l)] / expected, 1.0, 1e-12) << k << " " << l;
    }
  }
}

TEST(PatchDerivatives, OfARationalPatchAgreeWithDividedDifferences) {
  Random random(104);
  for (int round = 0; round < 100; ++round) {
    const NurbsPatch patch =
        random_patch(random, {3, 1, Ends::clamped, Weights::positive}, {2, 1, Ends::unclamped, Weights::positive});
    const double u = patch.knot_vector(Axis::u).domain().middle();
    const double v = patch.knot_vector(Axis::v).domain().middle();
    const double h = 1e-5 * patch.knot_vector(Axis::u).domain().length();
    const double g = 1e-5 * patch.knot_vector(Axis::v).domain().length();
    glm::dvec3 values[4];
    derivatives(patch, {&u, 1}, {&v, 1}, 1, {&values[0].x, 12});
    const glm::dvec3 along_u = (point_at(patch, u + h, v) - point_at(patch, u - h, v)) / (2 * h);
    const glm::dvec3 along_v = (point_at(patch, u, v + g) - point_at(patch, u, v - g)) / (2 * g);
    EXPECT_LE(largest(values[2] - along_u), 1e-7 * 10 * 1e-5 / h);
    EXPECT_LE(largest(values[1] - along_v), 1e-7 * 10 * 1e-5 / g);
  }
}

TEST(EvaluatePatch, RefusesOrMarksAPointAtInfinity) {
  const NurbsPatch patch = NurbsPatch::make(KnotVector::bezier(1), KnotVector::bezier(1),
                                            {{0, 0, 0, 1}, {0, 1, 0, 1}, {1, 0, 0, -1}, {1, 1, 0, -1}});
  try {
    point_at(patch, 0.5, 0.25);
    FAIL() << "infinity has no point";
  } catch (const PointAtInfinity& error) {
    EXPECT_STREQ(error.what(), "the patch passes through infinity at u = 0.5, v = 0.25");
  }
  const std::vector<double> u{0.25, 0.5};
  const std::vector<double> v{0.5};
  std::vector<double> points(6), normals(6);
  evaluate_grid_with_normals(patch, u, v, std::span(points), std::span(normals), {.at_infinity = AtInfinity::nan});
  for (int k = 0; k < 6; ++k) {
    EXPECT_EQ(std::isnan(points[k]), k >= 3);
    EXPECT_EQ(std::isnan(normals[k]), k >= 3);
  }
}

TEST(EvaluatePatch, NamesTheParameterOutsideTheDomain) {
  const NurbsPatch patch =
      NurbsPatch::make(KnotVector::bezier(1), KnotVector::bezier(1), std::vector<glm::dvec4>(4, glm::dvec4(1)));
  std::vector<double> points(12);
  const std::vector<double> good{0, 1}, bad{0, 7};
  EXPECT_EQ(refusal([&] { evaluate_grid(patch, good, bad, std::span(points)); }),
            "v[1] = 7 is outside the domain [0, 1]");
  EXPECT_EQ(refusal([&] { evaluate(patch, bad, good, std::span(points)); }), "u[1] = 7 is outside the domain [0, 1]");
  EXPECT_EQ(refusal([&] { derivatives(patch, good, good, 65, points); }), "order = 65 is outside [0, 64]");
}

}  // namespace
}  // namespace splinecore
