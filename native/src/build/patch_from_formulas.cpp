#include "splinecore/build/patch_from_formulas.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "base/require.hpp"
#include "exact_polynomial.hpp"
#include "fit_options.hpp"
#include "patch_fit.hpp"

namespace splinecore {

namespace {

void require_formulas(std::span<const Formula> coordinates) {
  if (coordinates.size() != 3) {
    throw InvalidShape("formulas has " + std::to_string(coordinates.size()) + " of them, x, y and z are expected");
  }
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    const std::size_t count = coordinates[i].variables().size();
    if (count == 2) continue;
    throw InvalidShape("formulas" + index_text(i) + " has " + std::to_string(count) + " variables, a patch has two");
  }
}

KnotVector one_span(int degree, const Interval& domain) {
  std::vector<double> knots(degree + 1, domain.start);
  knots.insert(knots.end(), degree + 1, domain.end);
  return KnotVector::make(degree, std::move(knots));
}

std::optional<NurbsPatch> exact_patch(std::span<const Formula> coordinates, const std::array<Interval, 2>& domains) {
  std::vector<ScaledBernstein> polynomials;
  int degree_u = 1;
  int degree_v = 1;
  for (const Formula& formula : coordinates) {
    auto found = scaled_bernstein(formula, domains, kHighestExactPatchDegree);
    if (!found) return std::nullopt;
    degree_u = std::max(degree_u, found->degree_u);
    degree_v = std::max(degree_v, found->degree_v);
    polynomials.push_back(*std::move(found));
  }
  std::vector<glm::dvec4> points((degree_u + 1) * (degree_v + 1), glm::dvec4(0.0, 0.0, 0.0, 1.0));
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<double> ordinates = bezier_ordinates(with_degrees(polynomials[axis], degree_u, degree_v));
    for (std::size_t i = 0; i < points.size(); ++i) points[i][axis] = ordinates[i];
  }
  return NurbsPatch::make(one_span(degree_u, domains[0]), one_span(degree_v, domains[1]), std::move(points));
}

}  // namespace

Approximation<NurbsPatch> patch_from_formulas(std::span<const Formula> coordinates,
                                              const std::array<Interval, 2>& domains, double tolerance) {
  require_formulas(coordinates);
  require_domain(domains[0], "domain_u");
  require_domain(domains[1], "domain_v");
  require_positive(tolerance);
  if (auto patch = exact_patch(coordinates, domains)) return {*std::move(patch), 0.0};
  return fitted_patch(coordinates, domains, tolerance);
}

}  // namespace splinecore
