#include "splinecore/surface/fillet_chain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>
#include <utility>

#include "base/length.hpp"
#include "patch_chain.hpp"
#include "side_first.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/patch/ends.hpp"
#include "splinecore/patch/join.hpp"

namespace splinecore {

namespace {

/// Places nearer than so much of the size are one.
constexpr double kSame = 1e-9;

/// One of the two patches of an edge, v_start at it, and how it was turned for that.
struct TurnedPatch {
  NurbsPatch patch;
  Border side;
  bool is_reversed;
};

TurnedPatch turned(const NurbsPatch& patch, Border side, bool is_reversed) {
  if (patch.knot_vector(axis_of(side)).periodic()) throw InvalidShape("a side is the seam of a periodic direction: it is not an edge");
  NurbsPatch made = with_side_first(patch, side);
  if (is_reversed) made = reversed(made, Axis::u);
  if (made.knot_vector(Axis::u).periodic()) throw InvalidShape("an edge of the chain is closed: round it alone");
  made = clamped(clamped(made, Axis::u), Axis::v);
  return {with_domain(with_domain(made, Axis::u, {0.0, 1.0}), Axis::v, {0.0, 1.0}), side, is_reversed};
}

NurbsPatch turned_back(const NurbsPatch& patch, const TurnedPatch& as) {
  return with_side_back(as.is_reversed ? reversed(patch, Axis::u) : patch, as.side);
}

struct EdgeEnd {
  glm::dvec3 point;
  glm::dvec3 way;
};

EdgeEnd end_at(const NurbsPatch& patch, double u) {
  const NurbsCurve edge = boundary(patch, Border::v_start);
  std::array<glm::dvec3, 2> jet;
  derivatives(edge, std::span(&u, 1), 1, std::span(&jet[0].x, 6));
  return {jet[0], jet[1]};
}

/// Whether the first edge of a chain runs against it: its end is then farther from the next one than its start.
bool runs_back(const NurbsPatch& first, const NurbsPatch& next) {
  const auto nearest = [&](double u) {
    const glm::dvec3 point = end_at(first, u).point;
    return std::min(distance_of(point, end_at(next, 0.0).point), distance_of(point, end_at(next, 1.0).point));
  };
  return nearest(0.0) < nearest(1.0);
}

/// The first patches of a chain, each turned to go on from the one before it.
std::vector<TurnedPatch> in_order(std::span<const PatchEdge> edges) {
  std::vector<TurnedPatch> found;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    TurnedPatch one = turned(edges[i].first, edges[i].first_side, false);
    bool turns = false;
    if (i > 0) {
      const glm::dvec3 end = end_at(found.back().patch, 1.0).point;
      turns = distance_of(end_at(one.patch, 1.0).point, end) < distance_of(end_at(one.patch, 0.0).point, end);
    } else if (edges.size() > 1) {
      turns = runs_back(one.patch, turned(edges[1].first, edges[1].first_side, false).patch);
    }
    found.push_back(turns ? turned(edges[i].first, edges[i].first_side, true) : std::move(one));
  }
  return found;
}

void require_goes_on(const EdgeEnd& end, const EdgeEnd& start, const std::string& one, const std::string& next, double size) {
  constexpr double kCorner = 1e-6;
  const double gap = distance_of(end.point, start.point);
  if (gap > kSame * size) throw InvalidShape("edges " + one + " and " + next + " of the chain lie " + text_of(gap) + " apart");
  const double angle = std::atan2(length_of(glm::cross(end.way, start.way)), glm::dot(end.way, start.way));
  if (!(angle > kCorner)) return;
  const auto degrees = static_cast<int>(std::round(180.0 - angle * 180.0 / std::numbers::pi));
  throw InvalidShape("edges " + one + " and " + next + " of the chain meet in a corner of " + std::to_string(degrees) +
                     " degrees: no ball rolls on there; round them one by one");
}

/// How long each edge is along u, so that all are run through as one.
std::vector<double> lengths_of(const std::vector<TurnedPatch>& patches, double size) {
  std::vector<double> lengths{1.0};
  for (std::size_t i = 1; i < patches.size(); ++i) {
    const EdgeEnd end = end_at(patches[i - 1].patch, 1.0);
    const EdgeEnd start = end_at(patches[i].patch, 0.0);
    require_goes_on(end, start, std::to_string(i), std::to_string(i + 1), size);
    const double ratio = length_of(start.way) / length_of(end.way);
    lengths.push_back(lengths.back() * (ratio > 0.0 && std::isfinite(ratio) ? ratio : 1.0));
  }
  return lengths;
}

bool ends_where_it_begins(const NurbsPatch& patch, double size) {
  const auto count_v = static_cast<std::size_t>(patch.count(Axis::v));
  const auto first = patch.points().first(count_v);
  const auto last = patch.points().last(count_v);
  return std::ranges::equal(first, last, [&](const glm::dvec4& p, const glm::dvec4& q) {
    return distance_of(glm::dvec3(p), glm::dvec3(q)) <= kSame * size;
  });
}

std::vector<NurbsPatch> patches_of(const std::vector<TurnedPatch>& turned) {
  std::vector<NurbsPatch> found;
  for (const TurnedPatch& one : turned) found.push_back(one.patch);
  return found;
}

/// Parts of a patch over [0, 1] along u, each over [0, 1].
std::vector<NurbsPatch> parts_at(const NurbsPatch& patch, const std::vector<double>& joints) {
  NurbsPatch rest = patch.knot_vector(Axis::u).periodic() ? clamped(patch, Axis::u) : patch;
  std::vector<NurbsPatch> found;
  for (std::size_t i = 1; i + 1 < joints.size(); ++i) {
    auto [before, behind] = split(rest, Axis::u, joints[i]);
    found.push_back(with_domain(before, Axis::u, {0.0, 1.0}));
    rest = std::move(behind);
  }
  found.push_back(with_domain(rest, Axis::u, {0.0, 1.0}));
  return found;
}

std::vector<RailNumber> along_chain(std::span<const RailNumber> radii, const std::vector<double>& joints) {
  const std::size_t count = joints.size() - 1;
  std::vector<RailNumber> found;
  for (const RailNumber& radius : radii) {
    if (!(radius.at >= 0.0 && radius.at <= static_cast<double>(count))) {
      throw InvalidShape("the radius at " + text_of(radius.at) + " is off the chain, which runs from 0 to " + std::to_string(count));
    }
    const std::size_t k = std::min(count - 1, static_cast<std::size_t>(radius.at));
    found.push_back({std::lerp(joints[k], joints[k + 1], radius.at - static_cast<double>(k)), radius.value});
  }
  return found;
}

}  // namespace

