#include "splinecore/convert/to_hermite.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <span>
#include <string>

#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/patch/evaluate.hpp"

namespace splinecore {

namespace {

void require_cubic(const KnotVector& knots, std::span<const glm::dvec4> points) {
  if (knots.degree() > 3) {
    throw InvalidShape("degree = " + std::to_string(knots.degree()) + ": a Hermite shape is cubic at most");
  }
  const auto differs = [&](const glm::dvec4& p) { return p.w != points.front().w; };
  const auto other = std::ranges::find_if(points, differs);
  if (other != points.end()) {
    throw InvalidShape("weights" + index_text(other - points.begin()) + " = " + text_of(other->w) +
                       " differs from weights[0]: a Hermite shape is not rational");
  }
}

/// Where the spans begin, and where the last one ends.
std::vector<double> breaks(const KnotVector& knots) {
  std::vector<double> parameters;
  for (const int k : knots.spans()) parameters.push_back(knots.unrolled()[k]);
  parameters.push_back(knots.domain().end);
  return parameters;
}

using CurveEnd = std::array<glm::dvec3, 2>;  // C, C'

CurveEnd end_at(const NurbsCurve& curve, double u, Side side) {
  CurveEnd end;
  derivatives(curve, {&u, 1}, 1, {&end[0].x, 6}, {.side = side});
  return end;
}

using Corner = std::array<glm::dvec3, 4>;  // S, S_v, S_u, S_uv

Corner corner_at(const NurbsPatch& patch, double u, double v, PatchOptions options = {}) {
  Corner corner;
  derivatives(patch, {&u, 1}, {&v, 1}, 1, {&corner[0].x, 12}, options);
  return corner;
}

/// The sides from which first derivatives may differ at a knot.
std::span<const Side> sides_of(const KnotVector& knots, double u) {
  static constexpr std::array kBoth{Side::right, Side::left};
  return std::span(kBoth).first(multiplicity(knots, u) < knots.degree() ? 1 : 2);
}

/// @throws InvalidShape if a value differs from one side to another by more than rounding does
///         where the spans around the corner are that long.
void require_smooth(const NurbsPatch& patch, double u, double v, const Corner& corner, double length_u,
                    double length_v) {
  constexpr double kRounding = 1e-13;
  const double noise = kRounding * largest_coordinate(patch.points());
  const double noises[4] = {noise, noise / length_v, noise / length_u, noise / (length_u * length_v)};
  for (const Side side_u : sides_of(patch.knot_vector(Axis::u), u)) {
    for (const Side side_v : sides_of(patch.knot_vector(Axis::v), v)) {
      const Corner other = corner_at(patch, u, v, {side_u, side_v});
      for (int k = 0; k < 4; ++k) {
        if (glm::distance(corner[k], other[k]) <= noises[k]) continue;
        throw InvalidShape("the patch is not C1 at u = " + text_of(u) + ", v = " + text_of(v) +
                           ": a Hermite corner has one tangent in each direction");
      }
    }
  }
}

/// The shorter one of the steps around a break; the first and the last one follow each other.
double shorter_step(const std::vector<double>& breaks, std::size_t i) {
  const std::size_t last = breaks.size() - 1;
  const std::size_t after = i == last ? 1 : i + 1;
  const std::size_t before = i == 0 ? last : i;
  return std::min(breaks[after] - breaks[after - 1], breaks[before] - breaks[before - 1]);
}

}  // namespace

HermiteCurve to_hermite(const NurbsCurve& curve) {
  require_cubic(curve.knot_vector(), curve.points());
  std::vector<double> parameters = breaks(curve.knot_vector());
  std::vector<glm::dvec3> points;
  std::vector<Tangents> tangents;
  for (const double u : parameters) {
    const CurveEnd before = end_at(curve, u, Side::left);
    const CurveEnd after = end_at(curve, u, Side::right);
    if (before[0] != after[0] && multiplicity(curve.knot_vector(), u) > curve.degree()) {
      throw InvalidShape("the curve has a gap at u = " + text_of(u) + ": a Hermite chain is connected");
    }
    points.push_back(after[0]);
    tangents.push_back({before[1], after[1]});
  }
  return HermiteCurve::make(std::move(points), std::move(tangents), std::move(parameters));
}

HermitePatch to_hermite(const NurbsPatch& patch) {
  require_cubic(patch.knot_vector(Axis::u), patch.points());
  require_cubic(patch.knot_vector(Axis::v), patch.points());
  const std::vector<double> breaks_u = breaks(patch.knot_vector(Axis::u));
  const std::vector<double> breaks_v = breaks(patch.knot_vector(Axis::v));
  HermiteNet net;
  for (std::size_t i = 0; i < breaks_u.size(); ++i) {
    for (std::size_t j = 0; j < breaks_v.size(); ++j) {
      const Corner corner = corner_at(patch, breaks_u[i], breaks_v[j]);
      require_smooth(patch, breaks_u[i], breaks_v[j], corner, shorter_step(breaks_u, i), shorter_step(breaks_v, j));
      net.points.push_back(corner[0]);
      net.tangents_v.push_back(corner[1]);
      net.tangents_u.push_back(corner[2]);
      net.twists.push_back(corner[3]);
    }
  }
  const int count_u = static_cast<int>(breaks_u.size());
  const int count_v = static_cast<int>(breaks_v.size());
  return HermitePatch::make(count_u, count_v, std::move(net), breaks_u, breaks_v);
}

}  // namespace splinecore
