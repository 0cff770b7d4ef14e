// Work whose instructions are counted for so many knots, spans or patches: growth WORKLOAD COUNT.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "counted_work.hpp"
#include "splinecore/convert/to_bezier.hpp"
#include "splinecore/curve/compatible.hpp"
#include "splinecore/curve/removal.hpp"
#include "splinecore/fit/interpolate.hpp"
#include "splinecore/patch/panels.hpp"
#include "splinecore/tessellate/tessellation.hpp"

namespace {

using splinecore::KnotVector;
using splinecore::NurbsCurve;
using splinecore::PatchSet;

/// Clamped on [0, 1], no two spans next to each other of one length.
KnotVector uneven_knots(int count, double phase = 0.0) {
  std::vector<double> knots(3, 0.0);
  const int spans = count - 3;
  for (int i = 0; i <= spans; ++i) knots.push_back((i + (0 < i && i < spans ? 0.3 * std::sin(i + phase) : 0.0)) / spans);
  knots.insert(knots.end(), 3, 1.0);
  return KnotVector::make(3, knots);
}

NurbsCurve coil(int count, double phase = 0.0) {
  std::vector<glm::dvec4> points;
  for (int i = 0; i < count; ++i) points.emplace_back(std::cos(0.3 * i), std::sin(0.3 * i), 0.01 * i, 1.25 + 0.75 * std::sin(i));
  return NurbsCurve::make(uneven_knots(count, phase), points);
}

/// Every second knot can be removed.
void remove_knots(int count) {
  const NurbsCurve plain = coil(count);
  std::vector<double> inserted;
  for (int i = 0; i < static_cast<int>(plain.knot_vector().spans().size()); ++i) {
    inserted.push_back(plain.knot_vector().span_interval(i).middle());
  }
  const NurbsCurve refined = refine(plain, inserted);
  counted_work([&] { splinecore::remove_knots(refined, 1e-9); });
}

void insert_knots(int count) {
  const NurbsCurve curve = coil(count);
  std::vector<double> inserted;
  for (int i = 0; i < count; ++i) inserted.push_back((i + 0.5) / count);
  counted_work([&] { refine(curve, inserted); });
}

void to_beziers(int count) {
  const NurbsCurve curve = coil(count);
  counted_work([&] { to_bezier(curve); });
}

void pieces_of_gaps(int count) {
  std::vector<double> knots;
  for (int i = 0; i <= count; ++i) knots.insert(knots.end(), 4, i);
  std::vector<glm::dvec4> points;
  for (int i = 0; i < 4 * count; ++i) points.emplace_back(i, i % 3, i % 5, 1.0);
  const NurbsCurve curve = NurbsCurve::make(3, knots, points);
  counted_work([&] { pieces(curve); });
}

void compatible_knots(int count) {
  const NurbsCurve a = coil(count);
  const NurbsCurve b = coil(count + 5, 1.0);
  counted_work([&] { compatible(a, b); });
}

void multiplicities(int count) {
  const KnotVector knots = uneven_knots(count);
  long sum = 0;
  counted_work([&] {
    for (const double u : knots.knots()) sum += multiplicity(knots, u);
  });
  if (sum < count) std::abort();
}

void points_interpolated(int count) {
  std::vector<glm::dvec3> points;
  std::vector<double> parameters;
  for (int i = 0; i < count; ++i) {
    points.emplace_back(std::cos(0.3 * i), std::sin(0.3 * i), 0.01 * i);
    parameters.push_back(i);
  }
  splinecore::InterpolationOptions options;
  options.degree = 5;
  counted_work([&] { interpolate(points, parameters, options); });
}

std::vector<splinecore::AnyPatch> row_of_patches(int count) {
  std::vector<splinecore::AnyPatch> row;
  for (int i = 0; i < count; ++i) {
    std::vector<glm::dvec4> net;
    for (int k = 0; k < 9; ++k) net.emplace_back(2 * i + k / 3, k % 3, (k * k) % 5 * (k / 3 % 2), 1);
    row.emplace_back(splinecore::BezierPatch::make(3, 3, net));
  }
  return row;
}

/// Points that are equal are found and shared.
void points_shared(int count) {
  const std::vector<splinecore::AnyPatch> row = row_of_patches(count);
  counted_work([&] { PatchSet::of(row, true); });
}

void panels(int count) {
  const PatchSet set = PatchSet::of(row_of_patches(count), true);
  counted_work([&] { panels_of(set); });
}

void mesh(int count) {
  const PatchSet set = PatchSet::of(row_of_patches(count), true);
  counted_work([&] { splinecore::Tessellation::make(set, 3, 3); });
}

}  // namespace

int main(int argc, char** argv) {
  const std::map<std::string, void (*)(int)> workloads = {
      {"remove knots", remove_knots}, {"insert knots", insert_knots}, {"to Beziers", to_beziers},
      {"pieces of gaps", pieces_of_gaps}, {"compatible knots", compatible_knots}, {"multiplicities", multiplicities},
      {"points interpolated", points_interpolated}, {"points shared", points_shared}, {"panels", panels}, {"mesh", mesh}};
  const auto found = argc == 3 ? workloads.find(argv[1]) : workloads.end();
  if (found == workloads.end()) {
    std::fprintf(stderr, "usage: growth WORKLOAD COUNT, a workload of:\n");
    for (const auto& [name, _] : workloads) std::fprintf(stderr, "  '%s'\n", name.c_str());
    return 2;
  }
  found->second(std::atoi(argv[2]));
}
