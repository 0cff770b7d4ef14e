#include "plane_region.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "seen_point.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

using Loop = std::vector<PartSide>;
using Line = std::vector<glm::dvec2>;

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }
double dot(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.x + a.y * b.y; }

double area_of(const Line& line) {
  double sum = 0.0;
  for (std::size_t i = 0; i < line.size(); ++i) sum += cross(line[i] - line[0], line[(i + 1) % line.size()] - line[0]);
  return 0.5 * sum;
}

/// Whether the boxes about two segments have no point in common: of parts of one line rounding tells nothing else.
bool are_beside(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
  return std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) || std::max(a.y, b.y) < std::min(c.y, d.y) ||
         std::max(c.y, d.y) < std::min(a.y, b.y);
}

/// Whether two segments have a point in common.
bool do_touch(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
  if (are_beside(a, b, c, d)) return false;
  const double c_side = cross(b - a, c - a);
  const double d_side = cross(b - a, d - a);
  const double a_side = cross(d - c, a - c);
  const double b_side = cross(d - c, b - c);
  if (c_side == 0.0 && d_side == 0.0) {
    const double from = dot(c - a, b - a);
    const double to = dot(d - a, b - a);
    return std::max(from, to) >= 0.0 && std::min(from, to) <= dot(b - a, b - a);
  }
  return c_side * d_side <= 0.0 && a_side * b_side <= 0.0;
}

/// A chord from a corner of a loop to a later one.
struct RegionChord {
  std::size_t from;
  std::size_t to;
  double length;
};

/// A chord from a corner of a loop to one of a hole.
struct Bridge {
  std::size_t hole;
  std::size_t from;
  std::size_t to;
  double length;
};

/// Both loops that a chord leaves, the first one that from its beginning to its end.
struct Halves {
  Loop first;
  Loop second;
};

class RegionCutter {
 public:
  explicit RegionCutter(std::vector<RegionSide> sides) : made_{std::move(sides), {}} {
    for (const RegionSide& side : made_.sides) lines_.push_back(line_of(side));
  }

  std::optional<CutRegion> cut(std::span<const std::size_t> counts) && {
    std::vector<Loop> loops;
    std::size_t next = 0;
    for (const std::size_t count : counts) {
      loops.emplace_back();
      for (std::size_t k = 0; k < count; ++k) loops.back().push_back({next++, false});
    }
    const std::optional<glm::dvec2> whole = loops.size() == 1 ? seen_from(loops[0]) : std::nullopt;
    if (whole) {
      made_.parts.push_back({loops[0], *whole});
      return std::move(made_);
    }
    for (const Loop& loop : loops) {
      if (crosses_itself(loop, &loop != &loops[0])) return {};
    }
    const std::optional<Loop> bridged = without_holes(std::move(loops));
    if (!bridged || !divide(*bridged)) return {};
    return std::move(made_);
  }

 private:
  /// One loop round all of the region, which goes to each hole and back by a chord. @returns none where there is no such chord
  std::optional<Loop> without_holes(std::vector<Loop> loops) {
    Loop whole = std::move(loops[0]);
    loops.erase(loops.begin());
    while (!loops.empty()) {
      const std::optional<Bridge> bridge = shortest_bridge(whole, loops);
      if (!bridge) return {};
      Loop hole = std::move(loops[bridge->hole]);
      loops.erase(loops.begin() + static_cast<std::ptrdiff_t>(bridge->hole));
      std::ranges::rotate(hole, hole.begin() + static_cast<std::ptrdiff_t>(bridge->to));
      const std::size_t added = add_chord(whole[bridge->from], hole[0]);
      hole.insert(hole.begin(), {added, false});
      hole.push_back({added, true});
      whole.insert(whole.begin() + static_cast<std::ptrdiff_t>(bridge->from), hole.begin(), hole.end());
    }
    return whole;
  }

  std::optional<Bridge> shortest_bridge(const Loop& whole, const std::vector<Loop>& holes) const {
    const Outline outer = outline_of(whole);
    std::vector<Outline> others;
    for (const Loop& hole : holes) others.push_back(outline_of(hole));
    std::vector<Bridge> all;
    for (std::size_t h = 0; h < holes.size(); ++h) {
      for (std::size_t i = 0; i < whole.size(); ++i) {
        for (std::size_t k = 0; k < holes[h].size(); ++k) {
          const glm::dvec2 way = others[h].line[others[h].corners[k]] - outer.line[outer.corners[i]];
          all.push_back({h, i, k, dot(way, way)});
        }
      }
    }
    std::ranges::sort(all, {}, &Bridge::length);
    for (const Bridge& bridge : all) {
      const Outline& hole = others[bridge.hole];
      const std::size_t from = outer.corners[bridge.from];
      const std::size_t to = hole.corners[bridge.to];
      const glm::dvec2 a = outer.line[from];
      const glm::dvec2 b = hole.line[to];
      breathe(outer.line.size());
      if (!leaves_inside(outer.line, from, b) || !leaves_inside(hole.line, to, a)) continue;
      const auto is_clear = [&](const Outline& one) { return !meets(one.line, a, b); };
      if (is_clear(outer) && std::ranges::all_of(others, is_clear)) return bridge;
    }
    return {};
  }

