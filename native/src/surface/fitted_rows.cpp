#include "fitted_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "base/length.hpp"
#include "base/sort_by.hpp"
#include "fit/row_spline.hpp"
#include "greville.hpp"
#include "splinecore/base/approximation.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/basis/samples.hpp"

namespace splinecore {

namespace {

constexpr int kDegree = 3;
constexpr std::size_t kMostRows = 1 << 14;
/// A little below the tolerance, for what lies between the places that are measured.
constexpr double kAccepted = 0.85;
/// Steps of numbers as large as parameters are that are too short to be parted.
double shortest_in(const Interval& interval) {
  constexpr double kShortest = 0x1p-46;
  return kShortest * std::max(std::abs(interval.start), std::abs(interval.end));
}

double distance_between(const glm::dvec4& a, const glm::dvec4& b) {
  if (a.w == 0.0 || b.w == 0.0) return length_of(glm::dvec3(a) - glm::dvec3(b));
  return length_of(glm::dvec3(a) * (1.0 / a.w) - glm::dvec3(b) * (1.0 / b.w));
}

/// The larger one; what is no number counts as larger than any.
double worse(double a, double b) { return a >= b || std::isnan(a) ? a : b; }

/// A part of a stretch in which rows are smooth.
struct RowPiece {
  double start;
  double end;
  int copies;                      ///< of its start, if a knot is there
  std::vector<glm::dvec4> wanted;  ///< at places of it, row after row; empty until they are asked for
};

/// As parts of a piece: its start, and near where a cubic through four or two places of it is farthest off.
constexpr std::array kPlaces{0.0, 0.125, 0.4, 0.6, 0.875};

void add_places(const RowPiece& piece, std::vector<double>& at) {
  for (const double place : kPlaces) at.push_back(piece.start + (piece.end - piece.start) * place);
}

/// What lies between two knots: pieces.
struct RowStep {
  std::vector<RowPiece> pieces;
  double error = 0.0;

  double start() const { return pieces.front().start; }
  double end() const { return pieces.back().end; }
};

RowPiece part_of(const RowPiece& piece, int k, int parts) {
  const auto at = [&](int i) { return i == parts ? piece.end : piece.start + (piece.end - piece.start) * i / parts; };
  return {at(k), at(k + 1), k == 0 ? piece.copies : 1, {}};
}

/// Where pieces begin that are nearest to even shares of a step.
std::vector<std::size_t> cuts_of(const RowStep& step, int parts) {
  std::vector<std::size_t> cuts;
  for (int k = 1; k < parts; ++k) {
    const double wanted = step.start() + (step.end() - step.start()) * k / parts;
    std::size_t nearest = 1;
    for (std::size_t i = 2; i < step.pieces.size(); ++i) {
      if (std::abs(step.pieces[i].start - wanted) < std::abs(step.pieces[nearest].start - wanted)) nearest = i;
    }
    if (cuts.empty() || nearest > cuts.back()) cuts.push_back(nearest);
  }
  return cuts;
}

/// Between pieces, if there are several.
std::vector<RowStep> parted(RowStep step, int parts) {
  std::vector<RowStep> made;
  if (step.pieces.size() == 1) {
    for (int k = 0; k < parts; ++k) made.push_back({{part_of(step.pieces[0], k, parts)}});
    return made;
  }
  std::vector<std::size_t> cuts = cuts_of(step, parts);
  cuts.push_back(step.pieces.size());
  std::size_t begin = 0;
  for (const std::size_t end : cuts) {
    made.emplace_back();
    for (; begin < end; ++begin) made.back().pieces.push_back(std::move(step.pieces[begin]));
  }
  return made;
}

/// Pieces between joints.
RowStep whole_of(const Interval& interval, const std::vector<RowJoint>& joints) {
  const auto is_same = [&](double a, double b) { return b - a <= shortest_in(interval); };
  RowStep step{{{interval.start, interval.end, 1, {}}}};
  for (const RowJoint& joint : joints) {
    RowPiece& last = step.pieces.back();
    if (is_same(last.start, joint.at)) {
      last.copies = std::max(last.copies, joint.copies);
    } else if (!is_same(joint.at, interval.end)) {
      last.end = joint.at;
      step.pieces.push_back({joint.at, interval.end, joint.copies, {}});
    }
  }
  return step;
}

void write_row(const FittedRows& made, const Samples& samples, std::size_t sample, std::vector<glm::dvec4>& row) {
  const auto count = static_cast<std::size_t>(made.knots.count());
  std::ranges::fill(row, glm::dvec4(0.0));
  auto next = static_cast<std::size_t>(samples.first(sample));
  for (const double weight : samples.weights(sample)) {
    const glm::dvec4* const from = &made.rows[(next++ % count) * row.size()];
    for (std::size_t j = 0; j < row.size(); ++j) row[j] += weight * from[j];
  }
}

/// One stretch without corners.
class RowStretch {
 public:
  RowStretch(const RowsAt& rows_at, const Interval& interval, const std::vector<RowJoint>& joints, Closing closing)
      : rows_at_(rows_at), interval_(interval), closing_(closing), steps_{whole_of(interval, joints)} {
    constexpr int kAround = 8;
    if (closing == Closing::closed) steps_ = parted(std::move(steps_[0]), kAround);
  }

