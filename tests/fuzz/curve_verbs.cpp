#include "curve_steps.hpp"
#include "finding.hpp"
#include "shapes.hpp"
#include "splinecore/build/drag.hpp"
#include "splinecore/convert/to_hermite.hpp"
#include "splinecore/curve/compatible.hpp"
#include "splinecore/curve/degree.hpp"
#include "splinecore/curve/distance.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/finite_arcs.hpp"
#include "splinecore/curve/join.hpp"
#include "splinecore/curve/moebius.hpp"
#include "splinecore/curve/removal.hpp"
#include "splinecore/curve/transform.hpp"

namespace splinecore::fuzz {

namespace {

void take(NurbsCurve& curve, Approximation<NurbsCurve> found) {
  demand_error(found.error, "a curve");
  curve = std::move(found.value);
}

void take(NurbsCurve& curve, Bytes& bytes, std::pair<NurbsCurve, NurbsCurve> parts) {
  curve = std::move(bytes.flag() ? parts.first : parts.second);
}

std::optional<double> maybe_tolerance(Bytes& bytes) {
  return bytes.flag() ? std::optional(bytes.tolerance()) : std::nullopt;
}

constexpr CurveStep kVerbs[] = {
    [](Bytes& bytes, NurbsCurve& curve) {
      std::vector<double> inserted(bytes.integer(1, 6));
      for (double& u : inserted) u = parameter(bytes, curve.knot_vector());
      curve = refine(curve, inserted);
    },
    [](Bytes& bytes, NurbsCurve& curve) {
      const double u = parameter(bytes, curve.knot_vector());
      curve = insert_knot(curve, u, bytes.integer(0, 5));
    },
    [](Bytes& bytes, NurbsCurve& curve) {
      const double u = parameter(bytes, curve.knot_vector());
      take(curve, bytes, split(curve, u));
    },
    [](Bytes& bytes, NurbsCurve& curve) { curve = opened(curve, parameter(bytes, curve.knot_vector())); },
    [](Bytes&, NurbsCurve& curve) { curve = unrolled(curve); },
    [](Bytes&, NurbsCurve& curve) {
      const NurbsCurve there = reversed(curve);
      demand(reversed(there).points().size() == curve.points().size(), "a curve turned twice has other points");
      curve = there;
    },
    [](Bytes& bytes, NurbsCurve& curve) { curve = elevated(curve, bytes.integer(0, 4)); },
    [](Bytes& bytes, NurbsCurve& curve) {
      const int times = bytes.integer(0, 4);
      take(curve, reduced(curve, times, maybe_tolerance(bytes)));
    },
    [](Bytes& bytes, NurbsCurve& curve) {
      const double u = parameter(bytes, curve.knot_vector());
      const int times = bytes.integer(0, 3);
      take(curve, remove_knot(curve, u, times, maybe_tolerance(bytes)));
    },
    [](Bytes& bytes, NurbsCurve& curve) { take(curve, remove_knots(curve, bytes.tolerance())); },
    [](Bytes& bytes, NurbsCurve& curve) {
      const double start = bytes.number();
      curve = with_domain(curve, {start, start + std::abs(bytes.number())});
    },
    [](Bytes&, NurbsCurve& curve) { curve = clamped(curve); },
    [](Bytes&, NurbsCurve& curve) { curve = unclamped(curve); },
    [](Bytes& bytes, NurbsCurve& curve) { take(curve, made_periodic(curve, maybe_tolerance(bytes))); },
    [](Bytes&, NurbsCurve& curve) { curve = with_whole_seam(curve); },
    [](Bytes& bytes, NurbsCurve& curve) { take(curve, bytes, compatible(curve, nurbs_curve(bytes))); },
    [](Bytes& bytes, NurbsCurve& curve) {
      const double reach = bytes.tolerance() * 10.0;
      const std::vector<glm::dvec3> around = bytes.flag() ? vectors(bytes, 2) : std::vector<glm::dvec3>{};
      const std::vector<NurbsCurve> arcs = finite_arcs(curve, reach, around);
      if (!arcs.empty()) curve = arcs[bytes.byte() % arcs.size()];
    },
    [](Bytes& bytes, NurbsCurve& curve) {
      const auto smoothness = static_cast<Smoothness>(bytes.integer(0, 3));
      const NurbsCurve other = bytes.flag() ? nurbs_curve(bytes) : reversed(curve);
      take(curve, joined(curve, other, smoothness));
    },
    [](Bytes& bytes, NurbsCurve& curve) { curve = moebius(curve, bytes.number()); },
    [](Bytes&, NurbsCurve& curve) { curve = standard_form(curve); },
    [](Bytes& bytes, NurbsCurve& curve) { curve = transformed(curve, matrix(bytes)); },
    [](Bytes& bytes, NurbsCurve& curve) { curve = curve.with_points(points(bytes, curve.points().size())); },
    [](Bytes& bytes, NurbsCurve& curve) {
      const double u = parameter(bytes, curve.knot_vector());
      Drag drag{vector(bytes), {}, {}};
      if (bytes.flag()) drag.tangent_by = vector(bytes);
      if (bytes.flag()) drag.second_by = vector(bytes);
      Following following{{}, bytes.flag() ? bytes.number() : 0.0};
      if (bytes.flag()) following.factors = numbers(bytes, curve.points().size());
      curve = dragged(curve, u, drag, following);
    },
    [](Bytes& bytes, NurbsCurve& curve) {
      const HermiteCurve chain = to_hermite(curve);
      curve = dragged(chain, bytes.within(chain.nurbs().domain()), {vector(bytes), {}, {}}).nurbs();
    },
};

}  // namespace

std::span<const CurveStep> curve_verbs() { return kVerbs; }

}  // namespace splinecore::fuzz
