#include "stationary_line.hpp"

#include <algorithm>
#include <cmath>

#include "base/one_sign.hpp"
#include "basis/bernstein_roots.hpp"
#include "slope_form.hpp"

namespace splinecore {

namespace {

using Piece = BernsteinNet<glm::dvec4>;

/// Nearer to an end of a piece a zero is that end.
constexpr double kAtEnd = 0x1p-40;

/// How the distance goes along a piece.
struct Course {
  std::vector<double> zeros{};  ///< inside
  std::vector<int> signs{};     ///< of the slope before, between and after these
  bool is_zero_at_start = false;
  bool is_zero_at_end = false;
  bool is_constant = false;
  bool is_finite = true;

  int first() const noexcept { return signs.empty() ? 0 : signs.front(); }
  int last() const noexcept { return signs.empty() ? 0 : signs.back(); }
};

int sign_at(const std::vector<double>& coefficients, double t) {
  const double value = bernstein_value(coefficients, t);
  return value > 0.0 ? 1 : value < 0.0 ? -1 : 0;
}

Course whole_course_of(const Piece& piece, const glm::dvec3& point, double rounding) {
  Course course;
  SlopeForm form = slope_form(piece, Axis::u, point, rounding);
  if (!has_one_sign(piece.values, &glm::dvec4::w)) form = times_weights(form, piece);
  const std::vector<Interval> zeros = bernstein_zeros(form.net.values, form.noise);
  course.is_constant = zeros.size() == 1 && zeros.front() == Interval{0.0, 1.0};
  if (course.is_constant) return course;
  for (const Interval& zero : zeros) {
    if (zero.start <= kAtEnd) {
      course.is_zero_at_start = true;
    } else if (zero.start >= 1.0 - kAtEnd) {
      course.is_zero_at_end = true;
    } else {
      course.zeros.push_back(zero.start);
    }
  }
  const double sign = piece.values.front().w < 0.0 && has_one_sign(piece.values, &glm::dvec4::w) ? -1.0 : 1.0;
  double start = 0.0;
  for (std::size_t i = 0; i <= course.zeros.size(); ++i) {
    const double end = i < course.zeros.size() ? course.zeros[i] : 1.0;
    course.signs.push_back(static_cast<int>(sign) * sign_at(form.net.values, Interval{start, end}.middle()));
    start = end;
  }
  return course;
}

/// Of the two halves of a piece. A half on which rounding hides all is a zero where they meet.
Course joined(const Course& a, const Course& b) {
  Course both;
  both.is_constant = a.is_constant && b.is_constant;
  if (both.is_constant) return both;
  const bool is_zero = a.is_zero_at_end || b.is_zero_at_start || a.is_constant || b.is_constant;
  both.is_zero_at_start = a.is_zero_at_start;
  both.is_zero_at_end = b.is_zero_at_end;
  for (const double zero : a.zeros) both.zeros.push_back(0.5 * zero);
  if (is_zero || a.last() * b.first() < 0) both.zeros.push_back(0.5);
  for (const double zero : b.zeros) both.zeros.push_back(0.5 + 0.5 * zero);
  both.signs = a.is_constant ? std::vector{b.first()} : a.signs;
  const auto rest = b.is_constant ? std::vector{a.last()} : b.signs;
  const bool meets = both.zeros.size() == a.zeros.size() + b.zeros.size();
  both.signs.insert(both.signs.end(), rest.begin() + (meets ? 1 : 0), rest.end());
  return both;
}

/// Uneven weights are evened by halving, so that each part has a noise of its own.
Course course_of(Piece piece, const glm::dvec3& point, double rounding, int depth) {
  constexpr int kDeepest = 40;
  if (!scale_weights(piece)) return {.is_finite = false};
  if (depth == kDeepest || !is_uneven(piece)) return whole_course_of(piece, point, rounding);
  Piece after;
  piece.halve(Axis::u, after);
  return joined(course_of(std::move(piece), point, rounding, depth + 1),
                course_of(std::move(after), point, rounding, depth + 1));
}

bool is_finite_at(const Piece& piece, double t) {
  constexpr double kInfinite = 0x1p-40;
  if (t > 0.0 && t < 1.0 && has_one_sign(piece.values, &glm::dvec4::w)) return true;
  const std::vector<double> weights = weights_of(piece).values;
  double largest = 0.0;
  for (const double w : weights) largest = std::max(largest, std::abs(w));
  const double weight = std::abs(bernstein_value(weights, t));
  return weight > (has_one_sign(weights) ? 0.0 : kInfinite * largest);
}

class Walk {
 public:
  Walk(const PieceLine& line, std::vector<Course> courses) : line_(line), courses_(std::move(courses)) {
    for (std::size_t i = 0; i < courses_.size(); ++i) {
      pass_knot(i);
      for (std::size_t k = 0; k < courses_[i].zeros.size(); ++k) {
        add(i, courses_[i].zeros[k], courses_[i].signs[k], courses_[i].signs[k + 1]);
      }
    }
    if (!goes_on(0)) add(courses_.size() - 1, 1.0, courses_.back().last(), 0);
  }

  std::vector<LinePlace> found() && { return std::move(found_); }

 private:
  std::size_t before(std::size_t i) const noexcept { return i > 0 ? i - 1 : courses_.size() - 1; }

  /// Whether the line comes to the start of a piece from the one before.
  bool goes_on(std::size_t i) const {
    const KnotVector& knots = line_.knots;
    if (i == 0 && !knots.periodic()) return line_.is_closed;
    return multiplicity(knots, knots.span_interval(static_cast<int>(i)).start) <= knots.degree();
  }

  void pass_knot(std::size_t i) {
    const Course& left = courses_[before(i)];
    const Course& right = courses_[i];
    if (!goes_on(i)) {
      if (i > 0) add(i - 1, 1.0, left.last(), 0);
      return add(i, 0.0, 0, right.first());
    }
    const bool is_zero = left.is_zero_at_end || right.is_zero_at_start || left.is_constant || right.is_constant;
    if (is_zero || left.last() * right.first() < 0) add(i, 0.0, left.last(), right.first());
  }

  void add(std::size_t i, double t, int before, int after) {
    if (courses_[i].is_finite && is_finite_at(line_.pieces[i], t)) found_.push_back({i, t, before, after});
  }

  const PieceLine& line_;
  std::vector<Course> courses_;
  std::vector<LinePlace> found_;
};

}  // namespace

std::vector<LinePlace> stationary_places(const PieceLine& line, const glm::dvec3& point, double rounding,
                                         const std::function<void(std::size_t)>& constant) {
  std::vector<Course> courses;
  for (std::size_t i = 0; i < line.pieces.size(); ++i) {
    courses.push_back(course_of(line.pieces[i], point, rounding, 0));
    if (courses.back().is_constant) constant(i);
  }
  return Walk(line, std::move(courses)).found();
}

}  // namespace splinecore
