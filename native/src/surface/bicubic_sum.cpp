#include "bicubic_sum.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "base/length.hpp"
#include "base/positive_weights.hpp"
#include "boolean_sum.hpp"
#include "end_cubic.hpp"
#include "end_scale.hpp"
#include "fit/row_spline.hpp"
#include "greville.hpp"
#include "homogeneous_places.hpp"
#include "raised_knots.hpp"
#include "run_back.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/compatible.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

constexpr int kCubic = 3;

using EndVectors = std::array<glm::dvec3, 2>;

/// A point and the first derivative at both ends.
struct Ends {
  EndVectors points;
  EndVectors slopes;
};

Ends ends_of(const NurbsCurve& curve) {
  const double at[] = {0.0, 1.0};
  glm::dvec3 found[4];
  derivatives(curve, at, 1, std::span(&found[0].x, 12), {.side = Side::left});
  return {{found[0], found[2]}, {found[1], found[3]}};
}

/// One border while the patch is made.
struct CrossedBorder {
  LeftBorder given;
  Ends ends;                     ///< of the curve
  std::optional<Ends> across;    ///< of the derivative given
  EndCubic<glm::dvec3> added;    ///< to that, or to nothing
  EndScale scale;                ///< of weights
  EndCubic<double> growth;       ///< of weights across
};

using CrossedPair = std::array<CrossedBorder, 2>;

CrossedPair crossings_of(const BorderPair& borders) {
  CrossedPair made{CrossedBorder{borders[0], {}, {}, {}, EndScale::of(borders[0].curve), {}},
                   CrossedBorder{borders[1], {}, {}, {}, EndScale::of(borders[1].curve), {}}};
  for (CrossedBorder& one : made) {
    const auto points = one.given.curve.points();
    if (points.front().w == 0.0 || points.back().w == 0.0) throw InvalidShape("a side ends at infinity");
    one.ends = ends_of(one.given.curve);
    if (one.given.across) one.across = ends_of(*one.given.across);
  }
  return made;
}

/// How long derivatives across a border are at its ends, where they are those along the next borders.
double lengths_across(const CrossedPair& next, std::size_t end) {
  return length_of(next[0].ends.slopes[end]) + length_of(next[1].ends.slopes[end]);
}

/// The twist that the bilinear patch of all borders has in a corner, but not so long that a cubic with it swings out between
/// the ends of a border, as it would where weights let the border leave a corner fast.
glm::dvec3 bilinear_twist(const CrossedPair& u, const CrossedPair& v, std::size_t i, std::size_t j) {
  const auto& low = u[0].ends;
  const auto& high = u[1].ends;
  const glm::dvec3 twist = (high.slopes[i] - low.slopes[i]) + (v[1].ends.slopes[j] - v[0].ends.slopes[j]) -
                           ((low.points[0] - low.points[1]) + (high.points[1] - high.points[0]));
  constexpr double kMost = 3.0;
  const double most = kMost * std::min(lengths_across(u, i), lengths_across(v, j));
  const double length = length_of(twist);
  return length > most ? twist * (most / length) : twist;
}

/// The derivative of what is given at an end: the twist in that corner.
std::optional<glm::dvec3> twist_of(const CrossedBorder& one, std::size_t end) {
  return one.across ? std::optional(one.across->slopes[end]) : std::nullopt;
}

/// Lets a derivative across end in the one along the next border, with this twist. @returns what it was changed by
std::array<double, 2> end_in(CrossedBorder& one, std::size_t end, const glm::dvec3& along_next, const glm::dvec3& twist) {
  constexpr double kBump = 4.0 / 27.0;  // the most of s (1 - s)²
  one.added.values[end] = along_next;
  one.added.slopes[end] = twist;
  if (!one.across) return {0.0, 0.0};
  one.added.values[end] -= one.across->points[end];
  one.added.slopes[end] -= one.across->slopes[end];
  return {length_of(one.added.values[end]), kBump * length_of(one.added.slopes[end])};
}

