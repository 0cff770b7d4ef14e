#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/fit/interpolate_patch.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// How far a shape may lie from its points between them, beside the size of their neighborhood.
struct Swing {
  double most;
  double tolerance;  ///< is added
};

/// What is looked for first, and what is taken where nothing else is found.
inline constexpr double kCalm = 1.0;
inline constexpr double kWide = 4.0;

/// The same of patches beside the disk around scattered points. The corners of a square around that are a fifth of its
/// width away.
inline constexpr double kCalmAround = 0.25;
inline constexpr double kWideAround = 0.5;
inline constexpr double kMostAround = 4.0;  ///< on knots that are given, where no other patch can be looked for

/// Whether a curve stays near the polygon of its points between them. The neighborhood of a place are `degree` points on
/// each side of it. What swings farther follows rounding or noise, not the points.
/// @param parameters  of the points, in order; where closed one more for the return
bool stays_near(const NurbsCurve& curve, std::span<const glm::dvec3> points, std::span<const double> parameters,
                const Swing& swing);

/// How far a curve lies from the chord between two of its points, at some places between each two, beside the longest
/// chord, of which each counts three quarters as much for every point that it is farther away.
double swing_of(const NurbsCurve& curve, std::span<const glm::dvec3> points, std::span<const double> parameters);

/// The same of a patch through a grid, beside the bilinear pieces between its points and the longest sides of these.
double swing_of(const NurbsPatch& patch, const PointGrid& grid, std::span<const double> u, std::span<const double> v);

/// Whether a patch stays near the bilinear pieces between the points of a grid.
/// @param u, v  as many parameters as rows of points, and where closed one more for the return
bool stays_near(const NurbsPatch& patch, const PointGrid& grid, std::span<const double> u, std::span<const double> v,
                const Swing& swing);

/// Whether a patch stays near scattered points: no farther from the disk around them, which is
/// as thick as they are, than so many times its width.
bool stays_near(const NurbsPatch& patch, std::span<const glm::dvec3> points, double most);

}  // namespace splinecore
#pragma GCC visibility pop
