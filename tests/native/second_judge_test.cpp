// SISL (SINTEF, Debian's libsisl-dev) computes the same in its own way.
#include "splinecore/base/points.hpp"
#include "splinecore/conic/conic_arc.hpp"
#include "splinecore/curve/degree.hpp"
#include "splinecore/curve/join.hpp"
#include "splinecore/curve/removal.hpp"
#include "support.hpp"

#ifdef HAS_SISL
#include <sisl.h>

#include <memory>
#endif

namespace splinecore {
namespace {

using namespace testing;

#ifdef HAS_SISL

using SislCurve = std::unique_ptr<SISLCurve, decltype(&freeCurve)>;

SislCurve owned(SISLCurve* curve) { return {curve, &freeCurve}; }

/// Knot removal of SISL does not take rational curves: it gets x, y, z and w as four coordinates.
enum class Kind { rational = 2, four_coordinates = 1 };

SislCurve in_sisl(const NurbsCurve& curve, Kind kind = Kind::rational) {
  constexpr int kCopied = 1;
  std::vector<double> knots(curve.knot_vector().knots().begin(), curve.knot_vector().knots().end());
  std::vector<double> points;
  for (const glm::dvec4& p : homogeneous(curve.points())) points.insert(points.end(), {p.x, p.y, p.z, p.w});
  return owned(newCurve(static_cast<int>(curve.points().size()), curve.degree() + 1, knots.data(), points.data(),
                        static_cast<int>(kind), kind == Kind::rational ? 3 : 4, kCopied));
}

/// A curve SISL takes: open, with no knot more often than the degree, so that it is continuous.
NurbsCurve open_curve(Random& random, int degree) {
  std::vector<double> knots(degree + 1, 0.0);
  double u = 0.0;
  for (int span = integer(random, 0, 6); span > 0; --span) {
    u += real(random, 0.2, 1.5);
    knots.insert(knots.end(), integer(random, 0, 2) == 0 ? integer(random, 1, degree) : 1, u);
  }
  knots.insert(knots.end(), degree + 1, u + real(random, 0.2, 1.5));
  std::vector<glm::dvec4> points =
      random_points(random, static_cast<int>(knots.size()) - degree - 1, Weights::positive);
  return NurbsCurve::make(KnotVector::make(degree, std::move(knots), false), std::move(points));
}

void expect_equal(const NurbsCurve& curve, const SISLCurve& other, double tolerance) {
  const auto knots = curve.knot_vector().knots();
  ASSERT_EQ(other.ik, curve.degree() + 1);
  ASSERT_EQ(static_cast<std::size_t>(other.in), curve.points().size());
  for (std::size_t i = 0; i < knots.size(); ++i) EXPECT_NEAR(other.et[i], knots[i], 1e-14);
  for (int i = 0; i < other.in; ++i) {
    const double* p = (other.ikind == 1 ? other.ecoef : other.rcoef) + 4 * i;
    const glm::dvec4 point(p[0], p[1], p[2], p[3]);
    EXPECT_LT(largest(point - homogeneous(curve.points()[i])), tolerance * size_of(curve)) << i;
  }
}

TEST(SecondJudge, FindsTheSameDerivativesFromBothSides) {
  Random random(81);
  for (int n = 0; n < 300; ++n) {
    const NurbsCurve curve = open_curve(random, integer(random, 1, 9));
    const SislCurve judge = in_sisl(curve);
    const Interval domain = curve.domain();
    for (const Side side : {Side::left, Side::right}) {
      const double u = real(random, domain.start, domain.end);
      std::vector<glm::dvec3> found(3);
      derivatives(curve, {&u, 1}, 2, std::span(&found[0].x, 9), {.side = side});
      std::vector<double> expected(9);
      int left = 0;
      int status = 0;
      (side == Side::right ? s1221 : s1227)(judge.get(), 2, u, &left, expected.data(), &status);
      ASSERT_EQ(status, 0);
      for (int k = 0; k <= 2; ++k) {
        const glm::dvec3 other(expected[3 * k], expected[3 * k + 1], expected[3 * k + 2]);
        const double scale = std::pow(curve.degree() * 10.0 / 0.2, k) * 10.0;
        EXPECT_LT(largest(found[k] - other), 1e-13 * scale) << "degree " << curve.degree() << ", derivative " << k;
      }
    }
  }
}

TEST(SecondJudge, InsertsTheSameKnots) {
  Random random(82);
  for (int n = 0; n < 300; ++n) {
    const NurbsCurve curve = open_curve(random, integer(random, 1, 9));
    std::vector<double> knots = random_parameters(random, curve.domain(), integer(random, 1, 5));
    std::ranges::sort(knots);
    SISLCurve* refined = nullptr;
    int status = 0;
    s1018(in_sisl(curve).get(), knots.data(), static_cast<int>(knots.size()), &refined, &status);
    ASSERT_EQ(status, 0);
    expect_equal(refine(curve, knots), *owned(refined), 1e-13);
  }
}

TEST(SecondJudge, RaisesTheDegreeToTheSamePoints) {
  Random random(83);
  for (int n = 0; n < 300; ++n) {
    const NurbsCurve curve = open_curve(random, integer(random, 1, 9));
    const int times = integer(random, 1, 3);
    SISLCurve* raised = nullptr;
    int status = 0;
    s1750(in_sisl(curve).get(), curve.degree() + 1 + times, &raised, &status);
    ASSERT_EQ(status, 0);
    expect_equal(elevated(curve, times), *owned(raised), 1e-11);
  }
}

TEST(SecondJudge, SplitsIntoTheSameTwo) {
  Random random(84);
  for (int n = 0; n < 300; ++n) {
    const NurbsCurve curve = open_curve(random, integer(random, 1, 9));
    const double u = real(random, curve.domain().start, curve.domain().end);
    SISLCurve* first = nullptr;
    SISLCurve* second = nullptr;
    int status = 0;
    s1710(in_sisl(curve).get(), u, &first, &second, &status);
    ASSERT_EQ(status, 0);
    const auto [before, after] = split(curve, u);
    expect_equal(before, *owned(first), 1e-13);
    expect_equal(after, *owned(second), 1e-13);
  }
}

TEST(SecondJudge, RemovesTheKnotsThatWereInserted) {
  Random random(86);
  for (int n = 0; n < 300; ++n) {
    const NurbsCurve curve = open_curve(random, integer(random, 1, 9));
    // Not so near a knot that either may go.
    const auto is_near = [&](double u) {
      return std::ranges::any_of(curve.knot_vector().knots(), [&](double knot) { return std::abs(knot - u) < 0.05; });
    };
    double u = curve.domain().start;
    while (is_near(u)) u = real(random, curve.domain().start, curve.domain().end);
    const NurbsCurve fine = refine(curve, std::vector<double>(integer(random, 1, curve.degree()), u));
    const double tolerance = 1e-12 * size_of(curve);
    std::vector<double> tolerances(4, tolerance);
    std::vector<double> errors(4);
    constexpr int kEndPointsStay = 1;
    constexpr int kOpen = 1;
    constexpr int kMostRounds = 10;
    SISLCurve* made = nullptr;
    int status = 0;
    s1940(in_sisl(fine, Kind::four_coordinates).get(), tolerances.data(), kEndPointsStay, kEndPointsStay, kOpen,
          kMostRounds, &made, errors.data(), &status);
    ASSERT_GE(status, 0);
    const SislCurve judge = owned(made);
    const NurbsCurve coarse = remove_knots(fine, tolerance).value;
    expect_equal(coarse, *judge, 1e-9);
    EXPECT_EQ(coarse.knot_vector(), curve.knot_vector()) << "degree " << curve.degree() << ", u = " << u;
    expect_equal(curve, *judge, 1e-9);
  }
}

TEST(SecondJudge, JoinsTwoCurvesInTheSamePoints) {
  Random random(87);
  for (int n = 0; n < 300; ++n) {
    const NurbsCurve first = open_curve(random, integer(random, 1, 9));
    const NurbsCurve other = open_curve(random, first.degree());
    // SISL would move the second curve, weights and all, to where the first one ends.
    std::vector<glm::dvec4> points(other.points().begin(), other.points().end());
    points.front() = first.points().back();
    const NurbsCurve second = other.with_points(std::move(points));
    constexpr int kStart = 0;
    constexpr int kEnd = 1;
    SISLCurve* made = nullptr;
    int status = 0;
    s1715(in_sisl(first).get(), in_sisl(second).get(), kEnd, kStart, &made, &status);
    ASSERT_GE(status, 0);
    expect_equal(joined(first, second, Smoothness::c0).value, *owned(made), 1e-13);
  }
}

TEST(SecondJudge, MakesConicsThroughTheSamePoints) {
  Random random(85);
  for (int n = 0; n < 300; ++n) {
    const double weight = real(random, 0.05, 5.0);
    glm::dvec3 p0 = random_vector(random);
    glm::dvec3 p1 = random_vector(random);
    glm::dvec3 p2 = random_vector(random);
    SISLCurve* made = nullptr;
    int status = 0;
    s1011(&p0.x, &p1.x, &p2.x, weight / (1.0 + weight), 3, &made, &status);
    ASSERT_EQ(status, 0);
    const SislCurve judge = owned(made);
    const NurbsCurve conic = conic_arc(p0, p1, p2, weight).nurbs();
    const double start = judge->et[judge->ik - 1];
    const double end = judge->et[judge->in];
    for (int i = 0; i <= 20; ++i) {
      double u = start + (end - start) * i / 20.0;
      glm::dvec3 point;
      int left = 0;
      s1221(judge.get(), 0, u, &left, &point.x, &status);
      ASSERT_EQ(status, 0);
      EXPECT_LT(largest(point - point_at(conic, i / 20.0, i == 20 ? Side::left : Side::right)), 2e-11);
    }
  }
}

#else

TEST(SecondJudge, IsMissing) { GTEST_SKIP() << "SISL is missing: install libsisl-dev, configure and build again"; }

#endif

}  // namespace
}  // namespace splinecore
