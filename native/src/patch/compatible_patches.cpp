#include "compatible_patches.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <vector>

#include "lines.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/compatible.hpp"
#include "splinecore/patch/degree.hpp"

namespace splinecore {

namespace {

/// Some curve on these knots.
NurbsCurve line_on(const KnotVector& knots) {
  return NurbsCurve::make(knots, std::vector(static_cast<std::size_t>(knots.count()), glm::dvec4(0.0, 0.0, 0.0, 1.0)));
}

/// The patch on common knots of which it has some already, once its degree is theirs; none where that is not so.
std::optional<NurbsPatch> with_more_knots(const NurbsPatch& patch, Axis axis, const KnotVector& common) {
  const KnotVector& own = patch.knot_vector(axis);
  if (own.periodic() || common.periodic() || own.domain() != common.domain()) return {};
  NurbsPatch raised = elevated(patch, axis, common.degree() - own.degree());
  const auto have = raised.knot_vector(axis).knots();
  const auto wanted = common.knots();
  if (!std::ranges::includes(wanted, have)) return {};
  std::vector<double> missing;
  std::ranges::set_difference(wanted, have, std::back_inserter(missing));
  return refine(raised, axis, missing);
}

void make_compatible(std::vector<NurbsPatch>& patches, Axis axis) {
  std::vector<NurbsCurve> lines;
  for (const NurbsPatch& patch : patches) lines.push_back(line_on(patch.knot_vector(axis)));
  const NurbsCurve common = compatible(lines)[0];
  for (NurbsPatch& patch : patches) {
    if (patch.knot_vector(axis) == common.knot_vector()) continue;
    const auto refined = with_more_knots(patch, axis, common.knot_vector());
    patch = refined ? *refined : along(patch, axis, [&](const NurbsCurve& line) { return compatible(common, line).second; });
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
