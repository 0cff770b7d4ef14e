#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "base/require.hpp"
#include "build/fit_options.hpp"
#include "curve/rescale.hpp"
#include "fairest.hpp"
#include "plate_net.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/fit/fair.hpp"
#include "splinecore/patch/distance.hpp"

namespace splinecore {

namespace {

void require_patch(const NurbsPatch& patch) {
  if (patch.knot_vector(Axis::u).degree() < 2 && patch.knot_vector(Axis::v).degree() < 2) {
    throw InvalidShape("a patch of degree 1 in both directions has nothing to be faired: it is straight between knots");
  }
  const bool is_positive = patch.points().front().w > 0.0;
  for (const glm::dvec4& point : patch.points()) {
    if (is_positive ? point.w > 0.0 : point.w < 0.0) continue;
    throw InvalidShape("weights of both signs, or zero: a patch that may run to infinity cannot be faired");
  }
}

int exponent_of(const NurbsPatch& patch) {
  double largest = 0.0;
  for (const glm::dvec4& point : patch.points()) {
    for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(point[c]));
  }
  return largest > 0.0 ? std::ilogb(largest) : 0;
}

/// The points without weights around one of them, of coordinates near 1 or less.
std::vector<glm::dvec3> net_of(const NurbsPatch& patch, int exponent) {
  std::vector<glm::dvec3> net;
  for (const glm::dvec4& point : patch.points()) {
    net.emplace_back(std::ldexp(point.x, -exponent), std::ldexp(point.y, -exponent), std::ldexp(point.z, -exponent));
  }
  const glm::dvec3 origin = net.front();
  for (glm::dvec3& point : net) point -= origin;
  return net;
}

/// How long the net is along a direction, in the mean.
double length_along(const NurbsPatch& patch, std::span<const glm::dvec3> net, Axis axis) {
  const auto count_u = static_cast<std::size_t>(patch.count(Axis::u));
  const auto count_v = static_cast<std::size_t>(patch.count(Axis::v));
  const auto along = axis == Axis::u ? count_u : count_v;
  const auto across = net.size() / along;
  const std::size_t steps = patch.knot_vector(axis).periodic() ? along : along - 1;
  double sum = 0.0;
  for (std::size_t j = 0; j < across; ++j) {
    const auto at = [&](std::size_t i) { return axis == Axis::u ? net[i * count_v + j] : net[j * count_v + i]; };
    for (std::size_t i = 0; i < steps; ++i) sum += glm::distance(at(i), at((i + 1) % along));
  }
  return sum / static_cast<double>(across);
}

/// The plate's length and width: the larger is 1.
glm::dvec2 sizes_of(const NurbsPatch& patch, std::span<const glm::dvec3> net) {
  constexpr double kNarrowest = 0x1p-10;
  const double u = length_along(patch, net, Axis::u);
  const double v = length_along(patch, net, Axis::v);
  const double most = std::max(u, v);
  if (!(most > 0.0)) return {1.0, 1.0};
  return {std::max(u / most, kNarrowest), std::max(v / most, kNarrowest)};
}

PlateAxis axis_of(const NurbsPatch& patch, Axis axis, double length, KeptEnds ends) {
  const KnotVector& knots = patch.knot_vector(axis);
  return {near_one(knots).knots, length, held_of(knots, ends)};
}

NurbsPatch moved(const NurbsPatch& patch, std::span<const glm::dvec3> moves, int exponent) {
  std::vector<glm::dvec4> points(patch.points().begin(), patch.points().end());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int c = 0; c < 3; ++c) points[i][c] += std::ldexp(moves[i][c], exponent);
  }
  return patch.with_points(std::move(points));
}

}  // namespace

Approximation<NurbsPatch> fair(const NurbsPatch& patch, double tolerance, KeptEnds u, KeptEnds v) {
  require_positive(tolerance);
  require_patch(patch);
  const int exponent = exponent_of(patch);
  std::vector<glm::dvec3> net = net_of(patch, exponent);
  const glm::dvec2 size = sizes_of(patch, net);
  const PlateNet plate(axis_of(patch, Axis::u, size.x, u), axis_of(patch, Axis::v, size.y, v), std::move(net));
  if (!plate.is_free()) return {patch, 0.0};
  auto best = fairest(patch, tolerance, [&](double power) -> std::optional<Approximation<NurbsPatch>> {
    const auto moves = plate.moves(std::exp2(power));
    if (!moves) return {};
    NurbsPatch made = moved(patch, *moves, exponent);
    const double error = largest_distance(patch, made);
    return Approximation<NurbsPatch>{std::move(made), error};
  });
  if (best) return *std::move(best);
  throw InvalidShape("the patch cannot be faired as far as numbers can tell: its degrees are too high, or "
                     "knots lie too near each other");
}

}  // namespace splinecore
