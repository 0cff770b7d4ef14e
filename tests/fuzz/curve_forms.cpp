#include <glm/gtc/type_ptr.hpp>

#include "curve_steps.hpp"
#include "finding.hpp"
#include "shapes.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/build/chain.hpp"
#include "splinecore/build/join.hpp"
#include "splinecore/conic/conic_arc.hpp"
#include "splinecore/conic/hermite_conic.hpp"
#include "splinecore/conic/implicit_form.hpp"
#include "splinecore/convert/to_bezier.hpp"
#include "splinecore/convert/to_hermite.hpp"
#include "splinecore/convert/to_power.hpp"
#include "splinecore/curve/bezier_degree.hpp"
#include "splinecore/curve/casteljau.hpp"
#include "splinecore/curve/flatten.hpp"
#include "splinecore/curve/moebius.hpp"
#include "splinecore/exchange/json.hpp"

namespace splinecore::fuzz {

namespace {

template <class Curve>
Curve one_of(Bytes& bytes, const std::vector<Curve>& curves) {
  demand(!curves.empty(), "a curve has no pieces");
  return curves[bytes.byte() % curves.size()];
}

BezierCurve bezier(Bytes& bytes, const NurbsCurve& curve) { return one_of(bytes, to_bezier(curve)); }

template <class Curve>
void check_text(const Curve& curve) {
  const Document document = Value(curve);
  demand(from_json(to_json(document)) == document, "a curve's text is read as another");
}

void check_triangles(const BezierCurve& curve, double u) {
  for (const auto& row : casteljau_triangle(curve, u)) {
    for (const glm::dvec4& p : row) demand_finite<double>(std::span(glm::value_ptr(p), 4), "de Casteljau's triangle");
  }
  const RationalTriangle rational = rational_casteljau_triangle(curve, u);
  for (const auto& row : rational.rows) {
    for (const glm::dvec4& p : row) demand_finite<double>(std::span(glm::value_ptr(p), 4), "the rational triangle");
  }
}

constexpr CurveStep kForms[] = {
    [](Bytes& bytes, NurbsCurve& curve) {
      const BezierCurve one = bezier(bytes, curve);
      const auto parts = split(one, bytes.within({}));
      curve = bytes.flag() ? parts.first.nurbs() : parts.second.nurbs();
    },
    [](Bytes& bytes, NurbsCurve& curve) {
      const BezierCurve one = bezier(bytes, curve);
      check_text(reversed(one));
      curve = elevated(one, bytes.integer(0, 4)).nurbs();
    },
    [](Bytes& bytes, NurbsCurve& curve) {
      const BezierCurve one = bezier(bytes, curve);
      const int times = bytes.integer(0, 4);
      const auto lower = bytes.flag() ? reduced(one, times) : reduced(one, times, bytes.tolerance());
      demand_error(lower.error, "a lower degree");
      curve = lower.value.nurbs();
    },
    [](Bytes& bytes, NurbsCurve& curve) {
      const BezierCurve one = bezier(bytes, curve);
      check_triangles(one, bytes.within({}));
    },
    [](Bytes& bytes, NurbsCurve& curve) {
      const BezierCurve one = bezier(bytes, curve);
      curve = moebius(one, bytes.number()).nurbs();
    },
    [](Bytes& bytes, NurbsCurve& curve) { curve = standard_form(bezier(bytes, curve)).nurbs(); },
    [](Bytes& bytes, NurbsCurve& curve) {
      const BezierCurve one = bezier(bytes, curve);
      // Finer than this takes seconds, for points by the hundred thousand.
      const double least = 1e-6 * extent(one.points());
      const Flattened line = flattened(one, bytes.flag() ? std::max(least, bytes.tolerance()) : bytes.number());
      demand_finite<double>(line.parameters, "a parameter of a polyline");
      for (const glm::dvec3& p : line.points) demand_finite<double>(std::span(glm::value_ptr(p), 3), "a point");
    },
    [](Bytes& bytes, NurbsCurve& curve) {
      const BezierCurve one = bezier(bytes, curve);
      const PowerCurve power = to_power(one, bytes.number());
      check_text(power);
      curve = power.nurbs();
    },
    [](Bytes& bytes, NurbsCurve& curve) {
      const PowerCurve power = one_of(bytes, to_power(curve));
      attempt([&] { check_text(with_origin(power, bytes.number())); });
      attempt([&] { check_text(with_domain(power, {bytes.number(), bytes.number()})); });
      attempt([&] { check_text(split(power, bytes.within(power.domain())).second); });
      attempt([&] { check_text(reversed(power)); });
      curve = derivative(power).nurbs();
    },
    [](Bytes& bytes, NurbsCurve& curve) {
      const HermiteCurve chain = to_hermite(curve);
      check_text(reversed(chain));
      curve = split(chain, bytes.within(curve.domain())).first.nurbs();
    },
    [](Bytes& bytes, NurbsCurve& curve) {
      const auto chain = conic_as_hermite(curve, bytes.tolerance());
      demand_error(chain.error, "a chain of a conic");
      curve = chain.value.nurbs();
    },
    [](Bytes& bytes, NurbsCurve& curve) {
      const BezierCurve arc = bezier(bytes, curve);
      conic_class(arc);
      const ImplicitConic conic = implicit_conic(arc);
      demand_finite<double>(conic.coefficients(), "a coefficient");
      const std::vector<NurbsCurve> covering = curves_of(conic);
      if (!covering.empty()) curve = one_of(bytes, covering);
    },
    [](Bytes& bytes, NurbsCurve& curve) {
      const std::vector<BezierCurve> chain = to_bezier(curve);
      attempt([&] { chain_from_polygon(polygon_of_chain(chain)); });
      curve = join_beziers(chain, {}, bytes.flag() ? 0.0 : bytes.tolerance());
    },
};

}  // namespace

std::span<const CurveStep> curve_forms() { return kForms; }

}  // namespace splinecore::fuzz
