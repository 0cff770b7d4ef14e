#pragma once

#include <array>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "curve_pieces.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A place of each of two curves.
struct SpotPair {
  CurveSpot a;
  CurveSpot b;
};

/// Two curves in one space.
struct TwoCurves {
  const CurvePieces& a;
  const CurvePieces& b;
  double rounding = 0.0;  ///< how much of a coordinate may be rounding of those given

  std::array<double, 2> places(const SpotPair& at) const noexcept { return {a.place(at.a), b.place(at.b)}; }

  /// Less what rounding of parameters and coordinates moves the places by, which is much far out.
  double distance(const SpotPair& at) const;
};

/// Of parts of two pieces the places where they are nearest, of those around a pair: by Newton's method without the second
/// derivatives, on borders along them. @returns none where it does not converge
std::optional<SpotPair> nearest_pair(const TwoCurves& curves, SpotPair at, const Interval& range_a,
                                     const Interval& range_b);

/// The same on the whole curves, across the ends of pieces.
SpotPair settled(const TwoCurves& curves, SpotPair at);

/// Whether curves stay within a distance of each other from a pair of their places, as numbers, to another one.
bool are_joined(const TwoCurves& curves, const std::array<double, 2>& from, const std::array<double, 2>& to,
                double distance);

/// Whether a curve goes away from one place and comes back to another one beside the way that it went, up to a distance.
bool turns_back(const CurvePieces& curve, double low, double high, double distance);

/// Of a part of a piece whose tangents differ by less than a right angle the nearest place to a point.
double foot_of(const CurvePieces& curve, std::size_t piece, const Interval& range, const glm::dvec3& point);

}  // namespace splinecore
#pragma GCC visibility pop
