#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// Which places closed curves enclose, by how often all together run around them.
enum class FillRule { even_odd, nonzero };

/// Places in two regions, or in one of them.
enum class RegionOperation { united, common, without, in_one };

/// A part of a plane within closed curves: outer borders and borders of holes, in any number; none of an empty one.
///
/// Seen against the normal the region lies to the left of all of them. They do not cross; they may touch each other at points.
class Region {
 public:
  /// What closed curves of one plane enclose. Those that cross or touch themselves or each other, or run along each other, are cut
  /// there and put together again, of parts of them; others stay as they are, turned where they run the wrong way.
  /// @param normal     of the plane; none: that of the curves, towards +z
  /// @param tolerance  places so near are one; none: 2^-33 of how far all control points reach from their middle
  /// @throws InvalidShape naming a curve that is open, not in the plane, or encloses nothing; and as combined()
  static Region of(std::span<const NurbsCurve> curves, std::optional<glm::dvec3> normal = {}, FillRule rule = FillRule::even_odd,
                   std::optional<double> tolerance = {});

  /// Of outlines as outlines() gives them: that they do not cross is taken for granted.
  /// @throws InvalidShape naming one that is open or not in the plane, or if the normal is zero
  static Region of_outlines(std::vector<NurbsCurve> outlines, const glm::dvec3& normal);

  bool is_empty() const noexcept { return outlines_.empty(); }
  const glm::dvec3& normal() const noexcept { return normal_; }
  const std::vector<NurbsCurve>& outlines() const noexcept { return outlines_; }

  friend bool operator==(const Region&, const Region&) = default;
  friend Region combined(const Region& a, const Region& b, RegionOperation operation, std::optional<double> tolerance);

 private:
  Region(std::vector<NurbsCurve> outlines, const glm::dvec3& normal);

  std::vector<NurbsCurve> outlines_;
  glm::dvec3 normal_;
};

/// The union, the intersection, the difference or the symmetric difference of two regions of one plane; that of the first one gives
/// the normal, unless it is empty. Outlines are exact: parts of those given, that end where these meet.
///
/// Outlines are cut where they meet. Of every part, and of those that lie on each other as one, windings of both regions on either
/// side tell whether it bounds the result; around a place where several meet they follow each other as they are turned.
/// @throws InvalidShape if the regions are not in one plane, or outlines run along each other so that the tolerance does not tell
///         what lies between them; and as intersections()
Region combined(const Region& a, const Region& b, RegionOperation operation, std::optional<double> tolerance = {});

/// The image of a region under an affine map. Its outlines keep their directions; of a mirrored one the normal points the other way.
/// @throws InvalidShape if the map is not affine, or flattens the region
Region transformed(const Region& region, const glm::dmat4& matrix);

/// Whether points, seen against the normal, are in a region or on its border.
std::vector<bool> contains(const Region& region, std::span<const glm::dvec3> points);

}  // namespace splinecore
