#include "splinecore/surface/cap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "base/length.hpp"
#include "base/placement.hpp"
#include "fitted_together.hpp"
#include "rim_region.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/measure/area.hpp"
#include "splinecore/patch/panels.hpp"

namespace splinecore {

namespace {

constexpr int kMostRounds = 10;          // of cutting: at corners, and then in halves
constexpr std::size_t kMostSides = 128;  // of a rim that is cut, and of each hole in it

const char* const kNotSeen =
    "the rim is seen whole from no point, and no chords between its corners cut it into parts that are: it crosses itself or another "
    "one, or has too many narrow bends";

/// Parameters so near, by the length of a domain, are one.
constexpr double kOneParameter = 0x1p-36;

/// The middle of a curve, or the knot there: beside a knot a piece would be left that is nothing but rounding.
double middle_of(const NurbsCurve& curve) {
  const Interval domain = curve.domain();
  const double middle = domain.middle();
  for (const double knot : curve.knot_vector().knots()) {
    if (std::abs(knot - middle) <= kOneParameter * domain.length()) return knot;
  }
  return middle;
}

/// Where the curves of sides are cut in a round.
std::vector<double> cuts_of(const NurbsCurve& curve, int round) {
  const Interval domain = curve.domain();
  std::vector<double> cuts;
  if (round == 0) {
    cuts = corners_of({&curve, 1});
    std::erase_if(cuts, [&](double u) { return u == domain.end || (u == domain.start && !curve.periodic()); });
  } else if (curve.periodic()) {
    cuts = {domain.start, middle_of(curve)};
  } else if (!is_segment(curve)) {
    cuts = {middle_of(curve)};
  }
  return cuts;
}

/// Parts of a curve. @param cuts  of a periodic one the first of them is its beginning, or its own if there is none
std::vector<NurbsCurve> parts_of(NurbsCurve curve, const std::vector<double>& cuts) {
  std::vector<NurbsCurve> parts;
  std::size_t next = 0;
  if (curve.periodic() && !cuts.empty()) curve = opened(curve, cuts[next++]);
  for (; next < cuts.size(); ++next) {
    auto [before, after] = split(curve, cuts[next]);
    parts.push_back(std::move(before));
    curve = std::move(after);
  }
  parts.push_back(std::move(curve));
  return parts;
}

std::vector<RimLoop> loops_of(std::span<const NurbsCurve> sides, std::span<const std::vector<RimOrder>> orders) {
  std::vector<RimLoop> loops;
  for (const auto& order : orders) {
    loops.emplace_back();
    for (const RimOrder& one : order) loops.back().push_back({sides[one.side], one.is_reversed});
  }
  return loops;
}

/// What of a shape is one with what.
struct OpenSides {
  std::vector<std::array<int, 4>> counts;  ///< of each patch, how many sides each of its sides is; 0 for a pole
  std::vector<std::array<int, 4>> edges;   ///< of each patch, the numbers of its sides: what is one has one; -1 for a pole
};

PatchSet set_of(std::span<const NurbsPatch> patches) {
  const std::vector<AnyPatch> all(patches.begin(), patches.end());
  return PatchSet::of(all, true);
}

OpenSides open_sides(std::span<const NurbsPatch> patches) {
  const PatchSet set = set_of(patches);
  const std::vector<Panel> panels = panels_of(set);
  const std::vector<int> counts = side_counts(panels);
  OpenSides found{std::vector<std::array<int, 4>>(patches.size()), std::vector<std::array<int, 4>>(patches.size())};
  if (panels.size() != patches.size()) throw InvalidShape("a patch is in several pieces, and each has open ends");
  for (const Panel& panel : panels) {
    for (int side = 0; side < 4; ++side) {
      found.edges[panel.patch][side] = panel.sides[side].edge;
      found.counts[panel.patch][side] = panel.sides[side].edge < 0 ? 0 : counts[panel.sides[side].edge];
    }
  }
  return found;
}

/// The way along a side in which its patch lies to the left.
bool runs_along(Border border) { return border == Border::v_start || border == Border::u_end; }

Axis axis_along(Border border) { return axis_of(border) == Axis::u ? Axis::v : Axis::u; }

std::vector<NurbsCurve> sides_of(std::span<const NurbsPatch> patches, const OpenEnd& end) {
  std::vector<NurbsCurve> sides;
  for (const SideOfPatch& side : end) {
    if (side.patch >= patches.size()) throw InvalidShape("there is no patch " + std::to_string(side.patch));
    sides.push_back(boundary(patches[side.patch], side.border));
  }
  return sides;
}

/// Patches, and the sides of some of them that go round ends.
struct Capping {
  std::vector<NurbsPatch> patches;
  std::vector<OpenEnd> ends;

