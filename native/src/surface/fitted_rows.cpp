#include "fitted_rows.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "base/length.hpp"
#include "fit/row_spline.hpp"
#include "splinecore/base/approximation.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/basis/samples.hpp"

namespace splinecore {

namespace {

constexpr int kDegree = 3;
constexpr std::size_t kMostRows = 1 << 14;
/// A little below the tolerance, for what lies between the places that are measured.
constexpr double kAccepted = 0.9;

std::vector<double> numbers_of(std::span<const glm::dvec4> row) {
  std::vector<double> numbers;
  for (const glm::dvec4& p : row) numbers.insert(numbers.end(), {p.x, p.y, p.z, p.w});
  return numbers;
}

double distance_of(const glm::dvec4& a, const glm::dvec4& b) {
  if (a.w == 0.0 || b.w == 0.0) return length_of(glm::dvec3(a) - glm::dvec3(b));
  return length_of(glm::dvec3(a) / a.w - glm::dvec3(b) / b.w);
}

/// One stretch without corners. Places in it are counted in parts that are halved exactly.
class RowStretch {
 public:
  RowStretch(const RowsAt& rows_at, const Interval& interval, Closing closing)
      : rows_at_(rows_at), interval_(interval), closing_(closing), first_(closing == Closing::closed ? 8 : kDegree) {
    for (Place k = 0; k <= first_; ++k) knots_.push_back(k * kStep);
    ask(std::vector<Place>(knots_.begin(), knots_.end() - 1), kStep);
  }

  FittedRows within(double tolerance) {
    for (;;) {
      FittedRows made = through();
      const std::vector<std::size_t> missed = steps_missed(made, tolerance);
      if (missed.empty()) return made;
      if (knots_.size() + missed.size() > kMostRows || is_too_short(missed)) {
        throw ToleranceNotReached("the surface cannot be had with " + std::to_string(knots_.size()) + " rows of control points",
                                  tolerance, made.error);
      }
      halve(missed);
    }
  }

 private:
  using Place = std::int64_t;
  static constexpr Place kStep = Place{1} << 40;
  static constexpr Place kAhead = 16;  ///< parts of a step that are asked for at once: enough to halve it twice

  double parameter(Place place) const {
    if (place == first_ * kStep) return interval_.end;
    return interval_.start + interval_.length() * (static_cast<double>(place) / static_cast<double>(first_ * kStep));
  }

  /// Whether one of the steps cannot be halved twice.
  bool is_too_short(const std::vector<std::size_t>& steps) const {
    return std::ranges::any_of(steps, [&](std::size_t i) { return knots_[i + 1] - knots_[i] < 4 * kAhead; });
  }

  std::size_t width() const { return rows_.begin()->second.size(); }

  /// Asks for all parts of steps of one length that are not known.
  void ask(const std::vector<Place>& starts, Place length) {
    std::vector<Place> asked;
    for (const Place start : starts) {
      for (Place k = 0; k <= kAhead; ++k) {
        const Place place = start + k * (length / kAhead);
        if (rows_.try_emplace(place).second) asked.push_back(place);
      }
    }
    if (asked.empty()) return;
    std::vector<double> at;
    for (const Place place : asked) at.push_back(parameter(place));
    const std::vector<glm::dvec4> found = rows_at_(at, interval_);
    const auto columns = static_cast<std::ptrdiff_t>(found.size() / asked.size());
    for (std::size_t i = 0; i < asked.size(); ++i) {
      const auto row = found.begin() + static_cast<std::ptrdiff_t>(i) * columns;
      rows_[asked[i]].assign(row, row + columns);
    }
  }

  /// Halves steps, and asks for what the next two looks need.
  void halve(const std::vector<std::size_t>& missed) {
    std::map<Place, std::vector<Place>> unknown;  // by their lengths
    std::vector<Place> knots;
    auto next = missed.begin();
    for (std::size_t i = 0; i + 1 < knots_.size(); ++i) {
      knots.push_back(knots_[i]);
      if (next == missed.end() || *next != i) continue;
      ++next;
      const Place length = knots_[i + 1] - knots_[i];
      knots.push_back(knots_[i] + length / 2);
      if (!rows_.contains(knots_[i] + length / 8)) unknown[length].push_back(knots_[i]);
    }
    knots.push_back(knots_.back());
    knots_ = std::move(knots);
    for (const auto& [length, starts] : unknown) ask(starts, length);
  }

