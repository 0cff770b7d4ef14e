#pragma once

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "basis/bernstein_net.hpp"
#include "box_tree.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A box along a piece whose weights have one sign: the hull property has the piece in it.
struct PieceBox {
  glm::dvec3 center{0.0};
  std::array<glm::dvec3, 3> axes{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)};
  glm::dvec3 half{0.0};
};

/// @param net  homogeneous, of weights of one sign; one column is a curve
PieceBox piece_box(const BernsteinNet<glm::dvec4>& net);

/// The box of the control points along the axes of coordinates; everywhere if their weights have both signs.
TreeBox box_of(const BernsteinNet<glm::dvec4>& net);

}  // namespace splinecore
#pragma GCC visibility pop
