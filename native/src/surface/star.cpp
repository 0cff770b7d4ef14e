#include "star.hpp"

#include <Eigen/Sparse>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "basis/gauss_legendre.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/basis/samples.hpp"

namespace splinecore {

namespace {

using Index = Eigen::Index;

/// Integrals of products of two functions' derivatives of one order, for orders 0 to 3.
struct Products {
  std::array<Eigen::MatrixXd, 4> of_order;
};

Products products_of(const KnotVector& knots) {
  const Index width = knots.count();
  Products made;
  for (auto& matrix : made.of_order) matrix = Eigen::MatrixXd::Zero(width, width);
  const GaussRule rule = gauss_legendre(knots.degree() + 1);
  for (int s = 0; s < static_cast<int>(knots.spans().size()); ++s) {
    const Interval span = knots.span_interval(s);
    std::vector<double> at;
    for (const double node : rule.nodes) at.push_back(span.start + node * span.length());
    const Samples samples = Samples::make(knots, at, 3);
    for (std::size_t k = 0; k < at.size(); ++k) {
      const double weight = span.length() * rule.weights[k];
      for (int order = 0; order < 4; ++order) {
        const auto row = samples.weights(k, order);
        const Index first = samples.first(k);
        for (std::size_t a = 0; a < row.size(); ++a) {
          for (std::size_t b = 0; b < row.size(); ++b) {
            made.of_order[order](first + static_cast<Index>(a), first + static_cast<Index>(b)) += weight * row[a] * row[b];
          }
        }
      }
    }
  }
  return made;
}

/// Which points are sought, by number: their places among the unknowns, or -1.
std::vector<Index> unknowns_of(const Star& star, const std::vector<std::optional<glm::dvec3>>& given, Index& count) {
  std::vector<Index> places(star.size(), -1);
  count = 0;
  for (std::size_t k = 0; k < star.count(); ++k) {
    for (std::size_t i = 0; i < star.width(k, Axis::u); ++i) {
      for (std::size_t j = 0; j < star.width(k, Axis::v); ++j) {
        const std::size_t number = star.at(k, i, j);
        if (!given[number] && places[number] < 0) places[number] = count++;
      }
    }
  }
  return places;
}

using Triplets = std::vector<Eigen::Triplet<double>>;

Eigen::SparseMatrix<double> matrix_of(Index rows, Index columns, const Triplets& entries) {
  Eigen::SparseMatrix<double> made(rows, columns);
  made.setFromTriplets(entries.begin(), entries.end());
  return made;
}

/// Which control points are sought, as unknowns, and which are given.
class Unknowns {
 public:
  Unknowns(const Star& star, const std::vector<std::optional<glm::dvec3>>& given)
      : count(0), given_(given), places_(unknowns_of(star, given, count)) {}

  bool is_sought(std::size_t number) const { return places_[number] >= 0; }
  Index place(std::size_t number) const { return places_[number]; }
  const glm::dvec3& value(std::size_t number) const { return *given_[number]; }

  Index count;

 private:
  const std::vector<std::optional<glm::dvec3>>& given_;
  std::vector<Index> places_;
};

void add_vector(Eigen::MatrixXd& rows, Index row, const glm::dvec3& vector) {
  for (int c = 0; c < 3; ++c) rows(row, c) += vector[c];
}

/// A quadratic form in the unknowns, and what it takes of those given.
class Form {
 public:
  explicit Form(const Unknowns& unknowns) : right(Eigen::MatrixXd::Zero(unknowns.count, 3)), unknowns_(unknowns) {}

  void add(std::size_t a, std::size_t b, double value) {
    if (!unknowns_.is_sought(a)) return;
    if (unknowns_.is_sought(b)) {
      if (unknowns_.place(a) >= unknowns_.place(b)) entries_.emplace_back(unknowns_.place(a), unknowns_.place(b), value);
    } else {
      add_vector(right, unknowns_.place(a), -value * unknowns_.value(b));
    }
  }

  void expect(std::size_t a, const glm::dvec3& value) {
    if (unknowns_.is_sought(a)) add_vector(right, unknowns_.place(a), value);
  }

