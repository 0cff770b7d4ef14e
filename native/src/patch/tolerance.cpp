#include "tolerance.hpp"

#include "splinecore/base/errors.hpp"
#include "splinecore/patch/distance.hpp"

namespace splinecore {

void require_tolerance(std::optional<double> tolerance) {
  if (!tolerance || *tolerance >= 0.0) return;
  throw InvalidShape("tolerance = " + text_of(*tolerance) + " is not 0 or more");
}

Approximation<NurbsPatch> within(std::optional<double> tolerance, const NurbsPatch& original, NurbsPatch value,
                                 const char* what) {
  const double error = largest_distance(original, value);
  if (tolerance && !(error <= *tolerance)) throw ToleranceNotReached(what, *tolerance, error);
  return {std::move(value), error};
}

}  // namespace splinecore
