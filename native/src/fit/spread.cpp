#include "spread.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace splinecore {

glm::dvec3 least_spread(std::span<const glm::dvec3> points) {
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const glm::dvec3& point : points) {
    const Eigen::Vector3d at(point.x, point.y, point.z);
    spread += at * at.transpose();
  }
  const Eigen::Vector3d least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
  const glm::dvec3 normal(least.x(), least.y(), least.z());
  constexpr double kTells = 1e-9;
  for (const int axis : {2, 0, 1}) {
    if (std::abs(normal[axis]) > kTells) return normal[axis] > 0.0 ? normal : -normal;
  }
  return normal;
}

}  // namespace splinecore
