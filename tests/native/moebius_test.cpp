#include "splinecore/curve/moebius.hpp"

#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

/// The new parameter at which the curve is where it was at u.
double moved(double u, Interval domain, double rho) {
  const double x = (u - domain.start) / domain.length();
  return domain.start + domain.length() * (x / (rho * (1.0 - x) + x));
}

TEST(Moebius, MultipliesBezierWeightsByPowersOfRho) {
  const BezierCurve curve = BezierCurve::make({{0, 0, 0, 1}, {1, 2, 3, 2}, {4, 5, 6, 0}, {7, 8, 9, -3}});
  const BezierCurve result = moebius(curve, 2.0);
  EXPECT_EQ(result.points()[0], glm::dvec4(0, 0, 0, 1));
  EXPECT_EQ(result.points()[1], glm::dvec4(1, 2, 3, 4));
  EXPECT_EQ(result.points()[2], glm::dvec4(16, 20, 24, 0));
  EXPECT_EQ(result.points()[3], glm::dvec4(7, 8, 9, -24));
}

TEST(Moebius, IsTheSameCurveForThousandRationalCurves) {
  Random random(510);
  for (int round = 0; round < 1000; ++round) {
    const NurbsCurve curve = random_curve(random, Weights::positive);
    const double rho = std::exp2(real(random, -2, 2));
    const NurbsCurve result = moebius(curve, rho);
    EXPECT_FALSE(result.periodic());
    EXPECT_EQ(result.domain().start, curve.domain().start);
    EXPECT_NEAR(result.domain().end, curve.domain().end, 1e-14 * (1 + std::abs(curve.domain().end)));
    for (const double u : random_parameters(random, curve.domain(), 5)) {
      const glm::dvec3 expected = point_at(curve, u);
      const glm::dvec3 found = point_at(result, moved(u, curve.domain(), rho));
      EXPECT_LE(largest(found - expected), 1e-12 * 10) << round << " " << u;
    }
  }
}

TEST(Moebius, KeepsPointsWhereNoKnotIsBeyondThePole) {
  Random random(511);
  for (int round = 0; round < 100; ++round) {
    const NurbsCurve curve = random_curve(random, {integer(random, 1, 9), 5, Ends::clamped, Weights::positive});
    const NurbsCurve result = moebius(curve, 3.0);
    ASSERT_EQ(result.points().size(), curve.points().size());
    for (std::size_t i = 0; i < curve.points().size(); ++i) {
      EXPECT_EQ(glm::dvec3(result.points()[i]), glm::dvec3(curve.points()[i]));
    }
    EXPECT_EQ(result.points().front().w, curve.points().front().w);
    EXPECT_NEAR(result.points().back().w, std::pow(3.0, curve.degree()) * curve.points().back().w,
                1e-14 * std::pow(3.0, curve.degree()) * curve.points().back().w);
  }
}

TEST(Moebius, AndItsInverseGiveTheCurveBack) {
  Random random(512);
  for (int round = 0; round < 100; ++round) {
    const NurbsCurve curve = random_curve(random, {integer(random, 1, 9), 4, Ends::clamped, Weights::any});
    const NurbsCurve again = moebius(moebius(curve, 1.7), 1.0 / 1.7);
    for (std::size_t i = 0; i < curve.knot_vector().knots().size(); ++i) {
      EXPECT_NEAR(again.knot_vector().knots()[i], curve.knot_vector().knots()[i], 1e-13 * 10);
    }
    for (std::size_t i = 0; i < curve.points().size(); ++i) {
      EXPECT_LE(largest(again.points()[i] - curve.points()[i]), 1e-12 * 10);
    }
  }
}

TEST(Moebius, OfAnUnclampedCurveWhoseKnotsReachThePoleIsClamped) {
  const NurbsCurve curve = NurbsCurve::make(KnotVector::uniform(3, 5), {{0, 0, 0, 1}, {1, 2, 0, 1}, {2, 0, 1, 2},
                                                                        {3, 2, 0, 1}, {4, 0, 0, 1}});
  const NurbsCurve result = moebius(curve, 50.0);
  EXPECT_EQ(multiplicity(result.knot_vector(), 3.0), 4);
  for (const double u : {3.0, 3.1, 4.0, 4.9, 5.0}) {
    EXPECT_LE(largest(point_at(result, std::min(5.0, moved(u, {3, 5}, 50.0))) - point_at(curve, u)), 1e-12) << u;
  }
}

TEST(Moebius, RefusesWhatWouldNotKeepTheCurve) {
  const BezierCurve curve = BezierCurve::make({{0, 0, 0, 1}, {1, 2, 3, 1}, {4, 5, 6, 1}});
  EXPECT_EQ(refusal([&] { moebius(curve, -1.0); }), "rho = -1 is not positive: the map would not keep the curve");
  EXPECT_NE(refusal([&] { moebius(curve, 0.0); }), "not refused");
  EXPECT_NE(refusal([&] { moebius(curve, std::nan("")); }), "not refused");
  EXPECT_EQ(refusal([&] { moebius(curve, 1e200); }),
            "weights[2] = 1 times inf leaves the range of numbers");
  EXPECT_NE(refusal([&] { moebius(curve, 1e-200); }), "not refused");
}

TEST(StandardForm, HasTheWeightOneAtBothEndsForThousandCurves) {
  Random random(513);
  for (int round = 0; round < 1000; ++round) {
    const NurbsCurve curve = random_curve(random, {integer(random, 1, 9), integer(random, 1, 5), Ends::clamped,
                                                   Weights::positive});
    const NurbsCurve result = standard_form(curve);
    EXPECT_EQ(result.points().front().w, 1.0);
    EXPECT_EQ(result.points().back().w, 1.0);
    const double rho = std::pow(curve.points().front().w / curve.points().back().w, 1.0 / curve.degree());
    for (const double u : random_parameters(random, curve.domain(), 3)) {
      const glm::dvec3 found = point_at(result, std::min(moved(u, curve.domain(), rho), curve.domain().end));
      EXPECT_LE(largest(found - point_at(curve, u)), 1e-12 * 10);
    }
  }
}

TEST(StandardForm, OfAQuadraticHasTheInvariantAsItsWeight) {
  const BezierCurve result = standard_form(BezierCurve::make({{0, 0, 0, -4}, {1, 1, 0, -3}, {2, 0, 0, -9}}));
  EXPECT_EQ(result.points()[0].w, 1.0);
  EXPECT_NEAR(result.points()[1].w, 0.5, 1e-16);
  EXPECT_EQ(result.points()[2].w, 1.0);
}

TEST(StandardForm, IsRefusedWhereThereIsNone) {
  const auto with_ends = [](double w0, double w2) {
    return BezierCurve::make({{0, 0, 0, w0}, {1, 1, 0, 1}, {2, 0, 0, w2}});
  };
  EXPECT_EQ(refusal([&] { standard_form(with_ends(1, -2)); }),
            "weights[0] = 1 and weights[2] = -2 have not one sign: there is no standard form");
  EXPECT_NE(refusal([&] { standard_form(with_ends(0, 1)); }), "not refused");
  EXPECT_NE(refusal([&] { standard_form(with_ends(0, 0)); }), "not refused");
  const NurbsCurve open = NurbsCurve::make(KnotVector::uniform(2, 4), std::vector<glm::dvec4>(4, glm::dvec4(1)));
  EXPECT_EQ(refusal([&] { standard_form(open); }), "the curve is not clamped at both ends: it has no end weights");
}

}  // namespace
}  // namespace splinecore
