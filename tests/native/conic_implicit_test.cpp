#include <glm/geometric.hpp>

#include "splinecore/conic/conic_arc.hpp"
#include "splinecore/conic/ellipse.hpp"
#include "splinecore/conic/implicit_form.hpp"
#include "splinecore/curve/finite_arcs.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;
using Six = std::array<double, 6>;

ConicType type_of(const Six& k) { return ImplicitConic::make(k).type(); }

/// The conic's value at a point, relative to its largest term at the size of the shape.
double residual(const ImplicitConic& conic, const glm::dvec3& point) {
  const glm::dvec2 p = point_in(conic.plane(), point);
  const double size = std::max({10.0, std::abs(p.x), std::abs(p.y)});
  const double terms[6] = {p.x * p.x, p.x * p.y, p.y * p.y, p.x, p.y, 1.0};
  const double sizes[6] = {size * size, size * size, size * size, size, size, 1.0};
  double sum = 0.0, largest_term = 0.0;
  for (int i = 0; i < 6; ++i) {
    sum += conic.coefficients()[i] * terms[i];
    largest_term = std::max(largest_term, std::abs(conic.coefficients()[i] * sizes[i]));
  }
  return std::abs(sum) / largest_term;
}

/// Coefficients of the same conic turned and moved.
Six moved(const Six& k, double angle, double x, double y) {
  const double c = std::cos(angle), s = std::sin(angle);
  const auto [a, b, cc, d, e, f] = k;
  const Six turned{a * c * c - b * c * s + cc * s * s, 2 * (a - cc) * c * s + b * (c * c - s * s),
                   a * s * s + b * c * s + cc * c * c, d * c - e * s, d * s + e * c, f};
  const auto [p, q, r, u, v, w] = turned;
  return {p, q, r, u - 2 * p * x - q * y, v - 2 * r * y - q * x,
          w + p * x * x + q * x * y + r * y * y - u * x - v * y};
}

TEST(ImplicitConic, TellsEveryType) {
  EXPECT_EQ(type_of({1, 0, 1, 0, 0, -1}), ConicType::circle);
  EXPECT_EQ(type_of({1, 0, 4, 0, 0, -4}), ConicType::ellipse);
  EXPECT_EQ(type_of({1, 0, 0, 0, -1, 0}), ConicType::parabola);
  EXPECT_EQ(type_of({1, 2, 1, 1, 0, 0}), ConicType::parabola);
  EXPECT_EQ(type_of({0, 1, 0, 0, 0, -1}), ConicType::hyperbola);
  EXPECT_EQ(type_of({0, 1, 0, 0, 0, 0}), ConicType::crossing_lines);
  EXPECT_EQ(type_of({1, 0, 0, 0, 0, -1}), ConicType::parallel_lines);
  EXPECT_EQ(type_of({1, -2, 1, 0, 0, 0}), ConicType::line);
  EXPECT_EQ(type_of({0, 0, 0, 1, 2, 3}), ConicType::line);
  EXPECT_EQ(type_of({1, 0, 1, 0, 0, 0}), ConicType::point);
  EXPECT_EQ(type_of({1, 0, 1, 0, 0, 1}), ConicType::empty);
  EXPECT_EQ(type_of({1, 0, 0, 0, 0, 1}), ConicType::empty);
  EXPECT_EQ(type_of({0, 0, 0, 0, 0, 1}), ConicType::empty);
}