CornerMisfits meet_in_corners(CrossedPair& u, CrossedPair& v) {
  CornerMisfits misfits;
  std::array<double, 2> bent_along_u{};  // what is changed at both ends of a border adds up
  std::array<double, 2> bent_along_v{};
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      const auto by_u = twist_of(u[j], i);
      const auto by_v = twist_of(v[i], j);
      glm::dvec3 twist = by_u ? *by_u : by_v ? *by_v : bilinear_twist(u, v, i, j);
      if (by_u && by_v && *by_u != *by_v) twist = 0.5 * (*by_u + *by_v);
      const auto [off_u, bent_u] = end_in(u[j], i, v[i].ends.slopes[j], twist);
      const auto [off_v, bent_v] = end_in(v[i], j, u[j].ends.slopes[i], twist);
      misfits.along_u[j] = std::max(misfits.along_u[j], off_u);
      misfits.along_v[i] = std::max(misfits.along_v[i], off_v);
      bent_along_u[j] += bent_u;
      bent_along_v[i] += bent_v;
    }
  }
  misfits.twist = std::max({bent_along_u[0], bent_along_u[1], bent_along_v[0], bent_along_v[1]});
  return misfits;
}

/// Homogeneous points of a border with weights 1 at both ends.
std::vector<glm::dvec4> scaled_places(const CrossedBorder& one, std::span<const double> at) {
  std::vector<glm::dvec4> found = homogeneous_places(one.given.curve, at);
  for (std::size_t k = 0; k < at.size(); ++k) found[k] *= one.scale.at(at[k]);
  return found;
}

/// Homogeneous derivatives across a border.
std::vector<glm::dvec4> leaving_places(const CrossedBorder& one, std::span<const double> at, std::span<const glm::dvec4> places) {
  std::vector<glm::dvec3> by(at.size(), glm::dvec3(0.0));
  if (one.given.across) evaluate(*one.given.across, at, {&by.front().x, 3 * by.size()});
  std::vector<glm::dvec4> found;
  for (std::size_t k = 0; k < at.size(); ++k) {
    const glm::dvec3 vector = by[k] + one.added.at(at[k]);
    found.push_back(places[k].w * glm::dvec4(vector, 0.0) + one.growth.at(at[k]) * places[k]);
  }
  return found;
}

/// The derivatives by s, at an end, of homogeneous points and of homogeneous derivatives across.
std::array<glm::dvec4, 2> changes_at_end(const CrossedBorder& one, std::size_t end) {
  const double weight_slope = scaled_weight_slopes(one.given.curve)[end];
  glm::dvec3 vector = one.added.values[end];
  glm::dvec3 twist = one.added.slopes[end];
  if (one.across) {
    vector += one.across->points[end];
    twist += one.across->slopes[end];
  }
  const glm::dvec4 change(weight_slope * one.ends.points[end] + one.ends.slopes[end], weight_slope);
  return {change, glm::dvec4(weight_slope * vector + twist, 0.0) + one.growth.values[end] * change};
}

/// What multiplies the homogeneous points of both borders: a number, or a linear function.
int scale_degree(const CrossedPair& pair) { return pair[0].scale.is_level() && pair[1].scale.is_level() ? 0 : 1; }

/// Knots on which both borders and what leaves them are splines.
KnotVector knots_of(const CrossedPair& pair, bool is_rational) {
  std::vector<NurbsCurve> curves;
  for (const CrossedBorder& one : pair) curves.push_back(one.given.curve);
  for (const CrossedBorder& one : pair) {
    if (one.given.across) curves.push_back(*one.given.across);
  }
  const bool has_given = curves.size() > 2;
  const KnotVector common = compatible(curves).front().knot_vector();
  const int degree = common.degree();
  const int leaving = std::max(kCubic, has_given ? degree : 0);
  return raised_knots(common, is_rational ? degree + scale_degree(pair) + leaving : std::max(degree, kCubic), 0);
}

