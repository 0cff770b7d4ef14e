#include "least_going_on.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "going_on.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

using HomogeneousRow = std::vector<glm::dvec4>;

/// About the points of an edge: (w (P - O), w). What is at infinity there stays as it is.
HomogeneousRow about(std::span<const glm::dvec4> edge, const HomogeneousRow& row) {
  HomogeneousRow found;
  for (std::size_t i = 0; i < edge.size(); ++i) {
    const glm::dvec3 origin = edge[i].w == 0.0 ? glm::dvec3(0.0) : glm::dvec3(edge[i]) / edge[i].w;
    found.emplace_back(glm::dvec3(row[i]) - row[i].w * origin, row[i].w);
  }
  return found;
}

double product(const HomogeneousRow& a, const HomogeneousRow& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += glm::dot(glm::dvec3(a[i]), glm::dvec3(b[i]));
  return sum;
}

/// By how much of a row what is left of another becomes least.
double share_of(const HomogeneousRow& row, const HomogeneousRow& rest) { return product(row, rest) / product(row, row); }

glm::dvec3 place(const glm::dvec4& p) { return p.w == 0.0 ? glm::dvec3(p) : glm::dvec3(p) / p.w; }

/// One row after the other.
class Fit {
 public:
  Fit(std::span<const glm::dvec4> edge, const LeavingRows& out, const OwnRows& own)
      : own_(own), edge_(about(edge, {edge.begin(), edge.end()})) {
    for (const HomogeneousRow& row : out) out_.push_back(about(edge, row));
    for (const HomogeneousRow& row : own.rows.first(out.size() + 1)) before_.push_back(about(edge, row));
    made_.push_back(edge_);
  }

  /// A derivative, about the edge, by what of it is given and the part of a row that is free.
  HomogeneousRow next(HomogeneousRow given, const HomogeneousRow* free, double& factor) {
    const std::size_t k = made_.size();
    if (free) {
      factor = share_of(*free, rest(k, given));
      add_row(given, factor, *free);
    }
    factors_of_edge_.push_back(own_.are_rational ? of_edge(k, given) : 0.0);
    add_row(given, factors_of_edge_.back(), edge_);
    HomogeneousRow row = given;
    for (std::size_t j = 0; j < k; ++j) add_row(row, -own_.coefficients[k][j], made_[j]);
    for (glm::dvec4& p : row) p /= own_.coefficients[k][k];
    made_.push_back(std::move(row));
    return given;
  }

  /// What a derivative would have to be beside what is given for the rows to stay.
  HomogeneousRow rest(std::size_t k, const HomogeneousRow& given) const {
    HomogeneousRow found = scaled(own_.coefficients[k][k], before_[k]);
    for (std::size_t j = 0; j < k; ++j) add_row(found, own_.coefficients[k][j], made_[j]);
    add_row(found, -1.0, given);
    return found;
  }

  /// The sum of the squares of what points have moved by.
  double change() const {
    double sum = 0.0;
    for (std::size_t k = 1; k < made_.size(); ++k) {
      for (std::size_t i = 0; i < edge_.size(); ++i) {
        const glm::dvec3 way = place(made_[k][i]) - place(before_[k][i]);
        sum += glm::dot(way, way);
      }
    }
    return sum;
  }

  const HomogeneousRow& out(std::size_t order) const { return out_[order - 1]; }
  /// Derivative k of L.
  double of_edge(std::size_t k) const { return factors_of_edge_[k - 1]; }

 private:
  /// How much of the edge moves the weights of row k least, and more where one would fall below what it was and below a
  /// quarter of that on the edge.
  double of_edge(std::size_t k, const HomogeneousRow& given) const {
    constexpr double kShare = 0.25;
    const HomogeneousRow left = rest(k, given);
    double along = 0.0;
    double square = 0.0;
    bool are_positive = true;
    for (std::size_t i = 0; i < edge_.size(); ++i) {
      along += edge_[i].w * left[i].w;
      square += edge_[i].w * edge_[i].w;
      are_positive = are_positive && edge_[i].w > 0.0;
    }
    double factor = square > 0.0 ? along / square : 0.0;
    for (std::size_t i = 0; i < edge_.size() && are_positive; ++i) {
      const double was = before_[k][i].w;
      const double share = kShare * edge_[i].w;
      const double least = was > 0.0 ? std::min(was, share) : share;
      factor = std::max(factor, (left[i].w + own_.coefficients[k][k] * (least - was)) / edge_[i].w);
    }
    return factor;
  }

