#pragma once

#include <array>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "going_on.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// What a patch has beside its side.
struct OwnRows {
  std::span<const std::vector<glm::dvec4>> rows;        ///< homogeneous, row 0 along the side
  bool are_rational = true;                             ///< these or those of the other patch
  std::array<std::array<double, 4>, 4> coefficients{};  ///< derivative k at the side is the sum of [k][j] times row j
};

/// Which rows the pace is to suit best.
enum class PaceFor { first_row, all_rows };

/// Derivatives 1, 2, … of L(t) A(k t + m t² / 2 + n t³ / 6), A being the other patch beyond its side, homogeneous, and L a
/// function of t alone, by which the patch's own rows move least (least squares), k times the strength; the weights so that
/// they stay positive where they are.
/// @param out  of the other patch, three at most
/// @throws InvalidShape where a patch stands still across its side
LeavingRows least_going_on(std::span<const glm::dvec4> edge, const LeavingRows& out, const OwnRows& own,
                           PaceFor rows, double strength);

}  // namespace splinecore
#pragma GCC visibility pop
