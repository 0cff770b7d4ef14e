#pragma once

#include <string>
#include <vector>

#include "rolling_ball.hpp"
#include "splinecore/basis/knot_vector.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The degree that fits of curves along an edge have at least.
inline constexpr int kSmooth = 3;

/// Knots inside the domain, each once, and of a periodic one its start.
std::vector<double> inner_knots(const KnotVector& knots);

/// These, but for those that are as often as the degree: inserted, they make splines one derivative less smooth there.
std::vector<double> softened(const KnotVector& knots);

/// A share of an edge, for sentences.
std::string share_text(double share);

/// The same patch of a higher degree along u, and with more knots, so that these are those wanted.
NurbsPatch on_knots(const NurbsPatch& patch, const KnotVector& wanted);

/// What is left of two patches, v_start of both at the fillet, u along it over [0, 1], and the fillet between.
struct FilletBetween {
  NurbsPatch first;
  NurbsPatch fillet;
  NurbsPatch second;
  double error;  ///< how far the fillet was found to be from where it should be
};

/// The fillet of arcs whose sides are the sides of what is left of two patches, to the last bit, and on the same knots: these are
/// made of one degree along u, with the knots of each other, and with as many more as the arcs between them need.
/// @param first  what is left of the patches, at the same u of which the ball touches them
/// @throws ToleranceNotReached if 2^14 control points along do not come within the tolerance
FilletBetween fillet_of_arcs(const NurbsPatch& first, const NurbsPatch& second, const RollingBall& ball, double tolerance);

/// The same where the ball touches both at different u: the fillet goes across from one u of the first to the same of the second,
/// over several positions of the ball, so that it ends with both.
/// @throws ToleranceNotReached as fitted_patch()
FilletBetween slanted_fillet(const NurbsPatch& first, const NurbsPatch& second, const RollingBall& ball, double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
