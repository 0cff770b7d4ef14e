#include "splinecore/build/joint_equations.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>

#include "base/quotient.hpp"
#include "joint_order.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

using Factors = std::array<double, 3>;             // of the rows of a strip
using LegColumn = std::array<glm::dvec4, 3>;       // homogeneous points about that of the edge

/// A strip about its edge, and what its rows count in the derivatives across (The NURBS Book, formulas 3.4 and 3.8).
struct EdgeLeg {
  std::vector<LegColumn> columns;
  std::array<Factors, 3> across;

  glm::dvec4 derivative(std::size_t column, int order) const {
    glm::dvec4 sum(0.0);
    for (int i = 0; i < 3; ++i) sum += across[order][i] * columns[column][i];
    return sum;
  }
};

std::array<Factors, 3> across(const EdgeStrip& strip, double sign, double unit) {
  const double p = strip.degree;
  const double one = strip.first_span / unit;
  const double two = strip.second_span / unit;
  const double slope = sign * p / one;
  const double bend = (p - 1.0) * p / one;
  return {{{1.0, 0.0, 0.0}, {-slope, slope, 0.0}, {bend / one, -bend * (1.0 / one + 1.0 / two), bend / two}}};
}

EdgeLeg leg_of(const EdgeStrip& strip, const std::vector<glm::dvec4>& edge, double sign, double unit) {
  EdgeLeg leg{{}, across(strip, sign, unit)};
  for (std::size_t i = 0; i < edge.size(); ++i) {
    LegColumn column;
    for (int j = 0; j < 3; ++j) {
      const glm::dvec4& point = strip.rows[j][i];
      const glm::dvec3 place = point.w != 0.0 ? (glm::dvec3(point) - glm::dvec3(edge[i])) * point.w : glm::dvec3(point);
      column[j] = glm::dvec4(place, point.w);
    }
    leg.columns.push_back(column);
  }
  return leg;
}

/// Both legs in units of what is farthest from the edge.
void scale_to_one(EdgeLeg& first, EdgeLeg& second) {
  double reach = 0.0;
  for (const EdgeLeg* const leg : {&first, &second}) {
    for (const LegColumn& column : leg->columns) {
      for (const glm::dvec4& point : column) reach = std::max({reach, std::abs(point.x), std::abs(point.y), std::abs(point.z)});
    }
  }
  if (!(reach > 0.0)) return;
  for (EdgeLeg* const leg : {&first, &second}) {
    for (LegColumn& column : leg->columns) {
      for (glm::dvec4& point : column) point = glm::dvec4(glm::dvec3(point) / reach, point.w);
    }
  }
}

/// Numbers by which one row of vectors is the other, by least squares.
class Ratio {
 public:
  void add(double of, double by) {
    product_ += of * by;
    square_ += by * by;
  }
  void add(const glm::dvec4& of, const glm::dvec4& by) {
    product_ += glm::dot(glm::dvec3(of), glm::dvec3(by));
    square_ += glm::dot(glm::dvec3(by), glm::dvec3(by));
  }
  double value() const { return square_ > 0.0 ? product_ / square_ : 0.0; }

 private:
  double product_ = 0.0;
  double square_ = 0.0;
};

/// What the first side counts in a derivative of the second: its rows, and its edge beside that.
struct OfFirst {
  Factors rows{};
  double edge = 0.0;
};

class JointCondition {
 public:
  JointCondition(const EdgeLeg& first, const EdgeLeg& second, bool parametric) : first_(first), second_(second) {
    const std::size_t count = first.columns.size();
    Ratio weights;
    for (std::size_t i = 0; i < count; ++i) weights.add(second.columns[i][0].w, edge(i));
    weights_ = parametric ? 1.0 : weights.value();
    Ratio k;
    for (std::size_t i = 0; i < count; ++i) k.add(second.derivative(i, 1), first.derivative(i, 1));
    k_ = parametric ? 1.0 : k.value();
    Ratio g;
    for (std::size_t i = 0; i < count; ++i) g.add(second.derivative(i, 1).w - k_ * first.derivative(i, 1).w, edge(i));
    g_ = g.value();
    const auto rest = [&](std::size_t i) { return second.derivative(i, 2) - bend() * first.derivative(i, 2); };
    Ratio m;
    for (std::size_t i = 0; i < count; ++i) m.add(rest(i), first.derivative(i, 1));
    m_ = parametric ? 2.0 * g_ * k_ : m.value();
    Ratio e;
    for (std::size_t i = 0; i < count; ++i) e.add(rest(i).w - m_ * first.derivative(i, 1).w, edge(i));
    e_ = e.value();
  }

