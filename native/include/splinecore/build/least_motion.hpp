#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

namespace splinecore {

/// Linear equations of how far points move, for columns of points: the sum of factors times motions is to be 0.
struct MotionEquations {
  std::size_t width = 0;                      ///< points in a column
  std::vector<int> points;                    ///< the numbers of points, column after column
  std::vector<std::vector<double>> factors;   ///< one for each point of each column, once for each order
};

/// The motion of the least sum of squares by which free points meet equations again after others were moved.
///
/// Equations that share free points are solved together, those that are met stay out. In each column equations are first
/// made orthogonal in their order; then all are (Gram and Schmidt, the longest remainder first), those that depend on others by 1e-12
/// are left out.
/// @param moved    how far each point was moved already
/// @param is_free  which points may move on
/// @returns what points move by beside that; nothing where equations cannot be met, up to 1e-9 of the largest motion
/// @throws InvalidShape if a point has no such number, counts differ, or something is not finite
std::optional<std::vector<glm::dvec3>> least_motion(std::span<const MotionEquations> equations, std::span<const glm::dvec3> moved,
                                                    const std::vector<bool>& is_free);

}  // namespace splinecore
