#pragma once

#include <optional>
#include <vector>

#include "hole.hpp"
#include "hole_guide.hpp"
#include "seen_filling.hpp"
#include "star.hpp"
#include "star_rows.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A place of the parameters of patches at which a side is less smooth, and how often its knot is needed for that.
struct SideKnot {
  double at;
  int copies;
};

/// The knots of patches that fill a hole, of degree 5, or 7 where curvatures are to agree.
class StarKnots {
 public:
  explicit StarKnots(const Hole& hole);

  /// Each stretch between inner knots of sides in so many spans.
  KnotVector with(int spans) const;

  /// Whether so many are as many as there may be: for smaller angles, or at all.
  bool are_all(int spans) const;
  bool are_most(int spans) const;

 private:
  int degree_;
  std::vector<SideKnot> inner_;  ///< of all sides; none where patches had more than 2^21 control points for them
};

/// Patches that fill a hole, and what of their control points its sides decide.
struct ClaimedStar {
  Star star;
  std::vector<std::optional<glm::dvec3>> points;

  /// With the others at the origin.
  std::vector<NurbsPatch> patches() const;
};

ClaimedStar claimed_star(const Hole& hole, const KnotVector& knots);

/// With the others where patches bend least, but for what is expected of them.
/// @param guide  what is expected, if any
std::vector<NurbsPatch> solved(const Hole& hole, const ClaimedStar& claimed, const HoleGuide* guide);

}  // namespace splinecore
#pragma GCC visibility pop
