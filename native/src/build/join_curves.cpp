#include "splinecore/build/join_curves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "base/length.hpp"
#include "base/require.hpp"
#include "base/sort_by.hpp"
#include "curve_ends.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/measure/arc_length.hpp"

namespace splinecore {

namespace {

constexpr std::size_t kNoPartner = std::numeric_limits<std::size_t>::max();

/// Ends of curves: 2 i is where curve i starts, 2 i + 1 where it ends.
std::size_t other_end(std::size_t end) { return end ^ 1U; }

struct EndPair {
  std::size_t a;
  std::size_t b;
  double distance;
};

std::vector<glm::dvec3> ends_of(std::span<const NurbsCurve> curves) {
  std::vector<glm::dvec3> ends;
  for (const NurbsCurve& curve : curves) {
    ends.push_back(point_at(curve, curve.domain().start));
    ends.push_back(point_at(curve, curve.domain().end));
  }
  return ends;
}

/// Pairs of ends within the tolerance, the nearest first.
std::vector<EndPair> near_pairs(const std::vector<glm::dvec3>& ends, const std::vector<bool>& is_open, double tolerance) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (is_open[i / 2]) order.push_back(i);
  }
  sort_by(order, [&](std::size_t i) { return ends[i].x; });
  std::vector<EndPair> pairs;
  for (auto a = order.begin(); a != order.end(); ++a) {
    for (auto b = a + 1; b != order.end() && ends[*b].x - ends[*a].x <= tolerance; ++b) {
      const double distance = distance_of(ends[*a], ends[*b]);
      if (distance <= tolerance) pairs.push_back({std::min(*a, *b), std::max(*a, *b), distance});
    }
  }
  std::ranges::sort(pairs, [](const EndPair& p, const EndPair& q) {
    return std::tie(p.distance, p.a, p.b) < std::tie(q.distance, q.a, q.b);
  });
  return pairs;
}

/// The end that each is joined to.
std::vector<std::size_t> partners_of(std::size_t count, const std::vector<EndPair>& pairs) {
  std::vector<std::size_t> partners(count, kNoPartner);
  for (const EndPair& pair : pairs) {
    if (partners[pair.a] != kNoPartner || partners[pair.b] != kNoPartner) continue;
    partners[pair.a] = pair.b;
    partners[pair.b] = pair.a;
  }
  return partners;
}

}  // namespace

std::vector<NurbsCurve> join_curves(std::span<const NurbsCurve> curves, double tolerance) {
  if (curves.empty()) throw InvalidShape("there is no curve to join");
  require_tolerance(tolerance);
  std::vector<bool> is_open;
  for (const NurbsCurve& curve : curves) is_open.push_back(!is_closed(curve));
  const std::vector<std::size_t> partners =
      partners_of(2 * curves.size(), near_pairs(ends_of(curves), is_open, tolerance));
  std::vector<bool> is_done(curves.size(), false);
  std::vector<NurbsCurve> made;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (is_done[i]) continue;
    // Back to where the chain begins, or round to this curve again.
    std::size_t begin = 2 * i;
    while (partners[begin] != kNoPartner && other_end(partners[begin]) != 2 * i) begin = other_end(partners[begin]);
    const bool is_round = partners[begin] != kNoPartner;
    if (is_round) begin = 2 * i;
    std::vector<NurbsCurve> chain;
    for (std::size_t at = begin; at != kNoPartner && !is_done[at / 2]; at = partners[other_end(at)]) {
      is_done[at / 2] = true;
      chain.push_back(at % 2 == 0 ? curves[at / 2] : reversed(curves[at / 2]));
    }
    const bool is_alone = chain.size() == 1;
    const NurbsCurve whole = is_alone ? chain.front() : chained(chain);
    made.push_back(is_round ? with_one_end(is_alone ? clamped(whole) : whole) : whole);
  }
  return made;
}

}  // namespace splinecore
