#pragma once

#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "base/double_double.hpp"
#include "splinecore/base/interval.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

// Rows of coefficients c_k of sum c_k (t - origin)^k, lowest power first (lecture row S2). All sums are
// made with 32 digits, so that a result is as exact as coefficients stored as doubles allow.

/// The same polynomial about an origin that lies `shift` further on (Taylor shift by Horner's scheme;
/// Knuth, TAOCP 4.6.4). Coefficients about a far origin are large and cancel: of the digits of the
/// polynomial at t those of sum |c_k| |t - origin|^k / |value| are lost, for good.
std::vector<glm::dvec4> taylor_shifted(std::span<const glm::dvec4> coefficients, const DoubleDouble& shift);

/// Bernstein coefficients on `range` of a polynomial in powers of t - origin. Not finite where they overflow.
std::vector<glm::dvec4> power_to_bernstein(std::span<const glm::dvec4> coefficients, double origin, Interval range);

/// Coefficients of powers of t - origin from Bernstein coefficients on `range`. Not finite where they overflow.
std::vector<glm::dvec4> bernstein_to_power(std::span<const glm::dvec4> points, Interval range, double origin);

}  // namespace splinecore
#pragma GCC visibility pop