  FittedRows through() const {
    RowConditions given;
    for (const Place knot : knots_) {
      given.parameters.push_back(parameter(knot));
      given.rows.push_back(numbers_of(rows_.at(knot)));
    }
    if (closing_ == Closing::closed) given.rows.pop_back();
    const RowSpline spline = spline_through(given, kDegree, closing_);
    FittedRows made{spline.knots, std::vector<glm::dvec4>(spline.controls.size() / 4), 0.0};
    for (std::size_t i = 0; i < made.rows.size(); ++i) {
      const double* const p = &spline.controls[4 * i];
      made.rows[i] = {p[0], p[1], p[2], p[3]};
    }
    return made;
  }

  glm::dvec4 point_of(const FittedRows& made, const Samples& samples, std::size_t sample, std::size_t column) const {
    const auto count = static_cast<std::size_t>(made.knots.count());
    glm::dvec4 point(0.0);
    auto row = static_cast<std::size_t>(samples.first(sample));
    for (const double weight : samples.weights(sample)) point += weight * made.rows[(row++ % count) * width() + column];
    return point;
  }

  /// The steps in which a point is too far from where it should be, at three places of each.
  std::vector<std::size_t> steps_missed(FittedRows& made, double tolerance) const {
    std::vector<Place> places;
    std::vector<double> at;
    for (std::size_t i = 0; i + 1 < knots_.size(); ++i) {
      for (Place k = 1; k < 4; ++k) {
        places.push_back(knots_[i] + k * ((knots_[i + 1] - knots_[i]) / 4));
        at.push_back(parameter(places.back()));
      }
    }
    const Samples samples = Samples::make(made.knots, at, 0, Side::left);
    std::vector<std::size_t> missed;
    for (std::size_t i = 0; i + 1 < knots_.size(); ++i) {
      double largest = 0.0;
      for (std::size_t k = 3 * i; k < 3 * i + 3; ++k) {
        const std::vector<glm::dvec4>& wanted = rows_.at(places[k]);
        for (std::size_t j = 0; j < wanted.size(); ++j) {
          largest = std::max(largest, distance_of(point_of(made, samples, k, j), wanted[j]));
        }
      }
      made.error = std::max(made.error, largest);
      if (!(largest <= kAccepted * tolerance)) missed.push_back(i);
    }
    return missed;
  }

  const RowsAt& rows_at_;
  Interval interval_;
  Closing closing_;
  Place first_;                                      ///< steps at the beginning
  std::vector<Place> knots_;                         ///< where the rows go through those wanted
  std::map<Place, std::vector<glm::dvec4>> rows_;    ///< those wanted, as far as they were asked for
};

/// Both, the second behind the first, which share a row if it is the same, up to rounding.
FittedRows joined(const FittedRows& a, const FittedRows& b, std::size_t columns) {
  constexpr double kSame = 1e-12;
  const std::span<const glm::dvec4> last = std::span(a.rows).last(columns);
  const std::span<const glm::dvec4> first = std::span(b.rows).first(columns);
  bool is_same = true;
  for (std::size_t i = 0; i < columns; ++i) is_same = is_same && distance_of(last[i], first[i]) <= kSame;
  std::vector<double> knots(a.knots.knots().begin(), a.knots.knots().end() - (is_same ? 1 : 0));
  knots.insert(knots.end(), b.knots.knots().begin() + kDegree + 1, b.knots.knots().end());
  std::vector<glm::dvec4> rows(a.rows.begin(), a.rows.end() - (is_same ? static_cast<std::ptrdiff_t>(columns) : 0));
  rows.insert(rows.end(), b.rows.begin(), b.rows.end());
  return {KnotVector::make(kDegree, std::move(knots)), std::move(rows), std::max(a.error, b.error)};
}

}  // namespace

FittedRows fitted_rows(const RowsAt& rows_at, const std::vector<double>& breaks, Closing closing, double tolerance) {
  std::optional<FittedRows> all;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    FittedRows one = RowStretch(rows_at, {breaks[i], breaks[i + 1]}, closing).within(tolerance);
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
