#include "splinecore/curve/compatible.hpp"

#include "splinecore/curve/ends.hpp"
#include "support.hpp"

namespace splinecore {

namespace {

using namespace testing;

/// The parameter of b that belongs to one of a.
double mapped(double u, const Interval& from, const Interval& to) {
  return to.start + (u - from.start) / from.length() * to.length();
}

double miss(const NurbsCurve& one, double u, const NurbsCurve& other, double at) {
  const glm::dvec4 p = homogeneous_at(one, u);
  return largest(p - homogeneous_at(other, at)) / size_of(other);
}

}  // namespace

TEST(Compatible, CurvesOfAllKindsKeepTheirPointsOnCommonKnots) {
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const NurbsCurve a = random_curve(random, Weights::positive);
    const NurbsCurve b = random_curve(random, Weights::positive);
    const auto [first, second] = compatible(a, b);
    EXPECT_EQ(first.knot_vector(), second.knot_vector());
    EXPECT_EQ(first.periodic(), a.periodic() && b.periodic());
    EXPECT_EQ(first.degree(), std::max(a.degree(), b.degree()));
    for (const double u : random_parameters(random, a.domain(), 5)) {
      EXPECT_LE(miss(first, u, a, u), 1e-11);
      EXPECT_LE(miss(second, u, b, mapped(u, a.domain(), b.domain())), 1e-11);
    }
  }
}

TEST(Compatible, CurvesOnEqualKnotsStayBitForBit) {
  const KnotVector knots = KnotVector::uniform(3, 6);
  Random random(2);
  const NurbsCurve a = NurbsCurve::make(knots, random_points(random, 6, Weights::any));
  const NurbsCurve b = NurbsCurve::make(knots, random_points(random, 6, Weights::any));
  const auto [first, second] = compatible(a, b);
  EXPECT_EQ(first, a);
  EXPECT_EQ(second, b);
}

TEST(Compatible, MappedKnotsThatDifferByRoundingBecomeOne) {
  const auto on_steps = [](double step) {
    std::vector<double> knots{0.0, 0.0, 0.0};
    for (int i = 1; i <= 10; ++i) knots.push_back(i * step);
    knots.insert(knots.end(), 2, knots.back());
    return NurbsCurve::make(2, knots, std::vector<glm::dvec4>(12, glm::dvec4(1.0)));
  };
  const auto [first, second] = compatible(on_steps(0.1), on_steps(7.0));
  EXPECT_EQ(first.knot_vector().count(), 12);
  EXPECT_EQ(first.knot_vector(), second.knot_vector());
}

}  // namespace splinecore
