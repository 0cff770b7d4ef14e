#include "splinecore/measure/area.hpp"

#include <array>
#include <string>
#include <vector>

#include "base/placement.hpp"
#include "finite_weights.hpp"
#include "quadrature.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/patch/panels.hpp"

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

std::vector<const NurbsPatch*> patches_of(const PatchSet& set) {
  std::vector<const NurbsPatch*> patches;
  for (std::size_t i = 0; i < set.patches().size(); ++i) patches.push_back(&nurbs_of(set.patch(i)));
  return patches;
}

std::string name_of(std::size_t patch, int side) {
  constexpr std::array<const char*, 4> kNames{"u = start", "u = end", "v = start", "v = end"};
  return "the side " + std::string(kNames[side]) + " of patches" + index_text(patch);
}

/// Whether the boundary of a patch, with its inside to the left, runs along a side in the direction of its edge.
int turn_of(int side, const PanelSide& found) {
  const int turn = side == 1 || side == 2 ? 1 : -1;
  return found.reversed ? -turn : turn;
}

/// @throws InvalidShape unless the patches close up and their normals agree.
void require_closed(const PatchSet& set) {
  const std::vector<Panel> panels = panels_of(set);
  const std::vector<int> counts = side_counts(panels);
  std::vector<int> turns(counts.size(), 0);
  for (const Panel& panel : panels) {
    for (int side = 0; side < 4; ++side) {
      const PanelSide& found = panel.sides[side];
      if (found.edge < 0) continue;
      if (counts[found.edge] == 1) {
        throw InvalidShape(name_of(panel.patch, side) + " meets no other: the patches enclose no volume");
      }
      turns[found.edge] += turn_of(side, found);
    }
  }
  for (const Panel& panel : panels) {
    for (int side = 0; side < 4; ++side) {
      if (panel.sides[side].edge < 0 || turns[panel.sides[side].edge] == 0) continue;
      throw InvalidShape("beyond " + name_of(panel.patch, side) +
                         " the normals point to the other side: the volume has no sign");
    }
  }
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
