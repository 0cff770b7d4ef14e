#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "basis/bernstein_net.hpp"
#include "patch_part.hpp"
#include "section_place.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A line of knots in a plane, where the patch goes through it or touches it.
struct LevelLine {
  SectionTrace trace;
  bool is_crossing;
};

/// The Bernstein pieces of a patch that lie in a plane: what both have in common, up to their sides. Where the patch parts from the plane
/// smoothly no angle tells beyond which knots they have nothing in common any more; control points do: the height of a piece beside is a
/// power of the parameter from there on times a polynomial, which is zero nowhere if its coefficients have one sign.
class LevelPieces {
 public:
  /// @param patches   the patch, and one flat piece that reaches beyond it
  /// @param rounding  heights below are none
  LevelPieces(const TwoPatches& patches, double rounding);

  /// Whether there are such pieces.
  bool any() const noexcept { return !heights_.empty(); }

  /// Whether it is known of all pieces beside them what these have in common with the plane. If not, borders() alone knows anything.
  bool are_told() const noexcept { return !is_told_.empty(); }

  /// Whether a part of the patch has nothing in common with the plane but such pieces and lines().
  bool explains(const PatchPart& part) const { return are_told() && is_told_[part.piece]; }

  /// Sides of such pieces beyond which there is none, but for those that is_known is true of all along.
  std::vector<SectionTrace> borders(double tolerance, const std::function<bool(const glm::dvec3&)>& is_known) const;

  /// Sides in the plane between other pieces, of which explains() is asked.
  std::vector<LevelLine> lines(double tolerance) const;

 private:
  bool is_in_plane(std::size_t piece) const;
  BernsteinNet<double> heights_of(std::size_t piece) const;
  bool is_met_by_sides_alone(std::size_t piece) const;
  bool is_level(std::optional<std::size_t> piece) const { return piece && level_[*piece]; }
  bool is_level_at_corner(std::size_t piece, bool is_end_u, bool is_end_v) const;
  bool is_beside_level(std::size_t piece) const;
  bool is_border(std::size_t piece, const PieceSide& side) const;
  glm::dvec3 point_on(std::size_t piece, const PieceSide& side, double share) const;
  int sign_beside(std::size_t piece, const PieceSide& side) const;
  int line_at(std::size_t piece, const PieceSide& side) const;
  template <class IsThere>
  std::vector<SectionTrace> sides(const PieceSide& side, double tolerance, IsThere is_there) const;
  void add_side(SectionTrace& trace, std::size_t piece, const PieceSide& side, double tolerance) const;

  TwoPatches patches_;
  double rounding_;
  glm::dvec3 origin_;
  glm::dvec3 normal_;
  std::vector<bool> level_;
  std::vector<BernsteinNet<double>> heights_;
  std::vector<bool> is_told_;
};

}  // namespace splinecore
#pragma GCC visibility pop