  /// Its lower half.
  Eigen::SparseMatrix<double> left() const { return matrix_of(unknowns_.count, unknowns_.count, entries_); }

  Eigen::MatrixXd right;

 private:
  const Unknowns& unknowns_;
  Triplets entries_;
};

void add_energy(const Star& star, const std::vector<glm::dvec3>& expected, Form& form) {
  const auto degree = static_cast<std::size_t>(star.along(0, Axis::u).degree());
  const auto first = [&](std::size_t a) { return a - std::min(a, degree); };
  const auto behind = [&](std::size_t a, std::size_t width) { return std::min(a + degree + 1, width); };
  for (std::size_t k = 0; k < star.count(); ++k) {
    const auto& [along_u] = products_of(star.along(k, Axis::u));
    const auto& [along_v] = products_of(star.along(k, Axis::v));
    const std::size_t rows = star.width(k, Axis::u);
    const std::size_t columns = star.width(k, Axis::v);
    breathe(rows * columns * degree * degree);
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = 0; j < columns; ++j) {
        for (std::size_t m = first(i); m < behind(i, rows); ++m) {
          for (std::size_t n = first(j); n < behind(j, columns); ++n) {
            const auto product = [&](int u, int v) {
              return along_u[u](static_cast<Index>(i), static_cast<Index>(m)) * along_v[v](static_cast<Index>(j), static_cast<Index>(n));
            };
            const double value = product(3, 0) + 3.0 * product(2, 1) + 3.0 * product(1, 2) + product(0, 3);
            form.add(star.at(k, i, j), star.at(k, m, n), value);
            if (!expected.empty()) form.expect(star.at(k, i, j), value * expected[star.at(k, m, n)]);
          }
        }
      }
    }
  }
}

/// Conditions at places of spokes: sums of points that are to be 0.
struct SpokeConditions {
  Triplets left;
  std::vector<glm::dvec3> right;

  void add(const Unknowns& unknowns, std::size_t number, double factor) {
    if (unknowns.is_sought(number)) {
      left.emplace_back(std::ssize(right) - 1, unknowns.place(number), factor);
    } else {
      right.back() -= factor * unknowns.value(number);
    }
  }
};

double spoke_factor(const Star& star) {
  const double angle = (star.is_open ? 1.0 : 2.0) * std::numbers::pi / static_cast<double>(star.count());
  return 2.0 * std::cos(angle);
}

/// Along spoke k, at places of it; by the mean of the slopes beside it.
void add_conditions(const Star& star, std::size_t k, const Unknowns& unknowns, const Samples& samples, SpokeConditions& all) {
  const std::size_t next = star.after(k);
  const std::size_t last = star.last(k, Axis::u);
  const std::size_t last_of_next = star.last(next, Axis::v);
  const double here = end_slope(star.along(k, Axis::u));
  const double there = end_slope(star.along(next, Axis::v));
  const double slope = 0.5 * (here + there);
  const double factor = spoke_factor(star);
  for (std::size_t s = 0; s < samples.size(); ++s) {
    all.right.emplace_back(0.0);
    const double part = factor * std::pow(samples.parameter(s), star.power);
    auto j = static_cast<std::size_t>(samples.first(s));
    for (std::size_t m = 0; m < samples.weights(s).size(); ++m, ++j) {
      const double value = samples.weights(s)[m];
      all.add(unknowns, star.at(k, last, j), 2.0 * value - part / slope * samples.weights(s, 1)[m]);
      all.add(unknowns, star.at(k, last - 1, j), -here / slope * value);
      all.add(unknowns, star.at(next, j, last_of_next - 1), -there / slope * value);
    }
  }
}

Samples samples_along(const KnotVector& spoke) {
  constexpr int kInSpan = 8;
  std::vector<double> at;
  for (int s = 0; s < static_cast<int>(spoke.spans().size()); ++s) {
    const Interval span = spoke.span_interval(s);
    for (int k = 0; k <= kInSpan; ++k) {
      at.push_back(span.start + span.length() * 0.5 * (1.0 - std::cos(std::numbers::pi * k / kInSpan)));
    }
    at.back() = span.end;
  }
  return Samples::make(spoke, at, 1);
}

