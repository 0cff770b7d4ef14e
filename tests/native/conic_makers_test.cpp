#include <glm/geometric.hpp>

#include "splinecore/conic/implicit_form.hpp"
#include "splinecore/conic/make_conic.hpp"
#include "splinecore/curve/finite_arcs.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;
using Points = std::vector<glm::dvec3>;

/// Value at a point relative to the largest term.
double residual(const ImplicitConic& conic, const glm::dvec3& point) {
  const glm::dvec2 p = point_in(conic.plane(), point);
  const double terms[6] = {p.x * p.x, p.x * p.y, p.y * p.y, p.x, p.y, 1.0};
  double sum = 0.0, size = 0.0;
  for (int i = 0; i < 6; ++i) {
    sum += conic.coefficients()[i] * terms[i];
    size = std::max(size, std::abs(conic.coefficients()[i] * terms[i]));
  }
  return std::abs(sum) / size;
}

/// Visits points of all curves of a conic.
template <class Visit>
void for_points(const ImplicitConic& conic, Visit visit) {
  for (const NurbsCurve& curve : curves_of(conic)) {
    for (const NurbsCurve& arc : finite_arcs(curve, 10.0)) {
      for (int i = 0; i <= 20; ++i) {
        const double u = i == 20 ? arc.domain().end : arc.domain().start + arc.domain().length() * i / 20;
        visit(point_at(arc, u));
      }
    }
  }
}

TEST(ConicThrough, FivePointsHasThemOnItForThousandPlanes) {
  Random random(560);
  for (int round = 0; round < 1000; ++round) {
    const glm::dvec3 origin = random_vector(random), a = random_vector(random, 1), b = random_vector(random, 1);
    Points points;
    for (int i = 0; i < 5; ++i) points.push_back(origin + real(random, -5, 5) * a + real(random, -5, 5) * b);
    const ImplicitConic conic = conic_through(points);
    for (const glm::dvec3& p : points) EXPECT_LE(residual(conic, p), 1e-10) << round;
  }
}

TEST(ConicThrough, FindsTheCircleAndTheParabola) {
  const ImplicitConic circle = conic_through(Points{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0.6, 0.8, 0}});
  EXPECT_EQ(circle.type(), ConicType::circle);
  EXPECT_NEAR(circle.shape().first, 1.0, 1e-15);
  const ImplicitConic parabola = conic_through(Points{{0, 0, 7}, {1, 1, 7}, {-1, 1, 7}, {2, 4, 7}, {-2, 4, 7}});
  EXPECT_EQ(parabola.type(), ConicType::parabola);
  EXPECT_NEAR(parabola.shape().first, 0.25, 1e-14);
  EXPECT_LE(largest(*center(parabola) - glm::dvec3(0, 0, 7)), 1e-13);
}

TEST(ConicThrough, ThreePointsOnALineIsAPairOfLines) {
  EXPECT_EQ(conic_through(Points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 3, 0}}).type(), ConicType::crossing_lines);
  EXPECT_EQ(conic_through(Points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}}).type(), ConicType::parallel_lines);
  EXPECT_EQ(conic_through(Points{{0, 1, 0}, {0, 0, 0}, {1, 3, 0}, {1, 0, 0}, {2, 0, 0}}).type(), ConicType::crossing_lines);
}

TEST(ConicThrough, RefusesPointsThatDetermineNone) {
  const Points good{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0.6, 0.8, 0}};
  const auto with = [&](std::size_t i, glm::dvec3 p) {
    Points points = good;
    points[i] = p;
    return refusal([&] { conic_through(points); });
  };
  EXPECT_EQ(with(4, {0, 1, 0}), "points[1] and points[4] coincide");
  EXPECT_EQ(with(4, {0, 0, 1}).find("points[4] lies "), 0u);
  EXPECT_NE(with(4, {0, 0, 1}).find(" off the plane of others"), std::string::npos);
  EXPECT_EQ(with(2, {std::nan(""), 0, 0}), "points[2].x = nan is not finite");
  EXPECT_EQ(refusal([&] { conic_through(Points(4)); }), "points has 4 rows, a conic is given by 5");
  EXPECT_EQ(refusal([&] { conic_through(good, -1.0); }), "tolerance = -1 is not a length");
  EXPECT_EQ(refusal([&] { conic_through(Points{{0, 0, 0}, {1, 1, 0}, {5, 0, 0}, {2, 2, 0}, {3, 3, 0}}); }),
            "points 0, 1, 3, 4 lie on one line: more than one conic passes through all five");
  EXPECT_NE(refusal([&] { conic_through(Points(5)); }), "not refused");
}

TEST(ConicThrough, TakesPointsAsPlanarAsTheToleranceSays) {
  const Points bent{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 1e-4}, {0.6, 0.8, 0}};
  EXPECT_NE(refusal([&] { conic_through(bent); }), "not refused");
  EXPECT_EQ(conic_through(bent, 1e-3).type(), ConicType::ellipse);
}

TEST(ConicByFoci, OfAnEllipseHasThatSumOfDistances) {
  Random random(561);
  for (int round = 0; round < 100; ++round) {
    const glm::dvec3 f1 = random_vector(random), f2 = random_vector(random);
    const double sum = glm::distance(f1, f2) * real(random, 1.1, 3.0);
    const ImplicitConic conic = conic_by_foci(f1, f2, sum, random_vector(random));
    EXPECT_EQ(conic.type(), ConicType::ellipse);
    for_points(conic, [&](const glm::dvec3& p) {
      EXPECT_NEAR(glm::distance(p, f1) + glm::distance(p, f2), sum, 1e-12 * sum);
    });
  }
}