  const OwnRows& own_;
  HomogeneousRow edge_;
  std::vector<HomogeneousRow> out_;
  std::vector<HomogeneousRow> before_;
  std::vector<HomogeneousRow> made_;
  std::vector<double> factors_of_edge_;
};

/// How fast the patch leaves its own side, by how fast the other one does there.
double own_pace(std::span<const glm::dvec4> edge, const LeavingRows& out, const OwnRows& own) {
  const HomogeneousRow slope = about(edge, out.front());
  const HomogeneousRow leg = scaled(own.coefficients[1][1], about(own.rows[0], own.rows[1]));
  const double pace = std::sqrt(product(leg, leg) / product(slope, slope));
  if (pace > 0.0 && std::isfinite(pace)) return pace;
  throw InvalidShape("a patch has a zero derivative across its side: it cannot be continued there");
}

/// The derivatives with a pace, and the sum of the squares of what the rows move by.
struct Going {
  LeavingRows rows;
  double change;
};

Going going(std::span<const glm::dvec4> edge, const LeavingRows& out, const OwnRows& own, double k) {
  Fit fit(edge, out, own);
  double m = 0.0;
  double n = 0.0;
  Going found{{fit.next(scaled(k, fit.out(1)), nullptr, m)}, 0.0};
  if (out.size() > 1) {
    HomogeneousRow given = scaled(k * k, fit.out(2));
    add_row(given, 2.0 * fit.of_edge(1) * k, fit.out(1));
    found.rows.push_back(fit.next(std::move(given), &fit.out(1), m));
  }
  if (out.size() > 2) {
    HomogeneousRow given = scaled(k * k * k, fit.out(3));
    add_row(given, 3.0 * k * (m + fit.of_edge(1) * k), fit.out(2));
    add_row(given, 3.0 * (fit.of_edge(1) * m + fit.of_edge(2) * k), fit.out(1));
    found.rows.push_back(fit.next(std::move(given), &fit.out(1), n));
  }
  found.change = fit.change();
  return found;
}

/// The pace by which all rows together move least, between about an eighth and eight times the patch's own: where a step
/// less and a step more move the rows alike. The least value itself would be known to half of the digits only.
double least_pace(std::span<const glm::dvec4> edge, const LeavingRows& out, const OwnRows& own, double mean) {
  constexpr int kSteps = 24;
  constexpr int kHalvings = 52;
  constexpr double kStep = 0.25;  // in powers of two
  const auto change = [&](double exponent) { return going(edge, out, own, mean * std::exp2(exponent)).change; };
  const auto rises = [&](double exponent) { return change(exponent + kStep) >= change(exponent - kStep); };
  double best = 0.0;
  double least = change(best);
  for (int step = 0; step <= kSteps; ++step) {
    const double exponent = kStep * (step - kSteps / 2);
    const double one = change(exponent);
    if (!(one < least)) continue;
    best = exponent;
    least = one;
  }
  double low = best - kStep;
  double high = best + kStep;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (rises(middle) ? high : low) = middle;
  }
  return mean * std::exp2(0.5 * (low + high));
}

/// How fast the patch is to leave its side, by the other one: as it moves least, unless it would be folded back, or nearly.
double pace_of(std::span<const glm::dvec4> edge, const LeavingRows& out, const OwnRows& own, PaceFor rows) {
  constexpr double kLeastShare = 0.1;
  const double mean = own_pace(edge, out, own);
  if (rows == PaceFor::all_rows) return least_pace(edge, out, own, mean);
  const Fit fit(edge, out, own);
  const double least = share_of(fit.out(1), fit.rest(1, HomogeneousRow(edge.size(), glm::dvec4(0.0))));
  return least >= kLeastShare * mean ? least : mean;
}

/// A row about the edge where it is.
HomogeneousRow back(std::span<const glm::dvec4> edge, HomogeneousRow row) {
  for (std::size_t i = 0; i < edge.size(); ++i) {
    if (edge[i].w == 0.0) continue;
    row[i] += glm::dvec4(row[i].w / edge[i].w * glm::dvec3(edge[i]), 0.0);
  }
  return row;
}

}  // namespace

LeavingRows least_going_on(std::span<const glm::dvec4> edge, const LeavingRows& out, const OwnRows& own,
                           PaceFor rows, double strength) {
  LeavingRows found = going(edge, out, own, strength * pace_of(edge, out, own, rows)).rows;
  for (HomogeneousRow& row : found) row = back(edge, std::move(row));
  return found;
}

}  // namespace splinecore
