#include "splinecore/convert/to_hermite.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
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

std::vector<glm::dvec3> as_vectors(const std::vector<double>& numbers) {
  std::vector<glm::dvec3> vectors;
  for (std::size_t i = 0; i < numbers.size(); i += 3) {
    vectors.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  }
  return vectors;
}

/// Values from the two sides that rounding alone may tell apart.
bool equal_up_to_rounding(const glm::dvec3& a, const glm::dvec3& b, double size) {
  constexpr double kRounding = 1e-12;
  return glm::length(a - b) <= kRounding * size;
}

}  // namespace

HermiteCurve to_hermite(const NurbsCurve& curve) {
  require_cubic(curve.knot_vector(), curve.points());
  const std::vector<double> parameters = breaks(curve.knot_vector());
  std::vector<double> left(6 * parameters.size());
  std::vector<double> right(left.size());
  derivatives(curve, parameters, 1, left, {.side = Side::left});
  derivatives(curve, parameters, 1, right, {.side = Side::right});
  const auto before = as_vectors(left);
  const auto after = as_vectors(right);
  const double size = extent(curve.points());
  std::vector<glm::dvec3> points;
  std::vector<Tangents> tangents;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (!equal_up_to_rounding(before[2 * i], after[2 * i], size)) {
      throw InvalidShape("the curve has a gap at u = " + text_of(parameters[i]) +
                         ": a Hermite chain is connected");
    }
    points.push_back(after[2 * i]);
    tangents.push_back({before[2 * i + 1], after[2 * i + 1]});
  }
  return HermiteCurve::make(std::move(points), std::move(tangents), parameters);
}

HermitePatch to_hermite(const NurbsPatch& patch) {
  const std::vector<double> breaks_u = breaks(patch.knot_vector(Axis::u));
  const std::vector<double> breaks_v = breaks(patch.knot_vector(Axis::v));
  require_cubic(patch.knot_vector(Axis::u), patch.points());
  require_cubic(patch.knot_vector(Axis::v), patch.points());
  const double size = extent(patch.points());
  const double scale_u = size / patch.knot_vector(Axis::u).domain().length();
  const double scale_v = size / patch.knot_vector(Axis::v).domain().length();
  const double scales[4] = {size, scale_v, scale_u, scale_u * scale_v / std::max(size, 1e-300)};
  HermiteNet net;
  std::vector<double> values(12);
  for (const double u : breaks_u) {
    for (const double v : breaks_v) {
      derivatives(patch, {&u, 1}, {&v, 1}, 1, values);
      const auto corner = as_vectors(values);
      for (const Side side_u : {Side::left, Side::right}) {
        for (const Side side_v : {Side::left, Side::right}) {
          derivatives(patch, {&u, 1}, {&v, 1}, 1, values, {side_u, side_v});
          const auto other = as_vectors(values);
          for (int k = 0; k < 4; ++k) {
            if (equal_up_to_rounding(corner[k], other[k], 1e2 * scales[k])) continue;
            throw InvalidShape("the patch is not C1 at u = " + text_of(u) + ", v = " + text_of(v) +
                               ": a Hermite corner has one tangent in each direction");
          }
        }
      }
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