TEST(ConicByFoci, OfAHyperbolaHasThatDifferenceOfDistances) {
  Random random(562);
  for (int round = 0; round < 100; ++round) {
    const glm::dvec3 f1 = random_vector(random), f2 = random_vector(random);
    const double difference = glm::distance(f1, f2) * real(random, 0.1, 0.9);
    const ImplicitConic conic = conic_by_foci(f1, f2, difference, random_vector(random));
    EXPECT_EQ(conic.type(), ConicType::hyperbola);
    for_points(conic, [&](const glm::dvec3& p) {
      EXPECT_NEAR(std::abs(glm::distance(p, f1) - glm::distance(p, f2)), difference, 1e-11);
    });
    const auto found = foci(conic);
    EXPECT_LE(std::min(largest(found[0] - f1), largest(found[0] - f2)), 1e-13 * 10);
  }
}

TEST(ConicByFoci, InOnePlaceIsACircle) {
  EXPECT_EQ(conic_by_foci({1, 2, 3}, {1, 2, 3}, 4, {0, 1, 0}).type(), ConicType::circle);
  EXPECT_EQ(conic_by_foci({1, 2, 3}, {1, 2, 3}, 4, {0, 1, 0}).shape().first, 2.0);
}

TEST(ConicByFoci, RefusesWhatIsNoCurve) {
  const glm::dvec3 z(0, 0, 1);
  EXPECT_EQ(refusal([&] { conic_by_foci({0, 0, 0}, {2, 0, 0}, 2, z); }), "distance = 2 is that of the foci: no curve has it");
  EXPECT_EQ(refusal([&] { conic_by_foci({0, 0, 0}, {2, 0, 0}, 0, z); }), "distance = 0 is not a positive length");
  EXPECT_EQ(refusal([&] { conic_by_foci({0, 0, 0}, {0, 0, 2}, 3, z); }), "normal lies along the line of the foci");
  EXPECT_NE(refusal([&] { conic_by_foci({0, 0, 0}, {2, 0, 0}, 3, {0, 0, 0}); }), "not refused");
  EXPECT_NE(refusal([&] { conic_by_foci({0, 0, 0}, {2, NAN, 0}, 3, z); }), "not refused");
}

TEST(Parabola, IsAsFarFromItsFocusAsFromItsDirectrix) {
  Random random(563);
  for (int round = 0; round < 100; ++round) {
    const glm::dvec3 focus = random_vector(random), point = random_vector(random), along = random_vector(random);
    const ImplicitConic conic = parabola(focus, point, along);
    EXPECT_EQ(conic.type(), ConicType::parabola);
    EXPECT_LE(largest(foci(conic)[0] - focus), 1e-13 * 10);
    for_points(conic, [&](const glm::dvec3& p) {
      const double distance = glm::length(glm::cross(p - point, glm::normalize(along)));
      EXPECT_NEAR(glm::distance(p, focus), distance, 1e-12 * (1 + distance));
    });
  }
}

TEST(Parabola, RefusesAFocusOnItsDirectrix) {
  EXPECT_EQ(refusal([] { parabola({3, 3, 3}, {0, 0, 0}, {1, 1, 1}); }), "focus lies on the directrix");
  EXPECT_EQ(refusal([] { parabola({3, 3, 3}, {0, 0, 0}, {0, 0, 0}); }), "directrix_direction has the length 0");
}

TEST(ArcBetween, RunsFromOneParameterToTheOther) {
  const NurbsCurve quarter = arc_between(ImplicitConic::make({1, 0, 4, 0, 0, -4}), 0, std::acos(0.0));
  EXPECT_LE(largest(point_at(quarter, 0) - glm::dvec3(2, 0, 0)), 1e-15);
  EXPECT_LE(largest(point_at(quarter, 1) - glm::dvec3(0, 1, 0)), 1e-15);
  const NurbsCurve bowl = arc_between(ImplicitConic::make({1, 0, 0, 0, -1, 0}), -3, 2);
  for (int i = 0; i <= 10; ++i) {
    const glm::dvec3 p = point_at(bowl, i / 10.0);
    EXPECT_NEAR(p.y, p.x * p.x, 1e-14);
  }
  EXPECT_NEAR(std::abs(point_at(bowl, 0).x), 3, 1e-15);
  EXPECT_NEAR(std::abs(point_at(bowl, 1).x), 2, 1e-15);
  const NurbsCurve branch = arc_between(ImplicitConic::make({1, 0, -1, 0, 0, -1}), -1, 2);
  EXPECT_NEAR(point_at(branch, 0).x, std::cosh(1), 1e-15);
  EXPECT_NEAR(point_at(branch, 1).y, std::sinh(2), 4e-15);
  for (int i = 0; i <= 10; ++i) {
    const glm::dvec3 p = point_at(branch, i / 10.0);
    EXPECT_NEAR(p.x * p.x - p.y * p.y, 1, 1e-14);
  }
}

TEST(ArcBetween, RefusesWhatHasNone) {
  const ImplicitConic lines = ImplicitConic::make({0, 1, 0, 0, 0, 0});
  EXPECT_NE(refusal([&] { arc_between(lines, 0, 1); }), "not refused");
  const ImplicitConic circle = ImplicitConic::make({1, 0, 1, 0, 0, -1});
  EXPECT_EQ(refusal([&] { arc_between(circle, 1, 1); }), "start = end = 1: the arc would be a point");
  EXPECT_EQ(refusal([&] { arc_between(circle, 1, NAN); }), "end = nan is not finite");
  EXPECT_NE(refusal([&] { arc_between(circle, 0, 7); }), "not refused");
  EXPECT_NE(refusal([&] { arc_between(ImplicitConic::make({1, 0, -1, 0, 0, -1}), 0, 2000); }), "not refused");
}

}  // namespace
}  // namespace splinecore
