#pragma once

#include <string>

#include "splinecore/base/interval.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

inline constexpr int kMaxPieces = 100'000;

/// So many places of the whole domain are measured at least.
inline constexpr int kLeastMeasured = 4096;

/// A little below the tolerance, for what lies between the places that are measured.
inline constexpr double kAccepted = 0.9;

/// @throws InvalidShape naming the argument unless both ends and their distance are finite and it increases.
void require_domain(const Interval& domain, const std::string& argument);

/// The k-th place to measure in [0, 1]: first some near the ends, where roots have their errors, then a
/// sequence that meets no regular pattern (Weyl's, of the golden ratio).
double measured_place(int k) noexcept;

/// Whether enough of float64 lies between the ends to tell a steep piece from a jump.
bool can_be_cut(const Interval& interval) noexcept;

}  // namespace splinecore
#pragma GCC visibility pop
