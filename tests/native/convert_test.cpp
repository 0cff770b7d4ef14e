#include "reference.hpp"
#include "splinecore/convert/to_bezier.hpp"
#include "splinecore/convert/to_hermite.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

TEST(ToBezier, GivesOneCurveASpanThatAgreesForThousandCurves) {
  Random random(90);
  for (int round = 0; round < 1000; ++round) {
    const NurbsCurve curve = random_curve(random, Weights::positive);
    const auto beziers = to_bezier(curve);
    ASSERT_EQ(beziers.size(), curve.knot_vector().spans().size());
    for (std::size_t i = 0; i < beziers.size(); ++i) {
      const Interval span = curve.knot_vector().span_interval(static_cast<int>(i));
      for (const double t : {0.1, 0.5, 0.8}) {
        const glm::dvec4 expected = homogeneous_at(curve, span.start + t * span.length());
        EXPECT_LE(largest(homogeneous_at(beziers[i].nurbs(), t) - expected), 1e-12 * size_of(curve));
      }
    }
  }
}

TEST(ToBezier, KeepsPointsAtInfinityAndNegativeWeights) {
  Random random(91);
  for (int round = 0; round < 200; ++round) {
    const NurbsCurve curve = random_curve(random, {integer(random, 2, 9), 1, Ends::clamped, Weights::any});
    const auto beziers = to_bezier(curve);
    ASSERT_EQ(beziers.size(), 1u);
    for (std::size_t i = 0; i < curve.points().size(); ++i) {
      EXPECT_LE(largest(beziers[0].points()[i] - curve.points()[i]), 1e-14 * size_of(curve));
      EXPECT_EQ(beziers[0].points()[i].w == 0.0, curve.points()[i].w == 0.0);
    }
  }
}

// Lecture row S8: arc i of a cubic polygon has the points e_i, f_{i+1}, g_{i+1}, e_{i+1}.
TEST(ToBezier, OfACubicPolygonIsTheConstructionOfTheLectures) {
  const std::vector<double> h{1, 0.5, 2, 1.5};
  std::vector<double> knots(4, 0.0);
  for (const double step : h) knots.push_back(knots.back() + step);
  knots.insert(knots.end(), 3, knots.back());
  Random random(92);
  const std::vector<glm::dvec4> d = random_points(random, 7, Weights::one);
  const auto arcs = to_bezier(NurbsCurve::make(3, knots, d));
  ASSERT_EQ(arcs.size(), 4u);
  // The second arc: f_2, g_2 between the steps h_4 ... h_6, counted from h_4 = h[0].
  const double s = h[0] + h[1] + h[2];
  const glm::dvec4 f = ((h[1] + h[2]) * d[2] + h[0] * d[3]) / s;
  const glm::dvec4 g = (h[2] * d[2] + (h[0] + h[1]) * d[3]) / s;
  const glm::dvec4 before = (h[1] * d[1] + h[0] * d[2]) / (h[0] + h[1]);
  const glm::dvec4 e = (h[1] * before + h[0] * f) / (h[0] + h[1]);
  EXPECT_LE(largest(arcs[1].points()[0] - e), 1e-14 * 10);
  EXPECT_LE(largest(arcs[1].points()[1] - f), 1e-14 * 10);
  EXPECT_LE(largest(arcs[1].points()[2] - g), 1e-14 * 10);
}

TEST(ToBezier, OfAPatchGivesAGridThatAgrees) {
  Random random(93);
  for (int round = 0; round < 200; ++round) {
    const NurbsPatch patch = random_patch(random, Weights::positive);
    const BezierGrid grid = to_bezier(patch);
    const KnotVector& knots_u = patch.knot_vector(Axis::u);
    const KnotVector& knots_v = patch.knot_vector(Axis::v);
    ASSERT_EQ(grid.count_u, static_cast<int>(knots_u.spans().size()));
    ASSERT_EQ(grid.count_v, static_cast<int>(knots_v.spans().size()));
    const int i = integer(random, 0, grid.count_u - 1);
    const int j = integer(random, 0, grid.count_v - 1);
    const Interval u = knots_u.span_interval(i);
    const Interval v = knots_v.span_interval(j);
    const glm::dvec4 expected = homogeneous_at(patch, u.start + 0.3 * u.length(), v.start + 0.6 * v.length());
    const auto& piece = grid.patches[i * grid.count_v + j];
    EXPECT_LE(largest(homogeneous_at(piece.nurbs(), 0.3, 0.6) - expected), 1e-12 * size_of(patch));
  }
}

