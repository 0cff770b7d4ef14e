#include <ranges>

#include "splinecore/curve/nurbs_curve.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

/// Parameters of the domain, knots among them, that may be added to the knots.
std::vector<double> insertable(Random& random, const KnotVector& knots) {
  std::vector<double> inserted = random_parameters(random, knots.domain(), integer(random, 0, 4));
  if (!inserted.empty()) inserted.push_back(inserted.front());
  for (const double u : knots.knots()) {
    const bool inside = u >= knots.domain().start && u <= knots.domain().end;
    // At a seam both ends of the period count.
    if (!inside || (knots.periodic() && u == knots.domain().end)) continue;
    const auto times = multiplicity(knots, u) + std::ranges::count(inserted, u);
    if (times <= knots.degree() && integer(random, 0, 1) == 0) inserted.push_back(u);
  }
  std::erase_if(inserted, [&](double u) {
    return std::ranges::count(inserted, u) + multiplicity(knots, u) > knots.degree() + 1;
  });
  shuffle(random, inserted);
  return inserted;
}

void expect_same(const NurbsCurve& before, const NurbsCurve& after, std::span<const double> parameters) {
  for (const double u : parameters) {
    for (const Side side : {Side::left, Side::right}) {
      const double error = largest(homogeneous_at(before, u, side) - homogeneous_at(after, u, side));
      EXPECT_LE(error, 1e-12 * size_of(before)) << "u = " << u;
    }
  }
}

TEST(Refine, KeepsThousandRandomCurves) {
  Random random(10);
  for (int round = 0; round < 1000; ++round) {
    const NurbsCurve curve = random_curve(random);
    const std::vector<double> inserted = insertable(random, curve.knot_vector());
    const NurbsCurve refined = refine(curve, inserted);
    EXPECT_EQ(refined.points().size(), curve.points().size() + inserted.size());
    EXPECT_EQ(refined.domain(), curve.domain());
    expect_same(curve, refined, random_parameters(random, curve.domain(), 10));
    expect_same(curve, refined, inserted);
  }
}

TEST(Refine, GivesTheOldKnotsWithTheNewOnesInOrder) {
  Random random(11);
  for (const Kind& kind : all_kinds(Weights::one)) {
    const NurbsCurve curve = random_curve(random, kind);
    const KnotVector& knots = curve.knot_vector();
    const std::vector<double> inserted = insertable(random, knots);
    const KnotVector refined = refine(curve, inserted).knot_vector();
    std::vector<double> expected(knots.knots().begin(), knots.knots().end());
    expected.insert(expected.end(), inserted.begin(), inserted.end());
    std::ranges::sort(expected);
    EXPECT_TRUE(std::ranges::equal(refined.knots(), expected)) << text_of(kind);
  }
}

TEST(InsertKnot, CopiesUntouchedPointsBitForBit) {
  const std::vector<double> knots{0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5};
  Random random(12);
  const std::vector<glm::dvec4> points = random_points(random, 8, Weights::positive);
  const NurbsCurve refined = insert_knot(NurbsCurve::make(3, knots, points), 2.5);
  // Boehm 1980: of the new points only k - degree + 1 ... k differ, k = 5 being the knot before 2.5.
  for (int i = 0; i <= 2; ++i) EXPECT_EQ(refined.points()[i], points[i]);
  for (int i = 3; i <= 5; ++i) EXPECT_NE(refined.points()[i], points[i]);
  for (int i = 6; i <= 8; ++i) EXPECT_EQ(refined.points()[i], points[i - 1]);
}

TEST(InsertKnot, CopiesUntouchedPointsBitForBitAroundAPeriod) {
  Random random(13);
  const std::vector<glm::dvec4> points = random_points(random, 12, Weights::any);
  const NurbsCurve curve = NurbsCurve::make(KnotVector::periodic_uniform(3, 12), points);
  for (const double u : {0.5, 3.0, 11.5}) {
    const NurbsCurve refined = insert_knot(curve, u);
    const auto kept = std::ranges::count_if(points, [&](const glm::dvec4& p) {
      return std::ranges::count(refined.points(), p) == 1;
    });
    // Where u is no knot two old points go and three new ones come; at a knot one goes, two come.
    EXPECT_EQ(kept, u == 3.0 ? 11 : 10) << u;
  }
}

