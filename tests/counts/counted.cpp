// Small workloads whose instructions are counted: counted WORKLOAD. Only what runs inside of counted_work() counts.
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "counted_work.hpp"
#include "splinecore/build/parameterization.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/fit/interpolate.hpp"
#include "splinecore/meet/nearest.hpp"
#include "splinecore/patch/evaluate_set.hpp"
#include "splinecore/tessellate/tessellation.hpp"

namespace {

using splinecore::KnotVector;

constexpr int kDegree = 3;

/// Clamped on [0, 1], no two spans next to each other of one length.
KnotVector uneven_knots(int count) {
  std::vector<double> knots(kDegree, 0.0);
  const int spans = count - kDegree;
  for (int i = 0; i <= spans; ++i) knots.push_back((i + (0 < i && i < spans ? 0.3 * std::sin(i) : 0.0)) / spans);
  knots.insert(knots.end(), kDegree, 1.0);
  return KnotVector::make(kDegree, knots);
}

std::vector<double> even_parameters(int count) {
  std::vector<double> parameters(count);
  for (int i = 0; i < count; ++i) parameters[i] = static_cast<double>(i) / (count - 1);
  return parameters;
}

splinecore::NurbsPatch sheet(int count) {
  std::vector<glm::dvec4> points;
  for (int k = 0; k < count * count; ++k) {
    const double x = static_cast<double>(k / count) / (count - 1);
    const double y = static_cast<double>(k % count) / (count - 1);
    points.emplace_back(x, y, 0.2 * std::sin(9 * x) * std::cos(7 * y), 1.25 + 0.75 * std::sin(k));
  }
  return splinecore::NurbsPatch::make(uneven_knots(count), uneven_knots(count), points);
}

splinecore::NurbsCurve coil() {
  constexpr int kCount = 64;
  std::vector<glm::dvec4> points;
  for (int i = 0; i < kCount; ++i) {
    const double t = i / (kCount - 1.0);
    points.emplace_back(std::cos(12 * t), std::sin(12 * t), 2 * t, 1.25 + 0.75 * std::sin(i));
  }
  return splinecore::NurbsCurve::make(uneven_knots(kCount), points);
}

void points_at(const std::vector<double>& parameters) {
  const splinecore::NurbsCurve curve = coil();
  std::vector<double> out(3 * parameters.size());
  counted_work([&] { evaluate(curve, parameters, std::span(out)); });
}

void curve_points() { points_at(even_parameters(10'000)); }

/// Numbers in an order that has none.
std::vector<double> scattered(std::vector<double> numbers) {
  std::vector<double> found;
  for (std::size_t i = 0; i < numbers.size(); ++i) found.push_back(numbers[(i * 7919) % numbers.size()]);
  return found;
}

void scattered_points() { points_at(scattered(even_parameters(10'000))); }

void pairs() {
  const splinecore::NurbsPatch patch = sheet(32);
  const std::vector<double> u = scattered(even_parameters(10'000));
  const std::vector<double> v(u.rbegin(), u.rend());
  std::vector<double> out(3 * u.size());
  counted_work([&] { evaluate(patch, u, v, std::span(out)); });
}

void interpolation() {
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 10'000; ++i) points.emplace_back(std::cos(0.3 * i), std::sin(0.3 * i), 0.01 * i);
  const splinecore::InterpolationOptions options{.ends = splinecore::FitEnds::not_a_knot};
  counted_work([&] {
    interpolate(points, parameters_of(points, splinecore::Parameterization::chordal), options);
  });
}

void nearest_points() {
  const splinecore::NurbsCurve curve = coil();
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 1000; ++i) points.emplace_back(1.2 * std::sin(i), 1.2 * std::cos(3 * i), 1 + 1.2 * std::sin(7 * i));
  std::vector<splinecore::NearestOnCurve> found(points.size());
  counted_work([&] { nearest(curve, points, found, 1); });
}

/// A grid of which one side has many more parameters than the other.
void long_grid(int rows, int columns) {
  const splinecore::NurbsPatch patch = sheet(6);
  const std::vector<double> u = even_parameters(rows);
  const std::vector<double> v = even_parameters(columns);
  std::vector<double> out(3 * u.size() * v.size());
  counted_work([&] { evaluate_grid(patch, u, v, std::span(out)); });
}

void wide_grid() { long_grid(30, 4000); }

void tall_grid() { long_grid(4000, 30); }

void grid_points() {
  const splinecore::NurbsPatch patch = sheet(32);
  const std::vector<double> line = even_parameters(128);
  std::vector<double> out(3 * line.size() * line.size());
  counted_work([&] { evaluate_grid(patch, line, line, std::span(out)); });
}

/// A bicubic petal whose start along u is one point.
splinecore::BezierPatch petal(double turn) {
  std::vector<glm::dvec4> points;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const double angle = turn + 0.25 * j;
      points.emplace_back(i * std::cos(angle), i * std::sin(angle), std::sin(i + turn), 1.0);
    }
  }
  for (int j = 1; j < 4; ++j) points[j] = points[0];
  return splinecore::BezierPatch::make(4, 4, points);
}

void normals() {
  std::vector<splinecore::AnyPatch> patches;
  for (int i = 0; i < 8; ++i) patches.emplace_back(petal(0.75 * i));
  const auto set = splinecore::PatchSet::of(patches, true);
  const std::vector<double> line = even_parameters(32);
  std::vector<double> points(3 * patches.size() * line.size() * line.size());
  std::vector<double> found(points.size());
  counted_work([&] { evaluate_grid_with_normals(set, line, line, std::span(points), std::span(found)); });
}

void adaptive_mesh() {
  const std::vector<splinecore::AnyPatch> patches{sheet(6)};
  const auto set = splinecore::PatchSet::of(patches, true);
  std::vector<float> positions;
  counted_work([&] {
    const auto mesh = splinecore::Tessellation::adaptive(set, {.distance = 1e-3, .angle = HUGE_VAL});
    positions.resize(3 * mesh.vertex_count());
    mesh.evaluate_positions(set, positions);
  });
}

}  // namespace

int main(int argc, char** argv) {
  const std::map<std::string, void (*)()> workloads = {
      {"curve points", curve_points}, {"scattered points", scattered_points}, {"pairs", pairs}, {"grid points", grid_points}, {"normals", normals},
      {"adaptive mesh", adaptive_mesh}, {"wide grid", wide_grid}, {"tall grid", tall_grid},
      {"interpolation", interpolation}, {"nearest points", nearest_points}};
  const auto found = argc == 2 ? workloads.find(argv[1]) : workloads.end();
  if (found == workloads.end()) {
    std::fprintf(stderr, "usage: counted WORKLOAD, one of:\n");
    for (const auto& [name, _] : workloads) std::fprintf(stderr, "  '%s'\n", name.c_str());
    return 2;
  }
  found->second();
}
