#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "splinecore/base/approximation.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/interval.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Gauss's and Legendre's rule: exact for polynomials up to degree 2 kGaussNodes - 1.
inline constexpr std::size_t kGaussNodes = 12;

/// Nodes in (0, 1) and weights that sum to 1.
struct GaussRule {
  std::array<double, kGaussNodes> nodes;
  std::array<double, kGaussNodes> weights;
};

const GaussRule& gauss_rule();

/// The nodes of the rule on an interval.
std::array<double, kGaussNodes> gauss_nodes(const Interval& interval);

/// A box of parameters of one of several shapes.
template <std::size_t Dimension>
struct Cell {
  std::size_t part = 0;
  std::array<Interval, Dimension> box;
};

/// What a rule finds on a cell: the sum of a function, and of the size of the terms that its values are made
/// of, to which their rounding is relative.
struct Sum {
  double value = 0.0;
  double magnitude = 0.0;
};

namespace quadrature {

template <std::size_t Dimension>
std::array<Cell<Dimension>, (1 << Dimension)> halves_of(const Cell<Dimension>& cell) {
  std::array<Cell<Dimension>, (1 << Dimension)> halves;
  for (std::size_t i = 0; i < halves.size(); ++i) {
    halves[i].part = cell.part;
    for (std::size_t axis = 0; axis < Dimension; ++axis) {
      const Interval& side = cell.box[axis];
      const bool is_low = (i >> axis) % 2 == 0;
      halves[i].box[axis] = is_low ? Interval{side.start, side.middle()} : Interval{side.middle(), side.end};
    }
  }
  return halves;
}

/// Whether numbers are dense enough for the nodes of yet smaller cells.
template <std::size_t Dimension>
bool can_be_cut(const Cell<Dimension>& cell) {
  constexpr double kLeast = 0x1p-40;
  return std::ranges::all_of(cell.box, [](const Interval& side) {
    return side.length() > kLeast * std::max(std::abs(side.start), std::abs(side.end));
  });
}

/// A cell measured by its halves, and how far they are from the cell measured at once.
template <std::size_t Dimension>
struct Estimate {
  Cell<Dimension> cell;
  std::array<Sum, (1 << Dimension)> parts;
  Sum sum;
  double error = 0.0;
};

template <std::size_t Dimension, class Rule>
Estimate<Dimension> estimate(const Cell<Dimension>& cell, const Sum& whole, Rule& rule) {
  Estimate<Dimension> found{.cell = cell, .parts = {}, .sum = {}, .error = 0.0};
  const auto halves = halves_of(cell);
  for (std::size_t i = 0; i < halves.size(); ++i) {
    found.parts[i] = rule(halves[i]);
    found.sum.value += found.parts[i].value;
    found.sum.magnitude += found.parts[i].magnitude;
  }
  found.error = std::abs(found.sum.value - whole.value);
  return found;
}

template <std::size_t Dimension>
struct State {
  std::vector<Estimate<Dimension>> cells;
  Sum sum;
  double error = 0.0;

  void add_up() {
    sum = {};
    error = 0.0;
    for (const auto& cell : cells) {
      sum.value += cell.sum.value;
      sum.magnitude += cell.sum.magnitude;
      error += cell.error;
    }
  }
};

/// The cells with those halved whose error is more than their share. False if there was none to halve.
template <std::size_t Dimension, class Rule>
bool refine(State<Dimension>& state, double target, Rule& rule) {
  const double share = 0.5 * target / static_cast<double>(state.cells.size());
  std::vector<Estimate<Dimension>> next;
  bool is_finer = false;
  for (const auto& cell : state.cells) {
    if (!(cell.error > share) || !can_be_cut(cell.cell)) {
      next.push_back(cell);
      continue;
    }
    is_finer = true;
    const auto halves = halves_of(cell.cell);
    for (std::size_t i = 0; i < halves.size(); ++i) next.push_back(estimate(halves[i], cell.parts[i], rule));
  }
  state.cells = std::move(next);
  return is_finer;
}

}  // namespace quadrature

/// The integral over all cells: `rule(cell)` gives the Sum by Gauss's rule. Cells are halved where this
/// changes the result, until all changes together are within the tolerance, relative to the value, or within
/// rounding. The error is those changes, which for smooth functions is far above the truth, and rounding.
/// @throws ToleranceNotReached if that takes more than `most` cells, InvalidShape where the rule gives no numbers.
template <std::size_t Dimension, class Rule>
Approximation<double> adaptive_integral(const std::vector<Cell<Dimension>>& cells, Rule rule, double tolerance,
                                        std::size_t most, const std::string& what) {
  constexpr double kRounding = 0x1p-52;
  // The changes are no bound where a function has a corner between nodes.
  constexpr double kCaution = 0.125;
  quadrature::State<Dimension> state;
  for (const Cell<Dimension>& cell : cells) state.cells.push_back(quadrature::estimate(cell, rule(cell), rule));
  double before = HUGE_VAL;
  while (true) {
    state.add_up();
    if (!std::isfinite(state.sum.value) || !std::isfinite(state.sum.magnitude)) {
      throw InvalidShape(what + ": points and weights differ too much in size for it");
    }
    const double rounding = kRounding * state.sum.magnitude;
    const double wanted = tolerance * std::abs(state.sum.value);
    const double target = std::max(kCaution * wanted, rounding);
    // Where halving no longer helps only rounding is left.
    const bool is_steady = state.error > 0.5 * before && state.error <= std::max(wanted, 64.0 * rounding);
    if (state.error <= target || is_steady) return {state.sum.value, state.error + rounding};
    before = state.error;
    if (state.cells.size() > most || !quadrature::refine(state, target, rule)) {
      throw ToleranceNotReached(what, std::max(wanted, target), state.error);
    }
  }
}

/// @throws InvalidShape unless it is a positive, finite number.
void require_relative(double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
