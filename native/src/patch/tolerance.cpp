#include "tolerance.hpp"

#include "splinecore/base/errors.hpp"
#include "splinecore/patch/distance.hpp"

namespace splinecore {

Approximation<NurbsPatch> within(std::optional<double> tolerance, const NurbsPatch& original, NurbsPatch value,
                                 const char* what) {
  const double error = largest_distance(original, value);
  if (tolerance && !(error <= *tolerance)) throw ToleranceNotReached(what, *tolerance, error);
  return {std::move(value), error};
}

}  // namespace splinecore
