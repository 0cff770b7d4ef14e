#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "kronrod_21.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Nodes of the rules of 10 and 21 along a direction.
inline constexpr std::size_t kGridNodes = 2 * kKronrod21.size() - 1;

/// Node i of [0, 1], in order.
inline KronrodNode grid_node(std::size_t i) {
  if (i < kKronrod21.size()) return kKronrod21[i];
  KronrodNode node = kKronrod21[kGridNodes - 1 - i];
  node.at = 1.0 - node.at;
  return node;
}

template <std::size_t kCount>
using Integrals = std::array<double, kCount>;

/// Some integrals, how far they may be off by the rule, and the size of the terms, to which their rounding is relative.
template <std::size_t kCount>
struct IntegralSums {
  Integrals<kCount> values{};
  std::array<Integrals<kCount>, 2> errors{};  ///< along u and along v
  Integrals<kCount> terms{};

  double error(std::size_t i) const { return errors[0][i] + errors[1][i]; }
  double rounding(std::size_t i) const { return 0x1p-50 * terms[i]; }
};

/// An integrand's values at a place, and the size of the terms that they are sums of.
template <std::size_t kCount>
struct Integrands {
  Integrals<kCount> values{};
  Integrals<kCount> terms{};
};

/// The rules of Gauss and Kronrod of 10 and 21 nodes along both directions of [0, 1]².
/// @param at  (i, j) gives the Integrands at node i along u and j along v; asked row after row
template <std::size_t kCount, class At>
IntegralSums<kCount> grid_sums(At&& at) {
  IntegralSums<kCount> found;
  for (std::size_t i = 0; i < kGridNodes; ++i) {
    IntegralSums<kCount> line;
    for (std::size_t j = 0; j < kGridNodes; ++j) {
      const KronrodNode node = grid_node(j);
      const Integrands<kCount> here = at(i, j);
      for (std::size_t k = 0; k < kCount; ++k) {
        line.values[k] += node.kronrod * here.values[k];
        line.errors[1][k] += (node.kronrod - node.gauss) * here.values[k];
        line.terms[k] += node.kronrod * here.terms[k];
      }
    }
    const KronrodNode node = grid_node(i);
    for (std::size_t k = 0; k < kCount; ++k) {
      found.values[k] += node.kronrod * line.values[k];
      found.errors[0][k] += (node.kronrod - node.gauss) * line.values[k];
      found.errors[1][k] += node.kronrod * line.errors[1][k];
      found.terms[k] += node.kronrod * line.terms[k];
    }
  }
  for (Integrals<kCount>& errors : found.errors) {
    for (double& error : errors) error = std::abs(error);
  }
  return found;
}

}  // namespace splinecore
#pragma GCC visibility pop
