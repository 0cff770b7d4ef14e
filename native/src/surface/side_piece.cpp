#include "side_piece.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/geometric.hpp>
#include <iterator>
#include <utility>

#include "base/length.hpp"
#include "base/rounding.hpp"
#include "bulge.hpp"
#include "numeric/linear_equations.hpp"
#include "one_patch.hpp"
#include "patch/lines.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/patch/ends.hpp"
#include "splinecore/patch/evaluate.hpp"

namespace splinecore {

namespace {

/// With the side v_end, u along it as the curve runs, over [0, 1].
NurbsPatch turned_to(const LoftNeighbor& neighbor, const NurbsCurve& curve) {
  NurbsPatch patch = axis_of(neighbor.side) == Axis::u ? swapped(neighbor.patch) : neighbor.patch;
  if (!is_at_end(neighbor.side)) patch = reversed(patch, Axis::v);
  patch = with_domain(clamped(clamped(patch, Axis::u), Axis::v), Axis::u, {0.0, 1.0});
  const NurbsCurve side = boundary(patch, Border::v_end);
  const glm::dvec3 start(curve.points().front());
  const bool is_backwards =
      distance_of(start, glm::dvec3(side.points().back())) < distance_of(start, glm::dvec3(side.points().front()));
  return is_backwards ? reversed(patch, Axis::u) : patch;
}

/// x, y for which x a + y b is nearest to a vector; none where a and b are in one line.
std::optional<std::pair<double, double>> parts_of(const glm::dvec3& vector, const glm::dvec3& a, const glm::dvec3& b) {
  constexpr double kParallel = 1e-6;
  const glm::dvec3 normal = glm::cross(a, b);
  const double square = glm::dot(normal, normal);
  if (!(square > kParallel * kParallel * glm::dot(a, a) * glm::dot(b, b))) return {};
  return std::pair{glm::dot(glm::cross(vector, b), normal) / square, glm::dot(glm::cross(a, vector), normal) / square};
}

/// A function's derivatives of orders 0 to 2.
template <class Value>
using ThreeOrders = std::array<Value, 3>;

template <class Value>
ThreeOrders<Value> product(const ThreeOrders<double>& a, const ThreeOrders<Value>& b) {
  return {a[0] * b[0], a[1] * b[0] + a[0] * b[1], a[2] * b[0] + 2.0 * a[1] * b[1] + a[0] * b[2]};
}

ThreeOrders<glm::dvec3> sum(const ThreeOrders<glm::dvec3>& a, const ThreeOrders<glm::dvec3>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

/// 0 at both ends, with the derivative 1 at 0 and 0 at 1.
double slope_function(double s) { return s * (1.0 - s) * (1.0 - s); }

/// The same of the second derivative, first derivatives being 0.
double second_function(double s) { return 0.5 * s * s * (1.0 - s) * (1.0 - s) * (1.0 - s); }

/// A polynomial by its factors.
double value_of(const std::array<double, 5>& factors, double x) {
  double sum = 0.0;
  for (std::size_t k = factors.size(); k-- > 0;) sum = sum * x + factors[k];
  return sum;
}

/// Factors of the bulge, times powers of 2 s - 1, for values at places, by least squares.
std::array<double, 5> bulges_of(std::span<const double> s, const std::vector<double>& values, int power) {
  std::array<double, 5> found{};
  if (s.size() < found.size()) return found;
  LinearEquations equations(found.size());
  for (std::size_t i = 0; i < s.size(); ++i) {
    std::array<double, 5> terms{bulge(s[i], power)};
    for (std::size_t k = 1; k < terms.size(); ++k) terms[k] = terms[k - 1] * (2.0 * s[i] - 1.0);
    equations.add(terms, values[i]);
  }
  std::ranges::copy(equations.least_squares(), found.begin());
  return found;
}

/// Places on a curve, those that only rounding parts from an inner knot at that knot: derivatives that jump there are the mean of those
/// on both sides, whichever way the curve runs.
class PlacesAtKnots {
 public:
  PlacesAtKnots(std::span<const double> s, const KnotVector& knots) : places_(s.begin(), s.end()) {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const auto next = std::ranges::lower_bound(knots.knots(), places_[i] - kRoundingOfShape);
      if (next == knots.knots().end() || *next > places_[i] + kRoundingOfShape) continue;
      if (*next <= knots.domain().start || *next >= knots.domain().end) continue;
      places_[i] = *next;
      at_knots_.push_back(i);
    }
  }

  /// @param count  of vectors at each place
  /// @param write  them on one side of places
  template <class Write>
  std::vector<glm::dvec3> means(std::size_t count, const Write& write) const {
    std::vector<glm::dvec3> found(count * places_.size());
    if (found.empty()) return found;
    write(places_, Side::right, std::span(&found.front().x, 3 * found.size()));
    if (at_knots_.empty()) return found;
    std::vector<glm::dvec3> before(found.size());
    write(places_, Side::left, std::span(&before.front().x, 3 * before.size()));
    for (const std::size_t i : at_knots_) {
      for (std::size_t k = count * i; k < count * (i + 1); ++k) found[k] = 0.5 * (found[k] + before[k]);
    }
    return found;
  }

 private:
  std::vector<double> places_;
  std::vector<std::size_t> at_knots_;
};

}  // namespace

double SidePiece::Factor::at(double s) const {
  const double t = 1.0 - s;
  return t * values[0] + s * values[1] + slopes[0] * slope_function(s) - slopes[1] * slope_function(t) +
         seconds[0] * second_function(s) + seconds[1] * second_function(t) + bulge(s, power) * value_of(bulges, s - t);
}

std::array<double, 3> SidePiece::Factor::derivatives(bool is_end) const {
  const double of_slopes = is_end ? 2.0 * slopes[0] + 4.0 * slopes[1] : -4.0 * slopes[0] - 2.0 * slopes[1];
  return {values[is_end], values[1] - values[0] + slopes[is_end], of_slopes + seconds[is_end] + (power == 2 ? 32.0 * value_of(bulges, is_end ? 1.0 : -1.0) : 0.0)};
}

SidePiece::SidePiece(const NurbsCurve& curve, const std::optional<LoftNeighbor>& neighbor, std::size_t number)
    : curve_(with_domain(curve, {0.0, 1.0})), neighbor_(neighbor), number_(number) {
  if (!neighbor_) return;
  neighbor_->patch = turned_to(*neighbor, curve_);
  const NurbsCurve side = boundary(neighbor_->patch, Border::v_end);
  moved_ = {glm::dvec3(curve_.points().front()) - glm::dvec3(side.points().front()),
            glm::dvec3(curve_.points().back()) - glm::dvec3(side.points().back())};
  curve_ = side;
}

std::optional<SidePiece> SidePiece::of_one_patch(const SidePiece& first, const SidePiece& second) {
  if (!first.neighbor_ || !second.neighbor_ || first.continuity() != second.continuity()) return {};
  std::optional<NurbsPatch> patch = one_patch(first.neighbor_->patch, second.neighbor_->patch);
  if (!patch) return {};
  LoftNeighbor both{std::move(*patch), Border::v_end, first.continuity()};
  NurbsCurve curve = boundary(both.patch, both.side);
  std::vector<glm::dvec4> points(curve.points().begin(), curve.points().end());
  points.front() += glm::dvec4(first.moved_[0], 0.0);
  points.back() += glm::dvec4(second.moved_[1], 0.0);
  return SidePiece(curve.with_points(std::move(points)), both, first.number_);
}

std::string SidePiece::name() const { return "sides" + index_text(number_); }

NurbsCurve SidePiece::curve() const {
  std::vector<glm::dvec4> points(curve_.points().begin(), curve_.points().end());
  points.front() += glm::dvec4(moved_[0], 0.0);
  points.back() += glm::dvec4(moved_[1], 0.0);
  return curve_.with_points(std::move(points));
}

std::vector<glm::dvec3> SidePiece::points(std::span<const double> s) const {
  std::vector<glm::dvec3> found(s.size());
  if (s.empty()) return found;
  evaluate(curve_, s, std::span(&found.front().x, 3 * found.size()));
  for (std::size_t i = 0; i < s.size(); ++i) found[i] += (1.0 - s[i]) * moved_[0] + s[i] * moved_[1];
  return found;
}

std::vector<HolePlace> SidePiece::places(std::span<const double> s) const {
  const PlacesAtKnots at(s, curve_.knot_vector());
  std::vector<HolePlace> found(s.size());
  if (!neighbor_) {
    const auto write = [&](std::span<const double> here, Side side, std::span<double> out) {
      derivatives(curve_, here, 2, out, {.side = side});
    };
    const std::vector<glm::dvec3> values = at.means(3, write);
    for (std::size_t i = 0; i < s.size(); ++i) {
      found[i] = {values[3 * i], values[3 * i + 1], values[3 * i + 2], glm::dvec3(0.0), glm::dvec3(0.0), glm::dvec3(0.0)};
    }
    return found;
  }
  const std::vector<double> end(s.size(), neighbor_->patch.knot_vector(Axis::v).domain().end);
  const auto write = [&](std::span<const double> here, Side side, std::span<double> out) {
    PatchOptions options;
    options.side_u = side;
    derivatives(neighbor_->patch, here, end, 2, out, options);
  };
  const std::vector<glm::dvec3> values = at.means(9, write);
  for (std::size_t i = 0; i < s.size(); ++i) {
    const glm::dvec3* const d = &values[9 * i];  // by u and v: [k][l]
    const glm::dvec3 moved = (1.0 - s[i]) * moved_[0] + s[i] * moved_[1];
    found[i] = {d[0] + moved, d[3] + moved_[1] - moved_[0], d[6], d[1], d[4], d[2]};
  }
  return found;
}

void SidePiece::set_end(bool is_end, const glm::dvec3& across, const glm::dvec3& across_2) {
  const HolePlace here = place(is_end ? 1.0 : 0.0);
  const auto first = parts_of(across, here.out, here.along);
  if (!first) {
    throw InvalidShape("the neighbor of " + name() + " has a zero derivative across it at its " + (is_end ? "end" : "start") +
                       ": it cannot be continued there");
  }
  const auto [a, b] = *first;
  a_.values[is_end] = a;
  b_.values[is_end] = b;
  const glm::dvec3 rest = across_2 - a * a * here.out_2 - 2.0 * a * b * here.out_along - b * b * here.along_2;
  const auto second = parts_of(rest, here.out, here.along);
  c_.values[is_end] = second->first;
  d_.values[is_end] = second->second;
}

void SidePiece::bulge_towards(std::span<const double> s, std::span<const glm::dvec3> wanted, int order, int power) {
  constexpr double kParallel = 1e-6;
  constexpr double kLeast = 0.25;
  const std::vector<HolePlace> here = places(s);
  const std::vector<glm::dvec3> found = across(s, order);
  std::vector<double> at;
  std::vector<double> out;
  std::vector<double> along;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const glm::dvec3 normal = glm::cross(here[i].out, here[i].along);
    const double square = glm::dot(normal, normal);
    if (!(square > kParallel * kParallel * glm::dot(here[i].out, here[i].out) * glm::dot(here[i].along, here[i].along))) continue;
    const glm::dvec3 missing = wanted[i] - found[i];
    at.push_back(s[i]);
    out.push_back(glm::dot(glm::cross(missing, here[i].along), normal) / square);
    along.push_back(glm::dot(glm::cross(here[i].out, missing), normal) / square);
  }
  Factor& of_out = order == 1 ? a_ : c_;
  Factor& of_along = order == 1 ? b_ : d_;
  of_out.power = of_along.power = power;
  of_out.bulges = bulges_of(at, out, power);
  of_along.bulges = bulges_of(at, along, power);
  if (order == 2) return;
  Factor before = a_;
  before.bulges = {};
  double share = 1.0;
  for (const double place : at) {
    const double own = before.at(place);
    const double bent = a_.at(place) - own;
    if (own + share * bent < kLeast * own) share = (kLeast - 1.0) * own / bent;
  }
  for (Factor* factor : {&a_, &b_}) {
    for (double& part : factor->bulges) part *= share;
  }
}

