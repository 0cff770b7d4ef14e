#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "basis/banded_cholesky.hpp"
#include "plate_energy.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/basis/samples.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The net of control points on plain knots with least sum of weighted squared distances at pairs of parameters, and of
/// a multiple of the energy of a thin plate: the integral of S_uu² + 2 S_uv² + S_vv².
class ThinPlateFit {
 public:
  /// @param weights  as many as parameters, or none for 1 each
  /// Time goes with the number of control points times the square of those along v.
  /// @param is_turned  u and v have changed places: what is said of control points counts them as before
  /// @throws InvalidShape naming a control point that the points do not determine, or for nets beyond all memory.
  ThinPlateFit(const KnotVector& u, const KnotVector& v, std::span<const glm::dvec2> parameters,
               std::span<const double> weights, double energy, bool is_turned = false);

  /// @param points  of coordinates up to 1; one for each pair
  /// @throws InvalidShape naming a control point that is lost in the distance
  std::vector<glm::dvec3> net(std::span<const glm::dvec3> points) const;

 private:
  struct Plate {
    PlateDirection u;
    PlateDirection v;
    double factor;  ///< of the mean
  };

  static Plate plate_of(const KnotVector& u, const KnotVector& v, double energy);
  std::vector<double> energy_rows() const;
  std::string name_of(std::size_t control) const;
  InvalidShape undetermined(std::size_t control) const;
  void require_near(std::span<const glm::dvec3> net) const;
  void require_energy_leaves_points(const KnotVector& u, const KnotVector& v) const;
  glm::dvec3 at(std::size_t i, std::span<const glm::dvec3> net) const;
  void add_residuals(std::span<const glm::dvec3> points, std::span<const glm::dvec3> net,
                     std::span<glm::dvec3> right) const;
  double weight(std::size_t i) const noexcept { return weights_.empty() ? 1.0 : weights_[i]; }

  std::size_t count_u_;
  std::size_t count_v_;
  bool is_turned_;
  std::size_t width_;  ///< of a row of the system: from a control point to the last one that shares a span with it
  Samples u_;
  Samples v_;
  std::span<const double> weights_;
  std::optional<Plate> plate_;  ///< none where the energy has no weight
  BandedCholesky system_;
};

}  // namespace splinecore
#pragma GCC visibility pop
