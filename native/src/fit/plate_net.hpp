#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "plate_direction.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The net of a plate without weights that is let go: what it moves by has the least sum of the mean squared distance
/// and a multiple of the mean of S_uu² + 2 S_uv² + S_vv², over lengths.
class PlateNet {
 public:
  /// @param net  of coordinates near 1, row after row along v
  /// @throws InvalidShape for nets beyond all memory
  PlateNet(const PlateAxis& u, const PlateAxis& v, std::vector<glm::dvec3> net);

  /// What control points move by, of all of them; nothing where numbers cannot tell.
  ///
  /// The normal equations in Cholesky's form, their solution improved by what is left of them. Time goes with the number
  /// of control points times the square of those along the direction with fewer.
  std::optional<std::vector<glm::dvec3>> moves(double factor) const;

  /// Whether any control point may move.
  bool is_free() const noexcept { return outer_.free() > 0 && inner_.free() > 0; }

 private:
  std::vector<double> system(double factor) const;
  std::size_t place(std::size_t i, std::size_t j) const noexcept {
    return outer_.place(i) * inner_.free() + inner_.place(j);
  }

  bool is_swapped_;
  PlateDirection outer_;  ///< control points of it lie far from each other in the system
  PlateDirection inner_;
  std::size_t width_ = 0;
  std::vector<glm::dvec3> pull_;  ///< the energy's slope at the net that is given
};

}  // namespace splinecore
#pragma GCC visibility pop
