#pragma once

#include <cstddef>
#include <glm/vec4.hpp>
#include <optional>
#include <vector>

#include "splinecore/patch/panels.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The curve of a side of a panel, scaled to [0, 1], as Bezier pieces.
struct SideCurve {
  int degree;
  std::vector<double> breaks;      ///< where its spans begin, and 1
  std::vector<glm::dvec4> pieces;  ///< degree + 1 homogeneous points of every span, one after another
  int weight_exponent;
  double tolerance;                ///< up to which points of its patch are one
  double one_knot;                 ///< up to which a break may be the same knot as one of another side
};

/// Nothing where the side is a point: where all that it depends on lies in one place.
std::optional<SideCurve> side_curve(const NurbsPatch& patch, const Panel& panel, Border border, double tolerance);

/// Where the middle of a side lies along a direction in which few have the same place, and how far the rounding of
/// knots may move it. Where knots lie so near together there that it may come to another one, the middle between the
/// ends is taken.
struct SideMiddle {
  double place;
  double spread;
};
SideMiddle middle(const SideCurve& side);

/// Whether two sides have the same points at equal parameters, or the second has them from its end.
bool is_one_curve(const SideCurve& a, const SideCurve& b, bool reversed);

}  // namespace splinecore
#pragma GCC visibility pop