/// Knots of a degree, or of the lowest one above it, on which both borders are splines, and what leaves them nearly is: it
/// is once less smooth, for it runs along them, too.
KnotVector knots_of_degree(const CrossedPair& pair, int degree) {
  const std::array curves{pair[0].given.curve, pair[1].given.curve};
  const KnotVector common = compatible(curves).front().knot_vector();
  const bool has_given = pair[0].given.across || pair[1].given.across;
  return raised_knots(common, std::max(degree, common.degree() + scale_degree(pair)), has_given ? 1 : 0);
}

/// Both borders and, between them, the rows of control points that let cubics leave them.
struct CubicRows {
  KnotVector knots;
  std::array<std::vector<glm::dvec4>, 4> rows;
};

/// Homogeneous points, and derivatives across, of two borders at a place, or the derivatives of both, as control points of a cubic.
std::vector<double> cubic_between(const glm::dvec4& low, const glm::dvec4& from_low, const glm::dvec4& from_high,
                                  const glm::dvec4& high) {
  const std::array cubic{low, low + from_low / 3.0, high - from_high / 3.0, high};
  return numbers_of(cubic);
}

std::vector<double> change_at_end(const CrossedPair& pair, std::size_t end) {
  const auto low = changes_at_end(pair[0], end);
  const auto high = changes_at_end(pair[1], end);
  return cubic_between(low[0], low[1], high[1], high[0]);
}

CubicRows rows_of(const CrossedPair& pair, const KnotVector& knots, bool is_rational) {
  RowConditions given{interpolation_places_between_slopes(knots), {}, {change_at_end(pair, 0)}, {change_at_end(pair, 1)}};
  const auto& at = given.parameters;
  const auto low = scaled_places(pair[0], at);
  const auto high = scaled_places(pair[1], at);
  const auto from_low = leaving_places(pair[0], at, low);
  const auto from_high = leaving_places(pair[1], at, high);
  for (std::size_t k = 0; k < at.size(); ++k) given.rows.push_back(cubic_between(low[k], from_low[k], from_high[k], high[k]));
  const RowSpline spline = spline_through(given, knots.degree(), Closing::open, {knots.knots().begin(), knots.knots().end()});
  CubicRows made{spline.knots, {}};
  for (std::size_t k = 0; 16 * k < spline.controls.size(); ++k) {
    for (std::size_t row = 0; row < 4; ++row) {
      const double* const p = &spline.controls[16 * k + 4 * row];
      made.rows[row].emplace_back(p[0], p[1], p[2], is_rational ? p[3] : 1.0);
    }
  }
  return made;
}

/// The cubic with the same ends, and derivatives there, as a row of control points over [0, 1].
std::array<glm::dvec4, 4> cubic_of(const KnotVector& knots, std::span<const glm::dvec4> row) {
  const auto all = knots.knots();
  const auto degree = static_cast<std::size_t>(knots.degree());
  const double start = static_cast<double>(degree) / (all[degree + 1] - all[1]);
  const double end = static_cast<double>(degree) / (all[all.size() - 2] - all[all.size() - degree - 2]);
  const std::size_t last = row.size() - 1;
  return {row[0], row[0] + start / 3.0 * (row[1] - row[0]), row[last] - end / 3.0 * (row[last] - row[last - 1]), row[last]};
}

NurbsPatch patch_of(const CubicRows& rows) {
  const std::size_t count = rows.rows[0].size();
  std::vector<glm::dvec4> net;
  for (std::size_t i = 0; i < count; ++i) {
    for (const auto& row : rows.rows) net.push_back(row[i]);
  }
  return NurbsPatch::from_homogeneous(rows.knots, KnotVector::bezier(kCubic), net);
}