TEST(ToHermite, KeepsCurvesUpToDegreeThree) {
  Random random(94);
  for (int round = 0; round < 300; ++round) {
    const int degree = integer(random, 1, 3);
    const KnotVector knots =
        random_knots(random, degree, integer(random, 1, 6), static_cast<Ends>(integer(random, 0, 2)));
    const auto is_gap = [&](double u) {
      return multiplicity(knots, u) > degree && u > knots.domain().start && u < knots.domain().end;
    };
    if (std::ranges::any_of(knots.knots(), is_gap) ||
        (knots.periodic() && multiplicity(knots, knots.domain().start) > degree))
      continue;
    std::vector<glm::dvec4> points = random_points(random, knots.count(), Weights::one);
    const double weight = round % 2 == 0 ? 1.0 : 0.3;
    for (glm::dvec4& p : points) p.w = weight;
    const NurbsCurve curve = NurbsCurve::make(knots, points);
    const HermiteCurve chain = to_hermite(curve);
    for (const double u : random_parameters(random, curve.domain(), 10)) {
      EXPECT_LE(largest(point_at(chain.nurbs(), u) - point_at(curve, u)), 1e-12 * size_of(curve) / weight);
    }
  }
}

TEST(ToHermite, AcceptsACurveFarFromTheOrigin) {
  Random random(95);
  std::vector<glm::dvec4> points = random_points(random, 6, Weights::one);
  for (glm::dvec4& p : points) p += glm::dvec4(1e7, -1e7, 1e6, 0);
  const NurbsCurve curve = NurbsCurve::make(KnotVector::uniform(3, 6), points);
  const HermiteCurve chain = to_hermite(curve);
  for (const double u : random_parameters(random, curve.domain(), 10)) {
    EXPECT_LE(largest(point_at(chain.nurbs(), u) - point_at(curve, u)), 1e-14 * size_of(curve));
  }
}

TEST(ToHermite, SaysWhyACurveIsNone) {
  const std::vector<glm::dvec4> points{{0, 0, 0, 1}, {1, 0, 0, 1}, {5, 0, 0, 1}, {6, 0, 0, 1}};
  EXPECT_EQ(refusal([&] { to_hermite(NurbsCurve::make(1, {0, 0, 1, 1, 2, 2}, points)); }),
            "the curve has a gap at u = 1: a Hermite chain is connected");
  EXPECT_EQ(
      refusal([&] { to_hermite(NurbsCurve::make(KnotVector::bezier(4), std::vector<glm::dvec4>(5, glm::dvec4(1)))); }),
      "degree = 4: a Hermite shape is cubic at most");
  EXPECT_EQ(refusal([&] { to_hermite(NurbsCurve::make(KnotVector::bezier(1), {{0, 0, 0, 1}, {1, 0, 0, 2}})); }),
            "weights[1] = 2 differs from weights[0]: a Hermite shape is not rational");
}

TEST(ToHermite, KeepsPatchesUpToDegreeThreeThatAreSmooth) {
  Random random(96);
  for (const bool far : {false, true}) {
    for (int degree = 2; degree <= 3; ++degree) {
      const KnotVector knots =
          KnotVector::make(degree, degree == 2 ? std::vector<double>{0, 0, 0, 1, 1.001, 3, 3, 3}
                                               : std::vector<double>{-1, 0, 0, 0, 1, 1.001, 3, 3, 3, 3.5});
      std::vector<glm::dvec4> points = random_points(random, knots.count() * knots.count(), Weights::one);
      if (far) for (glm::dvec4& p : points) p += glm::dvec4(1e6, 2e6, 0, 0);
      const NurbsPatch patch = NurbsPatch::make(knots, knots, points);
      const HermitePatch grid = to_hermite(patch);
      for (int k = 0; k < 20; ++k) {
        const double u = real(random, patch.knot_vector(Axis::u).domain().start, 3);
        const double v = real(random, patch.knot_vector(Axis::v).domain().start, 3);
        EXPECT_LE(largest(point_at(grid.nurbs(), u, v) - point_at(patch, u, v)), 1e-12 * size_of(patch));
      }
    }
  }
}

TEST(ToHermite, GivesAHermitePatchBackFromItsNurbsForm) {
  Random random(98);
  HermiteNet net;
  for (auto* list : {&net.points, &net.tangents_u, &net.tangents_v, &net.twists}) {
    for (int i = 0; i < 9; ++i) list->push_back(random_vector(random) + glm::dvec3(1e3, 0, 0));
  }
  const HermitePatch patch = HermitePatch::make(3, 3, net, {0, 0.001, 2}, {1, 1.5, 7});
  const HermitePatch back = to_hermite(patch.nurbs());
  EXPECT_TRUE(std::ranges::equal(back.parameters(Axis::u), patch.parameters(Axis::u)));
  EXPECT_TRUE(std::ranges::equal(back.parameters(Axis::v), patch.parameters(Axis::v)));
  for (int i = 0; i < 9; ++i) {
    EXPECT_EQ(back.net().points[i], net.points[i]);
    EXPECT_LE(largest(back.net().tangents_u[i] - net.tangents_u[i]), 1e-8);
    EXPECT_LE(largest(back.net().twists[i] - net.twists[i]), 1e-7);
  }
}

TEST(ToHermite, RefusesAPatchWithACrease) {
  Random random(97);
  const NurbsPatch patch =
      NurbsPatch::make(KnotVector::clamped(1, 3), KnotVector::bezier(1), random_points(random, 6, Weights::one));
  EXPECT_EQ(refusal([&] { to_hermite(patch); }),
            "the patch is not C1 at u = 1, v = 0: a Hermite corner has one tangent in each direction");
}

}  // namespace
}  // namespace splinecore
