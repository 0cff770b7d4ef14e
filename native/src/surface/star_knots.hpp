#pragma once

#include <cstddef>
#include <vector>

#include "hole.hpp"
#include "seen_filling.hpp"
#include "star.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A place of the parameters of patches at which a side is less smooth, and how often its knot is needed for that.
struct SideKnot {
  double at;
  int copies;
};

/// The knots of patches that fill a hole, of degree 5, or 7 where curvatures are to agree: along each spoke those of the two
/// parts of sides that run beside it, and of one patch along either direction those of two sides.
class StarKnots {
 public:
  explicit StarKnots(const Hole& hole);

  /// Each stretch between inner knots of sides in spans so short that as many would make the whole.
  std::vector<KnotPair> with(int spans) const;

  /// The same, and in these each span halved as often as lets polynomials on it come within a tolerance of the sides: steep
  /// weights want short spans in few places.
  std::vector<KnotPair> graded(const Hole& hole, int spans, double tolerance) const;

  /// Whether so many are as many as there may be.
  bool are_all(int spans) const;

 private:
  /// Which of inner_ those of a patch are.
  std::size_t run_of(std::size_t patch, Axis axis) const;
  KnotVector of_run(std::size_t run, int spans) const;
  std::vector<KnotPair> pairs_of(const std::vector<KnotVector>& runs) const;
  std::size_t points() const;

  int degree_;
  std::size_t patches_;
  std::vector<std::vector<SideKnot>> inner_;  ///< of sides along each run; none where patches had more than 2^21 control points for them
};

}  // namespace splinecore
#pragma GCC visibility pop
