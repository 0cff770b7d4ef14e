#include "rim_region.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "base/length.hpp"
#include "curve/bezier_piece.hpp"
#include "meet/near_space.hpp"
#include "plane_region.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/build/sweeps.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

NearSpace space_of(std::span<const RimLoop> loops) {
  std::vector<glm::dvec4> all;
  for (const RimLoop& loop : loops) {
    for (const RimSide& side : loop) all.insert(all.end(), side.curve.points().begin(), side.curve.points().end());
  }
  return NearSpace(all);
}

/// Homogeneous Bezier pieces of a side in a space near it, as it is run.
using RimPieces = std::vector<std::vector<glm::dvec4>>;

RimPieces pieces_of(const RimSide& side, const NearSpace& space) {
  const NurbsCurve near = side.curve.with_points(space.enter(side.curve.points()));
  RimPieces pieces;
  for (int i = 0; i < static_cast<int>(near.knot_vector().spans().size()); ++i) {
    pieces.push_back(bezier_piece(near, i).values);
    for (const glm::dvec4& p : pieces.back()) {
      if (!(p.w > 0.0)) throw InvalidShape("the rim has a weight that is not positive: nothing can be said of what lies within it");
    }
    if (side.is_reversed) std::ranges::reverse(pieces.back());
  }
  if (side.is_reversed) std::ranges::reverse(pieces);
  return pieces;
}

/// @throws InvalidShape if a piece begins elsewhere than the one before it ends
void require_whole(const std::vector<RimPieces>& sides) {
  constexpr double kSame = 1e-9;
  const auto place = [](const glm::dvec4& p) { return glm::dvec3(p) / p.w; };
  glm::dvec3 at = place(sides.back().back().back());
  for (const RimPieces& pieces : sides) {
    for (const auto& piece : pieces) {
      if (!(distance_of(place(piece.front()), at) <= kSame)) throw InvalidShape("the rim is not closed: there is a gap in it");
      at = place(piece.back());
    }
  }
}

/// The plane that a rim lies in, or over.
struct RimPlane {
  glm::dvec3 origin;
  glm::dvec3 x;
  glm::dvec3 y;
  glm::dvec3 normal;
  double area;  ///< twice of what the rim encloses

  glm::dvec3 seen(const glm::dvec4& p) const {
    const glm::dvec3 from = glm::dvec3(p) - p.w * origin;
    return {glm::dot(from, x), glm::dot(from, y), p.w};
  }
  glm::dvec3 at(const glm::dvec2& p) const { return origin + p.x * x + p.y * y; }
};

std::vector<glm::dvec3> places_along(const std::vector<RimPieces>& sides) {
  std::vector<glm::dvec3> places;
  for (const RimPieces& pieces : sides) {
    for (const auto& piece : pieces) {
      const int steps = piece.size() == 2 ? 1 : 4 * static_cast<int>(piece.size());
      for (int k = 0; k < steps; ++k) {
        const double t = static_cast<double>(k) / steps;
        std::vector<glm::dvec4> points = piece;
        for (std::size_t left = points.size(); left > 1; --left) {
          for (std::size_t i = 0; i + 1 < left; ++i) points[i] += t * (points[i + 1] - points[i]);
        }
        places.push_back(glm::dvec3(points[0]) / points[0].w);
      }
    }
  }
  return places;
}

RimPlane plane_of(const std::vector<RimPieces>& sides) {
  constexpr double kNothing = 1e-12;
  const std::vector<glm::dvec3> places = places_along(sides);
  RimPlane plane{glm::dvec3(0.0), {}, {}, glm::dvec3(0.0), 0.0};
  for (const glm::dvec3& p : places) plane.origin += p / static_cast<double>(places.size());
  double size = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::dvec3 from = places[i] - plane.origin;
    plane.normal += glm::cross(from, places[(i + 1) % places.size()] - plane.origin);
    size = std::max(size, length_of(from));
  }
  plane.area = length_of(plane.normal);
  if (!(plane.area > kNothing * size * size)) throw InvalidShape("the rim encloses almost no area");
  plane.normal /= plane.area;
  int least = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (std::abs(plane.normal[axis]) < std::abs(plane.normal[least])) least = axis;
  }
  glm::dvec3 across(0.0);
  across[least] = 1.0;
  plane.x = glm::normalize(glm::cross(across, plane.normal));
  plane.y = glm::cross(plane.normal, plane.x);
  return plane;
}

double bend_of(const std::vector<RimPieces>& sides, const RimPlane& plane) {
  double bend = 0.0;
  for (const RimPieces& pieces : sides) {
    for (const auto& piece : pieces) {
      for (const glm::dvec4& p : piece) {
        bend = std::max(bend, std::abs(glm::dot(glm::dvec3(p) / p.w - plane.origin, plane.normal)));
      }
    }
  }
  return bend;
}

