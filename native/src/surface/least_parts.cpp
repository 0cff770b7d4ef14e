#include "least_parts.hpp"

#include <glm/geometric.hpp>

#include "base/length.hpp"
#include "numeric/linear_equations.hpp"

namespace splinecore {

namespace {

glm::dvec3 normal_of(const std::array<glm::dvec3, 2>& vectors) {
  const glm::dvec3 normal = glm::cross(vectors[0], vectors[1]);
  const double length = length_of(normal);
  return length > 0.0 ? normal / length : glm::dvec3(0.0);
}

/// Of the plane between two; 0 where there is none.
glm::dvec3 mean_normal(const std::array<glm::dvec3, 2>& of_a, const std::array<glm::dvec3, 2>& of_b) {
  const glm::dvec3 a = normal_of(of_a);
  const glm::dvec3 b = normal_of(of_b);
  const glm::dvec3 sum = glm::dot(a, b) < 0.0 ? a - b : a + b;
  const double length = length_of(sum);
  return length > 0.0 ? sum / length : glm::dvec3(0.0);
}

}  // namespace

std::array<double, 4> least_parts(const glm::dvec3& vector, const std::array<glm::dvec3, 2>& of_a, const std::array<glm::dvec3, 2>& of_b) {
  constexpr double kDependent = 1e-6;
  const glm::dvec3 normal = mean_normal(of_a, of_b);
  const auto flat = [&](const glm::dvec3& v) { return v - normal * glm::dot(normal, v); };
  const std::array columns{flat(of_a[0]), flat(of_a[1]), flat(of_b[0]), flat(of_b[1])};
  const glm::dvec3 wanted = flat(vector);
  LinearEquations equations(columns.size());
  for (int c = 0; c < 3; ++c) equations.add(std::array{columns[0][c], columns[1][c], columns[2][c], columns[3][c]}, wanted[c]);
  const std::vector<double> parts = equations.least_squares(kDependent);
  return {parts[0], parts[1], parts[2], parts[3]};
}

}  // namespace splinecore
