#include "least_change.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

/// What is left of the tangent's equation beside the point's is rounding, as a part of it, below this.
constexpr double kDependent = 1e-11;

std::vector<double> factors_of(const Following& following, std::size_t count) {
  if (!(std::isfinite(following.locality) && following.locality >= 0.0)) {
    throw InvalidShape("locality = " + text_of(following.locality) + " is not a number of 0 or more");
  }
  std::vector<double> factors = following.factors;
  if (factors.empty()) factors.assign(count, 1.0);
  if (factors.size() != count) {
    throw InvalidShape("factors has " + std::to_string(factors.size()) + " values for " + std::to_string(count) +
                       " points");
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (std::isfinite(factors[i]) && factors[i] >= 0.0) continue;
    throw InvalidShape("factors" + index_text(i) + " = " + text_of(factors[i]) + " is not a number of 0 or more");
  }
  return factors;
}

/// What moves as one, as one unknown: coefficients for a motion measured as a length.
struct Unknown {
  double in_point = 0.0;
  double in_tangent = 0.0;
  double measure = 0.0;
  int measured = 0;
  double factor = 1.0;

  double length() const { return measured == 0 ? 1.0 : measure / measured; }
};

/// The Unknown of each leader.
std::vector<Unknown> unknowns_of(const Movable& movable, const std::vector<double>& factors) {
  std::vector<Unknown> unknowns(factors.size());
  for (Unknown& unknown : unknowns) unknown.factor = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < factors.size(); ++i) {
    Unknown& unknown = unknowns[movable.leader(static_cast<int>(i))];
    unknown.in_point += movable.in_point[i];
    unknown.in_tangent += movable.in_tangent[i];
    unknown.measure += movable.measure[i];
    unknown.measured += movable.measure[i] > 0.0 ? 1 : 0;
    unknown.factor = std::min(unknown.factor, movable.is_fixed[i] ? 0.0 : factors[i]);
  }
  for (Unknown& unknown : unknowns) {
    unknown.in_point /= unknown.length();
    unknown.in_tangent /= unknown.length();
  }
  return unknowns;
}

double largest(const std::vector<Unknown>& unknowns, double Unknown::*member) {
  double size = 0.0;
  for (const Unknown& unknown : unknowns) {
    if (unknown.factor > 0.0) size = std::max(size, std::abs(unknown.*member));
  }
  return size;
}

void scale(std::vector<double>& row, double factor) {
  for (double& value : row) value *= factor;
}

double product(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

double largest_of(const std::vector<double>& row) {
  double size = 0.0;
  for (const double value : row) size = std::max(size, std::abs(value));
  return size;
}

/// A row of the system, as its length times a row of length 1.
struct Row {
  std::vector<double> unit;
  double size = 0.0;
};

Row unit_row(std::vector<double> values) {
  const double size = largest_of(values);
  if (size == 0.0) return {std::move(values), 0.0};
  scale(values, 1.0 / size);  // squares neither overflow nor vanish
  const double length = std::sqrt(product(values, values));
  scale(values, 1.0 / length);
  return {std::move(values), length * size};
}

/// A row of length 1 as a part of another and what is left, at right angles to that.
struct Beside {
  double shared = 0.0;
  Row rest;
};

Beside beside_of(std::vector<double> row, const std::vector<double>& other) {
  double shared = 0.0;
  for (int pass = 0; pass < 2; ++pass) {  // the second takes away what the first left by rounding
    const double part = product(other, row);
    for (std::size_t i = 0; i < row.size(); ++i) row[i] -= part * other[i];
    shared += part;
  }
  return {shared, unit_row(std::move(row))};
}

std::vector<double> row_of(const std::vector<Unknown>& unknowns, const std::vector<double>& roots,
                           double Unknown::*member) {
  std::vector<double> row(unknowns.size(), 0.0);
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (roots[i] > 0.0) row[i] = roots[i] * (unknowns[i].*member);
  }
  return row;
}

/// Square roots of the factors, relative to the largest of those that count.
std::vector<double> roots_of(const std::vector<Unknown>& unknowns, double locality) {
  const double size = largest(unknowns, &Unknown::in_point);
  std::vector<double> roots(unknowns.size(), 0.0);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const Unknown& one = unknowns[i];
    if (!(one.factor > 0.0) || (one.in_point == 0.0 && one.in_tangent == 0.0)) continue;
    const double part = size > 0.0 ? std::abs(one.in_point) / size : 1.0;
    roots[i] = std::sqrt(one.factor) * (locality == 0.0 ? 1.0 : std::pow(part, 0.5 * locality));
  }
  const double most = largest_of(roots);
  if (most > 0.0) scale(roots, 1.0 / most);
  return roots;
}

}  // namespace

Movable::Movable(std::size_t count)
    : in_point(count, 0.0), in_tangent(count, 0.0), measure(count, 0.0), is_fixed(count, 0), leaders_(count) {
  std::iota(leaders_.begin(), leaders_.end(), 0);
}

void Movable::tie(int one, int other) { leaders_[leader(other)] = leader(one); }

int Movable::leader(int i) const {
  while (leaders_[i] != i) i = leaders_[i] = leaders_[leaders_[i]];
  return i;
}

Motion least_change(const Movable& movable, bool has_tangent, const Following& following, const std::string& where) {
  const std::size_t count = movable.in_point.size();
  const std::vector<Unknown> unknowns = unknowns_of(movable, factors_of(following, count));
  const std::vector<double> roots = roots_of(unknowns, following.locality);
  const Row point = unit_row(row_of(unknowns, roots, &Unknown::in_point));
  if (point.size == 0.0) {
    throw InvalidShape("no control point that the point at " + where + " depends on may move");
  }
  Motion least{point.unit, {}};
  scale(least.of_point, 1.0 / point.size);
  if (has_tangent) {
    const Row tangent = unit_row(row_of(unknowns, roots, &Unknown::in_tangent));
    const Beside beside = beside_of(tangent.unit, point.unit);
    if (!(beside.rest.size > kDependent)) {
      throw InvalidShape("the tangent at " + where + " cannot be chosen beside the point: too few control points may move");
    }
    const double back = beside.shared / (beside.rest.size * point.size);
    for (std::size_t i = 0; i < count; ++i) least.of_point[i] -= back * beside.rest.unit[i];
    least.of_tangent = beside.rest.unit;
    scale(least.of_tangent, 1.0 / (beside.rest.size * tangent.size));
  }
  Motion motion{std::vector<double>(count), std::vector<double>(least.of_tangent.size())};
  for (std::size_t i = 0; i < count; ++i) {
    const int leader = movable.leader(static_cast<int>(i));
    const double step = roots[leader] / unknowns[leader].length();
    motion.of_point[i] = step * least.of_point[leader];
    if (has_tangent) motion.of_tangent[i] = step * least.of_tangent[leader];
  }
  return motion;
}

}  // namespace splinecore
