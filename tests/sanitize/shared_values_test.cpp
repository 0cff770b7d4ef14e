// Many threads read one value at the same time. It says most where the thread sanitizer watches.

#include <barrier>
#include <numbers>
#include <thread>

#include "../native/support.hpp"
#include "splinecore/build/primitives.hpp"
#include "splinecore/exchange/json.hpp"
#include "splinecore/formula/taylor.hpp"
#include "splinecore/measure/area.hpp"
#include "splinecore/measure/length.hpp"
#include "splinecore/tessellate/polyline.hpp"
#include "splinecore/tessellate/tessellation.hpp"

namespace splinecore {
namespace {

using namespace testing;

constexpr int kThreads = 4;

/// What every thread reads at once, three times each; all must read what one reads alone afterwards. `make` gives
/// a value that nobody has read yet, so that what is built at the first reading is built under many eyes.
template <class Make, class Read>
void expect_equal_readings(Make make, Read read) {
  for (int round = 0; round < 5; ++round) {
    const auto value = make(round);
    std::vector<decltype(read(value))> found(kThreads);
    std::barrier gate(kThreads);
    std::vector<std::jthread> threads;
    for (int i = 0; i < kThreads; ++i) {
      threads.emplace_back([&, i] {
        gate.arrive_and_wait();
        for (int times = 0; times < 3; ++times) found[i] = read(value);
      });
    }
    threads.clear();
    for (const auto& one : found) EXPECT_EQ(one, read(value)) << "round " << round;
  }
}

NurbsCurve curve_of(int seed) {
  Random random(seed);
  return random_curve(random, {3, 40, Ends::unclamped, Weights::positive});
}

PatchSet set_of(int seed) {
  Random random(seed);
  const std::vector<AnyPatch> patches{torus({0, 0, 0}, {0, 0, 1}, 3.0, 1.0 + 0.1 * seed),
                                      random_patch(random, {3, 3, Ends::clamped, Weights::positive},
                                                   {2, 2, Ends::clamped, Weights::positive})};
  return PatchSet::of(patches, true);
}

std::vector<float> mesh_of(const Tessellation& mesh, const PatchSet& set) {
  std::vector<float> positions(3 * mesh.vertex_count());
  std::vector<float> normals(3 * mesh.corner_vertices().size());
  mesh.evaluate(set, positions, normals);
  positions.insert(positions.end(), normals.begin(), normals.end());
  return positions;
}

TEST(SharedValues, CurvesAreEvaluated) {
  expect_equal_readings(curve_of, [](const NurbsCurve& curve) {
    Random random(1);
    const std::vector<double> u = random_parameters(random, curve.domain(), 60);
    std::vector<double> out(3 * 3 * u.size());
    derivatives(curve, u, 2, out);
    out.push_back(length(curve).value);
    return out;
  });
}

TEST(SharedValues, CurvesOfOneKnotVectorAreEvaluated) {
  expect_equal_readings(
      [](int seed) {
        const NurbsCurve one = curve_of(seed);
        return std::array{one, one.with_points({one.points().rbegin(), one.points().rend()})};
      },
      [](const std::array<NurbsCurve, 2>& pair) {
        std::vector<Polyline> lines = polylines(pair[0], 8);
        for (Polyline& line : polylines(pair[1], 8)) lines.push_back(std::move(line));
        std::vector<double> all;
        for (const Polyline& line : lines) all.insert(all.end(), line.points.begin(), line.points.end());
        return all;
      });
}

TEST(SharedValues, SetsAreTessellated) {
  expect_equal_readings(set_of, [](const PatchSet& set) {
    std::vector<float> all = mesh_of(Tessellation::make(set, 5, 7), set);
    const std::vector<float> fine = mesh_of(Tessellation::adaptive(set, {0.1, std::numbers::pi}), set);
    all.insert(all.end(), fine.begin(), fine.end());
    return all;
  });
}

TEST(SharedValues, BatchesRunOnSeveralThreads) {
  expect_equal_readings(set_of, [](const PatchSet& set) {
    std::vector<double> u(40);
    for (std::size_t i = 0; i < u.size(); ++i) u[i] = static_cast<double>(i) / static_cast<double>(u.size());
    const PatchOptions options{Side::right, Side::right, AtInfinity::nan, 3};
    const NurbsPatch patch = nurbs_of(set.patch(0));
    std::vector<double> pairs(9 * u.size());
    first_derivatives(patch, u, u, pairs, options);
    std::vector<double> points(3 * u.size() * u.size());
    std::vector<double> normals(points.size());
    evaluate_grid_with_normals(patch, u, u, points, normals, options);
    std::vector<float> all = mesh_of(Tessellation::adaptive(set, {0.1, std::numbers::pi}, 3), set);
    for (const auto& some : {pairs, points, normals}) all.insert(all.end(), some.begin(), some.end());
    return all;
  });
}

TEST(SharedValues, OneTopologyIsEvaluated) {
  const Tessellation mesh = Tessellation::make(set_of(0), 6, 6);
  expect_equal_readings(set_of, [&](const PatchSet& set) {
    return mesh.fits(set) ? mesh_of(mesh, set) : std::vector<float>{};
  });
}

TEST(SharedValues, SetsAreMeasuredAndWritten) {
  expect_equal_readings(set_of, [](const PatchSet& set) {
    const Document document = Value(set);
    const std::string text = to_json(document);
    EXPECT_TRUE(from_json(text) == document);
    return text + text_of(area(set, 1e-3).value);
  });
}

TEST(SharedValues, FormulasAreEvaluated) {
  expect_equal_readings([](int seed) { return Formula::make("sin(t)^3 + " + std::to_string(seed) + " * t", {"t"}); },
                        [](const Formula& formula) {
                          const std::array t{0.0, 0.5, 1.0, 2.0};
                          std::vector<double> out(4 * t.size());
                          derivatives(formula, t, 3, out);
                          return out;
                        });
}

}  // namespace
}  // namespace splinecore