// Boehm's formula: Q_i = a P_i + (1 - a) P_{i-1} with a = (u - u_i) / (u_{i+p} - u_i).
TEST(InsertKnot, GivesBoehmsPoints) {
  Random random(14);
  for (int round = 0; round < 200; ++round) {
    const int degree = integer(random, 1, 9);
    const Ends ends = integer(random, 0, 1) == 0 ? Ends::clamped : Ends::unclamped;
    const NurbsCurve curve = random_curve(random, {degree, 5, ends, Weights::one});
    const double u = real(random, curve.domain().start, curve.domain().end);
    const NurbsCurve refined = insert_knot(curve, u);
    const auto t = curve.knot_vector().knots();
    const int k = static_cast<int>(std::ranges::upper_bound(t, u) - t.begin()) - 1;
    for (int i = 0; i < static_cast<int>(refined.points().size()); ++i) {
      const double a = i <= k - degree ? 1.0 : i > k ? 0.0 : (u - t[i]) / (t[i + degree] - t[i]);
      glm::dvec4 expected(0.0);
      if (a > 0.0) expected += a * curve.points()[i];
      if (a < 1.0) expected += (1.0 - a) * curve.points()[i - 1];
      EXPECT_LE(largest(refined.points()[i] - expected), 1e-13 * size_of(curve)) << degree << " " << i;
    }
  }
}

TEST(InsertKnot, UpToDegreeTimesPutsAPointOnTheCurve) {
  Random random(15);
  for (const Kind& kind : all_kinds(Weights::positive)) {
    const NurbsCurve curve = random_curve(random, kind);
    const double u = real(random, curve.domain().start, curve.domain().end);
    const NurbsCurve refined = insert_knot(curve, u, kind.degree);
    const glm::dvec3 expected = point_at(curve, u);
    const auto distance = [&](const glm::dvec4& p) { return largest(glm::dvec3(p) - expected); };
    EXPECT_LE(std::ranges::min(refined.points() | std::views::transform(distance)), 1e-12 * size_of(curve))
        << text_of(kind);
  }
}

TEST(Refine, OfPointsWithOneWeightKeepsThemInTheHull) {
  Random random(16);
  for (int round = 0; round < 200; ++round) {
    const NurbsCurve curve = random_curve(random, Weights::one);
    const auto [low, high] =
        std::ranges::minmax(curve.points() | std::views::transform([](const auto& p) { return p.x; }));
    const NurbsCurve refined = refine(curve, insertable(random, curve.knot_vector()));
    for (const glm::dvec4& p : refined.points()) {
      EXPECT_GE(p.x, low - 1e-13 * size_of(curve));
      EXPECT_LE(p.x, high + 1e-13 * size_of(curve));
    }
  }
}

TEST(BezierPoints, AreThoseOfEverySpan) {
  Random random(17);
  for (const Kind& kind : all_kinds(Weights::any)) {
    const NurbsCurve curve = random_curve(random, kind);
    const std::size_t order = kind.degree + 1;
    std::vector<glm::dvec4> all(curve.knot_vector().spans().size() * order);
    bezier_points(curve, all);
    for (int i = 0; i < static_cast<int>(curve.knot_vector().spans().size()); ++i) {
      const Interval span = curve.knot_vector().span_interval(i);
      const auto points = std::span(all).subspan(i * order, order);
      std::vector<glm::dvec4> ends(2);
      evaluate_homogeneous(curve, std::vector{span.start}, std::span(ends).first(1), Side::right);
      evaluate_homogeneous(curve, std::vector{span.end}, std::span(ends).last(1), Side::left);
      EXPECT_LE(largest(points.front() - ends[0]), 1e-13 * size_of(curve)) << text_of(kind);
      EXPECT_LE(largest(points.back() - ends[1]), 1e-13 * size_of(curve)) << text_of(kind);
    }
  }
}

TEST(InsertKnot, NamesWhatCannotBeInserted) {
  const NurbsCurve curve = NurbsCurve::make(2, {0, 0, 0, 1, 2, 2, 2}, std::vector<glm::dvec4>(4, glm::dvec4(1)));
  EXPECT_EQ(refusal([&] { insert_knot(curve, 2.5); }), "knots[0] = 2.5 is outside the domain [0, 2]");
  EXPECT_EQ(refusal([&] { insert_knot(curve, 1, 3); }), "knots: 1 would have multiplicity 4, above degree + 1 = 3");
  EXPECT_EQ(refusal([&] { insert_knot(curve, 0); }), "knots: 0 would have multiplicity 4, above degree + 1 = 3");
  EXPECT_EQ(refusal([&] { insert_knot(curve, 1, 0); }), "times = 0 is outside [1, 3]");
  EXPECT_EQ(refusal([&] { insert_knot(curve, 1, 1 << 30); }), "times = 1073741824 is outside [1, 3]");
  EXPECT_EQ(refusal([&] { refine(curve, std::vector{1.5, 0.0 / 0.0}); }).substr(0, 8), "knots[1]");
}

}  // namespace
}  // namespace splinecore
