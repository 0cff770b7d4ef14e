#include "one_patch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "base/length.hpp"
#include "patch/lines.hpp"
#include "patch/without_copies.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/patch/degree.hpp"
#include "splinecore/patch/ends.hpp"
#include "splinecore/patch/evaluate.hpp"

namespace splinecore {

namespace {

constexpr double kSame = 1e-9;

bool are_alike(const KnotVector& a, const KnotVector& b) {
  const double length = a.domain().length();
  const auto is_same = [&](double x, double y) { return std::abs(x - y) <= kSame * length; };
  return a.degree() == b.degree() && !a.periodic() && !b.periodic() && std::ranges::equal(a.knots(), b.knots(), is_same);
}

/// How fast u runs along v_end.
double speed_at(const NurbsPatch& patch, double u) {
  const double v = patch.knot_vector(Axis::v).domain().end;
  std::array<glm::dvec3, 4> found;
  derivatives(patch, std::span(&u, 1), std::span(&v, 1), 1, std::span(&found.front().x, 3 * found.size()));
  return length_of(found[2]);
}

/// The nets one after the other, weights of the second one by a factor.
NurbsPatch in_a_row(const NurbsPatch& first, const NurbsPatch& second, double factor) {
  const auto knots_a = first.knot_vector(Axis::u).knots();
  const auto knots_b = second.knot_vector(Axis::u).knots();
  const auto order = static_cast<std::size_t>(first.knot_vector(Axis::u).degree()) + 1;
  const auto row = static_cast<std::size_t>(first.knot_vector(Axis::v).count());
  std::vector<double> knots(knots_a.begin(), knots_a.end() - 1);
  knots.insert(knots.end(), knots_b.begin() + order, knots_b.end());
  std::vector<glm::dvec4> points(first.points().begin(), first.points().end());
  for (std::size_t i = row; i < second.points().size(); ++i) {
    const glm::dvec4& p = second.points()[i];
    points.emplace_back(glm::dvec3(p), p.w * factor);
  }
  return NurbsPatch::make(KnotVector::make(static_cast<int>(order) - 1, std::move(knots)), first.knot_vector(Axis::v), std::move(points));
}

/// Whether the first row of a net is the last one of another, weights by a factor.
bool have_common_row(const NurbsPatch& first, const NurbsPatch& second, double factor, double size) {
  const auto row = static_cast<std::size_t>(first.knot_vector(Axis::v).count());
  const auto last = first.points().last(row);
  for (std::size_t j = 0; j < row; ++j) {
    const glm::dvec4& a = last[j];
    const glm::dvec4& b = second.points()[j];
    if (distance_of(glm::dvec3(a), glm::dvec3(b)) > kSame * size || std::abs(a.w - factor * b.w) > kSame * std::abs(a.w)) return false;
  }
  return true;
}

}  // namespace

std::optional<NurbsPatch> one_patch(const NurbsPatch& first, const NurbsPatch& second) {
  if (!are_alike(first.knot_vector(Axis::v), second.knot_vector(Axis::v))) return {};
  const int degree = std::max(first.knot_vector(Axis::u).degree(), second.knot_vector(Axis::u).degree());
  const NurbsPatch a = elevated(with_domain(first, Axis::u, {0.0, 1.0}), Axis::u, degree - first.knot_vector(Axis::u).degree());
  const Interval domain = second.knot_vector(Axis::u).domain();
  const double pace = speed_at(second, domain.start) * domain.length() / speed_at(a, 1.0);
  if (!(pace > kSame && pace < 1.0 / kSame)) return {};
  const NurbsPatch b = elevated(with_domain(second, Axis::u, {1.0, 1.0 + pace}), Axis::u, degree - second.knot_vector(Axis::u).degree());
  const double factor = a.points().back().w / b.points()[static_cast<std::size_t>(b.knot_vector(Axis::v).count()) - 1].w;
  const double size = largest_coordinate(a.points());
  if (!(factor > 0.0) || !std::isfinite(factor) || !have_common_row(a, b, factor, size)) return {};
  const NurbsPatch whole = in_a_row(a, b, factor);
  NurbsPatch one = without_copies({whole, 0.0}, Axis::u, 1.0, whole, kSame * size).value;
  if (multiplicity(one.knot_vector(Axis::u), 1.0) >= degree) return {};
  return with_domain(one, Axis::u, {0.0, 1.0});
}

}  // namespace splinecore
