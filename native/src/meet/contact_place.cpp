#include "contact_place.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>
#include <vector>

#include "base/rounding.hpp"

namespace splinecore {

namespace {

/// Coefficients of Chebyshev polynomials on [-1, 1].
using ChebyshevSeries = std::vector<glm::dvec3>;

/// A series without the last coefficients, which are nothing but rounding, and how large these are.
struct ChoppedSeries {
  ChebyshevSeries series;
  double rounding;
};

ChoppedSeries chopped(ChebyshevSeries series) {
  constexpr std::size_t kTail = 16;
  constexpr double kAbove = 4.0;
  double rounding = 0.0;
  for (std::size_t k = series.size() - kTail; k < series.size(); ++k) {
    rounding = std::max(rounding, glm::length(series[k]));
  }
  while (series.size() > 1 && glm::length(series.back()) <= kAbove * rounding) series.pop_back();
  return {std::move(series), rounding};
}

ChoppedSeries fit_of(const Interval& along, const std::function<glm::dvec3(double)>& gap) {
  constexpr std::size_t kCount = 33;
  constexpr std::size_t kLast = kCount - 1;
  const auto cosine = [](std::size_t i) {
    return std::cos(std::numbers::pi * static_cast<double>(i % (2 * kLast)) / static_cast<double>(kLast));
  };
  std::array<glm::dvec3, kCount> values;
  for (std::size_t i = 0; i < kCount; ++i) {
    values[i] = gap(along.middle() + 0.5 * along.length() * cosine(i));
    if (i == 0 || i == kLast) values[i] *= 0.5;
  }
  ChebyshevSeries series(kCount, glm::dvec3(0.0));
  for (std::size_t k = 0; k < kCount; ++k) {
    for (std::size_t i = 0; i < kCount; ++i) series[k] += cosine(i * k) * values[i];
    series[k] *= (k == 0 || k == kLast ? 1.0 : 2.0) / static_cast<double>(kLast);
  }
  return chopped(std::move(series));
}

ChebyshevSeries derivative(const ChebyshevSeries& series) {
  const std::size_t count = series.size();
  ChebyshevSeries of(std::max<std::size_t>(count, 2) - 1, glm::dvec3(0.0));
  for (std::size_t k = count - 1; k-- > 0;) {
    of[k] = 2.0 * static_cast<double>(k + 1) * series[k + 1];
    if (k + 2 < of.size()) of[k] += of[k + 2];
  }
  of[0] *= 0.5;
  return of;
}

glm::dvec3 value_at(const ChebyshevSeries& series, double x) {
  glm::dvec3 next(0.0);
  glm::dvec3 after(0.0);
  for (std::size_t k = series.size() - 1; k > 0; --k) {
    const glm::dvec3 now = series[k] + 2.0 * x * next - after;
    after = next;
    next = now;
  }
  return series[0] + x * next - after;
}

/// The series, and its derivatives, each divided by its factorial: Taylor's coefficients about a place.
std::vector<ChebyshevSeries> taylor_of(const ChebyshevSeries& series) {
  std::vector<ChebyshevSeries> taylor{series};
  while (taylor.back().size() > 1) {
    ChebyshevSeries next = derivative(taylor.back());
    for (glm::dvec3& c : next) c /= static_cast<double>(taylor.size());
    taylor.push_back(std::move(next));
  }
  return taylor;
}

/// Where a coefficient is least, by Newton's method from the middle; none beyond the interval by much.
std::optional<double> least_of(const std::vector<ChebyshevSeries>& taylor, std::size_t k) {
  constexpr int kRounds = 20;
  constexpr double kBeyond = 1.25;
  double x = 0.0;
  for (int round = 0; round < kRounds; ++round) {
    const glm::dvec3 slope = static_cast<double>(k + 1) * value_at(taylor[k + 1], x);
    const double square = glm::dot(slope, slope);
    if (!(square > 0.0)) return {};
    const double step = glm::dot(value_at(taylor[k], x), slope) / square;
    x -= step;
    if (!(std::abs(x) <= kBeyond)) return {};
    if (std::abs(step) <= 0x1p-50) break;
  }
  return x;
}

/// Whether about a place a power is most of a function as far as the interval goes: those below it are hardly there.
bool is_power(const std::vector<ChebyshevSeries>& taylor, std::size_t power, double x) {
  constexpr double kBelow = 0.125;
  constexpr double kAbove = 2.0;
  const double most = glm::length(value_at(taylor[power], x));
  for (std::size_t k = 0; k < taylor.size(); ++k) {
    if (k == power) continue;
    if (!(glm::length(value_at(taylor[k], x)) <= (k < power ? kBelow : kAbove) * most)) return false;
  }
  return true;
}

}  // namespace

std::optional<double> contact_place(const std::array<Interval, 2>& along,
                                    const std::function<glm::dvec3(double)>& gap) {
  constexpr double kAsSmooth = 4.0;
  const auto& [whole, part] = along;
  if (!(part.length() > 0.0)) return {};
  const ChoppedSeries of_whole = fit_of(whole, gap);
  const ChoppedSeries of_part = part.length() < whole.length() ? fit_of(part, gap) : of_whole;
  const bool is_smooth = of_whole.rounding <= std::max(kAsSmooth * of_part.rounding, kRoundingOfSum);
  const Interval& in = is_smooth ? whole : part;
  const std::vector<ChebyshevSeries> taylor = taylor_of((is_smooth ? of_whole : of_part).series);
  for (std::size_t power = 2; power < taylor.size(); ++power) {
    const std::optional<double> x = least_of(taylor, power - 1);
    if (x && is_power(taylor, power, *x)) return in.middle() + 0.5 * in.length() * *x;
  }
  return {};
}

}  // namespace splinecore
