// How often evaluation into memory of the caller allocates, on one thread and with all tables made. Every operator new of
// the process is counted, those of the library with it.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <new>
#include <vector>

#include "splinecore/curve/evaluate.hpp"
#include "splinecore/patch/evaluate_set.hpp"
#include "splinecore/tessellate/tessellation.hpp"

namespace {
std::atomic<long> allocations{0};

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  const std::size_t whole = (size + alignment - 1) / alignment * alignment;
  if (void* found = std::aligned_alloc(alignment, whole > 0 ? whole : alignment)) return found;
  throw std::bad_alloc();
}
}  // namespace

void* operator new(std::size_t size) { return counted(size, alignof(std::max_align_t)); }
void* operator new[](std::size_t size) { return counted(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t at) { return counted(size, static_cast<std::size_t>(at)); }
void* operator new[](std::size_t size, std::align_val_t at) { return counted(size, static_cast<std::size_t>(at)); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace splinecore {
namespace {

/// Of one call, once all tables are made.
long allocations_of(const std::function<void()>& call) {
  call();
  const long before = allocations;
  call();
  return allocations - before;
}

/// All over a domain, in order or not.
std::vector<double> parameters(const Interval& domain, std::size_t count, bool is_sorted) {
  std::vector<double> found(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t place = is_sorted ? i : (i * 7919) % count;
    const double part = static_cast<double>(place) / static_cast<double>(count - 1);
    found[i] = std::min(domain.start + domain.length() * part, domain.end);
  }
  return found;
}

std::vector<glm::dvec4> wavy_points(int count, bool is_rational) {
  std::vector<glm::dvec4> points;
  for (int i = 0; i < count; ++i) points.emplace_back(i, i % 3, i % 5, is_rational ? 1.0 + 0.5 * (i % 2) : 1.0);
  return points;
}

std::vector<NurbsCurve> curves() {
  std::vector<NurbsCurve> found;
  for (const bool is_rational : {false, true}) {
    for (const int degree : {1, 3, 9}) {
      found.push_back(NurbsCurve::make(KnotVector::clamped(degree, 20), wavy_points(20, is_rational)));
      found.push_back(NurbsCurve::make(KnotVector::uniform(degree, 20), wavy_points(20, is_rational)));
      found.push_back(NurbsCurve::make(KnotVector::periodic_uniform(degree, 20), wavy_points(20, is_rational)));
    }
  }
  return found;
}

/// Nets of 12 x 12 points, every second with a pole.
std::vector<NurbsPatch> patches() {
  std::vector<NurbsPatch> found;
  for (const bool is_rational : {false, true}) {
    for (const int degree : {1, 3, 5}) {
      for (const KnotVector& u : {KnotVector::clamped(degree, 12), KnotVector::periodic_uniform(degree, 12)}) {
        std::vector<glm::dvec4> net = wavy_points(144, is_rational);
        for (int i = 0; i < 144; ++i) net[i] = {i / 12, i % 12, (i * i) % 7, net[i].w};
        found.push_back(NurbsPatch::make(u, KnotVector::clamped(degree, 12), net));
        for (int i = 0; i < 12; ++i) net[12 * i] = {0, 0, 0, net[12 * i].w};
        found.push_back(NurbsPatch::make(u, KnotVector::clamped(degree, 12), net));
      }
    }
  }
  return found;
}

template <class Real>
void expect_none_of_curves() {
  for (const NurbsCurve& curve : curves()) {
    for (const bool is_sorted : {true, false}) {
      for (const std::size_t count : {2, 100, 20'000}) {
        const std::vector<double> u = parameters(curve.domain(), count, is_sorted);
        std::vector<Real> out(3 * count);
        EXPECT_EQ(allocations_of([&] { evaluate(curve, u, std::span<Real>(out), {.threads = 1}); }), 0);
      }
    }
  }
}

TEST(Allocations, OfPointsOfCurvesThereAreNone) {
  expect_none_of_curves<double>();
  expect_none_of_curves<float>();
}

TEST(Allocations, OfDerivativesOfCurvesThereAreNone) {
  for (const NurbsCurve& curve : curves()) {
    for (int order = 1; order <= 5; ++order) {
      for (const std::size_t count : {2, 5'000}) {
        const std::vector<double> u = parameters(curve.domain(), count, false);
        std::vector<double> out(3 * count * (order + 1));
        const long found = allocations_of([&] { derivatives(curve, u, order, out, {.threads = 1}); });
        EXPECT_EQ(found, 0) << curve.degree() << ", order " << order;
      }
    }
  }
}

TEST(Allocations, OfPairsOnPatchesThereAreNone) {
  constexpr PatchOptions kOne{.threads = 1};
  for (const NurbsPatch& patch : patches()) {
    for (const std::size_t count : {2, 64, 5'000}) {
      const std::vector<double> u = parameters(patch.knot_vector(Axis::u).domain(), count, false);
      const std::vector<double> v = parameters(patch.knot_vector(Axis::v).domain(), count, true);
      std::vector<double> out(3 * 16 * count), normals(3 * count);
      std::vector<float> single(3 * count);
      const std::span<double> points = std::span(out).first(3 * count);
      EXPECT_EQ(allocations_of([&] { evaluate(patch, u, v, points, kOne); }), 0);
      EXPECT_EQ(allocations_of([&] { evaluate(patch, u, v, std::span(single), kOne); }), 0);
      for (int order = 1; order <= 3; ++order) {
        const std::span<double> jets = std::span(out).first(3 * count * (order + 1) * (order + 1));
        EXPECT_EQ(allocations_of([&] { derivatives(patch, u, v, order, jets, kOne); }), 0) << order;
      }
      EXPECT_EQ(allocations_of([&] { evaluate_with_normals(patch, u, v, points, normals, kOne); }), 0);
    }
  }
}

/// Grids of several sizes: points, and with normals.
template <class Real, class Shape>
void expect_none_of_every_grid(const Shape& shape, const NurbsPatch& on, std::size_t patches) {
  constexpr PatchOptions kOne{.threads = 1};
  for (const std::size_t rows : {20, 200}) {
    for (const std::size_t columns : {20, 200}) {
      const std::vector<double> u = parameters(on.knot_vector(Axis::u).domain(), rows, true);
      const std::vector<double> v = parameters(on.knot_vector(Axis::v).domain(), columns, true);
      std::vector<Real> out(3 * patches * rows * columns), to_normals(out.size());
      EXPECT_EQ(allocations_of([&] { evaluate_grid(shape, u, v, std::span<Real>(out), kOne); }), 0);
      const auto with_normals = [&] {
        evaluate_grid_with_normals(shape, u, v, std::span<Real>(out), std::span<Real>(to_normals), kOne);
      };
      EXPECT_EQ(allocations_of(with_normals), 0);
    }
  }
}

TEST(Allocations, OfAGridThereAreNone) {
  for (const NurbsPatch& patch : patches()) {
    expect_none_of_every_grid<double>(patch, patch, 1);
    expect_none_of_every_grid<float>(patch, patch, 1);
  }
}

TEST(Allocations, OfASetThereAreNone) {
  for (const NurbsPatch& patch : patches()) {
    for (const std::size_t count : {1, 5, 20}) {
      const PatchSet set = PatchSet::of(std::vector<AnyPatch>(count, patch), false);
      expect_none_of_every_grid<double>(set, patch, count);
    }
  }
}

TEST(Allocations, OfASetOfPatchesOnTwoKnotVectorsInTurnThereAreNone) {
  const std::vector<NurbsPatch> all = patches();
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::vector<AnyPatch> mixed;
    const NurbsPatch refined = insert_knot(all[i], Axis::u, 0.75);
    for (int k = 0; k < 10; ++k) mixed.emplace_back(k % 2 == 0 ? all[i] : refined);
    expect_none_of_every_grid<double>(PatchSet::of(mixed, false), all[i], mixed.size());
  }
}

/// So many patches in a row, neighbors on the same points along an edge.
PatchSet row_of_patches(int count) {
  std::vector<AnyPatch> row;
  for (int i = 0; i < count; ++i) {
    std::vector<glm::dvec4> net;
    for (int k = 0; k < 9; ++k) net.emplace_back(2 * i + k / 3, k % 3, (k * k) % 5 * (k / 3 % 2), 1);
    row.emplace_back(BezierPatch::make(3, 3, net));
  }
  return PatchSet::of(row, true);
}

// To tell which sides are one edge takes several allocations for every patch.
TEST(Allocations, OfALocalMoveAreFewAsPanelsAreNotFoundAgain) {
  for (const int count : {20, 200}) {
    const PatchSet before = row_of_patches(count);
    std::vector<glm::dvec4> points(before.points().begin(), before.points().end());
    points[points.size() / 2].z += 0.25;
    const PatchSet after = before.with_points(points);
    for (const Tessellation& mesh : {Tessellation::make(before, 4, 4), Tessellation::adaptive(before, {0.01, HUGE_VAL})}) {
      bool fits = false;
      EXPECT_GT(allocations_of([&] { fits = mesh.fits(after); }), 8 * count);
      EXPECT_EQ(allocations_of([&] { fits = mesh.still_fits(after, before); }), 0);
      EXPECT_TRUE(fits);
      std::vector<float> positions(3 * mesh.vertex_count());
      EXPECT_LT(allocations_of([&] { mesh.update_positions(after, before, positions); }), 100);
    }
  }
}

}  // namespace
}  // namespace splinecore
