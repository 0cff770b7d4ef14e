#pragma once

#include <optional>

#include "splinecore/patch/isocurve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// What two patches share where one continues the other: the points of the edge; the tangent planes, too; the
/// first derivatives across; the curvatures; the first two derivatives.
enum class PatchSmoothness { c0, g1, c1, g2, c2 };

/// Which of two patches gives way.
enum class JoinMoves { second, first, both };

/// Two patches with a common edge: equal points and weights along it, in the same or in the opposite order.
struct PatchJoin {
  NurbsPatch first;
  NurbsPatch second;
  double first_error = 0.0;   ///< how far it moved, as of largest_distance(); 0 for one that stays
  double second_error = 0.0;  ///< the same of the second
  bool reversed = false;      ///< the second runs against the first along the edge
};

/// Whether one side runs against another: by which ends lie nearer to one another, and where both ways are as
/// near, as of closed edges, by the points at quarters.
bool run_against(const NurbsPatch& a, Border side_a, const NurbsPatch& b, Border side_b);

/// Two patches with their sides brought together and the rows of points beside them moved so that one
/// continues the other smoothly (S21; Farin 2002 and Faux and Pratt 1979 on composite surfaces).
///
/// Both keep their domains and the directions of their parameters. First both get, exactly, one degree and the
/// same knots along the edge, scaled to each domain; they are clamped, but stay periodic along it where both are.
/// Across it a patch that moves is raised in degree until its opposite side is not among the rows that move:
/// those stay where they were. Between rational patches the weights of b are scaled by one factor first.
///
/// With A and B for homogeneous points, t from a to b and constants g, e, d, k > 0 the rows of b become those of
///   c1: B_t = A_t + g A                  c2: and B_tt = A_tt + 2 g A_t + e A
///   g1: B_t = k A_t + g A                g2: and B_tt = k^2 A_tt + d A_t + e A
/// c1 and c2 in the parameters that the patches have. k and d are those by which the points move least (least
/// squares); a k that would fold b back, or shorten its derivatives to a tenth, gives way to that of their length.
/// g and e (0 unless rational) move the weights least, while these stay positive where they are. Where the first
/// moves, a and b change places.
///
/// Where both move, their points do so by the least sum of squares that gives these conditions, k being that of
/// both patches' legs (total least squares); between rational ones the first keeps its weights but for the edge,
/// which has the means of both.
/// @param reversed  the second runs against the first along the edge; without it run_against() says
/// @throws InvalidShape if a side is one point, lies at infinity or is the seam of a periodic direction, if a
///         patch leaves the edge in no direction (g1, g2), or knots along the edge cannot be told apart.
PatchJoin joined_patches(const NurbsPatch& a, Border side_a, const NurbsPatch& b, Border side_b,
                         PatchSmoothness smoothness, JoinMoves moves = JoinMoves::second,
                         std::optional<bool> reversed = {});

}  // namespace splinecore
