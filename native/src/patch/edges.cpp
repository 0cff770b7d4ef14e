#include "splinecore/patch/edges.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>

namespace splinecore {

namespace {

/// What two sides on the same points have in common: scaled knots, then rows of the pool.
using Key = std::vector<std::int64_t>;

bool ends_in_point(const KnotVector& knots, bool at_end) {
  if (knots.periodic()) return false;
  const auto all = knots.knots();
  const int degree = knots.degree();
  return at_end ? all[knots.count()] == all[knots.count() + degree - 1] : all[1] == all[degree];
}

/// Knots are compared in steps of this fraction of the domain: scaling them rounds.
constexpr std::int64_t kKnotSteps = 1'000'000'000'000;

std::vector<std::int64_t> scaled(const KnotVector& knots) {
  const Interval range = knots.domain();
  std::vector<std::int64_t> values;
  for (const double u : knots.knots()) {
    // Halves go to the even neighbour, so that mirrored knots stay mirrored.
    values.push_back(std::llrint((u - range.start) / range.length() * static_cast<double>(kKnotSteps)));
  }
  return values;
}

/// Rows of the pool along a side, in the direction of its parameter; equal rows as one.
std::vector<std::int64_t> rows_along(const IndexedPatch& patch, const std::vector<int>& first_equal, int side,
                                     std::size_t net) {
  const auto* indices = patch.indices.data() + net * patch.count_u * patch.count_v;
  std::vector<std::int64_t> rows;
  if (side < 2) {
    const int i = side == 0 ? 0 : patch.count_u - 1;
    for (int j = 0; j < patch.count_v; ++j) rows.push_back(first_equal[indices[i * patch.count_v + j]]);
  } else {
    const int j = side == 2 ? 0 : patch.count_v - 1;
    for (int i = 0; i < patch.count_u; ++i) rows.push_back(first_equal[indices[i * patch.count_v + j]]);
  }
  return rows;
}

Key joined(std::int64_t degree, const std::vector<std::int64_t>& knots, const std::vector<std::int64_t>& rows) {
  Key key{degree};
  key.insert(key.end(), knots.begin(), knots.end());
  key.insert(key.end(), rows.begin(), rows.end());
  return key;
}

/// Whether rows lie on one finite point; their weights may differ.
bool is_one_point(std::span<const glm::dvec4> pool, const std::vector<std::int64_t>& rows) {
  const glm::dvec4& first = pool[rows.front()];
  return std::ranges::all_of(rows, [&](std::int64_t row) {
    return pool[row].w != 0.0 && glm::dvec3(pool[row]) == glm::dvec3(first);
  });
}

struct KeyedSide {
  PatchSide side;
  std::optional<Key> key;
};

KeyedSide keyed_side(const PatchSet& set, std::size_t i, const std::vector<int>& first_equal, int side) {
  const IndexedPatch& patch = set.patches()[i];
  const NurbsPatch& form = nurbs_of(set.patch(i));
  const Axis across = side < 2 ? Axis::u : Axis::v;
  const KnotVector& along = form.knot_vector(side < 2 ? Axis::v : Axis::u);
  if (!ends_in_point(form.knot_vector(across), side % 2 == 1)) return {};
  const auto rows = rows_along(patch, first_equal, side, 0);
  if (patch.kind != PatchKind::hermite && is_one_point(set.points(), rows)) {
    return {{EdgeKind::pole, -1, false}, std::nullopt};
  }
  const std::int64_t periodic = along.periodic() ? -1 : 1;
  std::vector<std::int64_t> knots = scaled(along);
  if (patch.kind == PatchKind::hermite) {
    // Opposite tangents are other rows of the pool, so only sides of one direction match.
    std::vector<std::int64_t> all = rows;
    const auto tangents = rows_along(patch, first_equal, side, side < 2 ? 2 : 1);
    all.insert(all.end(), tangents.begin(), tangents.end());
    return {{EdgeKind::free, -1, false}, joined(0, knots, all)};
  }
  const Key forward = joined(periodic * along.degree(), knots, rows);
  std::ranges::reverse(knots);
  for (std::int64_t& u : knots) u = kKnotSteps - u;
  const Key backward = joined(periodic * along.degree(), knots, {rows.rbegin(), rows.rend()});
  const bool reversed = !along.periodic() && backward < forward;
  return {{EdgeKind::free, -1, reversed}, reversed ? backward : forward};
}

}  // namespace

std::vector<int> first_equal_rows(const PatchSet& set) {
  // Sums with 0.0 make zeros of both signs equal in every bit, too.
  const auto bits_of = [](const glm::dvec4& p) {
    return std::bit_cast<std::array<std::uint64_t, 4>>(p + 0.0);
  };
  std::map<std::array<std::uint64_t, 4>, int> first;
  std::vector<int> rows;
  for (const glm::dvec4& point : set.points()) {
    rows.push_back(first.emplace(bits_of(point), static_cast<int>(rows.size())).first->second);
  }
  return rows;
}

std::vector<std::array<PatchSide, 4>> patch_sides(const PatchSet& set) {
  const std::vector<int> first_equal = first_equal_rows(set);
  std::vector<std::array<PatchSide, 4>> sides(set.patches().size());
  std::map<Key, std::vector<PatchSide*>> edges;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (int side = 0; side < 4; ++side) {
      const KeyedSide found = keyed_side(set, i, first_equal, side);
      sides[i][side] = found.side;
      if (found.key) edges[*found.key].push_back(&sides[i][side]);
    }
  }
  int edge = 0;
  for (const auto& [key, members] : edges) {
    for (PatchSide* side : members) {
      side->edge = edge;
      side->kind = members.size() > 1 ? EdgeKind::shared : EdgeKind::free;
    }
    ++edge;
  }
  return sides;
}

}  // namespace splinecore
