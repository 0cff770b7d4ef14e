#include "splinecore/curve/hermite_curve.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "base/require.hpp"
#include "basis/selection.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/basis/hermite.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

/// Inner Bezier points lie a third of a segment along the tangents (R_1 = 3 (P_2 - P_1)).
NurbsCurve bezier_chain(const std::vector<glm::dvec3>& points, const std::vector<Tangents>& tangents,
                        const std::vector<double>& parameters) {
  std::vector<glm::dvec4> chain{{points[0], 1.0}};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double third = (parameters[i] - parameters[i - 1]) / 3.0;
    chain.emplace_back(points[i - 1] + third * tangents[i - 1].outgoing, 1.0);
    chain.emplace_back(points[i] - third * tangents[i].incoming, 1.0);
    chain.emplace_back(points[i], 1.0);
  }
  return NurbsCurve::make(hermite_knots(parameters), std::move(chain));
}

}  // namespace

HermiteCurve::HermiteCurve(std::vector<glm::dvec3> points, std::vector<Tangents> tangents,
                           std::vector<double> parameters)
    : points_(std::move(points)), tangents_(std::move(tangents)), parameters_(std::move(parameters)),
      form_(bezier_chain(points_, tangents_, parameters_)) {}

HermiteCurve HermiteCurve::make(std::vector<glm::dvec3> points, std::vector<Tangents> tangents,
                                std::vector<double> parameters) {
  if (points.size() < 2) {
    throw InvalidShape("points has " + std::to_string(points.size()) +
                       " rows, a Hermite chain needs 2 or more");
  }
  if (tangents.size() != points.size()) {
    throw InvalidShape("tangents has " + std::to_string(tangents.size()) + " rows for " +
                       std::to_string(points.size()) + " points");
  }
  require_finite(points, "points");
  const auto* rows = reinterpret_cast<const glm::dvec3*>(tangents.data());
  require_finite({rows, 2 * tangents.size()}, "tangents", 2);
  parameters = hermite_parameters(std::move(parameters), points.size(), "parameters");
  return {std::move(points), std::move(tangents), std::move(parameters)};
}

std::pair<HermiteCurve, HermiteCurve> split(const HermiteCurve& curve, double u) {
  const auto parameters = curve.parameters();
  if (!(u > parameters.front() && u < parameters.back())) {
    throw InvalidShape("u = " + text_of(u) + " is not inside the domain (" +
                       text_of(parameters.front()) + ", " + text_of(parameters.back()) + ")");
  }
  const auto at = std::ranges::lower_bound(parameters, u) - parameters.begin();
  std::vector<glm::dvec3> points(curve.points().begin(), curve.points().end());
  std::vector<Tangents> tangents(curve.tangents().begin(), curve.tangents().end());
  std::vector<double> knots(parameters.begin(), parameters.end());
  if (parameters[at] != u) {
    std::array<double, 6> values{};
    derivatives(curve.nurbs(), {&u, 1}, 1, values);
    const glm::dvec3 tangent(values[3], values[4], values[5]);
    points.insert(points.begin() + at, {values[0], values[1], values[2]});
    tangents.insert(tangents.begin() + at, {tangent, tangent});
    knots.insert(knots.begin() + at, u);
  }
  return {HermiteCurve::make({points.begin(), points.begin() + at + 1},
                             {tangents.begin(), tangents.begin() + at + 1},
                             {knots.begin(), knots.begin() + at + 1}),
          HermiteCurve::make({points.begin() + at, points.end()}, {tangents.begin() + at, tangents.end()},
                             {knots.begin() + at, knots.end()})};
}

HermiteCurve reversed(const HermiteCurve& curve) {
  std::vector<Tangents> tangents;
  for (auto t = curve.tangents().rbegin(); t != curve.tangents().rend(); ++t) {
    tangents.push_back({-t->outgoing, -t->incoming});
  }
  const auto given = curve.parameters();
  std::vector<double> parameters = mirrored(given, {given.front(), given.back()}, 1);
  return HermiteCurve::make({curve.points().rbegin(), curve.points().rend()}, std::move(tangents),
                            std::move(parameters));
}

}  // namespace splinecore