SpokeConditions conditions_of(const Star& star, const Unknowns& unknowns) {
  SpokeConditions all;
  for (std::size_t k = 0; k < star.inner_spokes(); ++k) add_conditions(star, k, unknowns, samples_along(star.along(k, Axis::v)), all);
  return all;
}

using Sparse = Eigen::SparseMatrix<double>;

/// A form, whole, in unknowns by which its diagonal is 1: else what is stiff in it hides what is not.
struct EvenForm {
  Eigen::VectorXd scale;  ///< of the unknowns
  Sparse left;
  Eigen::MatrixXd right;

  explicit EvenForm(const Form& form) : right(form.right) {
    const Sparse given = form.left();
    scale = given.diagonal().cwiseSqrt().cwiseInverse();
    left = scale.asDiagonal() * Sparse(given.selfadjointView<Eigen::Lower>()) * scale.asDiagonal();
    right = scale.asDiagonal() * form.right;
  }
};

/// The least by itself; what is left of it is added until rounding is all.
Eigen::MatrixXd least_of(const EvenForm& form) {
  constexpr int kRounds = 4;
  const Eigen::SimplicialLDLT<Sparse> solver(form.left);
  Eigen::MatrixXd points = solver.solve(form.right);
  for (int round = 0; round < kRounds; ++round) points += solver.solve(form.right - form.left * points);
  return form.scale.asDiagonal() * points;
}

/// The least of a form under conditions, as nearly as these agree: multipliers (Hestenes 1969, Powell 1969). Each round adds what
/// is left, of the form and of the conditions by themselves: their sum has lost digits of the form.
Eigen::MatrixXd least(const Form& given, const SpokeConditions& conditions) {
  constexpr int kLeastRounds = 12;
  constexpr int kMostRounds = 100;
  constexpr double kSlow = 0.95;
  constexpr double kFirm = 1e7;
  constexpr double kLoose = 1e-4;  // first, for conditions may hide how large the form is in their common directions
  constexpr double kNear = 1e-13;  // to the round before, of the diagonal, for the same reason
  const Index count = given.right.rows();
  if (count == 0) return Eigen::MatrixXd(0, 3);
  const EvenForm form(given);
  if (conditions.right.empty()) return least_of(form);
  const Sparse left = matrix_of(std::ssize(conditions.right), count, conditions.left) * form.scale.asDiagonal();
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(std::ssize(conditions.right), 3);
  for (Index i = 0; i < right.rows(); ++i) add_vector(right, i, conditions.right[static_cast<std::size_t>(i)]);
  const double firm = kFirm * static_cast<double>(count) / std::max(left.squaredNorm(), 1e-300);
  const Sparse back = left.transpose();
  Eigen::MatrixXd points = Eigen::MatrixXd::Zero(count, 3);
  Eigen::MatrixXd multipliers = Eigen::MatrixXd::Zero(right.rows(), 3);
  for (const double share : {kLoose, 1.0}) {
    const Sparse whole = form.left + share * firm * (back * left);
    const Eigen::VectorXd near = kNear * whole.diagonal();
    const Eigen::SimplicialLDLT<Sparse> solver(whole + Sparse(near.asDiagonal()));
    double before = std::numeric_limits<double>::infinity();
    for (int round = 0; round < kMostRounds; ++round) {
      breathe(static_cast<std::size_t>(whole.nonZeros()));
      const Eigen::MatrixXd pull = back * (multipliers + share * firm * (left * points - right));
      const Eigen::MatrixXd change = solver.solve(form.right - form.left * points - pull);
      points += change;
      const Eigen::MatrixXd off = left * points - right;
      multipliers += share * firm * off;
      const double size = off.norm();
      if (round >= kLeastRounds && !(size < kSlow * before)) break;
      before = size;
    }
  }
  return form.scale.asDiagonal() * points;
}

