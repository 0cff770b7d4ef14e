#include "function_breaks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/length.hpp"
#include "base/rounding.hpp"
#include "basis/gauss_legendre.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

/// From values at the nodes of an interval to those of its polynomial at the nodes of both halves and at all ends, by the
/// barycentric formula (Berrut and Trefethen 2004). A kink between the last node and the end shows at the end alone.
class NodeHalves {
 public:
  explicit NodeHalves(int count) : nodes_(gauss_legendre(count).nodes), places_(places_of(nodes_)) {
    const std::vector<double> factors = barycentric_factors();
    for (const double node : places_) {
      std::vector<double> row;
      double sum = 0.0;
      for (std::size_t k = 0; k < nodes_.size(); ++k) {
        row.push_back(node == nodes_[k] ? 0.0 : factors[k] / (node - nodes_[k]));
        sum += row.back();
      }
      const auto same = std::ranges::find(nodes_, node);
      for (std::size_t k = 0; k < row.size(); ++k) {
        row[k] = same == nodes_.end() ? row[k] / sum : nodes_[k] == node ? 1.0 : 0.0;
      }
      rows_.push_back(std::move(row));
    }
  }

  std::size_t count() const noexcept { return nodes_.size(); }

  /// Of the interval from 0 to 1: where it is compared.
  std::span<const double> places() const noexcept { return places_; }
  std::span<const double> nodes() const noexcept { return nodes_; }

  /// The largest distance of the polynomial from the values at all places.
  double miss(std::span<const glm::dvec3> whole, std::span<const glm::dvec3> there) const {
    double largest = 0.0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      glm::dvec3 value(0.0);
      for (std::size_t k = 0; k < whole.size(); ++k) value += rows_[i][k] * whole[k];
      largest = std::max(largest, distance_of(value, there[i]));
    }
    return largest;
  }

 private:
  static std::vector<double> places_of(std::span<const double> nodes) {
    std::vector<double> places{0.0, 0.5, 1.0};
    for (const double start : {0.0, 0.5}) {
      for (const double node : nodes) places.push_back(start + 0.5 * node);
    }
    return places;
  }

  std::vector<double> barycentric_factors() const {
    constexpr double kSpread = 4.0;  // products of differences on [0, 1] stay in the range of numbers
    std::vector<double> factors;
    for (const double node : nodes_) {
      double product = 1.0;
      for (const double other : nodes_) product *= node == other ? 1.0 : kSpread * (node - other);
      factors.push_back(1.0 / product);
    }
    return factors;
  }

  std::vector<double> nodes_;
  std::vector<double> places_;
  std::vector<std::vector<double>> rows_;
};

struct FunctionPart {
  double start;
  double end;
  double share;  ///< of its span of knots

  double middle() const { return start + 0.5 * (end - start); }
  bool can_be_halved() const { return middle() > start && middle() < end; }
};

double largest_of(std::span<const glm::dvec3> values) {
  double largest = 0.0;
  for (const glm::dvec3& value : values) largest = std::max(largest, length_of(value));
  return largest;
}

/// Values at the same places of all parts, part after part.
std::vector<glm::dvec3> looked_at(const CurveFunction& function, std::span<const double> places,
                                  std::span<const FunctionPart> parts) {
  std::vector<double> parameters;
  for (const FunctionPart& part : parts) {
    for (const double place : places) {
      parameters.push_back(std::min(part.start + place * (part.end - part.start), part.end));
    }
  }
  return values_of(function, parameters);
}

std::vector<FunctionPart> first_parts(std::span<const double> breaks) {
  constexpr int kEach = 16;
  std::vector<FunctionPart> parts;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    double start = breaks[i];
    for (int k = 1; k <= kEach; ++k) {
      const double end = k == kEach ? breaks[i + 1] : breaks[i] + (breaks[i + 1] - breaks[i]) * k / kEach;
      if (!(end > start)) continue;
      parts.push_back({start, end, 1.0 / kEach});
      start = end;
    }
  }
  return parts;
}

}  // namespace

std::vector<glm::dvec3> values_of(const CurveFunction& function, std::span<const double> parameters) {
  std::vector<glm::dvec3> values(parameters.size());
  function(parameters, values);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const glm::dvec3& value = values[i];
    if (std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z)) continue;
    throw InvalidShape("the function is not finite at " + text_of(parameters[i]));
  }
  return values;
}

std::vector<double> function_breaks(const CurveFunction& function, std::span<const double> breaks, int nodes) {
  constexpr std::size_t kMostParts = 0x1p15;
  const NodeHalves halves(nodes);
  std::vector<double> found(breaks.begin(), breaks.end());
  std::vector<FunctionPart> parts = first_parts(breaks);
  for (const FunctionPart& part : parts) found.push_back(part.end);
  const std::size_t fewest = found.size();
  double size = 0.0;
  while (!parts.empty()) {
    const std::vector<glm::dvec3> values = looked_at(function, halves.nodes(), parts);
    const std::vector<glm::dvec3> others = looked_at(function, halves.places(), parts);
    size = std::max({size, largest_of(values), largest_of(others)});
    std::vector<FunctionPart> rough;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const FunctionPart& part = parts[i];
      breathe(4 * halves.count() * halves.count());
      const double miss = halves.miss(std::span(values).subspan(i * halves.count(), halves.count()),
                                      std::span(others).subspan(i * halves.places().size(), halves.places().size()));
      if (miss * part.share <= kRoundingOfShape * size || !part.can_be_halved()) continue;
      found.push_back(part.middle());
      rough.push_back({part.start, part.middle(), 0.5 * part.share});
      rough.push_back({part.middle(), part.end, 0.5 * part.share});
    }
    parts = std::move(rough);
    if (found.size() - fewest <= kMostParts) continue;
    throw InvalidShape("the function is too rough for its integrals to be told, as near " + text_of(parts.front().start) +
                       ": noise has no projection, and what oscillates fast needs more knots");
  }
  std::ranges::sort(found);
  const auto repeated = std::ranges::unique(found);
  found.erase(repeated.begin(), repeated.end());
  return found;
}

}  // namespace splinecore