double SidePiece::bend_onward() {
  constexpr int kPlaces = 33;
  constexpr double kLeast = 0.1;
  if (!(a_.values[0] > 0.0 && a_.values[1] > 0.0)) return 0.0;
  Factor line = a_;
  line.slopes = {};
  double share = 1.0;
  for (int k = 0; k < kPlaces; ++k) {
    const double s = static_cast<double>(k) / (kPlaces - 1);
    const double straight = line.at(s);
    const double bent = a_.at(s) - straight;
    if (straight + share * bent < kLeast * straight) share = (kLeast - 1.0) * straight / bent;
  }
  for (Factor* factor : {&a_, &b_}) {
    for (double& slope : factor->slopes) slope *= share;
  }
  return share;
}

AcrossJet SidePiece::jet(bool is_end) const {
  constexpr int kOrder = 4;
  constexpr int kWidth = kOrder + 1;
  const double s = is_end ? 1.0 : 0.0;
  const double t = neighbor_->patch.knot_vector(Axis::v).domain().end;
  std::vector<glm::dvec3> values(kWidth * kWidth);
  derivatives(neighbor_->patch, std::span(&s, 1), std::span(&t, 1), kOrder, std::span(&values.front().x, 3 * values.size()));
  const auto along = [&](int order, int out) {
    return ThreeOrders<glm::dvec3>{values[order * kWidth + out], values[(order + 1) * kWidth + out], values[(order + 2) * kWidth + out]};
  };
  const ThreeOrders<double> a = a_.derivatives(is_end);
  const ThreeOrders<double> b = b_.derivatives(is_end);
  const ThreeOrders<double> ab = product(a, b);
  const ThreeOrders<double> twice{2.0 * ab[0], 2.0 * ab[1], 2.0 * ab[2]};
  return {sum(product(a, along(0, 1)), product(b, along(1, 0))),
          sum(sum(sum(product(product(a, a), along(0, 2)), product(twice, along(1, 1))), product(product(b, b), along(2, 0))),
              sum(product(c_.derivatives(is_end), along(0, 1)), product(d_.derivatives(is_end), along(1, 0))))};
}