  struct Outline {
    Line line;
    std::vector<std::size_t> corners;
  };

  Outline outline_of(const Loop& loop) const {
    Outline found;
    found.line = line_of(loop, &found.corners);
    return found;
  }

  /// Whether the way to a place leaves a corner of a border into what that encloses, between what comes before and what comes after.
  static bool leaves_inside(const Line& line, std::size_t at, const glm::dvec2& to) {
    const std::size_t count = line.size();
    const glm::dvec2 before = line[(at + count - 1) % count] - line[at];
    const glm::dvec2 after = line[(at + 1) % count] - line[at];
    const glm::dvec2 way = to - line[at];
    const double from_after = cross(after, way);
    const double to_before = cross(way, before);
    const double turn = cross(after, before);
    if (turn > 0.0 || (turn == 0.0 && dot(after, before) < 0.0)) return from_after > 0.0 && to_before > 0.0;
    const bool is_along = (from_after == 0.0 && dot(after, way) > 0.0) || (to_before == 0.0 && dot(before, way) > 0.0);
    return !is_along && (from_after > 0.0 || to_before > 0.0 || (turn == 0.0 && from_after != 0.0));
  }

  /// Whether a segment has more in common with a border than its own ends.
  static bool meets(const Line& line, const glm::dvec2& a, const glm::dvec2& b) {
    const std::size_t count = line.size();
    for (std::size_t i = 0; i < count; ++i) {
      const glm::dvec2& c = line[i];
      const glm::dvec2& d = line[(i + 1) % count];
      if (c != a && c != b && d != a && d != b) {
        if (do_touch(a, b, c, d)) return true;
        continue;
      }
      const glm::dvec2& own = c == a || c == b ? c : d;
      const glm::dvec2& other = c == a || c == b ? d : c;
      const glm::dvec2 way = own == a ? b - a : a - b;
      if (cross(way, other - own) == 0.0 && dot(way, other - own) > 0.0) return true;
    }
    return false;
  }

  static Line line_of(const RegionSide& side) {
    constexpr int kInPiece = 16;
    Line line{place_on(side.pieces[0], 0.0)};
    for (const auto& piece : side.pieces) {
      const int steps = piece.size() == 2 ? 1 : kInPiece;
      for (int k = 1; k <= steps; ++k) line.push_back(place_on(piece, static_cast<double>(k) / steps));
    }
    return line;
  }

  Line line_of(const PartSide& one) const {
    Line line = lines_[one.side];
    if (one.is_reversed) std::ranges::reverse(line);
    return line;
  }

  Line line_of(const Loop& loop, std::vector<std::size_t>* corners = nullptr) const {
    Line line;
    for (const PartSide& one : loop) {
      if (corners) corners->push_back(line.size());
      const Line side = line_of(one);
      line.insert(line.end(), side.begin(), side.end() - 1);
    }
    return line;
  }

  std::size_t corner_of(const PartSide& one) const {
    const RegionSide& side = made_.sides[one.side];
    return one.is_reversed ? side.to : side.from;
  }

  std::optional<glm::dvec2> seen_from(const Loop& loop) const {
    std::vector<std::vector<glm::dvec3>> pieces;
    for (const PartSide& one : loop) {
      auto own = made_.sides[one.side].pieces;
      if (one.is_reversed) {
        std::ranges::reverse(own);
        for (auto& piece : own) std::ranges::reverse(piece);
      }
      pieces.insert(pieces.end(), own.begin(), own.end());
    }
    return point_seeing(pieces);
  }

  bool crosses_itself(const Loop& loop, bool is_hole) const {
    const Line line = line_of(loop);
    const std::size_t count = line.size();
    for (std::size_t i = 0; i + 2 < count; ++i) {
      breathe(count);
      for (std::size_t k = i + 2; k < count; ++k) {
        if (i == 0 && k + 1 == count) continue;
        if (do_touch(line[i], line[i + 1], line[k], line[(k + 1) % count])) return true;
      }
    }
    return !((is_hole ? -1.0 : 1.0) * area_of(line) > 0.0);
  }

  static bool turns_right(const glm::dvec2& before, const glm::dvec2& after) {
    return cross(before, after) < -1e-9 * std::sqrt(dot(before, before) * dot(after, after));
  }

