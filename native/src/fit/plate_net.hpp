#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "least_squares_fit.hpp"
#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// One direction of a plate.
struct PlateAxis {
  KnotVector knots;    ///< of a domain near 1
  double length;       ///< of the plate: what the domain stands for
  Held held;           ///< rows of control points that stay; none of periodic knots
};

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
  /// A symmetric matrix of functions that share a span: in row i those with i - degree to i + degree, around a period.
  struct Band {
    std::vector<double> values;
    std::size_t width;

    double at(std::size_t i, std::size_t k) const noexcept { return values[i * width + k]; }
  };

  struct Direction {
    Direction(const PlateAxis& axis, bool is_outer);

    std::size_t free() const noexcept { return count - held.start - held.end; }
    bool is_held(std::size_t i) const noexcept { return i < held.start || i >= count - held.end; }
    std::size_t partner(std::size_t i, std::size_t k) const noexcept { return (i + k + count - degree) % count; }
    bool has(std::size_t i, std::size_t k) const noexcept {
      return is_periodic || (i + k >= degree && i + k < count + degree);
    }
    std::size_t place(std::size_t i) const noexcept;

    std::size_t count;
    std::size_t degree;
    bool is_periodic;
    bool is_folded;           ///< a period's functions in the order 0, n - 1, 1, n - 2, …: neighbours stay near
    Held held;
    std::vector<Band> bands;  ///< of derivatives 0, 1 and 2
  };

  std::vector<double> system(double factor) const;
  std::vector<glm::dvec3> product(std::size_t outer, std::size_t inner, std::span<const glm::dvec3> net) const;
  std::vector<glm::dvec3> energy_of(std::span<const glm::dvec3> net) const;
  std::size_t place(std::size_t i, std::size_t j) const noexcept {
    return outer_.place(i) * inner_.free() + inner_.place(j);
  }

  bool is_swapped_;
  Direction outer_;  ///< control points of it lie far from each other in the system
  Direction inner_;
  std::size_t width_ = 0;
  std::vector<glm::dvec3> pull_;  ///< the energy's slope at the net that is given
};

}  // namespace splinecore
#pragma GCC visibility pop