  /// Puts the parts of a patch in its place; ends keep the sides that they had, in parts.
  void replace(std::size_t at, Axis axis, std::vector<NurbsPatch> parts) {
    const std::size_t more = parts.size() - 1;
    patches.erase(patches.begin() + static_cast<std::ptrdiff_t>(at));
    patches.insert(patches.begin() + static_cast<std::ptrdiff_t>(at), parts.begin(), parts.end());
    for (OpenEnd& end : ends) {
      OpenEnd moved;
      for (const SideOfPatch& side : end) {
        if (side.patch != at) {
          moved.push_back({side.patch + (side.patch > at ? more : 0), side.border});
        } else if (axis_along(side.border) == axis) {
          for (std::size_t k = 0; k <= more; ++k) moved.push_back({at + k, side.border});
        } else {
          moved.push_back({at + (is_at_end(side.border) ? more : 0), side.border});
        }
      }
      end = std::move(moved);
    }
  }
};

std::vector<NurbsPatch> parts_of(NurbsPatch patch, Axis axis, const std::vector<double>& cuts) {
  std::vector<NurbsPatch> parts;
  std::size_t next = 0;
  if (patch.knot_vector(axis).periodic()) patch = opened(patch, axis, cuts[next++]);
  for (; next < cuts.size(); ++next) {
    auto [before, after] = split(patch, axis, cuts[next]);
    parts.push_back(std::move(before));
    patch = std::move(after);
  }
  parts.push_back(std::move(patch));
  return parts;
}

/// Where a patch is cut along an axis.
struct PatchCuts {
  std::size_t patch;
  Axis axis;
  std::vector<double> at;
};

/// What is to be cut along an end in a round, the last patch first.
std::vector<PatchCuts> cuts_along(const Capping& capping, const OpenEnd& end, int round) {
  std::vector<PatchCuts> found;
  for (const SideOfPatch& side : end) {
    const std::vector<double> cuts = cuts_of(boundary(capping.patches[side.patch], side.border), round);
    if (cuts.empty()) continue;
    const auto known = std::ranges::find(found, side.patch, &PatchCuts::patch);
    const Axis axis = axis_along(side.border);
    if (known == found.end()) {
      found.push_back({side.patch, axis, cuts});
      continue;
    }
    if (known->axis != axis) throw InvalidShape(std::string(kNotSeen) + ", unless patch " + std::to_string(side.patch) + " is cut both ways");
    known->at.insert(known->at.end(), cuts.begin(), cuts.end());
  }
  for (PatchCuts& cuts : found) {
    std::ranges::sort(cuts.at);
    const double same = kOneParameter * capping.patches[cuts.patch].knot_vector(cuts.axis).domain().length();
    const auto repeated = std::ranges::unique(cuts.at, [&](double a, double b) { return b - a <= same; });
    cuts.at.erase(repeated.begin(), repeated.end());
  }
  std::ranges::sort(found, std::greater(), &PatchCuts::patch);
  return found;
}

/// Cuts the patches along an end. @returns whether there was anything to cut
bool cut_along(Capping& capping, std::size_t end, int round) {
  const std::vector<PatchCuts> found = cuts_along(capping, capping.ends[end], round);
  const OpenSides all = open_sides(capping.patches);
  for (const PatchCuts& cuts : found) {
    const int first = cuts.axis == Axis::u ? 2 : 0;
    const auto& counts = all.counts[cuts.patch];
    if (counts[first] > 1 || counts[first + 1] > 1) {
      throw InvalidShape(std::string(kNotSeen) + ", unless patch " + std::to_string(cuts.patch) +
                         " is cut, which shares its side opposite to the end with another one");
    }
    capping.replace(cuts.patch, cuts.axis, parts_of(capping.patches[cuts.patch], cuts.axis, cuts.at));
  }
  return !found.empty();
}

Border turned(Border border) {
  if (border == Border::u_start) return Border::u_end;
  return border == Border::u_end ? Border::u_start : border;
}

/// The numbers of the patches that are bound to one by sides, and its own.
std::vector<std::size_t> bound_to(const std::vector<NurbsPatch>& patches, std::size_t first) {
  const OpenSides all = open_sides(patches);
  std::vector<std::size_t> found{first};
  for (std::size_t next = 0; next < found.size(); ++next) {
    for (std::size_t i = 0; i < patches.size(); ++i) {
      const bool is_beside = std::ranges::any_of(all.edges[i], [&](int edge) {
        return edge >= 0 && std::ranges::find(all.edges[found[next]], edge) != all.edges[found[next]].end();
      });
      if (is_beside && std::ranges::find(found, i) == found.end()) found.push_back(i);
    }
  }
  return found;
}

/// Turns normals of a patch, and of all that are bound to it. @throws InvalidShape if that is so of another one
void turn(Capping& capping, std::size_t patch, std::size_t but) {
  const std::vector<std::size_t> bound = bound_to(capping.patches, patch);
  if (std::ranges::find(bound, but) != bound.end()) {
    throw InvalidShape("patches " + std::to_string(patch) + " and " + std::to_string(but) +
                       " are bound to each other so that a cap between them would have normals on both sides");
  }
  for (const std::size_t i : bound) capping.patches[i] = reversed(capping.patches[i], Axis::u);
  for (OpenEnd& end : capping.ends) {
    for (SideOfPatch& side : end) {
      if (std::ranges::find(bound, side.patch) != bound.end()) side.border = turned(side.border);
    }
  }
}

struct Cap {
  std::vector<NurbsPatch> patches;
  double bend;
};

/// With normals on the side of those of the patches along the borders of regions; patches about holes are turned where they are
/// not so. @returns none where some were turned
std::optional<Cap> facing(Capping& capping, std::size_t end, std::span<const std::vector<RimOrder>> orders, FilledRim filled) {
  const OpenEnd sides = capping.ends[end];
  const auto side_of = [&](std::size_t loop) { return sides[orders[loop][0].side]; };
  const auto is_against = [&](std::size_t loop) { return runs_along(side_of(loop).border) != filled.is_turned[loop]; };
  Cap cap{{}, filled.bend};
  for (FilledRegion& region : filled.regions) {
    const std::size_t border = region.loops[0];
    for (const std::size_t hole : region.loops) {
      if (is_against(hole) == is_against(border)) continue;
      turn(capping, side_of(hole).patch, side_of(border).patch);
      return {};
    }
    for (NurbsPatch& patch : region.patches) {
      cap.patches.push_back(is_against(border) ? reversed(patch, Axis::u) : std::move(patch));
    }
  }
  return cap;
}

/// Of an end. @returns none where patches were turned for it
std::optional<Cap> cap_of(Capping& capping, std::size_t end) {
  for (int round = 0; round < kMostRounds; ++round) {
    const std::vector<NurbsCurve> sides = sides_of(capping.patches, capping.ends[end]);
    const auto orders = rim_orders(sides);
    if (sides.size() > kMostSides * orders.size()) break;
    auto filled = filled_rim(loops_of(sides, orders));
    if (filled) return facing(capping, end, orders, std::move(*filled));
    // A round that finds nothing to cut at corners goes on to halves.
    if (!cut_along(capping, end, round) && round > 0) break;
  }
  throw InvalidShape(kNotSeen);
}

/// Where the largest is about 1 large, and its volume a number.
std::vector<NurbsPatch> placed_together(std::span<const NurbsPatch> patches) {
  std::vector<glm::dvec4> points;
  for (const NurbsPatch& patch : patches) std::ranges::copy(patch.points(), std::back_inserter(points));
  const Placement placement = placement_of(points);
  std::vector<NurbsPatch> found;
  for (const NurbsPatch& patch : patches) found.push_back(placed(patch, placement));
  return found;
}

/// Whether what is closed has its normals inwards; false where that cannot be told.
bool is_inside_out(std::span<const NurbsPatch> patches) {
  try {
    return volume(set_of(placed_together(patches)), 1e-6).value < 0.0;
  } catch (const InvalidShape&) {
    return false;  // open, or not turned alike: there is no outside
  } catch (const ToleranceNotReached&) {
    return false;
  }
}

/// Caps of all ends; patches are cut and turned until no cap needs more of that.
std::vector<Cap> caps_of(Capping& capping) {
  std::size_t turns = 0;
  for (;;) {
    const std::size_t count = capping.patches.size();
    std::vector<Cap> caps;
    for (std::size_t i = 0; i < capping.ends.size(); ++i) {
      std::optional<Cap> cap = cap_of(capping, i);
      if (!cap) break;
      caps.push_back(std::move(*cap));
    }
    const bool is_turned = caps.size() < capping.ends.size();
    if (!is_turned && count == capping.patches.size()) return caps;
    turns += is_turned;
    if (turns > capping.patches.size()) throw InvalidShape("the patches between the ends have no outside: normals would point to both sides");
  }
}

std::vector<NurbsPatch> with_caps(std::vector<NurbsPatch> patches, const std::vector<Cap>& caps) {
  for (const Cap& cap : caps) patches.insert(patches.end(), cap.patches.begin(), cap.patches.end());
  return patches;
}

/// The same with all open ends filled, as far as they can be, to tell where its outside is.
bool is_inside_out_when_closed(const std::vector<NurbsPatch>& patches) {
  try {
    Capping capping{patches, open_ends(patches)};
    const std::vector<Cap> caps = caps_of(capping);
    return is_inside_out(with_caps(std::move(capping.patches), caps));
  } catch (const InvalidShape&) {
    return false;  // what has no closed form has no outside
  }
}

}  // namespace

Approximation<std::vector<NurbsPatch>> rim_filling(std::span<const NurbsCurve> given) {
  std::vector<NurbsCurve> sides(given.begin(), given.end());
  for (int round = 0; round < kMostRounds; ++round) {
    const auto orders = rim_orders(sides);
    if (sides.size() > kMostSides * orders.size()) break;
    auto filled = filled_rim(loops_of(sides, orders));
    if (filled) {
      std::vector<NurbsPatch> patches;
      for (FilledRegion& region : filled->regions) std::ranges::move(region.patches, std::back_inserter(patches));
      return {std::move(patches), filled->bend};
    }
    std::vector<NurbsCurve> parts;
    for (const NurbsCurve& side : sides) {
      std::vector<NurbsCurve> own = parts_of(side, cuts_of(side, round));
      std::ranges::move(own, std::back_inserter(parts));
    }
    if (parts.size() == sides.size() && round > 0) break;
    sides = std::move(parts);
  }
  throw InvalidShape(kNotSeen);
}

std::vector<OpenEnd> open_ends(std::span<const NurbsPatch> patches) {
  constexpr double kSame = 1e-9;
  const OpenSides all = open_sides(patches);
  OpenEnd open;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    for (int side = 0; side < 4; ++side) {
      if (all.counts[i][side] == 1) open.push_back({i, static_cast<Border>(side)});
    }
  }
  std::vector<std::array<glm::dvec3, 2>> places;
  std::vector<glm::dvec4> points;
  for (const NurbsPatch& patch : patches) points.insert(points.end(), patch.points().begin(), patch.points().end());
  const double same = kSame * extent(points);
  for (const NurbsCurve& curve : sides_of(patches, open)) places.push_back(end_points(curve));
  std::vector<bool> is_taken(open.size(), false);
  std::vector<OpenEnd> ends;
  for (std::size_t first = 0; first < open.size(); ++first) {
    if (is_taken[first]) continue;
    ends.push_back({open[first]});
    is_taken[first] = true;
    glm::dvec3 at = places[first][1];
    while (!(distance_of(at, places[first][0]) <= same)) {
      std::optional<std::size_t> next;
      for (std::size_t i = 0; i < open.size(); ++i) {
        const bool is_beside = !is_taken[i] && (distance_of(places[i][0], at) <= same || distance_of(places[i][1], at) <= same);
        if (is_beside && next) throw InvalidShape("more than two open sides end in one point: the sides around an end are ambiguous");
        if (is_beside) next = i;
      }
      if (!next) throw InvalidShape("an open side of patch " + std::to_string(open[first].patch) + " ends where no other one does");
      is_taken[*next] = true;
      ends.back().push_back(open[*next]);
      at = distance_of(places[*next][0], at) <= same ? places[*next][1] : places[*next][0];
    }
  }
  return ends;
}

Approximation<std::vector<NurbsPatch>> capped(std::span<const NurbsPatch> patches, std::span<const OpenEnd> ends) {
  Capping capping{{patches.begin(), patches.end()}, {ends.begin(), ends.end()}};
  const std::vector<Cap> caps = caps_of(capping);
  double bend = 0.0;
  for (const Cap& cap : caps) bend = std::max(bend, cap.bend);
  std::vector<NurbsPatch> made = with_caps(std::move(capping.patches), caps);
  if (is_inside_out_when_closed(made)) {
    for (NurbsPatch& patch : made) patch = reversed(patch, Axis::u);
  }
  return {std::move(made), bend};
}

}  // namespace splinecore
