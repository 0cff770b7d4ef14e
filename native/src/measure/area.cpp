#include "splinecore/measure/area.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "finite_weights.hpp"
#include "base/placement.hpp"
#include "quadrature.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/base/quotient.hpp"
#include "splinecore/basis/samples.hpp"
#include "splinecore/patch/panels.hpp"

namespace splinecore {

namespace {

constexpr std::size_t kMostCells = 8'000;

/// The surface at a node.
struct Place {
  glm::dvec3 point;
  glm::dvec3 normal;   ///< S_u x S_v
  double terms = 0.0;  ///< the size of what it is made of
};

double sum_of_sizes(std::span<const double> weights) {
  double sum = 0.0;
  for (const double weight : weights) sum += std::abs(weight);
  return sum;
}

/// Largest length of a homogeneous point.
double reach_of(const NurbsPatch& patch) {
  double reach = 0.0;
  for (const glm::dvec4& p : patch.homogeneous_points()) reach = std::max(reach, glm::length(glm::dvec3(p)));
  return reach;
}

/// Calls visit(place, weight) at the nodes of a cell of a patch whose homogeneous points reach so far.
template <class Visit>
void for_each_node(const NurbsPatch& patch, double reach, const Cell<2>& cell, Visit visit) {
  const auto nodes_u = gauss_nodes(cell.box[0]);
  const auto nodes_v = gauss_nodes(cell.box[1]);
  const Samples u = Samples::make(patch.knot_vector(Axis::u), nodes_u, 1);
  const Samples v = Samples::make(patch.knot_vector(Axis::v), nodes_v, 1);
  const std::size_t width = patch.knot_vector(Axis::v).unrolled_count();
  const std::size_t low = v.first(0);
  const std::size_t columns = v.first(kGaussNodes - 1) - low + v.weights(0).size();
  std::array<double, kGaussNodes> steps_v;
  for (std::size_t j = 0; j < kGaussNodes; ++j) steps_v[j] = sum_of_sizes(v.weights(j, 1));
  std::vector<glm::dvec4> row(columns);
  std::vector<glm::dvec4> slope(columns);
  for (std::size_t i = 0; i < kGaussNodes; ++i) {
    std::ranges::fill(row, glm::dvec4(0.0));
    std::ranges::fill(slope, glm::dvec4(0.0));
    breathe(8 * u.weights(i).size() * columns);
    for (std::size_t k = 0; k < u.weights(i).size(); ++k) {
      const glm::dvec4* points = patch.homogeneous_points().data() + (u.first(i) + k) * width + low;
      for (std::size_t j = 0; j < columns; ++j) {
        row[j] += u.weights(i, 0)[k] * points[j];
        slope[j] += u.weights(i, 1)[k] * points[j];
      }
    }
    for (std::size_t j = 0; j < kGaussNodes; ++j) {
      const std::size_t first = v.first(j) - low;
      const glm::dvec4 h = weighted_sum(v.weights(j, 0), row.data() + first);
      const glm::dvec4 hu = weighted_sum(v.weights(j, 0), slope.data() + first);
      const glm::dvec4 hv = weighted_sum(v.weights(j, 1), row.data() + first);
      const glm::dvec3 point = project(h);
      const glm::dvec3 su = (glm::dvec3(hu) - hu.w * point) / h.w;
      const glm::dvec3 sv = (glm::dvec3(hv) - hv.w * point) / h.w;
      const double terms = glm::length(su) * steps_v[j] + glm::length(sv) * sum_of_sizes(u.weights(i, 1));
      visit(Place{point, glm::cross(su, sv), terms * reach / std::abs(h.w)},
            gauss_rule().weights[i] * gauss_rule().weights[j]);
    }
  }
}

/// The rule for the sum of integrand(place), a Sum, over patches.
template <class Integrand>
auto rule_of(const std::vector<NurbsPatch>& patches, Integrand integrand) {
  std::vector<double> reaches;
  for (const NurbsPatch& patch : patches) reaches.push_back(reach_of(patch));
  return [&patches, reaches, integrand](const Cell<2>& cell) {
    Sum sum;
    for_each_node(patches[cell.part], reaches[cell.part], cell, [&](const Place& place, double weight) {
      const Sum here = integrand(place);
      sum.value += weight * here.value;
      sum.magnitude += weight * here.magnitude;
    });
    const double size = cell.box[0].length() * cell.box[1].length();
    return Sum{size * sum.value, size * sum.magnitude};
  };
}

/// One cell for each pair of spans.
std::vector<Cell<2>> cells_of(const std::vector<NurbsPatch>& patches) {
  std::vector<Cell<2>> cells;
  for (std::size_t part = 0; part < patches.size(); ++part) {
    const KnotVector& u = patches[part].knot_vector(Axis::u);
    const KnotVector& v = patches[part].knot_vector(Axis::v);
    for (std::size_t i = 0; i < u.spans().size(); ++i) {
      for (std::size_t j = 0; j < v.spans().size(); ++j) {
        cells.push_back({part, {u.span_interval(static_cast<int>(i)), v.span_interval(static_cast<int>(j))}});
      }
    }
  }
  return cells;
}

/// The patches about an origin of their own, all in one scale.
std::vector<NurbsPatch> placed_one_by_one(std::span<const NurbsPatch* const> patches, int exponent) {
  std::vector<NurbsPatch> near;
  for (const NurbsPatch* patch : patches) {
    require_finite_points(*patch);
    near.push_back(placed(*patch, {placement_of(patch->points()).origin, exponent}));
  }
  return near;
}

Approximation<double> area_of(std::span<const NurbsPatch* const> patches, const Placement& placement,
                              double tolerance) {
  require_relative(tolerance);
  const std::vector<NurbsPatch> near = placed_one_by_one(patches, placement.exponent);
  const auto rule = rule_of(near, [](const Place& place) { return Sum{glm::length(place.normal), place.terms}; });
  const std::size_t most = kMostCells + 4 * cells_of(near).size();
  const auto found = adaptive_integral(cells_of(near), rule, tolerance, most, "the area cannot be found");
  return {finite_size(found.value, 2, placement, "area"), given_size(found.error, 2, placement)};
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
  const NurbsPatch* one = &patch;
  return area_of({&one, 1}, placement_of(patch.points()), tolerance);
}

Approximation<double> area(const PatchSet& set, double tolerance) {
  return area_of(patches_of(set), placement_of(set.points()), tolerance);
}

Approximation<double> volume(const PatchSet& set, double tolerance) {
  require_relative(tolerance);
  require_closed(set);
  const Placement placement = placement_of(set.points());
  std::vector<NurbsPatch> near;
  for (const NurbsPatch* patch : patches_of(set)) {
    require_finite_points(*patch);
    near.push_back(placed(*patch, placement));
  }
  const auto rule = rule_of(near, [](const Place& place) {
    return Sum{glm::dot(place.point, place.normal) / 3.0, glm::length(place.point) * place.terms};
  });
  const std::size_t most = kMostCells + 4 * cells_of(near).size();
  const auto found = adaptive_integral(cells_of(near), rule, tolerance, most, "the volume cannot be found");
  return {finite_size(found.value, 3, placement, "volume"), given_size(found.error, 3, placement)};
}

}  // namespace splinecore