std::array<glm::dvec3, 2> SidePiece::directions(bool is_end) const {
  const HolePlace here = place(is_end ? 1.0 : 0.0);
  return {here.out, here.along};
}

void SidePiece::bend_first(bool is_end, double a, double b) {
  a_.slopes[is_end] += a;
  b_.slopes[is_end] += b;
}

void SidePiece::bend_second(bool is_end, int order, double c, double d) {
  (order == 1 ? c_.slopes : c_.seconds)[is_end] += c;
  (order == 1 ? d_.slopes : d_.seconds)[is_end] += d;
}

std::optional<NurbsPatch> SidePiece::neighbor_part(double from, double to) const {
  if (!neighbor_) return {};
  NurbsPatch part = neighbor_->patch;
  if (to < 1.0) part = split(part, Axis::u, to).first;
  if (from > 0.0) part = split(part, Axis::u, from).second;
  return part;
}

std::vector<glm::dvec3> SidePiece::across(std::span<const double> s, int order) const {
  const std::vector<HolePlace> here = places(s);
  std::vector<glm::dvec3> found;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const double a = a_.at(s[i]);
    const double b = b_.at(s[i]);
    const HolePlace& p = here[i];
    const glm::dvec3 second = a * a * p.out_2 + 2.0 * a * b * p.out_along + b * b * p.along_2;
    found.push_back(order == 1 ? a * p.out + b * p.along : second + c_.at(s[i]) * p.out + d_.at(s[i]) * p.along);
  }
  return found;
}

}  // namespace splinecore