NurbsPatch corner_patch(const CubicRows& rows) {
  std::vector<glm::dvec4> net(16);
  for (std::size_t j = 0; j < 4; ++j) {
    const auto cubic = cubic_of(rows.knots, rows.rows[j]);
    for (std::size_t i = 0; i < 4; ++i) net[4 * i + j] = cubic[i];
  }
  return NurbsPatch::from_homogeneous(KnotVector::bezier(kCubic), KnotVector::bezier(kCubic), net);
}

bool is_rational(const CrossedPair& pair) {
  return std::ranges::any_of(pair, [](const CrossedBorder& one) { return one.given.curve.rational(); });
}

bool are_positive(const std::array<NurbsCurve, 2>& curves) {
  return have_positive_weights(curves[0].points()) && have_positive_weights(curves[1].points());
}

/// The border, its weights 1 at both ends.
NurbsCurve border_of(const CrossedBorder& one, const CubicRows& rows, std::size_t row) {
  if (!one.scale.is_level()) return NurbsCurve::from_homogeneous(rows.knots, rows.rows[row]);
  std::vector<glm::dvec4> points(one.given.curve.points().begin(), one.given.curve.points().end());
  for (glm::dvec4& p : points) p = p.w == 0.0 ? one.scale.start * p : glm::dvec4(glm::dvec3(p), one.scale.start * p.w);
  return one.given.curve.with_points(std::move(points));
}

NurbsCurve negative(const NurbsCurve& vectors) {
  std::vector<glm::dvec4> points(vectors.points().begin(), vectors.points().end());
  for (glm::dvec4& p : points) p = glm::dvec4(-glm::dvec3(p), 1.0);
  return vectors.with_points(std::move(points));
}

/// A side that goes back along u or v, and whose derivative goes out there.
LeftBorder opposite(const LeftBorder& border, bool is_back, bool is_out) {
  LeftBorder made = border;
  if (is_back) made.curve = run_back(made.curve);
  if (is_back && made.across) made.across = run_back(*made.across);
  if (is_out && made.across) made.across = negative(*made.across);
  return made;
}

}  // namespace

BorderPairs borders_around(const std::array<LeftBorder, 4>& sides) {
  return {{sides[0], opposite(sides[2], true, true)}, {opposite(sides[3], true, false), opposite(sides[1], false, true)}};
}

BicubicSum bicubic_sum(const BorderPair& along_u, const BorderPair& along_v, std::optional<int> degree) {
  CrossedPair u = crossings_of(along_u);
  CrossedPair v = crossings_of(along_v);
  const CornerMisfits misfits = meet_in_corners(u, v);
  for (std::size_t end = 0; end < 2; ++end) {
    u[end].growth.values = {scaled_weight_slopes(v[0].given.curve)[end], scaled_weight_slopes(v[1].given.curve)[end]};
    v[end].growth.values = {scaled_weight_slopes(u[0].given.curve)[end], scaled_weight_slopes(u[1].given.curve)[end]};
  }
  const bool rational = is_rational(u) || is_rational(v);
  const auto rows_along = [&](const CrossedPair& pair) {
    return rows_of(pair, degree ? knots_of_degree(pair, std::max(kCubic, *degree)) : knots_of(pair, rational), rational);
  };
  const CubicRows rows_u = rows_along(u);
  const CubicRows rows_v = rows_along(v);
  const std::array borders_u{border_of(u[0], rows_u, 0), border_of(u[1], rows_u, 3)};
  const std::array borders_v{border_of(v[0], rows_v, 0), border_of(v[1], rows_v, 3)};
  return {boolean_sum(patch_of(rows_u), swapped(patch_of(rows_v)), corner_patch(rows_u)), borders_u, borders_v, misfits};
}

bool keeps_weights_positive(const BicubicSum& sum) {
  return have_positive_weights(sum.patch.points()) || !are_positive(sum.along_u) || !are_positive(sum.along_v);
}

}  // namespace splinecore
