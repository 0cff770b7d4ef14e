#include "splinecore/measure/area.hpp"

#include <span>

#include "base/placement.hpp"
#include "closed_set.hpp"
#include "finite_weights.hpp"
#include "quadrature.hpp"

namespace splinecore {

namespace {

Approximation<double> integral_of(std::span<const NurbsPatch* const> patches, const Placement& placement,
                                  Integrand integrand, double tolerance) {
  const bool is_area = integrand == Integrand::area;
  for (const NurbsPatch* patch : patches) require_finite_points(*patch);
  const auto [value, error] = surface_integral(patches, placement, integrand, tolerance,
                                               is_area ? "the area cannot be found" : "the volume cannot be found");
  const int dimension = is_area ? 2 : 3;
  const double size = finite_size(value, dimension, placement, is_area ? "area" : "volume");
  return {size, given_size(error, dimension, placement)};
}

}  // namespace

Approximation<double> area(const NurbsPatch& patch, double tolerance) {
  require_relative(tolerance);
  const NurbsPatch* one = &patch;
  return integral_of({&one, 1}, placement_of(patch.points()), Integrand::area, tolerance);
}

Approximation<double> area(const PatchSet& set, double tolerance) {
  require_relative(tolerance);
  return integral_of(patches_of(set), placement_of(set.points()), Integrand::area, tolerance);
}

Approximation<double> volume(const PatchSet& set, double tolerance) {
  require_relative(tolerance);
  require_closed(set);
  return integral_of(patches_of(set), placement_of(set.points()), Integrand::volume, tolerance);
}

}  // namespace splinecore