TEST(ImplicitConic, TypeAndShapeStayWhenTurnedMovedAndMultiplied) {
  const std::vector<Six> conics{{1, 0, 4, 0, 0, -4}, {1, 0, 0, 0, -1, 0}, {1, 0, -2, 0, 0, -1}, {1, 0, 1, 0, 0, -9},
                                {1, 0, -3, 0, 0, 0}, {1, 0, 0, 0, 0, -4}, {2, 0, 1, 0, 0, 0}, {1, 0, 3, 0, 0, 5}};
  const auto is_exact = [](ConicType type) { return type == ConicType::parabola || type == ConicType::parallel_lines; };
  Random random(550);
  int lost = 0;
  for (int round = 0; round < 2000; ++round) {
    const Six& k = conics[round % conics.size()];
    const ImplicitConic plain = ImplicitConic::make(k);
    Six other = moved(k, real(random, -4, 4), real(random, -3, 3), real(random, -3, 3));
    const double factor = (integer(random, 0, 1) == 0 ? 1 : -1) * std::exp2(integer(random, -300, 300));
    for (double& value : other) value *= factor;
    const ImplicitConic found = ImplicitConic::make(other);
    // A parabola or a parallel pair whose determinant rounding leaves above the noise is not known again.
    if (is_exact(plain.type()) && found.type() != plain.type()) {
      ++lost;
      continue;
    }
    ASSERT_EQ(found.type(), plain.type()) << round;
    EXPECT_NEAR(found.shape().first, plain.shape().first, 1e-11);
    EXPECT_NEAR(found.shape().second, plain.shape().second, 1e-11);
  }
  EXPECT_LE(lost, 2);
}

TEST(ImplicitConic, OfAnEllipseHasFociWhoseDistancesAddUp) {
  const ImplicitConic conic = ImplicitConic::make(moved({9, 0, 25, 0, 0, -225}, 0.4, 2, -1));
  EXPECT_NEAR(conic.shape().first, 5, 1e-13);
  EXPECT_NEAR(conic.shape().second, 3, 1e-13);
  EXPECT_NEAR(*eccentricity(conic), 0.8, 1e-14);
  EXPECT_LE(largest(*center(conic) - glm::dvec3(2, -1, 0)), 1e-14 * 10);
  const auto focus = foci(conic);
  const auto curves = curves_of(conic);
  ASSERT_EQ(curves.size(), 1u);
  for (int i = 0; i <= 40; ++i) {
    const glm::dvec3 p = point_at(curves[0], i / 10.0);
    EXPECT_NEAR(glm::distance(p, focus[0]) + glm::distance(p, focus[1]), 10, 1e-13);
  }
}

TEST(ImplicitConic, NeedsCoefficients) {
  EXPECT_EQ(refusal([] { ImplicitConic::make({0, 0, 0, 0, 0, 0}); }),
            "coefficients are all zero: every point of the plane would lie on the conic");
  EXPECT_EQ(refusal([] { ImplicitConic::make({1, 0, std::nan(""), 0, 0, 0}); }), "coefficients[2] = nan is not finite");
  EXPECT_EQ(refusal([] { ImplicitConic::make({1, 0, 1, 1e300, 0, 0}); }),
            "coefficients describe a conic beyond the range of numbers");
  EXPECT_NE(refusal([] { plane_along({0, 0, 0}, {1, 0, 0}, {2, 0, 0}); }), "not refused");
}

TEST(ImplicitForm, HoldsOnTheCurveForThousandCurvesInSpace) {
  Random random(551);
  for (int round = 0; round < 1000; ++round) {
    const BezierCurve curve = BezierCurve::make(random_points(random, 3, Weights::any));
    const ImplicitConic conic = implicit_conic(curve);
    for (const double u : random_parameters(random, {0, 1}, 5)) {
      const glm::dvec4 h = homogeneous_at(curve.nurbs(), u);
      if (std::abs(h.w) < 1e-3) continue;
      EXPECT_LE(residual(conic, glm::dvec3(h) / h.w), 1e-12) << round;
    }
  }
}

TEST(ImplicitForm, HasTheTypeOfTheClass) {
  const auto type = [](double w1) { return implicit_conic(conic_arc({0, 0, 0}, {1, 3, 1}, {4, 0, 2}, w1)).type(); };
  for (const double w1 : {0.3, -0.3, 0.99, -0.99}) EXPECT_EQ(type(w1), ConicType::ellipse) << w1;
  for (const double w1 : {1.0, -1.0}) EXPECT_EQ(type(w1), ConicType::parabola) << w1;
  for (const double w1 : {1.01, -1.01, 7.0, -7.0}) EXPECT_EQ(type(w1), ConicType::hyperbola) << w1;
}

