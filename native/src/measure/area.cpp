#include "splinecore/measure/area.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <string>
#include <utility>

#include "finite_weights.hpp"
#include "base/placement.hpp"
#include "basis/knot_tables.hpp"
#include "kernels/kernels.hpp"
#include "quadrature.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
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

/// The functions along an axis at the nodes of an interval inside a span.
struct Nodes {
  std::size_t first;            ///< of the points that they depend on
  std::vector<double> values;  ///< function by function
  std::vector<double> slopes;
  std::array<double, kGaussNodes> steps;  ///< the sum of the sizes of the slopes
};

Nodes nodes_on(const KnotVector& knots, const Interval& interval) {
  const int degree = knots.degree();
  const int span = knots.span_of(interval.middle(), Side::right);
  const Interval whole = knots.span_interval(span);
  const auto at = gauss_nodes(interval);
  const double* const rows = knots.tables().rows(knots, span, 1);
  std::array<BasisPlace, kGaussNodes> places;
  for (std::size_t i = 0; i < kGaussNodes; ++i) {
    places[i] = {rows, (at[i] - whole.start) / whole.length(), (whole.end - at[i]) / whole.length()};
  }
  const std::size_t width = table_width(degree);
  std::vector<double> functions(2 * width * kGaussNodes);
  kernels().functions(degree, 1, places.data(), kGaussNodes, functions.data());
  const std::size_t count = kGaussNodes * (static_cast<std::size_t>(degree) + 1);
  Nodes found{static_cast<std::size_t>(knots.spans()[span] - degree), std::vector<double>(count),
              std::vector<double>(count), {}};
  for (std::size_t i = 0; i < kGaussNodes; ++i) {
    for (int k = 0; k <= degree; ++k) {
      found.values[k * kGaussNodes + i] = functions[2 * width * i + k];
      found.slopes[k * kGaussNodes + i] = functions[2 * width * i + width + k];
      found.steps[i] += std::abs(functions[2 * width * i + width + k]);
    }
  }
  return found;
}

/// Largest length of a homogeneous point.
double reach_of(const NurbsPatch& patch) {
  double reach = 0.0;
  for (const glm::dvec4& p : patch.homogeneous_points()) reach = std::max(reach, glm::length(glm::dvec3(p)));
  return reach;
}

/// A patch, and the functions at nodes that cells in a row have in common.
class Surface {
 public:
  explicit Surface(const NurbsPatch& patch) : patch_(patch), reach_(reach_of(patch)) {}

  /// Calls visit(place, weight) at the nodes of a cell.
  template <class Visit>
  void for_each_node(const Cell<2>& cell, Visit visit) {
    const Nodes& u = nodes(Axis::u, cell.box[0]);
    const Nodes& v = nodes(Axis::v, cell.box[1]);
    const SurfaceRow form{patch_.knot_vector(Axis::v).degree(), kGaussNodes, v.values.data(), v.slopes.data()};
    std::array<double, 9 * kGaussNodes> found;
    for (std::size_t i = 0; i < kGaussNodes; ++i) {
      sum_row(u, i, v.first);
      kernels().surface_row(form, &row_.front().x, &slope_.front().x, found.data());
      for (std::size_t j = 0; j < kGaussNodes; ++j) {
        const auto at = [&](std::size_t row) { return found[row * kGaussNodes + j]; };
        const double terms = at(6) * v.steps[j] + at(7) * u.steps[i];
        visit(Place{{at(0), at(1), at(2)}, {at(3), at(4), at(5)}, terms * reach_ / std::abs(at(8))},
              gauss_rule().weights[i] * gauss_rule().weights[j]);
      }
    }
  }

 private:
  const Nodes& nodes(Axis axis, const Interval& interval) {
    auto& known = nodes_[static_cast<int>(axis)];
    const auto [place, is_new] = known.try_emplace({interval.start, interval.end});
    if (is_new) place->second = nodes_on(patch_.knot_vector(axis), interval);
    return place->second;
  }

  /// The points along v at a node along u, from one on, and their derivatives.
  void sum_row(const Nodes& u, std::size_t node, std::size_t low) {
    const std::size_t width = patch_.knot_vector(Axis::v).unrolled_count();
    const std::size_t columns = patch_.knot_vector(Axis::v).degree() + 1;
    const std::size_t rows = patch_.knot_vector(Axis::u).degree() + 1;
    breathe(8 * rows * columns);
    row_.assign(columns, glm::dvec4(0.0));
    slope_.assign(columns, glm::dvec4(0.0));
    for (std::size_t k = 0; k < rows; ++k) {
      const glm::dvec4* points = patch_.homogeneous_points().data() + (u.first + k) * width + low;
      const double value = u.values[k * kGaussNodes + node];
      const double slope = u.slopes[k * kGaussNodes + node];
      for (std::size_t j = 0; j < columns; ++j) {
        row_[j] += value * points[j];
        slope_[j] += slope * points[j];
      }
    }
  }

  const NurbsPatch& patch_;
  double reach_;
  std::array<std::map<std::pair<double, double>, Nodes>, 2> nodes_;
  std::vector<glm::dvec4> row_;
  std::vector<glm::dvec4> slope_;
};

/// The rule for the sum of integrand(place), a Sum, over patches.
template <class Integrand>
auto rule_of(const std::vector<NurbsPatch>& patches, Integrand integrand) {
  std::vector<Surface> surfaces(patches.begin(), patches.end());
  return [surfaces = std::move(surfaces), integrand](const Cell<2>& cell) mutable {
    Sum sum;
    surfaces[cell.part].for_each_node(cell, [&](const Place& place, double weight) {
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
