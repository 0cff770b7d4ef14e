#include "rescale.hpp"

#include "curve/rescale.hpp"

namespace splinecore {

std::array<int, 2> parameter_scales(const NurbsPatch& patch) {
  return {scale_of(patch.knot_vector(Axis::u)), scale_of(patch.knot_vector(Axis::v))};
}

NurbsPatch divided(const NurbsPatch& patch, const std::array<int, 2>& parameters) {
  if (parameters[0] == 0 && parameters[1] == 0) return patch;
  return NurbsPatch::make(divided(patch.knot_vector(Axis::u), parameters[0]),
                          divided(patch.knot_vector(Axis::v), parameters[1]),
                          {patch.points().begin(), patch.points().end()});
}

}  // namespace splinecore
