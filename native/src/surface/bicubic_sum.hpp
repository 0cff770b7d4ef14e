#pragma once

#include <array>
#include <optional>

#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A border of a patch over [0, 1], and, where it is given, the patch's derivative across it by the other parameter: vectors
/// as the points of a curve over [0, 1].
struct LeftBorder {
  NurbsCurve curve;
  std::optional<NurbsCurve> across;
};

/// The borders along one direction, at the start and at the end of the other.
using BorderPair = std::array<LeftBorder, 2>;

struct BorderPairs {
  BorderPair along_u;
  BorderPair along_v;
};

/// The borders of a patch by its sides: v_start, u_end, v_end and u_start, as these go round, with derivatives into it.
BorderPairs borders_around(const std::array<LeftBorder, 4>& sides);

/// What derivatives that are given lie off those that a patch can have.
struct CornerMisfits {
  std::array<double, 2> along_u{};  ///< for each border, at its ends: off the derivative along the next border
  std::array<double, 2> along_v{};
  double twist = 0.0;               ///< the most that a derivative is changed along a border for twists to be one
};

struct BicubicSum {
  NurbsPatch patch;
  std::array<NurbsCurve, 2> along_u;  ///< the borders as they are in the patch: with weights 1 at both ends
  std::array<NurbsCurve, 2> along_v;
  CornerMisfits misfits;
};

/// The sum of the cubics from border to border in either direction, less the bicubic patch of the corners, in homogeneous
/// points (Coons 1967; Farin 2002, 22.3; row S21).
///
/// Weights are multiplied by a linear function that makes them 1 at both ends. Across, the homogeneous derivative is
///   H_v = w F + g H,   g running smoothly between the derivatives of the other borders' weights,
/// whose point goes by F and whose twists agree where those of F do. A derivative that is not given runs smoothly between those
/// of the other borders, with the given twist, or that of the bilinear patch (Adini). Where two twists are given, their mean.
///
/// With a degree, the patch has that one, or the lowest with which borders are what they are, and leaves them as given at
/// interpolation_places_between_slopes() of its knots, and as fast as given at both ends; without, everywhere.
/// @throws InvalidShape if a curve jumps, or an end lies at infinity
BicubicSum bicubic_sum(const BorderPair& along_u, const BorderPair& along_v, std::optional<int> degree = {});

/// False where weights inside the patch are not positive, and all of its borders are.
bool keeps_weights_positive(const BicubicSum& sum);

}  // namespace splinecore
#pragma GCC visibility pop
