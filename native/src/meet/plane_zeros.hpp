#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "slope_form.hpp"
#include "splinecore/base/interval.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A part of [0, 1]².
using PlaneRange = std::array<Interval, 2>;

/// A place where two polynomials are zero together.
struct PlaneZero {
  std::array<double, 2> at;
  double reach;    ///< other zeros as near are this one
  bool is_single;  ///< or one that rounding does not tell from others
};

struct PlaneZeros {
  std::vector<PlaneZero> zeros;
  std::optional<std::array<double, 2>> curve;  ///< a place near which they are a curve or more; then not all are found
};

/// All common zeros of two polynomials over [0, 1]² in Bernstein's form.
///
/// Halving. A part is left out where the coefficients of one of them, or of a combination of both that is nearly one of
/// the parameters, have one sign, and halved no more where the derivatives of such combinations show that no two places
/// have the same values: then Newton's method finds the zero (Sherbrooke and Patrikalakis 1993 use the like).
/// @param is_out  whether a part is left out for another reason; none: no part
PlaneZeros plane_zeros(const SlopeForm& a, const SlopeForm& b, const std::function<bool(const PlaneRange&)>& is_out);

}  // namespace splinecore
#pragma GCC visibility pop
