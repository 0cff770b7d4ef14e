#include "tangent_rounding.hpp"

#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "base/rounding.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/basis/samples.hpp"

namespace splinecore {

bool is_product_known(const NurbsPatch& patch, double u, double v, const PatchSlopes& tangents, PatchOptions options) {
  constexpr double kKnown = 0x1p-14;
  const Samples at_u = Samples::make(patch.knot_vector(Axis::u), {&u, 1}, 1, options.side_u);
  const Samples at_v = Samples::make(patch.knot_vector(Axis::v), {&v, 1}, 1, options.side_v);
  const int count_u = patch.count(Axis::u);
  const int count_v = patch.count(Axis::v);
  const double size = glm::length(tangents.point);
  double weight = 0.0;
  double of_u = 0.0;
  double of_v = 0.0;
  for (std::size_t i = 0; i < at_u.weights(0).size(); ++i) {
    const std::size_t row = (at_u.first(0) + i) % count_u * count_v;
    for (std::size_t j = 0; j < at_v.weights(0).size(); ++j) {
      const glm::dvec4& p = patch.points()[row + (at_v.first(0) + j) % count_v];
      if (p.w == 0.0) return false;
      const double noise = kRoundingOfStep * std::abs(p.w) * (glm::length(glm::dvec3(p)) + size);
      weight += at_u.weights(0)[i] * at_v.weights(0)[j] * p.w;
      of_u += std::abs(at_u.weights(0, 1)[i] * at_v.weights(0)[j]) * noise;
      of_v += std::abs(at_u.weights(0)[i] * at_v.weights(0, 1)[j]) * noise;
    }
  }
  const double noise = (of_u * glm::length(tangents.v) + of_v * glm::length(tangents.u)) / std::abs(weight);
  return glm::length(glm::cross(tangents.u, tangents.v)) * kKnown > noise;
}

}  // namespace splinecore
