#include <glm/gtc/type_ptr.hpp>

#include "curve_steps.hpp"
#include "finding.hpp"
#include "shapes.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/basis/functions.hpp"
#include "splinecore/curve/distance.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/exchange/json.hpp"
#include "splinecore/measure/continuity.hpp"
#include "splinecore/measure/curve_frame.hpp"
#include "splinecore/measure/length.hpp"
#include "splinecore/tessellate/polyline.hpp"

namespace splinecore::fuzz {

namespace {

std::vector<double> places(Bytes& bytes, const NurbsCurve& curve) {
  std::vector<double> u(bytes.integer(0, 5));
  for (double& one : u) one = parameter(bytes, curve.knot_vector());
  return u;
}

Side side(Bytes& bytes) { return bytes.flag() ? Side::left : Side::right; }

void check_continuity(const Continuity& found) {
  demand(found.gap >= 0.0, "a gap is negative or not a number");
  demand(found.c >= -1 && found.g >= -1, "an order of continuity is below -1");
}

void check_functions(Bytes& bytes, const NurbsCurve& curve) {
  const KnotVector& knots = curve.knot_vector();
  const int i = bytes.byte() % knots.count();
  const double u = bytes.number();
  attempt([&] { demand(std::isfinite(function_value(knots, i, u)), "a basis function is not finite"); });
  std::vector<double> row(bytes.integer(0, 70));
  attempt([&] { function_derivatives(knots, i, u, row); });
  attempt([&] {
    for (const TriangleRow& line : function_triangle(knots, parameter(bytes, knots))) {
      demand_finite<double>(line.values, "a row of the triangle");
    }
  });
  const Interval support = function_support(knots, i);
  demand(support.start <= support.end, "a support ends before it starts");
}

constexpr CurveStep kMeasures[] = {
    [](Bytes& bytes, NurbsCurve& curve) {
      const std::vector<double> u = places(bytes, curve);
      std::vector<double> out(3 * u.size());
      evaluate(curve, u, out, {side(bytes), AtInfinity::raise});
      demand_finite<double>(out, "a point");
    },
    [](Bytes& bytes, NurbsCurve& curve) {
      const std::vector<double> u = places(bytes, curve);
      std::vector<float> out(3 * u.size());
      evaluate(curve, u, out, {side(bytes), AtInfinity::nan});
    },
    [](Bytes& bytes, NurbsCurve& curve) {
      const std::vector<double> u = places(bytes, curve);
      const int order = bytes.integer(0, 66);
      std::vector<double> out(3 * u.size() * static_cast<std::size_t>(order + 1));
      derivatives(curve, u, order, out, {side(bytes), bytes.flag() ? AtInfinity::nan : AtInfinity::raise});
    },
    [](Bytes& bytes, NurbsCurve& curve) {
      const std::vector<double> u = places(bytes, curve);
      std::vector<glm::dvec4> out(u.size());
      evaluate_homogeneous(curve, u, out, side(bytes));
      for (const double at : u) is_at_infinity(curve, at, side(bytes));
    },
    [](Bytes&, NurbsCurve& curve) {
      double last = curve.domain().start;
      for (const Interval& piece : pieces(curve)) {
        demand(piece.start >= last && piece.end > piece.start, "pieces do not follow one another");
        last = piece.end;
      }
      demand(last <= curve.domain().end, "a piece ends outside the domain");
    },
    [](Bytes&, NurbsCurve& curve) {
      const Document document = Value(curve);
      demand(from_json(to_json(document)) == document, "a curve's text is read as another");
    },
    [](Bytes& bytes, NurbsCurve& curve) {
      NurbsCurve other = curve.with_points(points(bytes, curve.points().size()));
      demand(largest_distance(curve, other) >= 0.0, "a distance is negative or not a number");
      demand(largest_distance(curve, curve) >= 0.0, "a curve's distance from itself is not a number");
    },
    [](Bytes& bytes, NurbsCurve& curve) {
      const std::vector<double> u = places(bytes, curve);
      std::vector<double> out(u.size());
      const Side from = side(bytes);
      attempt([&] { curvature(curve, u, out, from); });
      attempt([&] { torsion(curve, u, out, from); });
      std::vector<MovingFrame> frames(u.size());
      frenet_frames(curve, u, frames, from);
    },
    [](Bytes& bytes, NurbsCurve& curve) {
      const double u = parameter(bytes, curve.knot_vector());
      attempt([&] { check_continuity(continuity_at(curve, u, bytes.tolerance())); });
      attempt([&] { check_continuity(continuity_between(curve, curve)); });
      for (const Joint& joint : joints(curve)) check_continuity(joint.continuity);
    },
    [](Bytes& bytes, NurbsCurve& curve) {
      attempt([&] {
        const Approximation<double> all = length(curve);
        demand(std::isfinite(all.value) && all.value >= 0.0 && all.error >= 0.0, "a length is none");
      });
      const double start = parameter(bytes, curve.knot_vector());
      const double end = parameter(bytes, curve.knot_vector());
      length(curve, {start, end}, bytes.tolerance());
    },
    [](Bytes& bytes, NurbsCurve& curve) {
      const int resolution = bytes.integer(0, 40);
      std::optional<double> reach;
      if (bytes.flag()) reach = bytes.tolerance() * 10.0;
      for (const Polyline& line : polylines(curve, resolution, reach)) {
        demand_finite<double>(line.points, "a point of a polyline");
      }
    },
    [](Bytes& bytes, NurbsCurve& curve) { check_functions(bytes, curve); },
    [](Bytes&, NurbsCurve& curve) {
      attempt([&] {
        for (const glm::dvec4& p : finite_homogeneous(curve.points())) {
          demand_finite<double>(std::span(glm::value_ptr(p), 4), "a homogeneous point");
        }
      });
    },
};

}  // namespace

std::span<const CurveStep> curve_measures() { return kMeasures; }

}  // namespace splinecore::fuzz
