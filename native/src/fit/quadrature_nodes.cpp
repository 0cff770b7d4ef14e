#include "quadrature_nodes.hpp"

#include <algorithm>

#include "basis/gauss_legendre.hpp"
#include "control_counts.hpp"

namespace splinecore {

QuadratureNodes quadrature_nodes(std::span<const double> breaks, int count, bool with_ends) {
  const GaussRule rule = gauss_legendre(count);
  const double whole = breaks.back() - breaks.front();
  QuadratureNodes nodes;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const double length = breaks[i + 1] - breaks[i];
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
      const double share = length / whole * rule.weights[k];
      if (!(share > 0.0)) continue;
      nodes.parameters.push_back(std::min(breaks[i] + length * rule.nodes[k], breaks[i + 1]));
      nodes.weights.push_back(share);
    }
  }
  if (!with_ends) return nodes;
  nodes.parameters.insert(nodes.parameters.begin(), breaks.front());
  nodes.parameters.push_back(breaks.back());
  nodes.weights.insert(nodes.weights.begin(), nodes.weights.front());
  nodes.weights.push_back(nodes.weights.back());
  return nodes;
}

int node_count(int degree, int other, bool is_rational) {
  constexpr int kMoreForQuotients = 8;
  return std::max(degree, other) + 1 + (is_rational ? kMoreForQuotients : 0);
}

std::vector<double> breaks_of(const KnotVector& a, const KnotVector& b) {
  std::vector<double> breaks{a.domain().start};
  for (const KnotVector* knots : {&a, &b}) {
    for (int i = 0; i < static_cast<int>(knots->spans().size()); ++i) breaks.push_back(knots->span_interval(i).end);
  }
  std::ranges::sort(breaks);
  const auto repeated = std::ranges::unique(breaks);
  breaks.erase(repeated.begin(), repeated.end());
  return breaks;
}

KnotVector even_knots(int degree, std::size_t count, const Interval& domain, bool is_periodic) {
  require_count(count, degree, is_periodic);
  const std::size_t spans = is_periodic ? count : count - static_cast<std::size_t>(degree);
  const std::size_t copies = is_periodic ? 1 : static_cast<std::size_t>(degree) + 1;
  std::vector<double> knots(copies, domain.start);
  for (std::size_t i = 1; i < spans; ++i) {
    knots.push_back(domain.start + domain.length() * (static_cast<double>(i) / static_cast<double>(spans)));
  }
  knots.insert(knots.end(), copies, domain.end);
  return KnotVector::make(degree, std::move(knots), is_periodic);
}

}  // namespace splinecore
