#include "loose_rows.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace splinecore {

namespace {

/// What the curve of a side is made of.
struct SideRows {
  std::vector<int> rows;
  int degree;
  bool has_tangents;
  std::vector<double> knots;  ///< scaled to [0, 1]

  SideRows reversed() const {
    SideRows turned = *this;
    std::ranges::reverse(turned.rows);
    std::ranges::reverse(turned.knots);
    for (double& t : turned.knots) t = 1.0 - t;
    return turned;
  }
};

bool is_clamped(const KnotVector& knots, bool is_end) {
  const auto all = knots.unrolled();
  const auto degree = static_cast<std::size_t>(knots.degree());
  return !knots.periodic() && (is_end ? all[all.size() - 1 - degree] == all.back() : all[degree] == all.front());
}

/// The rows that a side of a whole patch runs along; none where its curve depends on others, too.
std::optional<SideRows> rows_along(const PatchSet& set, const Panel& panel, int side) {
  const NurbsPatch& form = nurbs_of(set.patch(panel.patch));
  const KnotVector& along = form.knot_vector(side < 2 ? Axis::v : Axis::u);
  const KnotVector& across = form.knot_vector(side < 2 ? Axis::u : Axis::v);
  const bool is_whole = panel.u == form.knot_vector(Axis::u).domain() && panel.v == form.knot_vector(Axis::v).domain();
  if (!is_whole || along.periodic() || !is_clamped(across, side % 2 == 1)) return {};
  const IndexedPatch& patch = set.patches()[panel.patch];
  const int last = side % 2 == 0 ? 0 : (side < 2 ? patch.count_u : patch.count_v) - 1;
  const int count = side < 2 ? patch.count_v : patch.count_u;
  SideRows found{{}, along.degree(), patch.kind == PatchKind::hermite, {}};
  const auto add = [&](int net) {
    const int* first = patch.indices.data() + static_cast<std::ptrdiff_t>(net) * patch.count_u * patch.count_v;
    for (int k = 0; k < count; ++k) {
      found.rows.push_back(first[side < 2 ? last * patch.count_v + k : k * patch.count_v + last]);
    }
  };
  add(0);
  if (found.has_tangents) add(side < 2 ? 2 : 1);
  const Interval range = along.domain();
  for (const double t : along.unrolled()) found.knots.push_back((t - range.start) / range.length());
  return found;
}

bool are_glued(const SideRows& a, const SideRows& b) {
  constexpr double kOneKnot = 1e-14;
  return a.rows == b.rows && a.degree == b.degree && a.has_tangents == b.has_tangents &&
         std::ranges::equal(a.knots, b.knots, [](double s, double t) { return std::abs(s - t) <= kOneKnot; });
}

/// A side with others of its edge.
struct Member {
  const Panel* panel;
  int side;
};

bool are_all_glued(const PatchSet& set, const std::vector<Member>& members) {
  if (members.size() == 1) return true;
  const Panel& panel = *members[0].panel;
  const auto& form = nurbs_of(set.patch(panel.patch));
  const bool is_own = members.size() == 2 && &panel == members[1].panel && members[0].side / 2 == members[1].side / 2;
  if (is_own && form.knot_vector(members[0].side < 2 ? Axis::u : Axis::v).periodic()) return true;
  std::optional<SideRows> first;
  for (const Member& member : members) {
    std::optional<SideRows> rows = rows_along(set, *member.panel, member.side);
    if (!rows) return false;
    if (member.panel->sides[member.side].reversed) {
      if (rows->has_tangents) return false;
      rows = rows->reversed();
    }
    if (!first) first = rows;
    if (!are_glued(*first, *rows)) return false;
  }
  return true;
}

bool is_one_row(const std::vector<int>& rows) {
  return std::ranges::all_of(rows, [&](int row) { return row == rows.front(); });
}

/// Takes note of what a side may depend on: of rows, or of a whole patch.
struct Loose {
  std::vector<char> rows;
  std::vector<char> patches;

  void add(const PatchSet& set, const Member& member) {
    const std::optional<SideRows> found = rows_along(set, *member.panel, member.side);
    if (!found) patches[member.panel->patch] = 1;
    if (found) add_rows(found->rows);
  }
  void add_rows(const std::vector<int>& found) {
    for (const int row : found) rows[row] = 1;
  }
};

}  // namespace

std::vector<char> loose_rows(const PatchSet& set, const std::vector<Panel>& panels) {
  Loose loose{std::vector<char>(set.points().size(), 0), std::vector<char>(set.patches().size(), 0)};
  std::vector<std::vector<Member>> edges;
  for (const Panel& panel : panels) {
    for (int side = 0; side < 4; ++side) {
      const int edge = panel.sides[side].edge;
      if (edge >= 0) {
        edges.resize(std::max(edges.size(), static_cast<std::size_t>(edge) + 1));
        edges[edge].push_back({&panel, side});
        continue;
      }
      const std::optional<SideRows> rows = rows_along(set, panel, side);
      if (!rows || rows->has_tangents || !is_one_row(rows->rows)) loose.add(set, {&panel, side});
    }
  }
  for (const std::vector<Member>& members : edges) {
    if (are_all_glued(set, members)) continue;
    for (const Member& member : members) loose.add(set, member);
  }
  for (std::size_t patch = 0; patch < loose.patches.size(); ++patch) {
    if (loose.patches[patch]) loose.add_rows(set.patches()[patch].indices);
  }
  return loose.rows;
}

}  // namespace splinecore
