#include "boolean_sum.hpp"

#include <array>
#include <vector>

#include "patch/compatible_patches.hpp"
#include "splinecore/base/points.hpp"

namespace splinecore {

NurbsPatch boolean_sum(const NurbsPatch& a, const NurbsPatch& b, const NurbsPatch& common) {
  const std::array<NurbsPatch, 3> given{a, b, common};
  const std::vector<NurbsPatch> parts = compatible(given);
  std::vector<glm::dvec4> sum = homogeneous(parts[0].points());
  const std::vector<glm::dvec4> added = homogeneous(parts[1].points());
  const std::vector<glm::dvec4> taken = homogeneous(parts[2].points());
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += added[i] - taken[i];
  return NurbsPatch::from_homogeneous(parts[0].knot_vector(Axis::u), parts[0].knot_vector(Axis::v), sum);
}

}  // namespace splinecore
