#include "least_change.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

/// What is left of an equation beside those before it is rounding, as a part of it, below this.
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
  std::array<double, 3> in{};
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
    unknown.in[0] += movable.in_point[i];
    unknown.in[1] += movable.in_first[i];
    unknown.in[2] += movable.in_second[i];
    unknown.measure += movable.measure[i];
    unknown.measured += movable.measure[i] > 0.0 ? 1 : 0;
    unknown.factor = std::min(unknown.factor, movable.is_fixed[i] ? 0.0 : factors[i]);
  }
  for (Unknown& unknown : unknowns) {
    for (double& part : unknown.in) part /= unknown.length();
  }
  return unknowns;
}

double largest_in_point(const std::vector<Unknown>& unknowns) {
  double size = 0.0;
  for (const Unknown& unknown : unknowns) {
    if (unknown.factor > 0.0) size = std::max(size, std::abs(unknown.in[0]));
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

/// Rows of length 1, each at right angles to those before, and what the rows of a system are made of.
struct Orthogonal {
  std::vector<std::vector<double>> units;
  std::vector<std::vector<double>> parts;  // of each row, taken as 1 long: of the units up to its own
  std::vector<double> sizes;               // of the rows

  /// Whether a row is another than those before.
  bool add(std::vector<double> values) {
    Row row = unit_row(std::move(values));
    if (row.size == 0.0) return false;
    std::vector<double> part(units.size(), 0.0);
    for (int pass = 0; pass < 2; ++pass) {  // the second takes away what the first left by rounding
      for (std::size_t k = 0; k < units.size(); ++k) {
        const double shared = product(units[k], row.unit);
        for (std::size_t i = 0; i < row.unit.size(); ++i) row.unit[i] -= shared * units[k][i];
        part[k] += shared;
      }
    }
    Row rest = unit_row(std::move(row.unit));
    if (!(rest.size > kDependent)) return false;
    part.push_back(rest.size);
    units.push_back(std::move(rest.unit));
    parts.push_back(std::move(part));
    sizes.push_back(row.size);
    return true;
  }

  /// The least solution of the system whose right side is 1 in row k, and 0 in the others.
  std::vector<double> solution(std::size_t k) const {
    std::vector<double> along(units.size(), 0.0);
    std::vector<double> found(units.front().size(), 0.0);
    for (std::size_t row = k; row < units.size(); ++row) {
      double right = row == k ? 1.0 : 0.0;
      for (std::size_t before = k; before < row; ++before) right -= parts[row][before] * along[before];
      along[row] = right / parts[row][row];
      for (std::size_t i = 0; i < found.size(); ++i) found[i] += along[row] * units[row][i];
    }
    scale(found, 1.0 / sizes[k]);
    return found;
  }
};

std::vector<double> row_of(const std::vector<Unknown>& unknowns, const std::vector<double>& roots, int order) {
  std::vector<double> row(unknowns.size(), 0.0);
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (roots[i] > 0.0) row[i] = roots[i] * unknowns[i].in[order];
  }
  return row;
}

/// Square roots of the factors, relative to the largest of those that count.
std::vector<double> roots_of(const std::vector<Unknown>& unknowns, double locality) {
  const double size = largest_in_point(unknowns);
  std::vector<double> roots(unknowns.size(), 0.0);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const Unknown& one = unknowns[i];
    if (!(one.factor > 0.0) || one.in == std::array<double, 3>{}) continue;
    const double part = size > 0.0 ? std::abs(one.in[0]) / size : 1.0;
    roots[i] = std::sqrt(one.factor) * (locality == 0.0 ? 1.0 : std::pow(part, 0.5 * locality));
  }
  const double most = largest_of(roots);
  if (most > 0.0) scale(roots, 1.0 / most);
  return roots;
}

}  // namespace

Movable::Movable(std::size_t count)
    : in_point(count, 0.0), in_first(count, 0.0), in_second(count, 0.0), measure(count, 0.0), is_fixed(count, 0), leaders_(count) {
  std::iota(leaders_.begin(), leaders_.end(), 0);
}

void Movable::tie(int one, int other) { leaders_[leader(other)] = leader(one); }

int Movable::leader(int i) const {
  while (leaders_[i] != i) i = leaders_[i] = leaders_[leaders_[i]];
  return i;
}

Motion least_change(const Movable& movable, std::span<const char* const> chosen, const Following& following,
                    const std::string& where) {
  const std::size_t count = movable.in_point.size();
  const std::vector<Unknown> unknowns = unknowns_of(movable, factors_of(following, count));
  const std::vector<double> roots = roots_of(unknowns, following.locality);
  Orthogonal system;
  if (!system.add(row_of(unknowns, roots, 0))) {
    throw InvalidShape("no control point that the point at " + where + " depends on may move");
  }
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    if (system.add(row_of(unknowns, roots, static_cast<int>(k) + 1))) continue;
    throw InvalidShape(std::string(chosen[k]) + " at " + where +
                       " cannot be chosen beside the point: too few control points may move");
  }
  Motion motion;
  for (std::size_t k = 0; k < system.units.size(); ++k) {
    const std::vector<double> least = system.solution(k);
    std::vector<double>& steps = motion.emplace_back(count);
    for (std::size_t i = 0; i < count; ++i) {
      const int leader = movable.leader(static_cast<int>(i));
      steps[i] = roots[leader] / unknowns[leader].length() * least[leader];
    }
  }
  return motion;
}

}  // namespace splinecore