  OfFirst of_first(int order) const {
    OfFirst found;
    for (int i = 0; i < 3; ++i) {
      found.rows[i] = order == 1 ? k_ * first_.across[1][i] : bend() * first_.across[2][i] + m_ * first_.across[1][i];
    }
    found.edge = order == 1 ? g_ : e_;
    return found;
  }

  bool holds(int order) const {
    constexpr double kHolds = 1e-6;
    const OfFirst on = of_first(order);
    glm::dvec4 largest(0.0);
    std::vector<glm::dvec4> sums;
    for (std::size_t i = 0; i < first_.columns.size(); ++i) {
      glm::dvec4 sum(0.0);
      const auto add = [&](const glm::dvec4& term) {
        sum += term;
        largest = glm::max(largest, glm::abs(term));
      };
      for (int j = 0; j < 3; ++j) add(-on.rows[j] * first_.columns[i][j]);
      for (int j = 0; j < 3; ++j) add(second_.across[order][j] * second_.columns[i][j]);
      add(glm::dvec4(0.0, 0.0, 0.0, -on.edge * edge(i)));
      sums.push_back(sum);
    }
    const double most = kHolds * std::max({largest.x, largest.y, largest.z});
    return k_ / weights_ > 0.0 && std::ranges::all_of(sums, [&](const glm::dvec4& sum) {
      return std::abs(sum.x) <= most && std::abs(sum.y) <= most && std::abs(sum.z) <= most && std::abs(sum.w) <= kHolds * largest.w;
    });
  }

 private:
  double edge(std::size_t column) const { return first_.columns[column][0].w; }

  double bend() const { return k_ * k_ / weights_; }

  const EdgeLeg& first_;
  const EdgeLeg& second_;
  double weights_ = 1.0;  // at the edge, those of the second side by those of the first
  double k_ = 0.0;
  double g_ = 0.0;
  double m_ = 0.0;
  double e_ = 0.0;
};

/// A weight, and 1 for a direction, which moves as it is.
double weight_of(const glm::dvec4& point) { return point.w != 0.0 ? point.w : 1.0; }

std::vector<ColumnFactors> factors_of(const EdgeLeg& first, const EdgeLeg& second, const OfFirst& on, int order) {
  std::vector<ColumnFactors> all;
  for (std::size_t i = 0; i < first.columns.size(); ++i) {
    ColumnFactors factors;
    for (int j = 0; j < 3; ++j) {
      factors[j] = 0.0 - on.rows[j] * weight_of(first.columns[i][j]);
      factors[3 + j] = second.across[order][j] * weight_of(second.columns[i][j]);
    }
    factors[0] -= on.edge * weight_of(first.columns[i][0]);
    all.push_back(factors);
  }
  return all;
}

void require_strip(const EdgeStrip& strip, std::size_t columns, const char* name) {
  const std::string of = std::string(name) + " side of the edge ";
  if (strip.degree < 1) throw InvalidShape("the " + of + "has degree " + std::to_string(strip.degree) + ": 1 or more is expected");
  if (!(strip.first_span > 0.0 && strip.second_span >= strip.first_span && std::isfinite(strip.second_span))) {
    throw InvalidShape("the spans of the " + of + "are " + text_of(strip.first_span) + " and " + text_of(strip.second_span) +
                       ": they start above 0 and do not decrease");
  }
  for (const std::vector<glm::dvec4>& row : strip.rows) {
    if (row.size() != columns || row.empty()) {
      throw InvalidShape("the " + of + "has " + std::to_string(row.size()) + " columns, " +
                         (columns > 0 ? std::to_string(columns) : "1 or more") + " are expected");
    }
    for (const glm::dvec4& point : row) {
      if (!is_finite(glm::dvec3(point)) || !std::isfinite(point.w)) throw InvalidShape("a point of the " + of + "is not finite");
    }
  }
}

}  // namespace

std::optional<std::vector<std::vector<ColumnFactors>>> joint_equations(const EdgeStrip& first, const EdgeStrip& second,
                                                                       PatchSmoothness smoothness) {
  const std::vector<glm::dvec4>& edge = first.rows[0];
  require_strip(first, edge.size(), "first");
  require_strip(second, edge.size(), "second");
  if (std::ranges::any_of(edge, [](const glm::dvec4& point) { return point.w == 0.0; })) return std::nullopt;
  const double unit = std::max(first.first_span, second.first_span);
  EdgeLeg out = leg_of(first, edge, -1.0, unit);
  EdgeLeg into = leg_of(second, edge, 1.0, unit);
  scale_to_one(out, into);
  const JointCondition condition(out, into, is_parametric(smoothness));
  std::vector<std::vector<ColumnFactors>> equations;
  for (int order = 1; order <= order_of(smoothness); ++order) {
    if (!condition.holds(order)) return std::nullopt;
    equations.push_back(factors_of(out, into, condition.of_first(order), order));
  }
  return equations;
}

}  // namespace splinecore
