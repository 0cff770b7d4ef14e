#include "bicubic_sum.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "base/length.hpp"
#include "boolean_sum.hpp"
#include "fit/row_spline.hpp"
#include "greville.hpp"
#include "homogeneous_places.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/compatible.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

constexpr int kCubic = 3;

/// A cubic over [0, 1] by its values and derivatives at both ends.
template <class Value>
struct EndCubic {
  std::array<Value, 2> values{};
  std::array<Value, 2> slopes{};

  Value at(double s) const {
    const double t = 1.0 - s;
    return t * t * (1.0 + 2.0 * s) * values[0] + s * s * (1.0 + 2.0 * t) * values[1] + s * t * (t * slopes[0] - s * slopes[1]);
  }
};

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
  std::array<double, 2> scale;   ///< of weights, at both ends
  EndCubic<double> growth;       ///< of weights across

  bool is_level() const { return scale[0] == scale[1]; }
};

using CrossedPair = std::array<CrossedBorder, 2>;

CrossedPair crossings_of(const BorderPair& borders) {
  CrossedPair made{CrossedBorder{borders[0], {}, {}, {}, {}, {}}, CrossedBorder{borders[1], {}, {}, {}, {}, {}}};
  for (CrossedBorder& one : made) {
    const auto points = one.given.curve.points();
    if (points.front().w == 0.0 || points.back().w == 0.0) throw InvalidShape("a side ends at infinity");
    one.ends = ends_of(one.given.curve);
    if (one.given.across) one.across = ends_of(*one.given.across);
    one.scale = {1.0 / points.front().w, 1.0 / points.back().w};
  }
  return made;
}

/// The twist that the bilinear patch of all borders has in a corner.
glm::dvec3 bilinear_twist(const CrossedPair& u, const CrossedPair& v, std::size_t i, std::size_t j) {
  const auto& low = u[0].ends;
  const auto& high = u[1].ends;
  return (high.slopes[i] - low.slopes[i]) + (v[1].ends.slopes[j] - v[0].ends.slopes[j]) -
         ((low.points[0] - low.points[1]) + (high.points[1] - high.points[0]));
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
      misfits.twist = std::max({misfits.twist, bent_u, bent_v});
    }
  }
  return misfits;
}

/// Homogeneous points of a border with weights 1 at both ends.
std::vector<glm::dvec4> scaled_places(const CrossedBorder& one, std::span<const double> at) {
  std::vector<glm::dvec4> found = homogeneous_places(one.given.curve, at);
  for (std::size_t k = 0; k < at.size(); ++k) {
    found[k] *= one.is_level() ? one.scale[0] : (1.0 - at[k]) * one.scale[0] + at[k] * one.scale[1];
  }
  return found;
}

/// The derivative by s, at both ends, of weights that are 1 there.
std::array<double, 2> weight_slopes(const CrossedBorder& one) {
  const auto& curve = one.given.curve;
  const auto knots = curve.knot_vector().knots();
  const auto degree = static_cast<std::size_t>(curve.degree());
  const auto points = curve.points();
  const double change = one.scale[1] - one.scale[0];
  const double start = static_cast<double>(degree) / (knots[degree + 1] - knots[1]);
  const double end = static_cast<double>(degree) / (knots[knots.size() - 2] - knots[knots.size() - degree - 2]);
  return {one.scale[0] * start * (points[1].w - points[0].w) + change * points[0].w,
          one.scale[1] * end * (points[points.size() - 1].w - points[points.size() - 2].w) + change * points[points.size() - 1].w};
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
  const int linear = pair[0].is_level() && pair[1].is_level() ? 0 : 1;
  const int made = is_rational ? degree + linear + std::max(kCubic, has_given ? degree : 0) : std::max(degree, kCubic);
  std::vector<double> knots(static_cast<std::size_t>(made) + 1, 0.0);
  for (const double knot : common.knots()) {
    if (!(knot > 0.0 && knot < 1.0)) continue;
    const int times = multiplicity(common, knot);
    if (times > degree) throw InvalidShape("a side, or a derivative across it, jumps");
    if (knots.back() != knot) knots.insert(knots.end(), static_cast<std::size_t>(made - degree + times), knot);
  }
  knots.insert(knots.end(), static_cast<std::size_t>(made) + 1, 1.0);
  return KnotVector::make(made, std::move(knots));
}