  /// Whether a side turns to the right somewhere.
  bool is_hollow(const PartSide& one) const {
    const Line line = line_of(one);
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      if (turns_right(line[i] - line[i - 1], line[i + 1] - line[i])) return true;
    }
    return false;
  }

  /// Of each corner of a loop, whether the border turns to the right there, or on a side beside it.
  std::vector<bool> are_hollow(const Loop& loop, const Line& line, const std::vector<std::size_t>& corners) const {
    std::vector<bool> found;
    const std::size_t count = line.size();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::size_t at = corners[i];
      const bool is_turn = turns_right(line[at] - line[(at + count - 1) % count], line[(at + 1) % count] - line[at]);
      found.push_back(is_turn || is_hollow(loop[i]) || is_hollow(loop[(i + loop.size() - 1) % loop.size()]));
    }
    return found;
  }

  /// Whether a chord lies inside.
  static bool is_inside(const Line& line, std::size_t from, std::size_t to) {
    const glm::dvec2 a = line[from];
    const glm::dvec2 b = line[to];
    return leaves_inside(line, from, b) && leaves_inside(line, to, a) && !meets(line, a, b);
  }

  /// Those inside that begin or end where the border is hollow, the shortest first.
  std::vector<RegionChord> chords_in(const Loop& loop) const {
    constexpr std::size_t kMost = 48;
    constexpr std::size_t kMostTried = 3000;
    std::vector<std::size_t> corners;
    const Line line = line_of(loop, &corners);
    const std::vector<bool> hollow = are_hollow(loop, line, corners);
    std::vector<RegionChord> all;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      for (std::size_t k = i + 1; k < loop.size(); ++k) {
        const bool is_side = (k == i + 1 && made_.sides[loop[i].side].is_straight()) ||
                             (i == 0 && k + 1 == loop.size() && made_.sides[loop[k].side].is_straight());
        if (is_side || !(hollow[i] || hollow[k])) continue;
        const glm::dvec2 way = line[corners[k]] - line[corners[i]];
        all.push_back({i, k, std::sqrt(dot(way, way))});
      }
    }
    std::ranges::sort(all, {}, &RegionChord::length);
    all.resize(std::min(all.size(), kMostTried));
    std::vector<RegionChord> inside;
    for (const RegionChord& chord : all) {
      breathe(line.size());
      if (inside.size() == kMost) break;
      if (chord.length > 0.0 && is_inside(line, corners[chord.from], corners[chord.to])) inside.push_back(chord);
    }
    return inside;
  }

  /// A chord from where a side begins to where another does, as the last of all sides. @returns its number
  std::size_t add_chord(const PartSide& from, const PartSide& to) {
    const glm::dvec2 a = line_of(from).front();
    const glm::dvec2 b = line_of(to).front();
    made_.sides.push_back({{{glm::dvec3(a, 1.0), glm::dvec3(b, 1.0)}}, corner_of(from), corner_of(to)});
    lines_.push_back({a, b});
    return made_.sides.size() - 1;
  }

  /// The chord becomes the last of all sides.
  Halves halves_of(const Loop& loop, const RegionChord& chord) {
    const std::size_t added = add_chord(loop[chord.from], loop[chord.to]);
    Halves halves;
    for (std::size_t i = 0; i < loop.size(); ++i) (i >= chord.from && i < chord.to ? halves.first : halves.second).push_back(loop[i]);
    halves.first.push_back({added, true});
    halves.second.insert(halves.second.begin() + static_cast<std::ptrdiff_t>(chord.from), {added, false});
    return halves;
  }

  void take_back_chord() {
    made_.sides.pop_back();
    lines_.pop_back();
  }

  /// How good it is to cut there: both halves seen, or of one that is the area.
  double worth_of(const Loop& loop, const RegionChord& chord) {
    const Halves halves = halves_of(loop, chord);
    const bool is_first = seen_from(halves.first).has_value();
    const bool is_second = seen_from(halves.second).has_value();
    const double first = area_of(line_of(halves.first));
    const double second = area_of(line_of(halves.second));
    take_back_chord();
    if (is_first && is_second) return 2.0;
    if (!is_first && !is_second) return 0.0;
    return (is_first ? first : second) / (first + second);
  }

  /// Adds the parts of a loop that is not seen whole. @returns whether that can be done
  bool divide(const Loop& loop) {
    std::vector<RegionChord> chords = chords_in(loop);
    if (chords.empty()) return false;
    const RegionChord* best = nullptr;
    double most = -1.0;
    for (const RegionChord& chord : chords) {
      const double worth = worth_of(loop, chord);
      if (worth > most) {
        most = worth;
        best = &chord;
      }
      if (worth == 2.0) break;
    }
    const Halves halves = halves_of(loop, *best);
    for (const Loop* half : {&halves.first, &halves.second}) {
      const std::optional<glm::dvec2> from = seen_from(*half);
      if (from) {
        made_.parts.push_back({*half, *from});
      } else if (!divide(*half)) {
        return false;
      }
    }
    return true;
  }

  CutRegion made_;
  std::vector<Line> lines_;
};

}  // namespace

bool do_cross(std::span<const glm::dvec2> a, std::span<const glm::dvec2> b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    breathe(b.size());
    for (std::size_t k = 0; k < b.size(); ++k) {
      if (do_touch(a[i], a[(i + 1) % a.size()], b[k], b[(k + 1) % b.size()])) return true;
    }
  }
  return false;
}

std::optional<CutRegion> cut_into_seen(std::vector<RegionSide> sides, std::span<const std::size_t> counts) {
  return RegionCutter(std::move(sides)).cut(counts);
}

}  // namespace splinecore