  FittedRows within(double tolerance) {
    const double accepted = kAccepted * tolerance;
    for (;;) {
      ask();
      FittedRows made = through();
      measure(made);
      const auto is_missed = [&](const RowStep& step) { return !(step.error <= accepted); };
      if (std::ranges::none_of(steps_, is_missed)) return said(std::move(made));
      const bool is_short = std::ranges::any_of(steps_, [&](const RowStep& step) {
        return is_missed(step) && step.end() - step.start() <= shortest_in(interval_);
      });
      if ((steps_.size() > kMostRows || is_short) && made.error <= tolerance) return made;
      if (steps_.size() > kMostRows || is_short) {
        throw ToleranceNotReached("the surface cannot be fitted with " + std::to_string(made.knots.count()) + " rows of control points",
                                  tolerance, made.error);
      }
      part(accepted);
    }
  }

 private:
  /// With an error that what lies between places does not pass either.
  static FittedRows said(FittedRows made) {
    made.error /= kAccepted;
    return made;
  }

  /// Asks for the wanted rows of all pieces that have none.
  void ask() {
    std::vector<double> at;
    std::vector<RowPiece*> asked;
    for (RowStep& step : steps_) {
      for (RowPiece& piece : step.pieces) {
        if (!piece.wanted.empty()) continue;
        asked.push_back(&piece);
        add_places(piece, at);
      }
    }
    if (asked.empty()) return;
    const std::vector<glm::dvec4> found = rows_at_(at, interval_);
    const auto size = static_cast<std::ptrdiff_t>(found.size() / asked.size());
    auto next = found.begin();
    for (RowPiece* const piece : asked) {
      piece->wanted.assign(next, next + size);
      next += size;
    }
  }

  KnotVector knots() const {
    std::vector<double> knots;
    const bool is_closed = closing_ == Closing::closed;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      const bool is_end = i == 0 && !is_closed;
      knots.insert(knots.end(), static_cast<std::size_t>(is_end ? kDegree + 1 : steps_[i].pieces[0].copies), steps_[i].start());
    }
    knots.insert(knots.end(), static_cast<std::size_t>(is_closed ? 1 : kDegree + 1), interval_.end);
    return KnotVector::make(kDegree, std::move(knots), is_closed);
  }

  FittedRows through() const {
    FittedRows made{knots(), {}, 0.0};
    const std::vector<double> places = greville_places(made.knots);
    made.rows = rows_at_(places, interval_);
    const std::size_t columns = made.rows.size() / places.size();
    const std::vector<glm::dvec4> given = made.rows;
    solve_rows(made.knots, places, std::span(&made.rows.front().x, 4 * made.rows.size()));
    for (std::size_t j = 0; j < columns; ++j) {
      bool is_level = true;
      for (std::size_t i = j; i < given.size(); i += columns) is_level = is_level && given[i].w == given[j].w;
      for (std::size_t i = j; i < given.size() && is_level; i += columns) made.rows[i].w = given[j].w;
    }
    return made;
  }

