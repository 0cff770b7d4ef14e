#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "patch_march.hpp"
#include "patch_part.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Curves, by places on them that are close to each other.
class BeadStrings {
 public:
  /// A place of a curve, and how the surfaces part across it.
  struct Bead {
    glm::dvec3 point;
    double bend;
  };

  void add(const TwoPatches& patches, const SectionTrace& trace);
  bool empty() const noexcept { return strings_.empty(); }
  const Bead* nearest(const glm::dvec3& point, double& distance) const;
  bool is_near(const glm::dvec3& point, double distance) const;

 private:
  std::vector<std::vector<Bead>> strings_;
};

/// The curves along which two patches touch, and the borders of what they have in common, found as pairs of parts are asked
/// about.
class TouchingCurves {
 public:
  TouchingCurves(const TwoPatches& patches, double tolerance) : patches_(patches), tolerance_(tolerance) {}

  /// Whether all that two parts may have in common is known: a curve along which they touch, from which they part as two
  /// surfaces do that touch once, or they are one.
  bool knows(const PatchPart& a, const PatchPart& b);

  /// Whether all about a place is known already.
  std::function<bool(const PatchSpots&)> is_known_place;

  /// Whether patches are known to cross along a border at a point.
  std::function<bool(const glm::dvec3&)> is_crossing;

  /// Takes a border of what is known to be one. is_whole: whether all borders that it goes on in are known, too.
  void add_border(SectionTrace trace, bool is_whole = false);

  /// Where a border leaves the other patch, the border of that goes on: after all parts are asked about.
  void follow_borders();

  /// Whether a place where they cross is so near to a curve along which they touch that within the tolerance they touch there.
  bool runs_by(const SectionPlace& place) const;

  const std::vector<SectionTrace>& traces() const noexcept { return traces_; }
  bool are_one() const noexcept { return are_one_; }

  /// A place at which the border of what they have in common was lost, and where no other part of it goes by.
  std::optional<glm::dvec3> lost_border() const;

  const std::vector<SectionTrace>& borders() const noexcept { return borders_; }

  /// Whether they touch at a place, or a border of what they have in common is there.
  bool is_near(const glm::dvec3& point, double distance) const {
    return beads_.is_near(point, distance) || border_beads_.is_near(point, distance);
  }

 private:
  /// How a part lies that is within the tolerance of another one, as far as places all over it tell.
  struct Nearness {
    bool is_inside;  ///< a place of it is in the other one, not only on how that goes on
    double gap;      ///< how far it is from the other one at most
  };

  /// Where a border was begun and no step of it was found.
  struct LostBorder {
    glm::dvec3 point;
    std::optional<std::size_t> from;  ///< the border at whose end that is
  };

  template <class Look>
  bool for_feet(const PatchPart& a, const PatchPart& b, Look look) const;
  bool is_explained(const PatchPart& a, const PatchPart& b) const;
  std::optional<Nearness> nearness(const PatchPart& a, const PatchPart& b) const;
  bool is_explained(const glm::dvec3& point, double gap) const;
  bool is_one(const PatchPart& a, const PatchPart& b) const;
  std::optional<PatchSpots> touch_of_parts(const PatchPart& a, const PatchPart& b) const;
  bool find_near(const PatchPart& a, const PatchPart& b);
  bool ends_well(const SectionTrace& trace) const;
  void find_borders(const PatchPart& a, const PatchPart& b);
  void find_borders_of(const PatchPart& part, const PatchPart& other, bool is_a);
  void find_border(const PatchSpots& at, const OnFace& border);
  std::optional<SectionTrace> traced_border(const PatchSpots& at, const OnFace& border) const;
  std::vector<SectionTrace> without_crossings(SectionTrace trace) const;
  void keep_border(std::optional<SectionTrace> trace, std::optional<std::size_t> from);
  double near_border() const;
  std::vector<OnFace> borders_at(const PatchSpots& at) const;
  bool is_new(const SectionTrace& trace) const;

  TwoPatches patches_;
  double tolerance_;
  std::vector<SectionTrace> traces_;
  std::vector<SectionTrace> borders_;
  std::vector<bool> whole_;  ///< of borders
  std::vector<LostBorder> lost_;
  bool are_one_ = false;
  BeadStrings beads_;
  BeadStrings border_beads_;
  BeadStrings no_curves_;
};

}  // namespace splinecore
#pragma GCC visibility pop