/// Which points conditions along spokes are of, by number.
std::vector<bool> points_at_spokes(const Star& star) {
  std::vector<bool> found(star.size());
  for (std::size_t k = 0; k < star.inner_spokes(); ++k) {
    const std::size_t next = star.after(k);
    const std::size_t last = star.last(k, Axis::u);
    for (std::size_t j = 0; j < star.width(k, Axis::v); ++j) {
      for (const std::size_t number : {star.at(k, last, j), star.at(k, last - 1, j), star.at(next, j, star.last(next, Axis::v) - 1)}) {
        found[number] = true;
      }
    }
  }
  return found;
}

/// All points, those found and those given.
std::vector<glm::dvec3> points_by_number(const Star& star, const std::vector<std::optional<glm::dvec3>>& given, const Unknowns& unknowns,
                                         const Eigen::MatrixXd& found) {
  std::vector<glm::dvec3> points(star.size(), glm::dvec3(0.0));
  for (std::size_t number = 0; number < star.size(); ++number) {
    const Index place = unknowns.place(number);
    if (given[number]) {
      points[number] = *given[number];
    } else if (place >= 0) {
      points[number] = {found(place, 0), found(place, 1), found(place, 2)};
    }
  }
  return points;
}

}  // namespace

double end_slope(const KnotVector& knots) {
  const auto last = static_cast<std::size_t>(knots.count()) - 1;
  return knots.degree() / (knots.knots().back() - knots.knots()[last]);
}

std::size_t Star::at(std::size_t patch, std::size_t i, std::size_t j) const {
  const bool has_before = patch > 0 || !is_open;
  if (i == last(patch, Axis::u) && j == last(patch, Axis::v)) {  // the middle is that of the first patch
    patch = 0;
    i = last(0, Axis::u);
    j = last(0, Axis::v);
  } else if (j == last(patch, Axis::v) && has_before) {  // the spoke at which u of the patch before ends
    patch = (patch + count() - 1) % count();
    j = i;
    i = last(patch, Axis::u);
  }
  return first_of(patch) + i * width(patch, Axis::v) + j;
}

std::size_t Star::first_of(std::size_t patch) const {
  std::size_t sum = 0;
  for (std::size_t k = 0; k < patch; ++k) sum += width(k, Axis::u) * width(k, Axis::v);
  return sum;
}

std::vector<glm::dvec3> solved_star(const Star& star, const std::vector<std::optional<glm::dvec3>>& given,
                                    const std::vector<glm::dvec3>& expected) {
  const Unknowns unknowns(star, given);
  Form form(unknowns);
  add_energy(star, expected, form);
  return points_by_number(star, given, unknowns, least(form, conditions_of(star, unknowns)));
}

std::vector<glm::dvec3> nearest_star(const Star& star, const std::vector<std::optional<glm::dvec3>>& given,
                                     const std::vector<glm::dvec3>& points) {
  const std::vector<bool> is_at_spoke = points_at_spokes(star);
  std::vector<std::optional<glm::dvec3>> changes(star.size());
  for (std::size_t number = 0; number < star.size(); ++number) {
    if (given[number]) changes[number] = *given[number] - points[number];
    if (!given[number] && !is_at_spoke[number]) changes[number] = glm::dvec3(0.0);
  }
  const Unknowns sought(star, changes);
  Form form(sought);
  for (std::size_t number = 0; number < star.size(); ++number) form.add(number, number, 1.0);
  SpokeConditions conditions = conditions_of(star, sought);
  const std::vector<std::optional<glm::dvec3>> all(points.begin(), points.end());
  const SpokeConditions as_they_are = conditions_of(star, Unknowns(star, all));
  for (std::size_t i = 0; i < conditions.right.size(); ++i) conditions.right[i] += as_they_are.right[i];
  std::vector<glm::dvec3> found = points_by_number(star, changes, sought, least(form, conditions));
  for (std::size_t number = 0; number < star.size(); ++number) found[number] = given[number] ? *given[number] : points[number] + found[number];
  return found;
}

}  // namespace splinecore
