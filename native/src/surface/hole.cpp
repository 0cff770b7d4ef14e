#include "hole.hpp"

#include <Eigen/Dense>
#include <array>
#include <glm/geometric.hpp>
#include <string>

#include "base/length.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

/// A patch has no tangent plane in a corner whose sides go on into each other.
/// @param before, after  how the sides with these indices run there
void require_corner(std::size_t i, const glm::dvec3& before, std::size_t j, const glm::dvec3& after) {
  constexpr double kStraight = 1e-3;
  const double sizes = length_of(before) * length_of(after);
  if (length_of(glm::cross(before, after)) > kStraight * sizes || !(glm::dot(before, after) > 0.0)) return;
  throw InvalidShape("sides" + index_text(i) + " and sides" + index_text(j) +
                     " go on into each other without a corner: from neighbours no surface can go on there. Make them one side, or let "
                     "both go on with G0");
}

/// Each side leaves along the next one at its corners.
void set_ends(Hole& hole) {
  const double h = hole.share;
  for (std::size_t i = 0; i < hole.sides.size(); ++i) {
    HoleSide& side = hole.sides[i];
    if (side.continuity() == 0) continue;
    const HolePlace end = hole.sides[hole.before(i)].place(1.0);
    const HolePlace start = hole.sides[hole.after(i)].place(0.0);
    require_corner(hole.before(i), end.along, i, side.place(0.0).along);
    require_corner(i, side.place(1.0).along, hole.after(i), start.along);
    side.set_end(false, -h * end.along, h * h * end.along_2);
    side.set_end(true, h * start.along, h * h * start.along_2);
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

// Both sides of a corner want the same mixed derivatives there, as nearly as the least change allows: with u along a, s of
// which begins there, and v back along b,
//   S_uv: a.D' = -b.D'    S_uvv: a.D2' = h b.D''    S_uuv: b.D2' = -h a.D''    S_uuvv: a.D2'' = b.D2''
// As far as they may, those of the surface round about agree by themselves.

void agree_on_twist(HoleSide& a, HoleSide& b) {
  const auto parts = least_parts(-(a.jet(false).first[1] + b.jet(true).first[1]), a.directions(false), b.directions(true));
  a.bend_first(false, parts[0], parts[1]);
  b.bend_first(true, parts[2], parts[3]);
}

void agree_on_thirds(HoleSide& a, HoleSide& b, double h) {
  constexpr std::array<glm::dvec3, 2> kNone{glm::dvec3(0.0), glm::dvec3(0.0)};
  if (a.continuity() == 2) {
    const auto parts = least_parts(h * b.jet(true).first[2] - a.jet(false).second[1], a.directions(false), kNone);
    a.bend_second(false, 1, parts[0], parts[1]);
  }
  if (b.continuity() == 2) {
    const auto parts = least_parts(-h * a.jet(false).first[2] - b.jet(true).second[1], kNone, b.directions(true));
    b.bend_second(true, 1, parts[2], parts[3]);
  }
}

void agree_on_fourths(HoleSide& a, HoleSide& b) {
  if (a.continuity() < 2 || b.continuity() < 2) return;
  const std::array<glm::dvec3, 2> of_b = b.directions(true);
  const auto parts = least_parts(b.jet(true).second[2] - a.jet(false).second[2], a.directions(false), {-of_b[0], -of_b[1]});
  a.bend_second(false, 2, parts[0], parts[1]);
  b.bend_second(true, 2, parts[2], parts[3]);
}

}  // namespace

void agree_at_corners(Hole& hole) {
  set_ends(hole);
  const auto at_corners = [&](const auto& agree) {
    for (std::size_t i = 0; i < hole.sides.size(); ++i) {
      HoleSide& side = hole.sides[i];
      HoleSide& before = hole.sides[hole.before(i)];
      if (side.continuity() > 0 && before.continuity() > 0) agree(side, before);
    }
  };
  at_corners(agree_on_twist);
  at_corners([&](HoleSide& a, HoleSide& b) { agree_on_thirds(a, b, hole.share); });
  at_corners(agree_on_fourths);
}

}  // namespace splinecore