  /// The errors of steps, by the distance of their points from where they should be.
  void measure(FittedRows& made) {
    std::vector<double> at;
    for (const RowStep& step : steps_) {
      for (const RowPiece& piece : step.pieces) add_places(piece, at);
    }
    const Samples samples = Samples::make(made.knots, at);
    const auto columns = made.rows.size() / static_cast<std::size_t>(made.knots.count());
    std::vector<glm::dvec4> row(columns);
    std::size_t sample = 0;
    for (RowStep& step : steps_) {
      step.error = 0.0;
      for (const RowPiece& piece : step.pieces) {
        for (std::size_t begin = 0; begin < piece.wanted.size(); begin += columns) {
          write_row(made, samples, sample++, row);
          for (std::size_t j = 0; j < columns; ++j) {
            step.error = worse(step.error, distance_between(row[j], piece.wanted[begin + j]));
          }
        }
      }
      made.error = worse(made.error, step.error);
    }
  }

  /// Parts the steps that are missed: of cubics, the error falls to a 16th of it in halves.
  void part(double accepted) {
    constexpr double kByHalves = 16.0;
    constexpr double kSurely = 2.0;
    std::vector<RowStep> steps;
    for (RowStep& step : steps_) {
      if (step.error <= accepted) {
        steps.push_back(std::move(step));
        continue;
      }
      const int parts = step.error > kSurely * kByHalves * accepted ? 4 : 2;
      std::ranges::move(parted(std::move(step), parts), std::back_inserter(steps));
    }
    steps_ = std::move(steps);
  }

  const RowsAt& rows_at_;
  Interval interval_;
  Closing closing_;
  std::vector<RowStep> steps_;
};

/// Both, the second behind the first, which share a row if it is the same, up to rounding.
FittedRows joined(const FittedRows& a, const FittedRows& b, std::size_t columns) {
  constexpr double kSame = 1e-12;
  const std::span<const glm::dvec4> last = std::span(a.rows).last(columns);
  const std::span<const glm::dvec4> first = std::span(b.rows).first(columns);
  bool is_same = true;
  for (std::size_t i = 0; i < columns; ++i) is_same = is_same && distance_between(last[i], first[i]) <= kSame;
  std::vector<double> knots(a.knots.knots().begin(), a.knots.knots().end() - (is_same ? 1 : 0));
  knots.insert(knots.end(), b.knots.knots().begin() + kDegree + 1, b.knots.knots().end());
  std::vector<glm::dvec4> rows(a.rows.begin(), a.rows.end() - (is_same ? static_cast<std::ptrdiff_t>(columns) : 0));
  rows.insert(rows.end(), b.rows.begin(), b.rows.end());
  return {KnotVector::make(kDegree, std::move(knots)), std::move(rows), std::max(a.error, b.error)};
}

}  // namespace

std::vector<RowJoint> joints_at(const KnotVector& knots) {
  std::vector<RowJoint> joints;
  for (const double knot : knots.knots()) {
    if (!joints.empty() && joints.back().at == knot) continue;
    const int smooth_rows = knots.degree() - multiplicity(knots, knot) - 1;
    joints.push_back({knot, std::clamp(kDegree - smooth_rows, 1, 2)});
  }
  return joints;
}

FittedRows fitted_rows(const RowsAt& rows_at, const RowDomain& domain, double tolerance) {
  std::vector<RowJoint> joints = domain.joints;
  sort_by(joints, [](const RowJoint& joint) { return joint.at; });
  std::optional<FittedRows> all;
  for (std::size_t i = 0; i + 1 < domain.breaks.size(); ++i) {
    const Interval stretch{domain.breaks[i], domain.breaks[i + 1]};
    std::vector<RowJoint> inside;
    std::ranges::copy_if(joints, std::back_inserter(inside), [&](const RowJoint& joint) {
      return joint.at >= stretch.start && joint.at < stretch.end;
    });
    FittedRows one = RowStretch(rows_at, stretch, inside, domain.closing).within(tolerance);
    const std::size_t columns = one.rows.size() / static_cast<std::size_t>(one.knots.count());
    all = all ? joined(*all, one, columns) : std::move(one);
  }
  return *std::move(all);
}

NurbsPatch patch_of(const KnotVector& knots_u, const FittedRows& rows) {
  const auto count_u = static_cast<std::size_t>(knots_u.count());
  const auto count_v = static_cast<std::size_t>(rows.knots.count());
  std::vector<glm::dvec4> net(rows.rows.size());
  for (std::size_t j = 0; j < count_v; ++j) {
    for (std::size_t i = 0; i < count_u; ++i) net[i * count_v + j] = rows.rows[j * count_u + i];
  }
  return NurbsPatch::from_homogeneous(knots_u, rows.knots, net);
}

}  // namespace splinecore
