#include "compatible_patches.hpp"

#include "lines.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/compatible.hpp"

namespace splinecore {

namespace {

/// Some curve on these knots.
NurbsCurve line_on(const KnotVector& knots) {
  return NurbsCurve::make(knots, std::vector(static_cast<std::size_t>(knots.count()), glm::dvec4(0.0, 0.0, 0.0, 1.0)));
}

void make_compatible(std::vector<NurbsPatch>& patches, Axis axis) {
  std::vector<NurbsCurve> lines;
  for (const NurbsPatch& patch : patches) lines.push_back(line_on(patch.knot_vector(axis)));
  const NurbsCurve common = compatible(lines)[0];
  for (NurbsPatch& patch : patches) {
    if (patch.knot_vector(axis) == common.knot_vector()) continue;
    patch = along(patch, axis, [&](const NurbsCurve& line) { return compatible(common, line).second; });
  }
}

}  // namespace

std::vector<NurbsPatch> compatible(std::span<const NurbsPatch> patches) {
  if (patches.empty()) throw InvalidShape("there is no patch");
  std::vector<NurbsPatch> made(patches.begin(), patches.end());
  make_compatible(made, Axis::u);
  make_compatible(made, Axis::v);
  return made;
}

}  // namespace splinecore
