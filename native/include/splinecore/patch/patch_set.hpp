#pragma once

#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "splinecore/patch/bezier_patch.hpp"
#include "splinecore/patch/hermite_patch.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

enum class PatchKind { bezier, hermite, nurbs };

/// A patch whose numbers lie in a pool of points that it shares with its neighbors.
struct IndexedPatch {
  PatchKind kind = PatchKind::bezier;
  /// Points in each direction.
  int count_u = 0;
  int count_v = 0;
  /// Rows of the pool, row after row of count_v. A Hermite patch has four nets one after the
  /// other: points, tangents along u, tangents along v, twists.
  std::vector<int> indices;
  /// NURBS only.
  int degree_u = 0;
  int degree_v = 0;
  bool periodic_u = false;
  bool periodic_v = false;
  /// Knots of NURBS, parameters of Hermite, empty for Bezier.
  std::vector<double> knots_u;
  std::vector<double> knots_v;

  friend bool operator==(const IndexedPatch&, const IndexedPatch&) = default;
};

using AnyPatch = std::variant<BezierPatch, HermitePatch, NurbsPatch>;

/// The NURBS form of any patch.
const NurbsPatch& nurbs_of(const AnyPatch& patch) noexcept;

/// Many patches on one pool of points (x, y, z, w); tangents and twists are rows with w = 0.
class PatchSet {
 public:
  /// @throws InvalidShape if there is no patch, an index is outside the pool, or a patch is not
  ///         valid; the message begins with the patch.
  static PatchSet make(std::vector<glm::dvec4> points, std::vector<IndexedPatch> patches);

  /// A pool made of the patches' own points. Points equal in every bit become one where `merged`.
  static PatchSet of(std::span<const AnyPatch> patches, bool merged);

  /// The same patches on another pool: they keep their knot vectors, and those of which no point changed are shared.
  /// @throws InvalidShape as make().
  PatchSet with_points(std::vector<glm::dvec4> points) const;

  std::span<const glm::dvec4> points() const noexcept { return points_; }
  std::span<const IndexedPatch> patches() const noexcept { return *patches_; }
  const AnyPatch& patch(std::size_t i) const noexcept { return *values_[i]; }

  /// What all sets have in common that with_points() made of one: equal pointers, the same patches.
  const std::shared_ptr<const std::vector<IndexedPatch>>& topology() const noexcept { return patches_; }

  friend bool operator==(const PatchSet& a, const PatchSet& b) noexcept {
    return a.points_ == b.points_ && (a.patches_ == b.patches_ || *a.patches_ == *b.patches_);
  }

 private:
  PatchSet() = default;

  std::vector<glm::dvec4> points_;
  std::shared_ptr<const std::vector<IndexedPatch>> patches_;
  std::vector<std::shared_ptr<const AnyPatch>> values_;
};

/// All patches seen from the other side: u and v exchanged, the pool unchanged.
PatchSet flipped(const PatchSet& set);

}  // namespace splinecore
