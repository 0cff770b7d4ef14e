#include "splinecore/build/curve_from_formulas.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <string>

#include "base/require.hpp"
#include "exact_polynomial.hpp"
#include "fit_options.hpp"
#include "quintic.hpp"
#include "splinecore/basis/bernstein.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/formula/taylor.hpp"

namespace splinecore {

namespace {

void require_formulas(std::span<const Formula> coordinates) {
  if (coordinates.size() != 2 && coordinates.size() != 3) {
    throw InvalidShape("formulas has " + std::to_string(coordinates.size()) +
                       " of them, x and y or x, y and z are expected");
  }
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    const std::size_t count = coordinates[i].variables().size();
    if (count == 1) continue;
    throw InvalidShape("formulas" + index_text(i) + " has " + std::to_string(count) + " variables, a curve has one");
  }
}

/// The curve of one span, where all coordinates are polynomials.
std::optional<NurbsCurve> exact_curve(std::span<const Formula> coordinates, const Interval& domain) {
  std::vector<ScaledBernstein> polynomials;
  int degree = 1;
  for (const Formula& formula : coordinates) {
    const auto found = scaled_bernstein(formula, {&domain, 1}, kMaxDegree);
    if (!found) return std::nullopt;
    const auto powers = polynomial(formula, kMaxDegree);
    degree = std::max(degree, powers ? static_cast<int>(powers->size()) - 1 : found->degree_u);
    polynomials.push_back(*found);
  }
  std::vector<glm::dvec4> points(degree + 1, glm::dvec4(0.0, 0.0, 0.0, 1.0));
  for (std::size_t axis = 0; axis < polynomials.size(); ++axis) {
    const std::vector<double> ordinates = bezier_ordinates(with_degrees(polynomials[axis], degree, 0));
    for (std::size_t i = 0; i < points.size(); ++i) points[i][static_cast<int>(axis)] = ordinates[i];
  }
  std::vector<double> knots(degree + 1, domain.start);
  knots.insert(knots.end(), degree + 1, domain.end);
  return NurbsCurve::make(degree, std::move(knots), std::move(points));
}

/// The curve that formulas describe: points and jets.
class FormulaCurve {
 public:
  explicit FormulaCurve(std::span<const Formula> coordinates) : coordinates_(coordinates) {
    for (const Formula& formula : coordinates) expansions_.emplace_back(formula, 2);
  }

  /// @throws InvalidShape naming the parameter where a formula is undefined.
  void evaluate(std::span<const double> parameters, std::span<glm::dvec3> out) {
    values_.assign(parameters.size(), 0.0);
    std::ranges::fill(out, glm::dvec3(0.0));
    for (std::size_t axis = 0; axis < coordinates_.size(); ++axis) {
      splinecore::evaluate(coordinates_[axis], parameters, values_);
      for (std::size_t i = 0; i < values_.size(); ++i) out[i][static_cast<int>(axis)] = values_[i];
    }
  }

  Jet jet(double u) {
    Jet jet{u, {}, true};
    evaluate({&u, 1}, {jet.derivatives.data(), 1});
    const double one = 1.0;
    for (std::size_t axis = 0; axis < coordinates_.size(); ++axis) {
      const auto coefficients = expansions_[axis].along({&u, 1}, {&one, 1});
      jet.derivatives[1][static_cast<int>(axis)] = coefficients[1];
      jet.derivatives[2][static_cast<int>(axis)] = 2.0 * coefficients[2];
      jet.is_smooth = jet.is_smooth && std::isfinite(coefficients[1]) && std::isfinite(2.0 * coefficients[2]);
    }
    return jet;
  }

 private:
  std::span<const Formula> coordinates_;
  std::vector<Taylor> expansions_;
  std::vector<double> values_;
};

double largest_distance(std::span<const glm::dvec3> a, std::span<const glm::dvec3> b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double apart = glm::distance(a[i], b[i]);
    // What overflows is as far away as can be.
    largest = std::max(largest, std::isfinite(apart) ? apart : HUGE_VAL);
  }
  return largest;
}

class CurveFit {
 public:
  CurveFit(std::span<const Formula> coordinates, const Interval& domain, double tolerance)
      : formulas_(coordinates), domain_(domain), tolerance_(tolerance) {}

  Approximation<NurbsCurve> run() {
    cut();
    NurbsCurve curve = assembled();
    const double error = error_of(curve);
    if (error > tolerance_) throw ToleranceNotReached("the curve cannot follow the formulas", tolerance_, error);
    return {std::move(curve), error};
  }

