#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>

#include "paced_family.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/surface/loft.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The derivatives across a network's borders that have a neighbor, in its tangent planes: vectors as points of curves.
struct NetworkBorders {
  std::array<std::optional<NurbsCurve>, 2> along_u;   ///< by v, along the first and the last curve of u
  std::array<std::optional<NurbsCurve>, 2> along_v;   ///< by u, along those of v
  std::array<std::string, 2> names_u{};               ///< of the neighbors there; none without one
  std::array<std::string, 2> names_v{};
  std::array<std::array<glm::dvec3, 2>, 2> twists{};  ///< [end of u][end of v], where both borders have one
};

/// They end, where curves cross a border, in the parts of these curves' derivatives in the tangent plane there.
/// @param u, v       all polynomials
/// @param tolerance  how far a neighbor's side may be from an outermost curve
/// @param unit       what a length of 1 is said to be
/// @throws InvalidShape naming a neighbor that lies along no outermost curve, has no tangent plane, or over which a curve
///         turns back
NetworkBorders network_borders(const PacedFamily& u, const PacedFamily& v, std::span<const LoftNeighbor> neighbors,
                               double tolerance, double unit);

}  // namespace splinecore
#pragma GCC visibility pop
