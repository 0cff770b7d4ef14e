#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "splinecore/base/approximation.hpp"
#include "splinecore/build/parameterization.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/isocurve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// A curve that a surface runs through, or as the first or last one a point, in which it closes: a pole.
using LoftSection = std::variant<NurbsCurve, glm::dvec3>;

/// How a loft runs from section to section.
enum class LoftStyle {
  normal,    ///< smoothly, as fast as the sections are far apart: parameters by distance
  tight,     ///< smoothly, nearer to the straight way: by the roots of distances
  uniform,   ///< smoothly, as fast between near sections as between far ones
  loose,     ///< the sections are its rows of control points, which it need not touch
  straight,  ///< by segments
};

/// How the weights of sections are used, which may be multiplied by any factor without changing their curves.
enum class SectionWeights {
  scaled,  ///< each section's are divided by their mean
  kept,    ///< as they are given
};

/// How corners of sections are kept.
enum class LoftCorners {
  free,     ///< they lie where the parameters of each section have them: the surface has a knot for each
  matched,  ///< where all sections have as many, all have the same parameters: the surface has an edge for each
};

/// A patch that a loft continues at its first or last section, which is a side of that patch.
struct LoftNeighbor {
  NurbsPatch patch;
  Border side;
  int continuity = 1;     ///< 1: with its tangent planes, 2: and curvatures, 3: and how these change; 0: with its side alone
  double strength = 1.0;  ///< how far it follows the patch: its speed by that of the loft elsewhere
};

/// How a loft begins or ends. One of these at most.
struct LoftEnd {
  std::optional<glm::dvec3> tangent;        ///< where it goes, for all points; of length 1 as fast as elsewhere
  std::optional<glm::dvec3> flat;           ///< in a pole: the normal of its tangent plane there
  std::optional<LoftNeighbor> neighbor;   ///< whose side is a section before the first, or after the last one
  double flat_speed = 1.0;                  ///< along that plane, by that of the loft elsewhere
};

struct LoftOptions {
  LoftStyle style = LoftStyle::normal;
  Closing closing = Closing::open;
  int degree = 3;           ///< along v, less where the sections are too few
  bool is_aligned = true;   ///< directions and seams of sections are those of the section before
  std::vector<bool> turned;  ///< for each section, whether it runs the other way than that; empty: none does
  LoftCorners corners = LoftCorners::free;
  SectionWeights weights = SectionWeights::scaled;
  double knot_distance = 0.0;       ///< knots of sections that are nearer, as a part of the domain, are taken for one
  /// Sections may be moved so far, for few knots: denser where sections bend sharply, and at their corners and creases.
  std::optional<double> tolerance;
  std::vector<double> parameters;   ///< along v, one for each section, and where closed one more; empty: by style
  std::vector<double> knots;        ///< along v, all, one period where closed; empty: averages of parameters
  /// Where with curvatures of neighbors the loft would shoot out to three times as far as with tangent planes alone, or weights would not
  /// stay positive, it follows them with half of their strengths, or a quarter, to a 256th; else it is refused.
  bool is_calm = true;
  LoftEnd start;
  LoftEnd end;
};

/// The surface through sections, and what was found of it.
struct LoftSurface {
  NurbsPatch value;
  double error = 0.0;     ///< how far it is from the sections
  double followed = 1.0;  ///< the part of their strengths with which it follows its neighbors: less than 1 where it had to be calmed
};

/// The surface through sections: u along them, v from one to the next (skinning: The NURBS Book, 10.3; row S20).
///
/// Sections are made compatible(): exactly, unless a tolerance or a distance of knots allows less; knots within 2^-40 of the
/// domain are one, where that moves no section by more than 2^-40 of the size. Closed ones become periodic, if all are; where
/// they are aligned, they begin beside where that is best, by 1/512 of the period at most, where they then share knots. Matched corners are first given the same parameters, the means of those that the sections have: pieces
/// between them run at an even multiple of their pace, closed sections that are aligned begin at a corner, and the surface has
/// all copies of a knot there. Where corner_counts() differ none is matched. Homogeneous control points are interpolated along v, so that rational sections are exact; where
/// all have the same weights, these are those of the surface everywhere. Two sections alone are joined by segments, or by
/// one span of the degree that the conditions at the ends ask for.
/// @returns the surface, and how far it is from the sections: how far these were moved, and by how much rounding makes it miss
///          one, where that is more than rounding of their size
/// @throws InvalidShape if there are fewer than two sections, neighbors' sides among them (three where closed), a point is another one than the first
///         or last, sections follow each other that are one, weights would not stay positive between sections, a
///         neighbor's side lies at infinity, closed ones come back turned, knots that sections do not share would make more
///         than 2^20 control points, or degree and parameters take the surface so far away between sections that it would miss
///         one by more than the tolerance, or 2^-20 of the size; ToleranceNotReached.
LoftSurface loft(std::span<const LoftSection> sections, const LoftOptions& options = {});

/// How many corners each section of a loft has, those of neighbors' sides among them, where they are to be matched: all breaks
/// of the tangent if all have as many of these, else those of more than 0.02 radians. A point has none; the seam of closed
/// sections that are aligned counts as any other place.
std::vector<std::size_t> corner_counts(std::span<const LoftSection> sections, const LoftOptions& options = {});

/// The surface from a side of one patch to a side of another one that continues both: a loft of two neighbors, one
/// span of degree continuity + continuity + 1 across. Row S21.
/// @param is_aligned  the second side is run through as the first one is, and closed ones are joined where they lie beside each
///                    other. Both keep their beginnings, so that edges stay edges: where these do not lie beside each other, lines
///                    across lead from one to the other over several spans, and the surface is near the untwisted one: by hundredths
///                    of the radius of round sides
/// @param is_calm     with less than their strengths where it would shoot out, as loft() says how much less
/// @throws InvalidShape as loft() does; ToleranceNotReached where rounding leaves it off the tangent planes
///         by more than 1e-4 radians, or off the curvatures by more than a thousandth of the largest
NurbsPatch blend(const LoftNeighbor& from, const LoftNeighbor& to, bool is_aligned = true, bool is_calm = true);

}  // namespace splinecore