/// From a side, as it is given, to a point; turned so that it faces as the rim does.
NurbsPatch fan(const NurbsCurve& side, const glm::dvec3& point, bool is_against) {
  std::vector<glm::dvec4> tip;
  for (const glm::dvec4& p : side.points()) tip.emplace_back(point, p.w);
  const NurbsPatch patch = ruled(side, side.with_points(std::move(tip)));
  return is_against ? reversed(patch, Axis::u) : patch;
}

NurbsCurve segment(const glm::dvec3& a, const glm::dvec3& b) {
  return NurbsCurve::make(KnotVector::bezier(1), {glm::dvec4(a, 1.0), glm::dvec4(b, 1.0)});
}

RimPlane widest_plane(const std::vector<std::vector<RimPieces>>& loops) {
  std::vector<RimPlane> planes;
  for (const auto& sides : loops) planes.push_back(plane_of(sides));
  return *std::ranges::max_element(planes, {}, &RimPlane::area);
}

/// A loop as it is seen against a plane: its sides in homogeneous Bezier pieces, and places along it.
struct FlatLoop {
  std::vector<std::vector<std::vector<glm::dvec3>>> sides;
  std::vector<glm::dvec2> line;
  double area;
};

FlatLoop flat_loop(const std::vector<RimPieces>& sides, const RimPlane& plane) {
  FlatLoop flat{{}, {}, 0.0};
  for (const RimPieces& pieces : sides) {
    flat.sides.emplace_back();
    for (const auto& piece : pieces) {
      flat.sides.back().emplace_back();
      for (const glm::dvec4& p : piece) flat.sides.back().back().push_back(plane.seen(p));
    }
  }
  for (const glm::dvec3& place : places_along(sides)) flat.line.emplace_back(plane.seen(glm::dvec4(place, 1.0)));
  for (std::size_t i = 0; i < flat.line.size(); ++i) {
    const glm::dvec2 from = flat.line[i] - flat.line[0];
    const glm::dvec2 to = flat.line[(i + 1) % flat.line.size()] - flat.line[0];
    flat.area += 0.5 * (from.x * to.y - from.y * to.x);
  }
  return flat;
}

/// Whether a loop lies within another one, as far as its first place says.
bool is_within(const FlatLoop& inner, const FlatLoop& outer) {
  const glm::dvec2 p = inner.line[0];
  bool is_odd = false;
  for (std::size_t i = 0; i < outer.line.size(); ++i) {
    const glm::dvec2& c = outer.line[i];
    const glm::dvec2& d = outer.line[(i + 1) % outer.line.size()];
    if ((c.y > p.y) != (d.y > p.y) && p.x < c.x + (p.y - c.y) / (d.y - c.y) * (d.x - c.x)) is_odd = !is_odd;
  }
  return is_odd && std::abs(inner.area) < std::abs(outer.area);
}

/// In how many others each loop lies.
std::vector<int> depths_of(const std::vector<FlatLoop>& loops) {
  std::vector<int> depths;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    int depth = 0;
    for (std::size_t k = 0; k < loops.size(); ++k) depth += i != k && is_within(loops[i], loops[k]);
    depths.push_back(depth);
  }
  return depths;
}

glm::dvec3 start_of(const RimSide& side) {
  const double at = side.is_reversed ? side.curve.domain().end : side.curve.domain().start;
  glm::dvec3 point;
  evaluate(side.curve, {&at, 1}, {&point.x, 3}, {.side = side.is_reversed ? Side::left : Side::right});
  return point;
}

/// A loop run the other way.
void turn(RimLoop& loop, FlatLoop& flat) {
  std::ranges::reverse(loop);
  for (RimSide& side : loop) side.is_reversed = !side.is_reversed;
  std::ranges::reverse(flat.sides);
  for (auto& pieces : flat.sides) {
    std::ranges::reverse(pieces);
    for (auto& piece : pieces) std::ranges::reverse(piece);
  }
}

