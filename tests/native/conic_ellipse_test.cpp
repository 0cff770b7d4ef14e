#include "splinecore/conic/ellipse.hpp"

#include <glm/geometric.hpp>
#include <numbers>

#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

constexpr double kPi = std::numbers::pi;
constexpr std::array kForms{EllipseForm::square, EllipseForm::triangle, EllipseForm::halves, EllipseForm::single};

/// Largest deviation of the distance from the origin at 1001 parameters.
double deviation(const NurbsCurve& curve, double radius) {
  double worst = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    const double u = curve.domain().start + curve.domain().length() * i / 1000;
    worst = worse(worst, std::abs(glm::length(point_at(curve, u)) - radius));
  }
  return worst;
}

TEST(Circle, HasItsRadiusInEveryForm) {
  for (const EllipseForm form : kForms) {
    const NurbsCurve curve = circle({0, 0, 0}, 1.0, {0, 0, 1}, form);
    EXPECT_LE(deviation(curve, 1.0), 1e-15) << static_cast<int>(form);
    EXPECT_EQ(curve.points().front(), curve.points().back());
    EXPECT_EQ(point_at(curve, 0), glm::dvec3(1, 0, 0));
  }
}

TEST(Circle, HasThePointsAndWeightsOfTheBooks) {
  const double half = std::sqrt(0.5);
  const std::vector<glm::dvec4> square{{1, 0, 0, 1},  {1, 1, 0, half},   {0, 1, 0, 1},  {-1, 1, 0, half}, {-1, 0, 0, 1},
                                       {-1, -1, 0, half}, {0, -1, 0, 1}, {1, -1, 0, half}, {1, 0, 0, 1}};
  const auto found = circle({0, 0, 0}, 1.0, {0, 0, 1});
  EXPECT_EQ(std::vector(found.points().begin(), found.points().end()), square);
  const auto triangle = circle({0, 0, 0}, 1.0, {0, 0, 1}, EllipseForm::triangle);
  ASSERT_EQ(triangle.points().size(), 7u);
  for (int i = 1; i < 7; i += 2) EXPECT_EQ(triangle.points()[i].w, 0.5);
  const auto halves = circle({0, 0, 0}, 1.0, {0, 0, 1}, EllipseForm::halves);
  EXPECT_EQ(halves.points()[1], glm::dvec4(0, 1, 0, 0));
  EXPECT_EQ(halves.points()[3], glm::dvec4(0, -1, 0, 0));
  const auto single = circle({0, 0, 0}, 1.0, {0, 0, 1}, EllipseForm::single);
  EXPECT_EQ(single.degree(), 5);
  for (const glm::dvec4& p : single.points()) EXPECT_GT(p.w, 0.0);
}

TEST(Circle, LiesAcrossItsNormal) {
  Random random(540);
  for (int round = 0; round < 100; ++round) {
    const glm::dvec3 center = random_vector(random);
    const glm::dvec3 normal = random_vector(random);
    const NurbsCurve curve = circle(center, 3.0, normal, kForms[round % 4]);
    for (const double u : random_parameters(random, curve.domain(), 20)) {
      const glm::dvec3 offset = point_at(curve, u) - center;
      EXPECT_NEAR(glm::length(offset), 3.0, 3e-14);
      EXPECT_NEAR(glm::dot(offset, glm::normalize(normal)), 0.0, 3e-14);
    }
    const glm::dvec3 turn = glm::cross(point_at(curve, 0) - center, point_at(curve, 0.1) - center);
    EXPECT_GT(glm::dot(turn, normal), 0.0);
  }
}

TEST(Ellipse, FulfilsItsEquation) {
  for (const EllipseForm form : kForms) {
    const NurbsCurve curve = ellipse({1, 2, 3}, {4, 0, 0}, {0, 0, 0.5}, form);
    for (int i = 0; i <= 200; ++i) {
      const glm::dvec3 p = point_at(curve, curve.domain().length() * i / 200) - glm::dvec3(1, 2, 3);
      EXPECT_NEAR(p.x * p.x / 16 + p.z * p.z / 0.25, 1.0, 1e-14);
      EXPECT_EQ(p.y, 0.0);
    }
  }
}

TEST(Ellipse, TakesAnyConjugateAxes) {
  const NurbsCurve curve = ellipse({0, 0, 0}, {2, 0, 0}, {2, 1, 0});
  for (int i = 0; i <= 100; ++i) {
    const glm::dvec3 p = point_at(curve, 4.0 * i / 100);
    // In the basis of the axes it is a circle.
    EXPECT_NEAR(std::hypot((p.x - 2 * p.y) / 2, p.y), 1.0, 1e-14);
  }
}

