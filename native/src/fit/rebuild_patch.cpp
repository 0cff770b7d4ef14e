#include <cmath>

#include "along.hpp"
#include "quadrature_nodes.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/fit/rebuild.hpp"
#include "splinecore/patch/distance.hpp"
#include "splinecore/patch/evaluate.hpp"
#include "tensor_fit.hpp"

namespace splinecore {

namespace {

/// New knots, and where the old patch is looked at.
FittedAxis axis_of(const NurbsPatch& patch, Axis axis, const RebuiltDirection& wanted) {
  const KnotVector& old = patch.knot_vector(axis);
  return along(axis == Axis::u ? "u" : "v", [&]() -> FittedAxis {
    KnotVector knots = even_knots(wanted.degree, wanted.count, old.domain(), old.periodic());
    const int count = node_count(old.degree(), wanted.degree, patch.rational());
    QuadratureNodes nodes = quadrature_nodes(breaks_of(old, knots), count, !old.periodic());
    return {std::move(knots), std::move(nodes.parameters), std::move(nodes.weights)};
  });
}

}  // namespace

Approximation<NurbsPatch> rebuild(const NurbsPatch& patch, const RebuiltDirection& u, const RebuiltDirection& v) {
  const FittedAxis along_u = axis_of(patch, Axis::u, u);
  const FittedAxis along_v = axis_of(patch, Axis::v, v);
  std::vector<double> values(3 * along_u.parameters.size() * along_v.parameters.size());
  evaluate_grid(patch, along_u.parameters, along_v.parameters, std::span(values));
  NurbsPatch made = NurbsPatch::make(along_u.knots, along_v.knots, tensor_fit(along_u, along_v, values));
  const double error = largest_distance(patch, made);
  if (!std::isfinite(error)) throw InvalidShape("a patch that runs to infinity cannot be rebuilt");
  return {std::move(made), error};
}

}  // namespace splinecore
