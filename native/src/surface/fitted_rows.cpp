#include "fitted_rows.hpp"

#include <algorithm>
#include <cstddef>
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

/// One stretch without corners.
class RowStretch {
 public:
  RowStretch(const RowsAt& rows_at, const Interval& interval, Closing closing)
      : rows_at_(rows_at), interval_(interval), closing_(closing) {
    const int first = closing == Closing::closed ? 8 : kDegree;
    std::vector<double> places;
    for (int k = 0; k <= first; ++k) places.push_back(interval.start + interval.length() * k / first);
    places.back() = interval.end;
    add(places);
  }

  FittedRows within(double tolerance) {
    for (;;) {
      FittedRows made = through();
      const std::vector<double> missed = places_missed(made, tolerance);
      if (missed.empty()) return made;
      if (at_.size() + missed.size() > kMostRows) {
        throw ToleranceNotReached("the surface cannot be had with " + std::to_string(at_.size()) + " rows of control points",
                                  tolerance, made.error);
      }
      add(missed);
    }
  }

 private:
  std::size_t width() const { return rows_.front().size() / 4; }

  void add(const std::vector<double>& places) {
    const std::vector<glm::dvec4> found = rows_at_(places, interval_);
    const std::size_t columns = found.size() / places.size();
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto place = std::ranges::lower_bound(at_, places[i]) - at_.begin();
      at_.insert(at_.begin() + place, places[i]);
      rows_.insert(rows_.begin() + place, numbers_of(std::span(found).subspan(i * columns, columns)));
    }
  }

  FittedRows through() const {
    RowConditions given{at_, rows_, {}, {}};
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

  /// The middle of each step in which a point is too far from where it should be, at three places of it.
  std::vector<double> places_missed(FittedRows& made, double tolerance) const {
    constexpr double kPlaces[] = {0.25, 0.5, 0.75};
    std::vector<double> asked;
    for (std::size_t i = 0; i + 1 < at_.size(); ++i) {
      for (const double t : kPlaces) asked.push_back(at_[i] + t * (at_[i + 1] - at_[i]));
    }
    const std::vector<glm::dvec4> wanted = rows_at_(asked, interval_);
    const Samples samples = Samples::make(made.knots, asked, 0, Side::left);
    std::vector<double> missed;
    for (std::size_t i = 0; i + 1 < at_.size(); ++i) {
      double largest = 0.0;
      for (std::size_t k = 3 * i; k < 3 * i + 3; ++k) {
        for (std::size_t j = 0; j < width(); ++j) {
          largest = std::max(largest, distance_of(point_of(made, samples, k, j), wanted[k * width() + j]));
        }
      }
      made.error = std::max(made.error, largest);
      if (!(largest <= kAccepted * tolerance)) missed.push_back(asked[3 * i + 1]);
    }
    return missed;
  }

  const RowsAt& rows_at_;
  Interval interval_;
  Closing closing_;
  std::vector<double> at_;
  std::vector<std::vector<double>> rows_;
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