TEST(EllipseArc, RunsFromItsStartThroughItsSweep) {
  Random random(541);
  for (int round = 0; round < 500; ++round) {
    const double start = real(random, -10, 10);
    const double sweep = real(random, -2 * kPi, 2 * kPi);
    const int spans = integer(random, 0, 6);
    const NurbsCurve arc = ellipse_arc({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, start, sweep, spans);
    // One span of nearly a turn goes nearly to infinity and back.
    const double tolerance = 2e-14 / (1.0 + std::cos(0.5 * sweep / arc.domain().end));
    EXPECT_LE(deviation(arc, 1.0), tolerance) << start << " " << sweep << " " << spans;
    EXPECT_TRUE(spans == 0 || arc.domain().end == spans);
    const int count = static_cast<int>(arc.domain().end);
    for (int i = 0; i <= 2 * count; ++i) {
      const double angle = start + sweep * i / (2 * count);
      EXPECT_LE(largest(point_at(arc, 0.5 * i) - glm::dvec3(std::cos(angle), std::sin(angle), 0)), tolerance);
    }
  }
}

TEST(EllipseArc, OfHalfATurnHasADirection) {
  const NurbsCurve arc = ellipse_arc({5, 5, 5}, {2, 0, 0}, {0, 3, 0}, 0, kPi, 1);
  EXPECT_EQ(arc.points()[0], glm::dvec4(7, 5, 5, 1));
  EXPECT_EQ(arc.points()[1], glm::dvec4(0, 3, 0, 0));
  EXPECT_EQ(arc.points()[2], glm::dvec4(3, 5, 5, 1));
}

TEST(EllipseArc, HasAsFewQuartersAsItNeeds) {
  const auto spans = [](double sweep) {
    return ellipse_arc({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0.3, sweep).knot_vector().spans().size();
  };
  EXPECT_EQ(spans(0.1), 1u);
  EXPECT_EQ(spans(kPi / 2), 1u);
  EXPECT_EQ(spans(-kPi / 2), 1u);
  EXPECT_EQ(spans(1.6), 2u);
  EXPECT_EQ(spans(2 * kPi), 4u);
}

TEST(EllipseArc, OfAWholeTurnIsClosed) {
  for (const int spans : {2, 3, 4, 5, 7, 100}) {
    const NurbsCurve arc = ellipse_arc({0.1, 0.2, 0.3}, {1, 0, 0}, {0, 1, 0}, 0.7, -2 * kPi, spans);
    EXPECT_EQ(arc.points().front(), arc.points().back());
  }
}

TEST(Ellipse, RefusesWhatIsNone) {
  const glm::dvec3 o(0), x(1, 0, 0), y(0, 1, 0);
  EXPECT_EQ(refusal([&] { circle(o, 0, {0, 0, 1}); }), "radius = 0 is not a positive length");
  EXPECT_NE(refusal([&] { circle(o, -1, {0, 0, 1}); }), "not refused");
  EXPECT_NE(refusal([&] { circle(o, std::nan(""), {0, 0, 1}); }), "not refused");
  EXPECT_EQ(refusal([&] { circle(o, 1, o); }), "normal has no direction: its length is 0");
  EXPECT_EQ(refusal([&] { circle({INFINITY, 0, 0}, 1, y); }), "center.x = inf is not finite");
  EXPECT_EQ(refusal([&] { ellipse(o, o, y); }), "axis_a has the length 0");
  EXPECT_EQ(refusal([&] { ellipse(o, x, o); }), "axis_b has the length 0");
  EXPECT_EQ(refusal([&] { ellipse(o, x, -3.0 * x); }), "axis_b is parallel to axis_a: they span no ellipse");
  EXPECT_EQ(refusal([&] { ellipse_arc(o, x, y, 0, 0); }), "sweep = 0 is zero or more than a whole turn");
  EXPECT_NE(refusal([&] { ellipse_arc(o, x, y, 0, 7); }), "not refused");
  EXPECT_NE(refusal([&] { ellipse_arc(o, x, y, INFINITY, 1); }), "not refused");
  EXPECT_NE(refusal([&] { ellipse_arc(o, x, y, 0, std::nan("")); }), "not refused");
  EXPECT_EQ(refusal([&] { ellipse_arc(o, x, y, 0, 2 * kPi, 1); }), "span_count = 1: one span cannot hold a whole turn");
  EXPECT_EQ(refusal([&] { ellipse_arc(o, x, y, 0, 1, -1); }), "span_count = -1 is outside [0, 65536]");
}

}  // namespace
}  // namespace splinecore
