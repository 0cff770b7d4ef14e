#pragma once

#include <cmath>
#include <span>
#include <string>

#include "finding.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/exchange/json.hpp"
#include "splinecore/patch/evaluate.hpp"

namespace splinecore::fuzz {

/// What every value that was made must stand: its text, and points of it.
template <class Shape>
void look_at(const Shape& shape) {
  const Document document = Value(shape);
  demand(from_json(to_json(document)) == document, "a value's text is read as another");
}

inline void look_at_points(const NurbsCurve& curve) {
  look_at(curve);
  const Interval domain = curve.domain();
  const std::array u{domain.start, domain.middle(), domain.end};
  std::array<double, 9> out;
  attempt([&] {
    evaluate(curve, u, out);
    demand_finite<double>(out, "a point");
  });
}

/// A normal is a unit vector, or NaN where there is none.
inline void demand_unit_or_none(std::span<const double> normals) {
  for (std::size_t i = 0; i < normals.size(); i += 3) {
    const double length = std::hypot(normals[i], normals[i + 1], normals[i + 2]);
    const bool is_none = std::isnan(normals[i]) && std::isnan(normals[i + 1]) && std::isnan(normals[i + 2]);
    demand(is_none || std::abs(length - 1.0) <= 1e-12, "a normal is of length " + std::to_string(length));
  }
}

inline void look_at_points(const NurbsPatch& patch) {
  look_at(patch);
  const Interval u = patch.knot_vector(Axis::u).domain();
  const Interval v = patch.knot_vector(Axis::v).domain();
  const std::array places_u{u.start, u.middle(), u.end};
  const std::array places_v{v.start, v.middle(), v.end};
  std::array<double, 9> points;
  std::array<double, 9> normals;
  attempt([&] {
    evaluate_with_normals(patch, places_u, places_v, points, normals);
    demand_finite<double>(points, "a point");
    demand_unit_or_none(normals);
  });
}

}  // namespace splinecore::fuzz
