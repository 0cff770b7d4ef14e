#include <algorithm>

#include "finding.hpp"
#include "shapes.hpp"
#include "splinecore/build/blend.hpp"
#include "splinecore/build/contour.hpp"
#include "splinecore/build/corners.hpp"
#include "splinecore/build/curve_on_patch.hpp"
#include "splinecore/build/extend.hpp"
#include "splinecore/build/fillet.hpp"
#include "splinecore/build/helix.hpp"
#include "splinecore/build/join_curves.hpp"
#include "splinecore/build/offset.hpp"
#include "splinecore/build/part.hpp"
#include "splinecore/build/touching_circle.hpp"
#include "splinecore/meet/intersections.hpp"
#include "splinecore/meet/sections.hpp"
#include "targets.hpp"

namespace splinecore::fuzz {

namespace {

void demand_inside(double u, const Interval& domain, const std::string& what) {
  demand(u >= domain.start && u <= domain.end, what + " is outside the domain");
}

std::optional<double> maybe_tolerance(Bytes& bytes) {
  return bytes.flag() ? std::optional(bytes.tolerance()) : std::nullopt;
}

void meet_curves(Bytes& bytes) {
  const NurbsCurve a = nurbs_curve(bytes);
  const NurbsCurve b = bytes.flag() ? nurbs_curve(bytes) : a;
  attempt([&] {
    for (const CurveIntersection& place : intersections(a, b, maybe_tolerance(bytes)).places) {
      demand_inside(place.a, a.domain(), "a place on the first curve");
      demand_inside(place.b, b.domain(), "a place on the second curve");
    }
  });
  attempt([&] { self_intersections(a, maybe_tolerance(bytes)); });
}

void meet_patches(Bytes& bytes) {
  const NurbsPatch a = nurbs_patch(bytes);
  if (bytes.flag()) {
    const NurbsCurve curve = nurbs_curve(bytes);
    for (const PatchIntersection& place : intersections(curve, a).places) {
      demand_inside(place.t, curve.domain(), "a place on a curve");
    }
    return;
  }
  for (const SectionCurve& section : sections(a, bytes.flag() ? nurbs_patch(bytes) : a, maybe_tolerance(bytes)).curves) {
    demand(section.curve.points().size() == section.on_a.points().size(), "a section and its image have other points");
  }
}

void cut(Bytes& bytes) {
  const NurbsCurve curve = nurbs_curve(bytes);
  const double u = parameter(bytes, curve.knot_vector());
  const double v = parameter(bytes, curve.knot_vector());
  attempt([&] { demand(!parts(curve, {u, v}).empty(), "a curve was cut into nothing"); });
  attempt([&] { part(curve, std::min(u, v), std::max(u, v)); });
  const std::vector<NurbsCurve> others{nurbs_curve(bytes)};
  attempt([&] { demand(!trimmed(curve, others, u).empty(), "nothing is left of a curve that was trimmed"); });
  const auto how = static_cast<Extension>(bytes.integer(0, 2));
  const bool at_end = bytes.flag();
  attempt([&] { extended_to(curve, at_end, others, how); });
  const NurbsCurve longer = extended(curve, at_end, std::abs(bytes.number()), how);
  demand(longer.domain().length() >= curve.domain().length(), "a longer curve has a shorter domain");
}

void turn_corners(Bytes& bytes) {
  const NurbsCurve curve = nurbs_curve(bytes);
  const double size = bytes.tolerance() * 10.0;
  attempt([&] { rounded(curve, size); });
  attempt([&] { chamfered(curve, size); });
  const NurbsCurve other = nurbs_curve(bytes);
  const std::array<double, 2> kept{parameter(bytes, curve.knot_vector()), parameter(bytes, other.knot_vector())};
  const glm::dvec3 normal = vector(bytes);
  attempt([&] { filleted(curve, other, size, kept, normal); });
  attempt([&] { chamfered(curve, other, {size, bytes.tolerance()}, kept); });
  fillets(curve, other, size, normal);
}

void make_beside(Bytes& bytes) {
  const NurbsCurve curve = nurbs_curve(bytes);
  OffsetOptions options;
  if (bytes.flag()) options.normal = vector(bytes);
  options.tolerance = maybe_tolerance(bytes);
  options.corner = bytes.flag() ? OffsetCorner::sharp : OffsetCorner::round;
  options.trimmed = bytes.flag();
  attempt([&] { offset(curve, bytes.number(), options); });
  HelixOptions about;
  about.radii = {std::abs(bytes.number()), std::abs(bytes.number())};
  about.turns = bytes.integer(-6, 6);
  attempt([&] { helix(curve, about); });
  const NurbsCurve other = nurbs_curve(bytes);
  attempt([&] { blend({curve, bytes.flag()}, {other, bytes.flag()}, bytes.integer(0, 3)); });
  attempt([&] { join_curves(std::vector{curve, other, curve}, bytes.tolerance()); });
  const std::array<double, 3> near{parameter(bytes, curve.knot_vector()), parameter(bytes, other.knot_vector()),
                                   parameter(bytes, curve.knot_vector())};
  attempt([&] { touching_circle({curve, other, curve}, near, vector(bytes)); });
  curve_on_patch(nurbs_patch(bytes), curve, bytes.number(), maybe_tolerance(bytes));
}

void draw_contour(Bytes& bytes) {
  const std::vector<glm::dvec3> corners = vectors(bytes, bytes.integer(0, 6));
  const bool closed = bytes.flag();
  const std::size_t count = closed || corners.empty() ? corners.size() : corners.size() - 1;
  contour(corners, bytes.flag() ? numbers(bytes, count) : std::vector<double>{}, closed, vector(bytes));
}

}  // namespace

void meet(Input data) {
  constexpr std::array kLooks{meet_curves, meet_patches, cut, turn_corners, make_beside, draw_contour};
  Bytes bytes(data);
  const std::uint8_t look = bytes.byte();
  attempt([&] { kLooks[look % kLooks.size()](bytes); });
}

}  // namespace splinecore::fuzz
