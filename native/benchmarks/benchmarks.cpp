#include <benchmark/benchmark.h>

#include <algorithm>
#include <functional>

#include "rival.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/patch/evaluate.hpp"
#include "table.hpp"
#include "workloads.hpp"

namespace {

using benchmarks::Numbers;

constexpr std::size_t kCurveItems = 1'000'000;
constexpr std::size_t kGrid = 1000;

void add(const std::string& name, std::size_t items, std::function<void()> work) {
  benchmark::RegisterBenchmark(name.c_str(), [items, work](benchmark::State& state) {
    for (auto _ : state) work();
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * items));
  })->Repetitions(5)->MinTime(0.1)->Unit(benchmark::kMillisecond);
}

struct CurveWork {
  splinecore::NurbsCurve curve = benchmarks::helix();
  benchmarks::RivalCurve rival{curve};
  Numbers random = benchmarks::random_parameters(kCurveItems);
  Numbers sorted = random;
  Numbers out = Numbers(3 * kCurveItems);
};

struct GridWork {
  splinecore::NurbsPatch patch = benchmarks::sheet();
  benchmarks::RivalSurface rival{patch};
  Numbers line = benchmarks::even_parameters(kGrid);
  Numbers points = Numbers(9 * kGrid * kGrid);
  Numbers normals = Numbers(3 * kGrid * kGrid);
};

void add_curve_workloads(CurveWork& work) {
  std::ranges::sort(work.sorted);
  add("W1 curve, sorted/splinecore", kCurveItems, [&] { evaluate(work.curve, work.sorted, std::span(work.out)); });
  add("W1 curve, sorted/SISL", kCurveItems, [&] { work.rival.evaluate_batch(work.sorted, work.out); });
  add("W1 curve, random/splinecore", kCurveItems, [&] { evaluate(work.curve, work.random, std::span(work.out)); });
  add("W1 curve, random/SISL", kCurveItems, [&] { work.rival.evaluate_each(work.random, work.out); });
}

void add_grid_workloads(GridWork& work) {
  constexpr std::size_t kItems = kGrid * kGrid;
  add("W3 grid, points/splinecore", kItems, [&] {
    evaluate_grid(work.patch, work.line, work.line, std::span(work.points).first(3 * kItems));
  });
  add("W3 grid, points/SISL", kItems, [&] { work.rival.evaluate_grid(work.line, work.line, work.points); });
  add("W3 grid, normals/splinecore", kItems, [&] {
    evaluate_grid_with_normals(work.patch, work.line, work.line, std::span(work.points).first(3 * kItems),
                               std::span(work.normals));
  });
  add("W3 grid, normals/SISL", kItems, [&] {
    work.rival.evaluate_grid_with_normals(work.line, work.line, work.points, work.normals);
  });
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  CurveWork curve;
  GridWork grid;
  add_curve_workloads(curve);
  add_grid_workloads(grid);
  benchmarks::RatioTable table;
  benchmark::RunSpecifiedBenchmarks(&table);
}
