#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "basis/bernstein_roots.hpp"
#include "curve/bezier_piece.hpp"
#include "near_curve.hpp"
#include "numerators.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A part of a span on which a polynomial has one sign.
struct Run {
  Interval part;
  double sign;
  bool comes_from_infinity = false;
};

/// The zeros of a polynomial and the signs between them; none if it is zero everywhere.
struct Signs {
  std::vector<Interval> zeros;
  std::vector<Run> runs;

  explicit Signs(const Numerator& numerator) : zeros(bernstein_zeros(numerator.coefficients, numerator.noise)) {
    if (is_zero()) return;
    double start = 0.0;
    for (std::size_t i = 0; i <= zeros.size(); ++i) {
      const double end = i < zeros.size() ? zeros[i].start : 1.0;
      const Interval part{start, end};
      const double value = start < end ? bernstein_value(numerator.coefficients, part.middle()) : 0.0;
      if (std::abs(value) > 0.0) runs.push_back({part, std::copysign(1.0, value)});
      start = end;
    }
  }

  bool is_zero() const { return zeros.size() == 1 && zeros.front() == Interval{0.0, 1.0}; }
};

/// The parameter at a part of a span.
inline double at(const Interval& span, double t) { return std::lerp(span.start, span.end, t); }

/// Visits the spans of a curve near the origin, with their parameters as they were given.
template <class Visit>
void for_each_span(const NurbsCurve& near, const NurbsCurve& curve, Visit visit) {
  const int count = static_cast<int>(curve.knot_vector().spans().size());
  for (int i = 0; i < count; ++i) visit(curve.knot_vector().span_interval(i), bezier_piece(near, i).values);
}

/// Coordinates of what is seen against a unit direction.
class View {
 public:
  explicit View(const glm::dvec3& direction) {
    int least = 0;
    for (int axis = 1; axis < 3; ++axis) {
      if (std::abs(direction[axis]) < std::abs(direction[least])) least = axis;
    }
    glm::dvec3 across(0.0);
    across[least] = 1.0;
    x_ = glm::normalize(glm::cross(across, direction));
    y_ = glm::cross(direction, x_);
  }

  glm::dvec2 seen(const glm::dvec3& p) const { return {glm::dot(p, x_), glm::dot(p, y_)}; }

  /// The direction that is seen so, at right angles to that of the view.
  glm::dvec3 direction(const glm::dvec2& seen) const { return seen.x * x_ + seen.y * y_; }

  std::vector<glm::dvec3> seen(const std::vector<glm::dvec4>& piece) const {
    std::vector<glm::dvec3> points;
    for (const glm::dvec4& p : piece) points.emplace_back(seen(glm::dvec3(p)), p.w);
    return points;
  }

 private:
  glm::dvec3 x_;
  glm::dvec3 y_;
};

}  // namespace splinecore
#pragma GCC visibility pop
