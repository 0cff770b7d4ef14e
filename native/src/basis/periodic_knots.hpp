#pragma once

#include <cstddef>
#include <span>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The parameter u of one period, that many periods later.
double periodic_image(std::span<const double> period, double u, std::ptrdiff_t turns) noexcept;

/// Knot i of a periodic vector, for any integer i: unrolled()[i + degree] where that exists.
double periodic_knot(std::span<const double> period, std::ptrdiff_t i) noexcept;

}  // namespace splinecore
#pragma GCC visibility pop
