#include "hole.hpp"

#include <Eigen/Dense>
#include <array>

namespace splinecore {

namespace {

/// Each side leaves along the next one at its corners.
void set_ends(Hole& hole) {
  const double h = hole.share;
  for (std::size_t i = 0; i < hole.sides.size(); ++i) {
    const SidePlace end = hole.sides[hole.before(i)].place(1.0);
    const SidePlace start = hole.sides[hole.after(i)].place(0.0);
    hole.sides[i].set_end(false, -h * end.along, h * h * end.along_2);
    hole.sides[i].set_end(true, h * start.along, h * h * start.along_2);
  }
}

/// Numbers by which two vectors each of two sides add up to a vector, as nearly as may be; the least such.
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

/// Both sides of a corner want the same mixed derivatives there, as nearly as the least change allows: with u along a, s of
/// which begins there, and v back along b,
///   S_uv: a.D' = -b.D'    S_uvv: a.D2' = h b.D''    S_uuv: b.D2' = -h a.D''    S_uuvv: a.D2'' = b.D2''
void agree_at_corner(HoleSide& a, HoleSide& b, double h) {
  if (a.continuity() == 0 || b.continuity() == 0) return;
  const std::array<glm::dvec3, 2> of_a = a.directions(false);
  const std::array<glm::dvec3, 2> of_b = b.directions(true);
  const std::array<glm::dvec3, 2> none{glm::dvec3(0.0), glm::dvec3(0.0)};
  const auto twists = least_parts(-(a.jet(false).first[1] + b.jet(true).first[1]), of_a, of_b);
  a.bend_first(false, twists[0], twists[1]);
  b.bend_first(true, twists[2], twists[3]);
  if (a.continuity() == 2) {
    const auto parts = least_parts(h * b.jet(true).first[2] - a.jet(false).second[1], of_a, none);
    a.bend_second(false, 1, parts[0], parts[1]);
  }
  if (b.continuity() == 2) {
    const auto parts = least_parts(-h * a.jet(false).first[2] - b.jet(true).second[1], none, of_b);
    b.bend_second(true, 1, parts[2], parts[3]);
  }
  if (a.continuity() < 2 || b.continuity() < 2) return;
  const auto parts = least_parts(b.jet(true).second[2] - a.jet(false).second[2], of_a, {-of_b[0], -of_b[1]});
  a.bend_second(false, 2, parts[0], parts[1]);
  b.bend_second(true, 2, parts[2], parts[3]);
}

}  // namespace

void agree_at_corners(Hole& hole) {
  set_ends(hole);
  for (std::size_t i = 0; i < hole.sides.size(); ++i) agree_at_corner(hole.sides[i], hole.sides[hole.before(i)], hole.share);
}

}  // namespace splinecore
