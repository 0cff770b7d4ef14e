// Prints results of every room of the library, seeded, bit for bit, to be compared between systems by
// native/release/compare.py: "name" on a line, then the bits of each number on one of its own.
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "splinecore/build/offset.hpp"
#include "splinecore/build/primitives.hpp"
#include "splinecore/conic/plane.hpp"
#include "splinecore/curve/degree.hpp"
#include "splinecore/curve/removal.hpp"
#include "splinecore/exchange/json.hpp"
#include "splinecore/fit/approximate.hpp"
#include "splinecore/fit/interpolate.hpp"
#include "splinecore/formula/evaluate.hpp"
#include "splinecore/measure/area.hpp"
#include "splinecore/measure/curve_frame.hpp"
#include "splinecore/measure/length.hpp"
#include "splinecore/measure/patch_curvature.hpp"
#include "splinecore/meet/intersections.hpp"
#include "splinecore/meet/nearest.hpp"
#include "splinecore/meet/sections.hpp"
#include "splinecore/patch/degree.hpp"
#include "splinecore/tessellate/polyline.hpp"
#include "splinecore/tessellate/tessellation.hpp"
#include "support.hpp"

namespace splinecore::testing {
namespace {

std::string section;  ///< that the next numbers belong to

void begin(const std::string& name) {
  if (name != section) std::printf("%s\n", name.c_str());
  section = name;
}

void print(double number) {
  std::uint64_t bits;
  std::memcpy(&bits, &number, sizeof(bits));
  std::printf("%016" PRIx64 "\n", number == number ? bits : 0x7ff8000000000000);
}

void print(float number) { print(static_cast<double>(number)); }
void print(std::int32_t number) { print(static_cast<double>(number)); }
void print(const glm::dvec3& p) {
  for (int axis = 0; axis < 3; ++axis) print(p[axis]);
}
void print(const glm::dvec4& p) {
  for (int axis = 0; axis < 4; ++axis) print(p[axis]);
}
template <class Value>
void print(const std::vector<Value>& values) {
  for (const Value& value : values) print(value);
}
template <class Shape>
void print_points(const Shape& shape) {
  for (const glm::dvec4& p : shape.points()) print(p);
}

/// A message counts as a result.
void print(const std::string& text) {
  for (const char letter : text) print(static_cast<std::int32_t>(letter));
}

template <class Call>
void result(const std::string& name, Call call) {
  begin(name);
  try {
    call();
  } catch (const std::exception& error) {
    print(std::string(error.what()));
  }
}

void curve_results(Random& random, const Kind& kind) {
  const NurbsCurve curve = random_curve(random, kind);
  const Interval domain = curve.knot_vector().domain();
  const std::vector<double> at = random_parameters(random, domain, 8);
  std::vector<double> out(9 * at.size());
  result("curve.evaluate", [&] { evaluate(curve, at, std::span(out).first(3 * at.size())), print(out); });
  result("curve.derivatives", [&] { derivatives(curve, at, 2, out), print(out); });
  std::vector<double> one(at.size());
  result("curve.torsion", [&] { torsion(curve, at, one), print(one); });
  result("curve.curvature", [&] { curvature(curve, at, one), print(one); });
  std::vector<double> inserted = at;
  std::ranges::sort(inserted);
  result("curve.refine", [&] { print_points(refine(curve, inserted)); });
  result("curve.elevate", [&] { print_points(elevated(curve, 2)); });
  result("curve.reduce", [&] { print_points(reduced(elevated(curve, 1), 1).value); });
  result("curve.remove", [&] { print_points(remove_knots(refine(curve, inserted), 1e-9).value); });
  result("curve.json", [&] { print(to_json(Value(curve))); });
  if (kind.weights == Weights::any) return;
  result("curve.length", [&] { print(length(curve).value); });
  result("curve.polyline", [&] {
    for (const auto& line : polylines(curve, 6)) print(line.points);
  });
  std::vector<NearestOnCurve> near(4);
  std::vector<glm::dvec3> points;
  for (std::size_t i = 0; i < near.size(); ++i) points.push_back(random_vector(random));
  result("curve.nearest", [&] {
    nearest(curve, points, near);
    for (const NearestOnCurve& found : near) print(found.point), print(found.parameter);
  });
}

void patch_results(Random& random, bool with_adaptive) {
  const NurbsPatch patch = random_patch(random, Weights::positive);
  const std::vector<double> us = random_parameters(random, patch.knot_vector(Axis::u).domain(), 8);
  const std::vector<double> vs = random_parameters(random, patch.knot_vector(Axis::v).domain(), 8);
  std::vector<double> points(3 * us.size());
  std::vector<double> normals(3 * us.size());
  result("patch.evaluate", [&] {
    evaluate_with_normals(patch, us, vs, points, normals);
    print(points);
    print(normals);
  });
  result("patch.elevate", [&] { print_points(elevated(patch, Axis::u, 2)); });
  result("patch.area", [&] { print(area(patch, 1e-6).value); });
  result("patch.section", [&] {
    const Sections found = sections(patch, plane_across({0, 0, 0}, {1, 2, 3}));
    for (const auto& section_curve : found.curves) print_points(section_curve.curve);
  });
  const AnyPatch any[] = {AnyPatch(patch)};
  const PatchSet set = PatchSet::of(any, true);
  const auto mesh = [&](const Tessellation& made) {
    std::vector<float> positions(3 * made.vertex_count());
    std::vector<float> corners(3 * made.corner_vertices().size());
    made.evaluate(set, positions, corners);
    print(positions);
    print(corners);
    for (const auto vertex : made.corner_vertices()) print(static_cast<std::int32_t>(vertex));
  };
  result("mesh.even", [&] { mesh(Tessellation::make(set, 3, 3)); });
  if (with_adaptive) result("mesh.adaptive", [&] { mesh(Tessellation::adaptive(set, {0.5, 1.0})); });
}

NurbsCurve flattened(const NurbsCurve& curve) {
  std::vector<glm::dvec4> points(curve.points().begin(), curve.points().end());
  for (glm::dvec4& point : points) point.z = 0.0;
  return curve.with_points(std::move(points));
}

void meeting_results(Random& random) {
  const Kind kind{3, 4, Ends::clamped, Weights::positive};
  const NurbsCurve a = random_curve(random, kind);
  const NurbsCurve flat = flattened(a);
  const NurbsCurve other = flattened(random_curve(random, kind));
  result("meet.curves", [&] {
    for (const auto& place : intersections(flat, other).places) print(place.point), print(place.a), print(place.b);
  });
  const NurbsPatch patch = random_patch(random, Weights::positive);
  result("meet.patch", [&] {
    for (const auto& place : intersections(a, patch).places) print(place.point), print(place.t);
  });
  result("libm offset", [&] {
    for (const NurbsCurve& made : offset(flat, 0.4, {.tolerance = 1e-3})) print_points(made);
  });
}

void fit_results(Random& random) {
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 40; ++i) points.push_back(random_vector(random));
  std::vector<double> parameters{0.0};
  while (parameters.size() < points.size()) parameters.push_back(parameters.back() + real(random, 0.5, 1.5));
  for (int degree = 1; degree <= 9; degree += 2) {
    result("fit.interpolate", [&] { print_points(interpolate(points, parameters, {.degree = degree}).value); });
    result("fit.approximate", [&] { print_points(approximate(points, parameters, degree, 20).value); });
  }
}

/// What rests on the functions of a system's own library of them.
void libm_results(Random& random) {
  std::vector<double> at(200);
  for (double& t : at) t = real(random, 0.0, 1.0);
  std::vector<double> out(at.size());
  for (const char* name : {"sin(t)", "cos(t)", "tan(t)", "asin(t)", "acos(t)", "atan(t)", "sinh(t)", "cosh(t)", "tanh(t)",
                           "asinh(t)", "acosh(1+t)", "atanh(t)", "exp(t)", "log(t)", "log2(t)", "log10(t)", "cbrt(t)",
                           "(t+1)^2.7"}) {
    result(std::string("libm ") + name,
           [&] { evaluate(Formula::make(name, {"t"}), std::span<const double>(at), out), print(out); });
  }
  result("formula.sqrt", [&] { evaluate(Formula::make("sqrt(t)", {"t"}), std::span<const double>(at), out), print(out); });
  result("libm sphere", [&] { print_points(sphere({0.1, 0.2, 0.3}, 1.7)); });
  result("libm torus", [&] { print_points(torus({0, 0, 0}, {1, 2, 3}, 2, 0.7, {0.3, 2.1})); });
}

void all_results() {
  Random random(20261126);
  for (const Kind& kind : all_kinds()) curve_results(random, kind);
  for (int i = 0; i < 40; ++i) patch_results(random, i % 8 == 0);
  for (int i = 0; i < 40; ++i) meeting_results(random);
  for (int i = 0; i < 5; ++i) fit_results(random);
  libm_results(random);
}

}  // namespace
}  // namespace splinecore::testing

int main() { splinecore::testing::all_results(); }
