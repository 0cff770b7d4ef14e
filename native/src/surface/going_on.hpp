#pragma once

#include <glm/vec4.hpp>
#include <span>
#include <vector>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Derivatives 1, 2, … out of a patch at its side, homogeneous, for each control point along it.
using LeavingRows = std::vector<std::vector<glm::dvec4>>;

std::vector<glm::dvec4> scaled(double factor, std::vector<glm::dvec4> row);

void add_row(std::vector<glm::dvec4>& row, double factor, const std::vector<glm::dvec4>& other);

/// How fast points leave, on average.
double speed_of(std::span<const glm::dvec4> row, std::span<const glm::dvec4> derivative);

/// What a patch goes on as: derivatives 1, 2, … of L(t) A(k t + m t² / 2 + n t³ / 6), A being the patch beyond its side,
/// homogeneous, and L a function of t alone, under which weights on average begin level. m and n are 0 unless points would
/// gain or lose their speed within less than `room` of t, on average.
/// @param out  three at most
/// @throws InvalidShape where they do so within next to nothing
LeavingRows going_on(std::span<const glm::dvec4> edge, const LeavingRows& out, double k, double room);

}  // namespace splinecore
#pragma GCC visibility pop
