#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "splinecore/patch/join.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

inline constexpr int kMostRows = 3;

using EdgeRow = std::vector<glm::dvec4>;

/// What a patch, clamped across a side, is near it.
struct EdgeRows {
  /// Row 0 lies along the side; points as given.
  std::array<EdgeRow, kMostRows> rows;
  /// Derivative k across the side is the sum of coefficients[k][i] times homogeneous row i.
  std::array<std::array<double, kMostRows>, kMostRows> coefficients{};
};

/// Whether a derivative across is sought from one side to the other or back.
enum class Heading { out_of_patch, into_patch };

/// The rows beside a side, in the order of `columns`; kMostRows of them where there are as many.
/// @param unit  what the parameter is measured in
EdgeRows edge_rows(const NurbsPatch& patch, Border side, const std::vector<std::size_t>& columns, Heading heading,
                   double unit);

/// The patch with its first rows replaced.
NurbsPatch with_edge_rows(const NurbsPatch& patch, Border side, const std::vector<std::size_t>& columns,
                          const EdgeRows& rows, int count);

/// From the side to the first knot beyond it.
double first_step(const NurbsPatch& patch, Border side);

/// How many rows a smoothness binds.
int rows_of(PatchSmoothness smoothness) noexcept;

/// Brings the rows of b to those of a: which rows, and how, joined_patches() says.
/// @throws InvalidShape if a or b leaves the edge in no direction where that is needed.
void follow(const EdgeRows& a, EdgeRows& b, PatchSmoothness smoothness, bool is_rational);

/// Moves the rows of both.
void meet(EdgeRows& a, EdgeRows& b, PatchSmoothness smoothness, bool is_rational);

}  // namespace splinecore
#pragma GCC visibility pop
