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

NearSpace space_of(std::span<const RimSide> rim) {
  std::vector<glm::dvec4> all;
  for (const RimSide& side : rim) all.insert(all.end(), side.curve.points().begin(), side.curve.points().end());
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
  RimPlane plane{glm::dvec3(0.0), {}, {}, glm::dvec3(0.0)};
  for (const glm::dvec3& p : places) plane.origin += p / static_cast<double>(places.size());
  double size = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::dvec3 from = places[i] - plane.origin;
    plane.normal += glm::cross(from, places[(i + 1) % places.size()] - plane.origin);
    size = std::max(size, length_of(from));
  }
  const double area = length_of(plane.normal);
  if (!(area > kNothing * size * size)) throw InvalidShape("the rim encloses next to nothing");
  plane.normal /= area;
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

glm::dvec3 start_of(const RimSide& side) {
  const double at = side.is_reversed ? side.curve.domain().end : side.curve.domain().start;
  glm::dvec3 point;
  evaluate(side.curve, {&at, 1}, {&point.x, 3}, {.side = side.is_reversed ? Side::left : Side::right});
  return point;
}

}  // namespace

std::array<glm::dvec3, 2> end_points(const NurbsCurve& curve) { return {start_of({curve, false}), start_of({curve, true})}; }

bool is_segment(const NurbsCurve& curve) { return curve.degree() == 1 && curve.points().size() == 2; }

std::optional<FilledRim> filled_rim(std::span<const RimSide> rim) {
  constexpr double kFlat = 0x1p-40;
  const NearSpace space = space_of(rim);
  std::vector<RimPieces> sides;
  for (const RimSide& side : rim) sides.push_back(pieces_of(side, space));
  require_whole(sides);
  const RimPlane plane = plane_of(sides);
  std::vector<RegionSide> region;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    RegionSide side{{}, i, (i + 1) % sides.size()};
    for (const auto& piece : sides[i]) {
      side.pieces.emplace_back();
      for (const glm::dvec4& p : piece) side.pieces.back().push_back(plane.seen(p));
    }
    region.push_back(std::move(side));
  }
  const std::optional<CutRegion> cut = cut_into_seen(std::move(region));
  if (!cut) return {};
  std::vector<glm::dvec3> corners;
  for (const RimSide& side : rim) corners.push_back(start_of(side));
  FilledRim made;
  for (const SeenPart& part : cut->parts) {
    const glm::dvec3 point = space.leave(plane.at(part.from));
    for (const PartSide& one : part.sides) {
      const RegionSide& side = cut->sides[one.side];
      const bool is_own = one.side < rim.size();
      made.patches.push_back(is_own ? fan(rim[one.side].curve, point, rim[one.side].is_reversed)
                                    : fan(segment(corners[side.from], corners[side.to]), point, one.is_reversed));
    }
  }
  const double bend = bend_of(sides, plane);
  made.bend = bend <= kFlat + space.rounding() ? 0.0 : space.length(bend);
  return made;
}

std::vector<RimOrder> rim_order(std::span<const NurbsCurve> sides) {
  constexpr double kSame = 1e-9;
  if (sides.empty()) throw InvalidShape("there is no side");
  std::vector<glm::dvec4> all;
  for (const NurbsCurve& side : sides) all.insert(all.end(), side.points().begin(), side.points().end());
  const double same = kSame * NearSpace(all).length(1.0);
  std::vector<RimOrder> order{{0, false}};
  std::vector<bool> is_taken(sides.size(), false);
  is_taken[0] = true;
  const glm::dvec3 first = end_points(sides[0])[0];
  glm::dvec3 at = end_points(sides[0])[1];
  while (order.size() < sides.size()) {
    std::optional<RimOrder> next;
    double least = same;
    for (std::size_t i = 0; i < sides.size(); ++i) {
      for (const bool is_reversed : {false, true}) {
        const double apart = is_taken[i] ? same : distance_of(end_points(sides[i])[is_reversed], at);
        if (apart < least) {
          least = apart;
          next = RimOrder{i, is_reversed};
        }
      }
    }
    if (!next) throw InvalidShape("the sides do not go round: side " + std::to_string(order.back().side) + " ends where no other one does");
    is_taken[next->side] = true;
    at = end_points(sides[next->side])[!next->is_reversed];
    order.push_back(*next);
  }
  if (!(distance_of(at, first) <= same)) throw InvalidShape("the sides do not go round: they end elsewhere than they begin");
  return order;
}

}  // namespace splinecore
