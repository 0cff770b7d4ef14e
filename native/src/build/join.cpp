#include "splinecore/build/join.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/length.hpp"
#include "base/require.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/basis/hermite.hpp"
#include "splinecore/curve/bezier_degree.hpp"

namespace splinecore {

namespace {

void require_meeting(const glm::dvec4& end, const glm::dvec4& start, std::size_t joint, double tolerance) {
  const std::string name = "joint " + std::to_string(joint);
  if (end.w == 0.0 || start.w == 0.0) throw InvalidShape(name + " lies at infinity: the weight of an end is zero");
  const double gap = distance_of(glm::dvec3(end), glm::dvec3(start));
  if (gap <= tolerance) return;
  throw InvalidShape(name + " is open: an end lies " + text_of(gap) + " from the next start, the tolerance is " +
                     text_of(tolerance));
}

BezierCurve raised_to(const BezierCurve& curve, int degree) {
  return curve.degree() == degree ? curve : elevated(curve, degree - curve.degree());
}

/// All but the first point, with weights that continue from the last one there is.
void append(const BezierCurve& curve, std::vector<glm::dvec4>& points) {
  const double scale = points.back().w / curve.points().front().w;
  for (glm::dvec4 point : curve.points().subspan(1)) {
    if (point.w == 0.0) {
      point *= scale;  // A direction is as long as the weights are large.
    } else {
      point.w *= scale;
    }
    points.push_back(point);
  }
}

KnotVector joined_knots(int degree, const std::vector<double>& parameters) {
  std::vector<double> knots{parameters.front()};
  for (const double u : parameters) knots.insert(knots.end(), degree, u);
  knots.push_back(parameters.back());
  return KnotVector::make(degree, std::move(knots));
}

}  // namespace

NurbsCurve join_beziers(std::span<const BezierCurve> curves, std::vector<double> parameters, double tolerance) {
  if (curves.empty()) throw InvalidShape("curves is empty: it needs one curve or more");
  require_tolerance(tolerance);
  if (!parameters.empty() && parameters.size() != curves.size() + 1) {
    throw InvalidShape("parameters has " + std::to_string(parameters.size()) + " values for " +
                       std::to_string(curves.size()) + " curves");
  }
  parameters = hermite_parameters(std::move(parameters), curves.size() + 1, "parameters");
  const int degree = std::ranges::max(curves, {}, &BezierCurve::degree).degree();
  const BezierCurve first = raised_to(curves.front(), degree);
  std::vector<glm::dvec4> points(first.points().begin(), first.points().end());
  for (std::size_t i = 1; i < curves.size(); ++i) {
    require_meeting(curves[i - 1].points().back(), curves[i].points().front(), i, tolerance);
    append(raised_to(curves[i], degree), points);
  }
  return NurbsCurve::make(joined_knots(degree, parameters), std::move(points));
}

}  // namespace splinecore