TEST(ImplicitForm, OfAQuarterCircleIsItsEquation) {
  const ImplicitConic conic = implicit_conic(BezierCurve::make({{1, 0, 0, 1}, {1, 1, 0, 1}, {0, 1, 0, 2}}));
  EXPECT_EQ(conic.coefficients(), (Six{1, 0, 1, 0, 0, -1}));
  EXPECT_EQ(conic.plane(), Plane{});
}

TEST(ImplicitForm, AndBackIsTheSameConicForThousandConics) {
  Random random(552);
  for (int round = 0; round < 1000; ++round) {
    Six k;
    for (double& value : k) value = integer(random, -9, 9);
    if (std::ranges::all_of(k, [](double value) { return value == 0.0; })) continue;
    const ImplicitConic conic = ImplicitConic::make(k);
    for (const NurbsCurve& curve : curves_of(conic)) {
      for (const NurbsCurve& arc : finite_arcs(curve, 10.0)) {
        for (int i = 1; i < 16; ++i) {
          const double u = arc.domain().start + arc.domain().length() * i / 16;
          EXPECT_LE(residual(conic, point_at(arc, u)), 1e-12) << round;
        }
      }
    }
  }
}

TEST(ImplicitForm, CurvesBeginAndEndAtInfinity) {
  const auto parabola = curves_of(ImplicitConic::make({1, 0, 0, 0, -4, 0}));
  ASSERT_EQ(parabola.size(), 1u);
  EXPECT_EQ(point_at(parabola[0], 1.0), glm::dvec3(0, 0, 0));
  EXPECT_EQ(point_at(parabola[0], 1.5), glm::dvec3(-2, 1, 0));
  EXPECT_EQ(point_at(parabola[0], 0.5), glm::dvec3(2, 1, 0));
  EXPECT_TRUE(is_at_infinity(parabola[0], 0, Side::right) && is_at_infinity(parabola[0], 2, Side::left));
  const auto hyperbola = curves_of(ImplicitConic::make({0, 2, 0, 0, 0, -1}));
  ASSERT_EQ(hyperbola.size(), 2u);
  for (const NurbsCurve& branch : hyperbola) {
    EXPECT_EQ(finite_arcs(branch, 100.0).size(), 1u);
    EXPECT_EQ(pieces(branch), (std::vector<Interval>{{0, 1}}));
  }
  EXPECT_EQ(curves_of(ImplicitConic::make({0, 1, 0, 0, 0, 0})).size(), 2u);
  EXPECT_EQ(curves_of(ImplicitConic::make({1, 0, 0, 0, 0, -1})).size(), 2u);
  EXPECT_EQ(curves_of(ImplicitConic::make({0, 0, 0, 1, 1, 1})).size(), 1u);
  EXPECT_TRUE(curves_of(ImplicitConic::make({1, 0, 1, 0, 0, 0})).empty());
}

TEST(ImplicitForm, IsRefusedWhereRoundingLeavesNothingOfIt) {
  const auto refused = [](double end, double middle) {
    return refusal([&] { implicit_conic(BezierCurve::make({{0, 0, 0, end}, {1, 0, 0, middle}, {1, 1, 0, end}})); });
  };
  EXPECT_EQ(refused(1e-170, 1.0), "the points give no equation: it is lost in rounding");
  EXPECT_EQ(refused(1.0, 1e-320), "not refused");
}

TEST(ImplicitForm, IsRefusedWherePointsTimesWeightsOverflow) {
  const BezierCurve curve = BezierCurve::make({{0, 0, 0, 1}, {1e200, 0, 0, 1e200}, {0, 1e200, 0, 1}});
  EXPECT_EQ(refusal([&] { implicit_conic(curve); }), "points reach beyond the range of numbers with their weights");
}

TEST(ImplicitForm, IsRefusedForALine) {
  EXPECT_EQ(refusal([] { implicit_conic(conic_arc({0, 0, 0}, {1, 1, 1}, {2, 2, 2}, 1)); }),
            "the points lie on one line: the equation of the curve is not unique");
  EXPECT_NE(refusal([] { implicit_conic(BezierCurve::make({{0, 0, 0, 1}, {1, 0, 0, 1}})); }), "not refused");
}

}  // namespace
}  // namespace splinecore