/// Both borders and, between them, the rows of control points that let cubics leave them.
struct CubicRows {
  KnotVector knots;
  std::array<std::vector<glm::dvec4>, 4> rows;
};

void add(std::vector<double>& numbers, const glm::dvec4& p) { numbers.insert(numbers.end(), {p.x, p.y, p.z, p.w}); }

CubicRows rows_of(const CrossedPair& pair, bool is_rational) {
  const KnotVector knots = knots_of(pair, is_rational);
  RowConditions given{greville_places(knots), {}, {}, {}};
  const auto& at = given.parameters;
  const auto low = scaled_places(pair[0], at);
  const auto high = scaled_places(pair[1], at);
  const auto from_low = leaving_places(pair[0], at, low);
  const auto from_high = leaving_places(pair[1], at, high);
  for (std::size_t k = 0; k < at.size(); ++k) {
    std::vector<double> numbers;
    add(numbers, low[k]);
    add(numbers, low[k] + from_low[k] / 3.0);
    add(numbers, high[k] - from_high[k] / 3.0);
    add(numbers, high[k]);
    given.rows.push_back(std::move(numbers));
  }
  const RowSpline spline = spline_through(given, knots.degree(), Closing::open, {knots.knots().begin(), knots.knots().end()});
  CubicRows made{spline.knots, {}};
  for (std::size_t k = 0; k < at.size(); ++k) {
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

bool has_positive_weights(std::span<const glm::dvec4> points) {
  return std::ranges::all_of(points, [](const glm::dvec4& p) { return p.w > 0.0; });
}

bool have_positive_weights(const std::array<NurbsCurve, 2>& curves) {
  return std::ranges::all_of(curves, [](const NurbsCurve& curve) { return has_positive_weights(curve.points()); });
}

/// The border, its weights 1 at both ends.
NurbsCurve border_of(const CrossedBorder& one, const CubicRows& rows, std::size_t row) {
  if (!one.is_level()) return NurbsCurve::from_homogeneous(rows.knots, rows.rows[row]);
  std::vector<glm::dvec4> points(one.given.curve.points().begin(), one.given.curve.points().end());
  for (glm::dvec4& p : points) p = p.w == 0.0 ? one.scale[0] * p : glm::dvec4(glm::dvec3(p), one.scale[0] * p.w);
  return one.given.curve.with_points(std::move(points));
}

}  // namespace

BicubicSum bicubic_sum(const BorderPair& along_u, const BorderPair& along_v) {
  CrossedPair u = crossings_of(along_u);
  CrossedPair v = crossings_of(along_v);
  const CornerMisfits misfits = meet_in_corners(u, v);
  for (std::size_t end = 0; end < 2; ++end) {
    u[end].growth.values = {weight_slopes(v[0])[end], weight_slopes(v[1])[end]};
    v[end].growth.values = {weight_slopes(u[0])[end], weight_slopes(u[1])[end]};
  }
  const bool rational = is_rational(u) || is_rational(v);
  const CubicRows rows_u = rows_of(u, rational);
  const CubicRows rows_v = rows_of(v, rational);
  const std::array borders_u{border_of(u[0], rows_u, 0), border_of(u[1], rows_u, 3)};
  const std::array borders_v{border_of(v[0], rows_v, 0), border_of(v[1], rows_v, 3)};
  NurbsPatch patch = boolean_sum(patch_of(rows_u), swapped(patch_of(rows_v)), corner_patch(rows_u));
  if (have_positive_weights(borders_u) && have_positive_weights(borders_v) && !has_positive_weights(patch.points())) {
    throw InvalidShape("the weights of the sides differ so much that inside the patch some would not stay positive");
  }
  return {std::move(patch), borders_u, borders_v, misfits};
}

}  // namespace splinecore
