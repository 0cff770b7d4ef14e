#include "moment_integral.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <string>
#include <utility>

#include "kronrod_21.hpp"
#include "patch/bezier_piece.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/basis/bernstein.hpp"
#include "surface_rule.hpp"

namespace splinecore {

namespace {

constexpr std::size_t kCount = 2 * kKronrod21.size() - 1;
/// The changes of a rule are no bound; to be sure they are kept so much smaller.
constexpr double kCaution = 0.125;
constexpr std::size_t kMostCells = 16'000;

KronrodNode node_at(std::size_t i) {
  if (i < kKronrod21.size()) return kKronrod21[i];
  KronrodNode node = kKronrod21[kCount - 1 - i];
  node.at = 1.0 - node.at;
  return node;
}

/// Bernstein polynomials and their slopes at the nodes, node after node.
struct Functions {
  explicit Functions(std::size_t count) : values(kCount * count), slopes(values.size()) {
    const int degree = static_cast<int>(count) - 1;
    std::vector<double> less(degree);
    for (std::size_t i = 0; i < kCount; ++i) {
      const double at = node_at(i).at;
      const double rest = i < kKronrod21.size() ? 1.0 - at : kKronrod21[kCount - 1 - i].at;
      bernstein(degree, at, rest, std::span(values).subspan(i * count, count));
      bernstein(degree - 1, at, rest, less);
      for (int k = 0; k <= degree; ++k) {
        slopes[i * count + k] = degree * ((k > 0 ? less[k - 1] : 0.0) - (k < degree ? less[k] : 0.0));
      }
    }
  }

  std::vector<double> values;
  std::vector<double> slopes;
};

/// A surface at a place, homogeneous, with its derivatives.
struct Place {
  glm::dvec4 point{0.0};
  glm::dvec4 along_u{0.0};
  glm::dvec4 along_v{0.0};
};

/// The integrands at a place, and the size of their terms.
std::pair<MomentValues, MomentValues> integrands_at(const Place& place) {
  const double w = place.point.w;
  const glm::dvec3 s = glm::dvec3(place.point) / w;
  const glm::dvec3 along_u = (glm::dvec3(place.along_u) - place.along_u.w * s) / w;
  const glm::dvec3 along_v = (glm::dvec3(place.along_v) - place.along_v.w * s) / w;
  const double flux = glm::dot(s, glm::cross(along_u, along_v));
  const double far = glm::length(s);
  const double size = far * glm::length(along_u) * glm::length(along_v);
  MomentValues values{flux / 3.0};
  MomentValues terms{size / 3.0};
  int at = 4;
  for (int i = 0; i < 3; ++i) {
    values[1 + i] = s[i] * flux / 4.0;
    terms[1 + i] = far * size / 4.0;
    for (int j = i; j < 3; ++j, ++at) {
      values[at] = s[i] * s[j] * flux / 5.0;
      terms[at] = far * far * size / 5.0;
    }
  }
  return {values, terms};
}

/// The rules of 10 and 21 nodes on a piece, along both directions.
class Rule {
 public:
  Rule(std::size_t rows, std::size_t columns) : u_(rows), v_(columns) {}

  MomentSums operator()(const BernsteinNet<glm::dvec4>& net) {
    breathe(kCount * (8 * net.values.size() + kCount * (12 * net.columns + 80)));
    points_.resize(net.columns);
    slopes_.resize(net.columns);
    MomentSums found;
    for (std::size_t i = 0; i < kCount; ++i) {
      const KronrodNode node = node_at(i);
      const MomentSums line = line_at(net, i);
      for (int k = 0; k < kMoments; ++k) {
        found.values[k] += node.kronrod * line.values[k];
        found.errors[0][k] += (node.kronrod - node.gauss) * line.values[k];
        found.errors[1][k] += node.kronrod * line.errors[1][k];
        found.terms[k] += node.kronrod * line.terms[k];
      }
    }
    for (MomentValues& errors : found.errors) {
      for (double& error : errors) error = std::abs(error);
    }
    return found;
  }

 private:
  MomentSums line_at(const BernsteinNet<glm::dvec4>& net, std::size_t i) {
    std::ranges::fill(points_, glm::dvec4(0.0));
    std::ranges::fill(slopes_, glm::dvec4(0.0));
    for (std::size_t k = 0; k < net.rows; ++k) {
      for (std::size_t j = 0; j < net.columns; ++j) {
        points_[j] += u_.values[i * net.rows + k] * net.at(k, j);
        slopes_[j] += u_.slopes[i * net.rows + k] * net.at(k, j);
      }
    }
    MomentSums line;
    for (std::size_t n = 0; n < kCount; ++n) {
      const KronrodNode node = node_at(n);
      Place place;
      for (std::size_t j = 0; j < net.columns; ++j) {
        const double value = v_.values[n * net.columns + j];
        place.point += value * points_[j];
        place.along_u += value * slopes_[j];
        place.along_v += v_.slopes[n * net.columns + j] * points_[j];
      }
      const auto [values, terms] = integrands_at(place);
      for (int k = 0; k < kMoments; ++k) {
        line.values[k] += node.kronrod * values[k];
        line.errors[1][k] += (node.kronrod - node.gauss) * values[k];
        line.terms[k] += node.kronrod * terms[k];
      }
    }
    return line;
  }