 private:
  void cut();
  double error_of(const QuinticPiece& piece);
  double error_of(const NurbsCurve& curve);
  NurbsCurve assembled() const;

  FormulaCurve formulas_;
  Interval domain_;
  double tolerance_;
  std::vector<QuinticPiece> pieces_;
};

/// Stops at the first part that is too far away.
double CurveFit::error_of(const QuinticPiece& piece) {
  constexpr int kPart = 32;
  const Interval interval = piece.interval();
  if (!can_be_cut(interval)) return glm::distance(piece.start.derivatives[0], piece.end.derivatives[0]);
  const int parts = std::max(1, static_cast<int>(interval.length() / domain_.length() * kLeastMeasured / kPart));
  std::array<double, kPart> parameters;
  std::array<glm::dvec3, kPart> wanted;
  std::array<glm::dvec3, kPart> found;
  double largest = 0.0;
  for (int part = 0; part < parts && largest <= kAccepted * tolerance_; ++part) {
    for (int i = 0; i < kPart; ++i) parameters[i] = interval.at(measured_place(part * kPart + i));
    formulas_.evaluate(parameters, wanted);
    splinecore::evaluate(piece, parameters, found);
    largest = std::max(largest, largest_distance(wanted, found));
  }
  return largest;
}

void CurveFit::cut() {
  Jet start = formulas_.jet(domain_.start);
  std::vector<Jet> ends{formulas_.jet(domain_.end)};
  while (!ends.empty()) {
    const QuinticPiece piece = quintic_between(start, ends.back());
    const double error = error_of(piece);
    if (error <= kAccepted * tolerance_) {
      pieces_.push_back(piece);
      start = ends.back();
      ends.pop_back();
      continue;
    }
    if (!can_be_cut(piece.interval())) {
      throw ToleranceNotReached("the curve cannot be followed at t = " + text_of(start.u) +
                                " (a jump, a pole, or the end of the digits of float64)", tolerance_, error);
    }
    if (pieces_.size() + ends.size() >= kMaxPieces) {
      throw ToleranceNotReached(std::to_string(kMaxPieces) + " pieces reach t = " + text_of(start.u) +
                                " and cannot follow the curve", tolerance_, error);
    }
    ends.push_back(formulas_.jet(piece.interval().middle()));
  }
}

NurbsCurve CurveFit::assembled() const {
  std::vector<double> joints{domain_.start};
  std::vector<char> is_smooth{0};
  for (const QuinticPiece& piece : pieces_) {
    joints.push_back(piece.end.u);
    is_smooth.push_back(piece.end.is_smooth ? 1 : 0);
  }
  std::vector<double> knots = quintic_knots(joints, is_smooth);
  std::vector<glm::dvec4> points;
  std::size_t joint = 0;
  for (std::size_t i = 1; i + 6 <= knots.size(); ++i) {
    const std::span<const double, 5> window(knots.data() + i, 5);
    while (joints[joint] < window[2]) ++joint;
    const bool ends_here = window[0] < window[2] || joint == pieces_.size();
    const Jet& jet = ends_here ? pieces_[joint - 1].end : pieces_[joint].start;
    const auto weights = polar_weights(window);
    glm::dvec3 point(0.0);
    for (int k = 0; k < 3; ++k) point += weights[k] * jet.derivatives[k];
    points.emplace_back(point, 1.0);
  }
  return NurbsCurve::make(5, std::move(knots), std::move(points));
}

double CurveFit::error_of(const NurbsCurve& curve) {
  constexpr int kLeast = 48;
  const int count = std::max(kLeast, kLeastMeasured / static_cast<int>(pieces_.size()));
  std::vector<double> parameters(count);
  std::vector<glm::dvec3> wanted(count);
  std::vector<glm::dvec3> found(count);
  double largest = 0.0;
  for (const QuinticPiece& piece : pieces_) {
    for (int i = 0; i < count; ++i) parameters[i] = piece.interval().at(measured_place(i));
    parameters.back() = piece.end.u;
    formulas_.evaluate(parameters, wanted);
    splinecore::evaluate(curve, parameters, std::span(&found[0].x, 3 * found.size()));
    largest = std::max(largest, largest_distance(wanted, found));
  }
  return largest;
}

}  // namespace

Approximation<NurbsCurve> curve_from_formulas(std::span<const Formula> coordinates, const Interval& domain,
                                              double tolerance) {
  require_formulas(coordinates);
  require_domain(domain, "domain");
  require_positive(tolerance);
  if (auto curve = exact_curve(coordinates, domain)) return {*std::move(curve), 0.0};
  return CurveFit(coordinates, domain, tolerance).run();
}

}  // namespace splinecore
