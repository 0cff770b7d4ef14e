#include "splinecore/build/parameterization.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/length.hpp"
#include "base/require.hpp"
#include "kernels/kernels.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

/// Distances from each point to the next one.
void write_chords(std::span<const glm::dvec3> points, std::span<double> out) {
  constexpr std::size_t kFewest = 4;
  if (out.size() >= kFewest &&
      kernels().chords(&points.front().x, out.size(), kLeastSquare, kMostSquare, out.data())) {
    return;
  }
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = distance_of(points[i], points[i + 1]);
}

/// Steps of the parameter from distances.
void make_steps(std::span<double> chords, Parameterization kind) {
  if (kind == Parameterization::uniform) std::ranges::fill(chords, 1.0);
  if (kind != Parameterization::centripetal) return;
  for (double& chord : chords) chord = std::sqrt(chord);
}

[[noreturn]] void refuse_step(std::span<const glm::dvec3> points, const std::vector<double>& parameters) {
  require_finite(points, "points");
  std::size_t i = 1;
  while (parameters[i] > parameters[i - 1] && std::isfinite(parameters[i])) ++i;
  const std::string place = "points" + index_text(i % points.size());
  const std::string before = " points" + index_text(i - 1);
  if (!std::isfinite(parameters[i])) throw InvalidShape(place + " is too far from" + before + ": their distance overflows");
  throw InvalidShape(place + " is too close to" + before + ": they coincide within rounding and get equal parameters");
}

}  // namespace

std::vector<double> parameters_of(std::span<const glm::dvec3> points, Parameterization kind, Closing closing) {
  if (kind == Parameterization::uniform || points.size() == 1) require_finite(points, "points");
  if (points.empty()) return {};
  const std::size_t inner = points.size() - 1;
  const std::size_t count = points.size() + (closing == Closing::closed ? 1 : 0);
  std::vector<double> parameters(count);
  constexpr std::size_t kTogether = 64;
  std::array<double, kTogether> chords;
  for (std::size_t first = 0; first + 1 < count; first += kTogether) {
    const std::span<double> steps(chords.data(), std::min(kTogether, count - 1 - first));
    const std::size_t open = std::min(steps.size(), inner - std::min(first, inner));
    if (kind != Parameterization::uniform) write_chords(points.subspan(first), steps.first(open));
    if (open < steps.size()) steps.back() = distance_of(points.back(), points.front());
    make_steps(steps, kind);
    for (std::size_t i = 0; i < steps.size(); ++i) parameters[first + i + 1] = parameters[first + i] + steps[i];
  }
  const bool are_steps = kernels().are_increasing(parameters.data(), count) && std::isfinite(parameters.back());
  if (!are_steps) refuse_step(points, parameters);
  return parameters;
}

}  // namespace splinecore