  Functions u_;
  Functions v_;
  std::vector<glm::dvec4> points_;
  std::vector<glm::dvec4> slopes_;
};

struct Cell {
  SurfacePiece piece;
  std::size_t rule;
  MomentSums found;
};

class Adaptive {
 public:
  explicit Adaptive(const char* what) : what_(what) {}

  void add(const NurbsPatch& patch) {
    const KnotVector& u = patch.knot_vector(Axis::u);
    const KnotVector& v = patch.knot_vector(Axis::v);
    rules_.emplace_back(u.degree() + 1, v.degree() + 1);
    for (int i = 0; i < static_cast<int>(u.spans().size()); ++i) {
      for (int j = 0; j < static_cast<int>(v.spans().size()); ++j) add_piece({.net = bezier_piece(patch, i, j)});
    }
  }

  FoundMoments found(const MomentTargets& targets) {
    const std::size_t most = kMostCells + 4 * cells_.size();
    while (true) {
      const MomentSums sums = sum();
      const MomentValues allowed = targets(sums);
      double excess = 0.0;
      for (int k = 0; k < kMoments; ++k) {
        const double error = sums.error(k);
        const bool is_wrong = error > std::max(kCaution * allowed[k], 2.0 * sums.rounding(k));
        if (is_wrong) excess = std::max(excess, error / allowed[k]);
      }
      if (excess == 0.0 || cells_.size() > most || !refine(allowed)) return {sums, excess};
    }
  }

 private:
  void add_piece(SurfacePiece first) {
    constexpr double kMost = 16.0;
    first.normalise();
    std::vector<SurfacePiece> stack{std::move(first)};
    for (std::size_t cuts = 0; !stack.empty();) {
      SurfacePiece piece = std::move(stack.back());
      stack.pop_back();
      const Unevenness u = piece.unevenness(Axis::u);
      const Unevenness v = piece.unevenness(Axis::v);
      if (std::max(u.ratio, v.ratio) <= kMost) {
        put(std::move(piece), rules_.size() - 1, cells_);
        continue;
      }
      if (++cuts > kMostCells) throw InvalidShape(too_different("weights of the patch"));
      stack.emplace_back();
      piece.halve(u > v ? Axis::u : Axis::v, stack.back());
      stack.push_back(std::move(piece));
    }
  }

  void put(SurfacePiece piece, std::size_t rule, std::vector<Cell>& out) {
    const MomentSums found = rules_[rule](piece.net);
    out.push_back({std::move(piece), rule, found});
  }

  std::string too_different(const char* which) const {
    return std::string(what_) + ": the " + which + " differ too much in size for it";
  }

  MomentSums sum() const {
    MomentSums sums;
    for (int k = 0; k < kMoments; ++k) {
      double lost = 0.0;  // of many cells: what a sum loses goes into the next one (Kahan 1965)
      for (const Cell& cell : cells_) {
        const double more = cell.found.values[k] - lost;
        const double total = sums.values[k] + more;
        lost = (total - sums.values[k]) - more;
        sums.values[k] = total;
        for (int axis = 0; axis < 2; ++axis) sums.errors[axis][k] += cell.found.errors[axis][k];
        sums.terms[k] += cell.found.terms[k];
      }
      if (!std::isfinite(sums.values[k]) || !std::isfinite(sums.terms[k]) || !std::isfinite(sums.error(k))) {
        throw InvalidShape(too_different("points and weights"));
      }
    }
    return sums;
  }

  /// How many times a cell is off along a direction by its share, where that is more than rounding.
  static double wrongness(const Cell& cell, int axis, const MomentValues& shares) {
    double most = 0.0;
    for (int k = 0; k < kMoments; ++k) {
      const double error = cell.found.errors[axis][k];
      if (error > cell.found.rounding(k)) most = std::max(most, error / shares[k]);
    }
    return most;
  }

  /// Halves the cells that are off by more than their share. False if there was none.
  bool refine(const MomentValues& allowed) {
    MomentValues shares = allowed;
    for (double& share : shares) share *= 0.25 * kCaution / static_cast<double>(cells_.size());
    std::vector<Cell> next;
    next.reserve(cells_.size());
    bool is_finer = false;
    for (Cell& cell : cells_) {
      const double u = wrongness(cell, 0, shares);
      const double v = wrongness(cell, 1, shares);
      if (std::max(u, v) <= 1.0) {
        next.push_back(std::move(cell));
        continue;
      }
      is_finer = true;
      SurfacePiece second;
      cell.piece.halve(u > v ? Axis::u : Axis::v, second);
      put(std::move(cell.piece), cell.rule, next);
      put(std::move(second), cell.rule, next);
    }
    cells_ = std::move(next);
    return is_finer;
  }

  const char* what_;
  std::vector<Rule> rules_;
  std::vector<Cell> cells_;
};

}  // namespace

FoundMoments moments_of(const std::vector<NurbsPatch>& patches, const MomentTargets& targets, const char* what) {
  Adaptive adaptive(what);
  for (const NurbsPatch& patch : patches) adaptive.add(patch);
  return adaptive.found(targets);
}

}  // namespace splinecore
