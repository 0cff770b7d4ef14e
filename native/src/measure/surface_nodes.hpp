#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "basis/bernstein_net.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A point of a surface, and its derivatives.
struct SurfacePlace {
  glm::dvec3 point;
  glm::dvec3 along_u;
  glm::dvec3 along_v;
};

/// Places of Bezier pieces of two degrees at the nodes of kronrod_grid.hpp, row after row.
class SurfaceNodes {
 public:
  /// @param rows, columns  of the pieces' points
  SurfaceNodes(std::size_t rows, std::size_t columns) : u_(rows), v_(columns), points_(columns), slopes_(columns) {}

  /// Node i along u and j along v of a homogeneous piece: j = 0 before the others of a row.
  SurfacePlace at(const BernsteinNet<glm::dvec4>& net, std::size_t i, std::size_t j);

 private:
  /// Bernstein polynomials and their slopes at the nodes, node after node.
  struct Functions {
    explicit Functions(std::size_t count);

    std::vector<double> values;
    std::vector<double> slopes;
  };

  void start_row(const BernsteinNet<glm::dvec4>& net, std::size_t i);

  Functions u_;
  Functions v_;
  std::vector<glm::dvec4> points_;  ///< along v, at the row's node
  std::vector<glm::dvec4> slopes_;
};

/// Those of each patch.
std::vector<SurfaceNodes> nodes_of(std::span<const NurbsPatch> patches);

}  // namespace splinecore
#pragma GCC visibility pop
