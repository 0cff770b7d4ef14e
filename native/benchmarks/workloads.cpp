#include "workloads.hpp"

#include <cmath>
#include <cstdint>

namespace benchmarks {

namespace {

/// `count` numbers of [0, 1) from splitmix64 (Steele, Lea, Flood 2014), reproducible in any language.
Numbers random_numbers(std::uint64_t seed, std::size_t count) {
  Numbers numbers;
  numbers.reserve(count);
  std::uint64_t state = seed << 32;
  for (std::size_t i = 0; i < count; ++i) {
    std::uint64_t z = state += 0x9E3779B97F4A7C15U;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    numbers.push_back(static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53);
  }
  return numbers;
}

/// Clamped knots on [0, 1] whose spans are from 0.5 to 1.5 of the mean.
splinecore::KnotVector uneven_knots(std::uint64_t seed, int count) {
  constexpr int kDegree = 3;
  Numbers inner{0.0};
  for (const double gap : random_numbers(seed, count - kDegree)) inner.push_back(inner.back() + 0.5 + gap);
  Numbers knots(kDegree, 0.0);
  for (const double u : inner) knots.push_back(u / inner.back());
  knots.insert(knots.end(), kDegree, 1.0);
  return splinecore::KnotVector::make(kDegree, knots);
}

}  // namespace

splinecore::NurbsCurve helix() {
  constexpr int kCount = 64;
  const Numbers noise = random_numbers(2, 3 * kCount);
  const Numbers weights = random_numbers(3, kCount);
  std::vector<glm::dvec4> points;
  for (int i = 0; i < kCount; ++i) {
    const double t = i / (kCount - 1.0);
    const auto shift = [&](int axis) { return 0.1 * (noise[3 * i + axis] - 0.5); };
    points.emplace_back(std::cos(12 * t) + shift(0), std::sin(12 * t) + shift(1), 2 * t + shift(2),
                        0.5 + 1.5 * weights[i]);
  }
  return splinecore::NurbsCurve::make(uneven_knots(1, kCount), points);
}

splinecore::NurbsPatch sheet() {
  constexpr int kCount = 32;
  const Numbers noise = random_numbers(7, 3 * kCount * kCount);
  const Numbers weights = random_numbers(8, kCount * kCount);
  std::vector<glm::dvec4> points;
  for (int k = 0; k < kCount * kCount; ++k) {
    const double x = k / kCount / (kCount - 1.0);
    const double y = k % kCount / (kCount - 1.0);
    const double step = 0.3 / (kCount - 1.0);
    points.emplace_back(x + step * (noise[3 * k] - 0.5), y + step * (noise[3 * k + 1] - 0.5),
                        0.2 * std::sin(9 * x) * std::cos(7 * y) + 0.02 * (noise[3 * k + 2] - 0.5),
                        0.5 + 1.5 * weights[k]);
  }
  return splinecore::NurbsPatch::make(uneven_knots(5, kCount), uneven_knots(6, kCount), points);
}

Numbers random_parameters(std::size_t count) { return random_numbers(4, count); }

Numbers even_parameters(std::size_t count) {
  Numbers parameters(count);
  for (std::size_t i = 0; i < count; ++i) parameters[i] = static_cast<double>(i) / static_cast<double>(count - 1);
  return parameters;
}

}  // namespace benchmarks
