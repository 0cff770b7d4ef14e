#pragma once

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
    demand_finite<double>(normals, "a normal");
  });
}

}  // namespace splinecore::fuzz