std::vector<RoundedEdge> fillet_chain(std::span<const PatchEdge> edges, std::span<const RailNumber> radii,
                                      std::optional<double> tolerance) {
  if (edges.empty()) throw InvalidShape("there is no edge");
  const std::vector<TurnedPatch> firsts = in_order(edges);
  std::vector<TurnedPatch> seconds;
  double size = 0.0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    size = std::max({size, extent(edges[i].first.points()), extent(edges[i].second.points())});
    const TurnedPatch one = turned(edges[i].second, edges[i].second_side, false);
    const bool turns = run_against(firsts[i].patch, Border::v_start, one.patch, Border::v_start);
    seconds.push_back(turns ? turned(edges[i].second, edges[i].second_side, true) : one);
  }
  const std::vector<double> lengths = lengths_of(firsts, size);
  PatchChain first = chained(patches_of(firsts), lengths, "first");
  PatchChain second = chained(patches_of(seconds), lengths, "second");
  if (edges.size() > 1 && ends_where_it_begins(first.patch, size) && ends_where_it_begins(second.patch, size)) {
    require_goes_on(end_at(first.patch, 1.0), end_at(first.patch, 0.0), std::to_string(edges.size()), "1", size);
    for (PatchChain* const chain : {&first, &second}) chain->patch = made_periodic(chain->patch, Axis::u, kSame * size).value;
  }
  const std::vector<RailNumber> along = along_chain(radii, first.joints);
  const RoundedEdge whole = fillet(first.patch, Border::v_start, second.patch, Border::v_start, along, tolerance);
  const std::vector<NurbsPatch> left_a = parts_at(whole.first, first.joints);
  const std::vector<NurbsPatch> fillets = parts_at(whole.fillet, first.joints);
  const std::vector<NurbsPatch> left_b = parts_at(whole.second, first.joints);
  std::vector<RoundedEdge> found;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    found.push_back({turned_back(left_a[i], firsts[i]), fillets[i], turned_back(left_b[i], seconds[i]), whole.error});
  }
  return found;
}

}  // namespace splinecore
