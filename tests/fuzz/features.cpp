#include <algorithm>

#include "finding.hpp"
#include "shapes.hpp"
#include "splinecore/fit/interpolate_patch.hpp"
#include "splinecore/measure/arc_length.hpp"
#include "splinecore/measure/bounding_box.hpp"
#include "splinecore/measure/features.hpp"
#include "splinecore/measure/moving_frame.hpp"
#include "splinecore/measure/plane_curve.hpp"
#include "splinecore/meet/nearest.hpp"
#include "targets.hpp"

namespace splinecore::fuzz {

namespace {

std::vector<double> places(Bytes& bytes, const NurbsCurve& curve) {
  std::vector<double> u(bytes.integer(0, 4));
  for (double& one : u) one = parameter(bytes, curve.knot_vector());
  return u;
}

void demand_inside(std::span<const double> parameters, const Interval& domain, const std::string& what) {
  for (const double u : parameters) demand(u >= domain.start && u <= domain.end, what + " is outside the domain");
}

void demand_box(const Box& box) {
  for (int axis = 0; axis < 3; ++axis) demand(box.low[axis] <= box.high[axis], "a box is none");
}

void look_at_nearest(Bytes& bytes, const NurbsCurve& curve) {
  const std::vector<glm::dvec3> points = vectors(bytes, bytes.integer(1, 3));
  std::vector<NearestOnCurve> found(points.size());
  nearest(curve, points, found, 1);
  for (const NearestOnCurve& one : found) {
    demand(one.distance >= 0.0, "a distance is none");
    demand_inside(std::array{one.parameter}, curve.domain(), "the place of a nearest point");
  }
}

void look_at_lengths(Bytes& bytes, const NurbsCurve& curve) {
  const std::vector<double> parts = divide(curve, bytes.integer(1, 9));
  demand(std::ranges::is_sorted(parts), "parts of a curve do not follow one another");
  const std::vector<double> u = places(bytes, curve);
  const std::vector<double> lengths = lengths_at_parameters(curve, u);
  demand_finite<double>(parameters_at_lengths(curve, lengths), "a place by length");
}

void look_at_frames(Bytes& bytes, const NurbsCurve& curve) {
  CarriedFrame how;
  if (bytes.flag()) how.start = vector(bytes);
  how.is_closed = bytes.flag();
  const std::vector<double> u = places(bytes, curve);
  std::vector<MovingFrame> frames(u.size());
  rotation_minimizing_frames(curve, u, frames, how, bytes.flag() ? Side::left : Side::right);
  for (const MovingFrame& frame : frames) {
    const glm::dvec3& n = frame.normal;
    demand(std::abs(std::hypot(n.x, n.y, n.z) - 1.0) < 1e-9, "a normal that was carried has another length");
  }
}

void look_at_plane(Bytes& bytes, const NurbsCurve& curve) {
  const glm::dvec3 normal = vector(bytes);
  attempt([&] { demand(std::isfinite(signed_area(curve, normal, bytes.tolerance()).value), "an area is none"); });
  winding_number(curve, vector(bytes), normal);
}

void look_at_curve(Bytes& bytes) {
  const NurbsCurve curve = nurbs_curve(bytes);
  attempt([&] { look_at_nearest(bytes, curve); });
  attempt([&] { demand_box(bounding_box(curve)); });
  attempt([&] { look_at_lengths(bytes, curve); });
  attempt([&] { look_at_frames(bytes, curve); });
  attempt([&] { demand_inside(extrema(curve, vector(bytes)), curve.domain(), "an extremum"); });
  attempt([&] { demand_inside(inflections(curve, vector(bytes)), curve.domain(), "an inflection"); });
  attempt([&] { demand_inside(inflections(curve, plane_normal(curve)), curve.domain(), "an inflection"); });
  attempt([&] { look_at_plane(bytes, curve); });
}

void look_at_patch(Bytes& bytes) {
  const NurbsPatch patch = nurbs_patch(bytes);
  attempt([&] { demand_box(bounding_box(patch, bytes.tolerance())); });
  const std::vector<glm::dvec3> points = vectors(bytes, bytes.integer(1, 2));
  std::vector<NearestOnPatch> found(points.size());
  nearest(patch, points, found, 1);
  for (const NearestOnPatch& one : found) {
    demand(one.distance >= 0.0, "a distance is none");
    demand_inside(std::array{one.u}, patch.knot_vector(Axis::u).domain(), "the place of a nearest point along u");
    demand_inside(std::array{one.v}, patch.knot_vector(Axis::v).domain(), "the place of a nearest point along v");
  }
}

FitEnds ends(Bytes& bytes) {
  return std::array{FitEnds::averaged, FitEnds::not_a_knot, FitEnds::natural}[bytes.byte() % 3];
}

Closing closing(Bytes& bytes) { return bytes.integer(0, 3) == 0 ? Closing::closed : Closing::open; }

Parameterization parameterization(Bytes& bytes) {
  return std::array{Parameterization::uniform, Parameterization::centripetal, Parameterization::chordal}[bytes.byte() % 3];
}

void look_at_curve_through(Bytes& bytes) {
  InterpolationOptions options;
  options.degree = degree(bytes, 40);
  options.closing = closing(bytes);
  options.ends = ends(bytes);
  if (bytes.flag()) options.start = vectors(bytes, bytes.integer(0, 3));
  if (bytes.flag()) options.end = vectors(bytes, bytes.integer(0, 3));
  const std::vector<glm::dvec3> points = vectors(bytes, bytes.integer(0, 40));
  const auto found = interpolate(points, parameters_of(points, parameterization(bytes), options.closing), options);
  demand_error(found.error, "a curve through points");
}

void look_at_patch_through(Bytes& bytes) {
  const auto count_u = static_cast<std::size_t>(bytes.integer(0, 12));
  const auto count_v = static_cast<std::size_t>(bytes.integer(0, 12));
  const std::vector<glm::dvec3> points = vectors(bytes, count_u * count_v);
  const PointGrid grid{points, count_u, count_v};
  const auto direction = [&](Axis axis) {
    FitDirection made;
    made.degree = degree(bytes, 12);
    made.closing = closing(bytes);
    made.ends = ends(bytes);
    made.parameters = parameters_of(grid, axis, parameterization(bytes), made.closing);
    return made;
  };
  const FitDirection u = direction(Axis::u);
  demand_error(interpolate(grid, u, direction(Axis::v)).error, "a patch through points");
}

}  // namespace

void features(Input data) {
  constexpr std::array kLooks{look_at_curve, look_at_patch, look_at_curve_through, look_at_patch_through};
  Bytes bytes(data);
  const std::uint8_t look = bytes.byte();
  attempt([&] { kLooks[look % kLooks.size()](bytes); });
}

}  // namespace splinecore::fuzz
