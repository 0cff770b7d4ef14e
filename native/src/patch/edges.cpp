#include "splinecore/patch/edges.hpp"

#include <algorithm>
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

std::vector<std::int64_t> scaled(const KnotVector& knots) {
  const Interval range = knots.domain();
  std::vector<std::int64_t> values;
  for (const double u : knots.knots()) {
    values.push_back(std::llround((u - range.start) / range.length() * 1e12));
  }
  return values;
}

/// Rows of the pool along a side, in the direction of its parameter.
std::vector<std::int64_t> rows_along(const IndexedPatch& patch, int side, std::size_t net) {
  const int* first = patch.indices.data() + net * patch.count_u * patch.count_v;
  std::vector<std::int64_t> rows;
  if (side < 2) {
    const int i = side == 0 ? 0 : patch.count_u - 1;
    for (int j = 0; j < patch.count_v; ++j) rows.push_back(first[i * patch.count_v + j]);
  } else {
    const int j = side == 2 ? 0 : patch.count_v - 1;
    for (int i = 0; i < patch.count_u; ++i) rows.push_back(first[i * patch.count_v + j]);
  }
  return rows;
}

Key joined(std::int64_t degree, const std::vector<std::int64_t>& knots, const std::vector<std::int64_t>& rows) {
  Key key{degree};
  key.insert(key.end(), knots.begin(), knots.end());
  key.insert(key.end(), rows.begin(), rows.end());
  return key;
}

struct KeyedSide {
  PatchSide side;
  std::optional<Key> key;
};

KeyedSide keyed_side(const IndexedPatch& patch, const NurbsPatch& form, int side) {
  const Axis across = side < 2 ? Axis::u : Axis::v;
  const KnotVector& along = form.knot_vector(side < 2 ? Axis::v : Axis::u);
  if (!ends_in_point(form.knot_vector(across), side % 2 == 1)) return {};
  const auto rows = rows_along(patch, side, 0);
  const bool one_point = std::ranges::all_of(rows, [&](auto row) { return row == rows.front(); });
  if (one_point && patch.kind != PatchKind::hermite) {
    return {{EdgeKind::pole, -1, false}, std::nullopt};
  }
  const std::int64_t periodic = along.periodic() ? -1 : 1;
  std::vector<std::int64_t> knots = scaled(along);
  if (patch.kind == PatchKind::hermite) {
    // Opposite tangents are other rows of the pool, so only sides of one direction match.
    std::vector<std::int64_t> all = rows;
    const auto tangents = rows_along(patch, side, side < 2 ? 2 : 1);
    all.insert(all.end(), tangents.begin(), tangents.end());
    return {{EdgeKind::free, -1, false}, joined(0, knots, all)};
  }
  const Key forward = joined(periodic * along.degree(), knots, rows);
  std::ranges::reverse(knots);
  for (std::int64_t& u : knots) u = std::int64_t{1000000000000} - u;
  const Key backward = joined(periodic * along.degree(), knots, {rows.rbegin(), rows.rend()});
  const bool reversed = !along.periodic() && backward < forward;
  return {{EdgeKind::free, -1, reversed}, reversed ? backward : forward};
}

}  // namespace

std::vector<std::array<PatchSide, 4>> patch_sides(const PatchSet& set) {
  std::vector<std::array<PatchSide, 4>> sides(set.patches().size());
  std::map<Key, std::vector<PatchSide*>> edges;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (int side = 0; side < 4; ++side) {
      const KeyedSide found = keyed_side(set.patches()[i], nurbs_of(set.patch(i)), side);
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