/// Patches within the first of some loops and outside of the others.
std::optional<std::vector<NurbsPatch>> filled_region(std::span<const RimLoop> loops, std::span<const std::size_t> own,
                                                     const std::vector<bool>& is_turned, const std::vector<FlatLoop>& flat,
                                                     const RimPlane& plane, const NearSpace& space) {
  RimLoop rim;
  std::vector<RegionSide> region;
  std::vector<std::size_t> counts;
  for (const std::size_t i : own) {
    RimLoop loop = loops[i];
    FlatLoop sides = flat[i];
    if (is_turned[i]) turn(loop, sides);
    const std::size_t first = rim.size();
    for (std::size_t k = 0; k < loop.size(); ++k) {
      region.push_back({std::move(sides.sides[k]), first + k, first + (k + 1) % loop.size()});
    }
    rim.insert(rim.end(), loop.begin(), loop.end());
    counts.push_back(loop.size());
  }
  const std::optional<CutRegion> cut = cut_into_seen(std::move(region), counts);
  if (!cut) return {};
  std::vector<glm::dvec3> corners;
  for (const RimSide& side : rim) corners.push_back(start_of(side));
  std::vector<NurbsPatch> made;
  for (const SeenPart& part : cut->parts) {
    const glm::dvec3 point = space.leave(plane.at(part.from));
    for (const PartSide& one : part.sides) {
      const RegionSide& side = cut->sides[one.side];
      const bool is_own = one.side < rim.size();
      made.push_back(is_own ? fan(rim[one.side].curve, point, rim[one.side].is_reversed)
                            : fan(segment(corners[side.from], corners[side.to]), point, one.is_reversed));
    }
  }
  return made;
}

}  // namespace

std::array<glm::dvec3, 2> end_points(const NurbsCurve& curve) { return {start_of({curve, false}), start_of({curve, true})}; }

bool is_segment(const NurbsCurve& curve) { return curve.degree() == 1 && curve.points().size() == 2; }

std::optional<FilledRim> filled_rim(std::span<const RimLoop> loops) {
  constexpr double kFlat = 0x1p-40;
  const NearSpace space = space_of(loops);
  std::vector<std::vector<RimPieces>> pieces;
  for (const RimLoop& loop : loops) {
    pieces.emplace_back();
    for (const RimSide& side : loop) pieces.back().push_back(pieces_of(side, space));
    require_whole(pieces.back());
  }
  const RimPlane plane = widest_plane(pieces);
  std::vector<FlatLoop> flat;
  for (const auto& sides : pieces) flat.push_back(flat_loop(sides, plane));
  for (std::size_t i = 0; i < flat.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (do_cross(flat[i].line, flat[k].line)) return {};
    }
  }
  FilledRim made{{}, {}, 0.0};
  const std::vector<int> depths = depths_of(flat);
  for (std::size_t i = 0; i < loops.size(); ++i) made.is_turned.push_back((flat[i].area > 0.0) != (depths[i] % 2 == 0));
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (depths[i] % 2 == 1) continue;
    FilledRegion region{{i}, {}};
    for (std::size_t k = 0; k < loops.size(); ++k) {
      if (depths[k] == depths[i] + 1 && is_within(flat[k], flat[i])) region.loops.push_back(k);
    }
    auto patches = filled_region(loops, region.loops, made.is_turned, flat, plane, space);
    if (!patches) return {};
    region.patches = std::move(*patches);
    made.regions.push_back(std::move(region));
  }
  double bend = 0.0;
  for (const auto& sides : pieces) bend = std::max(bend, bend_of(sides, plane));
  made.bend = bend <= kFlat + space.rounding() ? 0.0 : space.length(bend);
  return made;
}

std::vector<std::vector<RimOrder>> rim_orders(std::span<const NurbsCurve> sides) {
  constexpr double kSame = 1e-9;
  if (sides.empty()) throw InvalidShape("there is no side");
  std::vector<glm::dvec4> all;
  for (const NurbsCurve& side : sides) all.insert(all.end(), side.points().begin(), side.points().end());
  const double same = kSame * NearSpace(all).length(1.0);
  std::vector<std::array<glm::dvec3, 2>> ends;
  for (const NurbsCurve& side : sides) ends.push_back(end_points(side));
  std::vector<bool> is_taken(sides.size(), false);
  std::vector<std::vector<RimOrder>> orders;
  for (std::size_t first = 0; first < sides.size(); ++first) {
    if (is_taken[first]) continue;
    std::vector<RimOrder> order{{first, false}};
    is_taken[first] = true;
    glm::dvec3 at = ends[first][1];
    while (!(distance_of(at, ends[first][0]) <= same)) {
      std::optional<RimOrder> next;
      double least = same;
      for (std::size_t i = 0; i < sides.size(); ++i) {
        for (const bool is_reversed : {false, true}) {
          const double apart = is_taken[i] ? same : distance_of(ends[i][is_reversed], at);
          if (apart < least) {
            least = apart;
            next = RimOrder{i, is_reversed};
          }
        }
      }
      if (!next) throw InvalidShape("the sides do not form a loop: side " + std::to_string(order.back().side) + " ends where no other one does");
      is_taken[next->side] = true;
      at = ends[next->side][!next->is_reversed];
      order.push_back(*next);
    }
    orders.push_back(std::move(order));
  }
  return orders;
}

}  // namespace splinecore
