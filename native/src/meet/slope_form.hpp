#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "basis/bernstein_net.hpp"
#include "splinecore/base/axis.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A polynomial in Bernstein's form, and how much of a coefficient may be rounding.
struct SlopeForm {
  BernsteinNet<double> net;
  double noise = 0.0;
};

/// A piece times a power of two, so that its largest weight is near 1. @returns false if no weight is above zero
bool scale_weights(BernsteinNet<glm::dvec4>& piece) noexcept;

/// Whether all weights have one sign and differ so much in size that a form of the whole piece would lose digits where
/// they are small.
bool is_uneven(const BernsteinNet<glm::dvec4>& piece) noexcept;

/// How the distance of a piece from a point changes along an axis: (X - W p) · (W X' - W' X), which has the sign of the
/// derivative times that of W; (X - p) · X' where every W is 1.
/// @param rounding  how much of a coordinate may be rounding
SlopeForm slope_form(const BernsteinNet<glm::dvec4>& piece, Axis axis, const glm::dvec3& point, double rounding);

/// A form times the weights of its piece.
SlopeForm times_weights(const SlopeForm& form, const BernsteinNet<glm::dvec4>& piece);

/// The same polynomial by the coefficients of higher degrees.
BernsteinNet<double> elevated(const BernsteinNet<double>& net, std::size_t rows, std::size_t columns);

}  // namespace splinecore
#pragma GCC visibility pop
