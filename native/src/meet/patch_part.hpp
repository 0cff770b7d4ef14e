#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "basis/bernstein_net.hpp"
#include "curve_part.hpp"
#include "splinecore/base/interval.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A unit vector, and the largest angle of others with it, above pi/2 where that is not known.
struct VectorCone {
  glm::dvec3 along{0.0, 0.0, 1.0};
  double spread = std::numbers::pi;
};

/// A part of a Bernstein piece of a patch, and what its hull says of it.
struct PatchPart {
  std::size_t piece;
  std::array<Interval, 2> range;  ///< in [0, 1]²
  BernsteinNet<glm::dvec4> net;
  bool is_boxed;                   ///< or its weights have both signs, and nothing below is known
  std::array<double, 2> size;      ///< no line along u, or v, is longer
  std::vector<glm::dvec3> points;  ///< the net projected

  PatchPart(std::size_t of_piece, const std::array<Interval, 2>& of_range, BernsteinNet<glm::dvec4> given);

  /// Of all normals.
  const VectorCone& normals() const {
    if (!normals_) normals_ = normal_cone();
    return *normals_;
  }

  /// Of all derivatives along an axis.
  const VectorCone& tangents(Axis axis) const {
    std::optional<VectorCone>& cone = tangents_[axis == Axis::u ? 0 : 1];
    if (!cone) cone = tangent_cone(axis);
    return *cone;
  }

  /// Halves along the longer direction.
  std::pair<PatchPart, PatchPart> halves() const;
  std::pair<PatchPart, PatchPart> halves(Axis axis) const;

  /// What lies within a range of an axis.
  PatchPart within(Axis axis, const Interval& kept) const;

  double largest_size() const noexcept { return size[0] > size[1] ? size[0] : size[1]; }
  std::array<double, 2> middle() const noexcept { return {range[0].middle(), range[1].middle()}; }

 private:
  VectorCone normal_cone() const;
  VectorCone tangent_cone(Axis axis) const;

  mutable std::optional<VectorCone> normals_;  ///< for most parts nobody asks
  mutable std::array<std::optional<VectorCone>, 2> tangents_;
};

/// A part of a piece of a patch.
PatchPart part_of(std::size_t piece, const BernsteinNet<glm::dvec4>& net, const std::array<Interval, 2>& range);

/// Whether hulls are farther apart than that, as seen along some axes of both. Of a part that runs through infinity the hull
/// is what lies outside of a slab about the other one.
bool are_apart(const PatchPart& a, const PatchPart& b, double distance);
bool are_apart(const CurvePart& a, const PatchPart& b, double distance);

/// The same, seen along what is at right angles to an edge of each, too: of flat parts it is so just where they are apart
/// (the separating axes of polygons).
bool are_edges_apart(const PatchPart& a, const PatchPart& b, double distance);

/// Whether no normal of one is parallel to one of the other, by a margin: then they meet in one line at most, which goes
/// one way.
bool do_normals_differ(const PatchPart& a, const PatchPart& b, double rounding);

/// Whether no tangent of a curve is parallel to a tangent plane, by a margin: then they meet once at most.
bool goes_through(const CurvePart& a, const PatchPart& b);

}  // namespace splinecore
#pragma GCC visibility pop
