#include "least_parts.hpp"

#include <Eigen/Dense>

namespace splinecore {

std::array<double, 4> least_parts(const glm::dvec3& vector, const std::array<glm::dvec3, 2>& of_a, const std::array<glm::dvec3, 2>& of_b) {
  constexpr double kDependent = 1e-6;
  Eigen::Matrix<double, 3, 4> left;
  for (int c = 0; c < 3; ++c) left.row(c) << of_a[0][c], of_a[1][c], of_b[0][c], of_b[1][c];
  Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix<double, 3, 4>> solver;
  solver.setThreshold(kDependent);
  solver.compute(left);
  const Eigen::Vector4d parts = solver.solve(Eigen::Vector3d(vector.x, vector.y, vector.z));
  return {parts[0], parts[1], parts[2], parts[3]};
}

}  // namespace splinecore
