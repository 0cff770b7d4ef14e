#include "splinecore/surface/network.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>

#include "base/length.hpp"
#include "base/positive_weights.hpp"
#include "base/quotient.hpp"
#include "base/require.hpp"
#include "boolean_sum.hpp"
#include "build/fit_options.hpp"
#include "fit/row_spline.hpp"
#include "homogeneous_places.hpp"
#include "meet/near_space.hpp"
#include "meet/said_outside.hpp"
#include "network_borders.hpp"
#include "network_curves.hpp"
#include "network_edges.hpp"
#include "network_weights.hpp"
#include "paced_family.hpp"
#include "span_places.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/curve/compatible.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/patch/isocurve.hpp"

namespace splinecore {

namespace {

using Rows = std::vector<std::vector<double>>;

/// How control points of one direction follow from places along it.
struct Across {
  std::vector<double> parameters;
  int degree;
  Closing closing;
  std::vector<double> knots;  ///< or none, for averages

  /// @param start, end  derivatives there: one row, or none
  std::vector<glm::dvec4> rows(const Rows& places, const Rows& start, const Rows& end, KnotVector& found) const {
    const RowSpline spline = spline_through({parameters, places, start, end}, degree, closing, knots);
    found = spline.knots;
    std::vector<glm::dvec4> points(spline.controls.size() / 4);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double* const p = &spline.controls[4 * i];
      points[i] = {p[0], p[1], p[2], p[3]};
    }
    return points;
  }
};

/// With the knots of the curves along it, if as many curves cross as these have control points, and nothing else is asked for.
Across across_by(const PacedFamily& along, const std::array<std::optional<NurbsCurve>, 2>& leaving) {
  const KnotVector& knots = along.curves[0].knot_vector();
  const std::size_t count = count_of_others(along);
  const std::size_t conditions = count + leaving[0].has_value() + leaving[1].has_value();
  Across across{along.wanted, 0, along.is_closed ? Closing::closed : Closing::open, {}};
  across.degree = std::min(std::max(3, knots.degree()), static_cast<int>(conditions) - 1);
  if (along.is_closed && across.degree % 2 == 0) across.degree = 3;  // even ones have their seams between the others
  if (conditions != count || static_cast<std::size_t>(knots.count()) != count) return across;
  across.degree = knots.degree();
  across.knots.assign(knots.knots().begin(), knots.knots().end());
  return across;
}

/// Rows of control points along u, one behind the other along v.
NurbsPatch from_rows(const KnotVector& knots_u, const KnotVector& knots_v, const std::vector<glm::dvec4>& rows) {
  const auto count_u = static_cast<std::size_t>(knots_u.count());
  const auto count_v = static_cast<std::size_t>(knots_v.count());
  std::vector<glm::dvec4> net(rows.size());
  for (std::size_t j = 0; j < count_v; ++j) {
    for (std::size_t i = 0; i < count_u; ++i) net[i * count_v + j] = rows[j * count_u + i];
  }
  return NurbsPatch::from_homogeneous(knots_u, knots_v, net);
}

void add_vector(std::vector<double>& row, const glm::dvec3& vector) {
  row.insert(row.end(), {vector.x, vector.y, vector.z, 0.0});
}

/// The control points of vectors as a row, none without them.
Rows row_of(const std::optional<NurbsCurve>& vectors) {
  if (!vectors) return {};
  std::vector<double> row;
  for (const glm::dvec4& p : vectors->points()) add_vector(row, glm::dvec3(p));
  return {row};
}

/// A vector at a parameter as a row, none without them.
Rows row_at(const std::optional<NurbsCurve>& vectors, double at) {
  if (!vectors) return {};
  glm::dvec3 vector;
  evaluate(*vectors, {&at, 1}, std::span(&vector.x, 3), {.side = Side::left});
  std::vector<double> row;
  add_vector(row, vector);
  return {row};
}

/// The patch through curves along u.
NurbsPatch through(const PacedFamily& family, const Across& across, const std::array<std::optional<NurbsCurve>, 2>& leaving) {
  Rows rows;
  for (const NurbsCurve& curve : family.curves) rows.push_back(numbers_of(homogeneous(curve.points())));
  KnotVector knots = family.curves[0].knot_vector();
  const std::vector<glm::dvec4> points = across.rows(rows, row_of(leaving[0]), row_of(leaving[1]), knots);
  return from_rows(family.curves[0].knot_vector(), knots, points);
}

/// A network and what leaves its borders.
struct GordonNet {
  PacedFamily u;
  PacedFamily v;
  NetworkBorders borders;
};

/// Derivatives of the curves along v at one of their ends, and at both ends of u the twists: a row of control points along u.
std::vector<double> leaving_row(const GordonNet& net, const Across& along_u, std::size_t end) {
  Rows places;
  for (const NurbsCurve& curve : net.v.curves) {
    const Interval domain = curve.domain();
    const double at[] = {end == 0 ? domain.start : domain.end};
    glm::dvec3 jet[2];
    derivatives(curve, at, 1, std::span(&jet[0].x, 6), {.side = end == 0 ? Side::right : Side::left});
    add_vector(places.emplace_back(), jet[1]);
  }
  std::array<Rows, 2> twists;
  for (std::size_t i = 0; i < 2; ++i) {
    if (net.borders.along_v[i]) add_vector(twists[i].emplace_back(), net.borders.twists[i][end]);
  }
  KnotVector knots = net.u.curves[0].knot_vector();
  return numbers_of(along_u.rows(places, twists[0], twists[1], knots));
}

/// The patch through the crossings alone, and what the derivatives of both sums have in common.
NurbsPatch through_crossings(const GordonNet& net, const Across& along_u, const Across& along_v) {
  const auto& [u, v, borders] = net;
  Rows rows;
  KnotVector knots_u = u.curves[0].knot_vector();
  for (std::size_t i = 0; i < u.curves.size(); ++i) {
    const auto on_u = homogeneous_places(u.curves[i], std::span(u.wanted).first(v.curves.size()));
    Rows places;
    for (std::size_t j = 0; j < v.curves.size(); ++j) {
      const glm::dvec4 on_v = homogeneous_places(v.curves[j], std::span(v.wanted).subspan(i, 1))[0];
      const glm::dvec4 middle = 0.5 * (on_u[j] + on_v);
      places.push_back({middle.x, middle.y, middle.z, middle.w});
    }
    const double at = v.wanted[i];
    rows.push_back(numbers_of(along_u.rows(places, row_at(borders.along_v[0], at), row_at(borders.along_v[1], at), knots_u)));
  }
  std::array<Rows, 2> ends;
  for (std::size_t end = 0; end < 2; ++end) {
    if (borders.along_u[end]) ends[end].push_back(leaving_row(net, along_u, end));
  }
  KnotVector knots_v = v.curves[0].knot_vector();
  const std::vector<glm::dvec4> points = along_v.rows(rows, ends[0], ends[1], knots_v);
  return from_rows(knots_u, knots_v, points);
}

NurbsPatch summed(const GordonNet& net) {
  const Across along_u = across_by(net.u, net.borders.along_v);
  const Across along_v = across_by(net.v, net.borders.along_u);
  return boolean_sum(through(net.u, along_v, net.borders.along_u), swapped(through(net.v, along_u, net.borders.along_v)),
                     through_crossings(net, along_u, along_v));
}

/// The curves of a family, and what leaves along them, on one knot vector.
void make_compatible(PacedFamily& family, std::array<std::optional<NurbsCurve>, 2>& leaving) {
  std::vector<NurbsCurve> all = family.curves;
  for (const auto& vectors : leaving) {
    if (vectors) all.push_back(*vectors);
  }
  all = compatible(all);
  auto next = all.begin() + static_cast<std::ptrdiff_t>(family.curves.size());
  for (auto& vectors : leaving) {
    if (vectors) vectors = *next++;
  }
  all.resize(family.curves.size(), all.front());
  family.curves = std::move(all);
}

/// Closed curves that only two or three others cross go round through as many more of their loft, half-way between: cubics close
/// smoothly through four. What families were given stays without these.
void add_others_to_closed(PacedFamily& closed, PacedFamily& others) {
  constexpr std::size_t kEnough = 4;
  const std::size_t count = others.curves.size();
  if (!closed.is_closed || count >= kEnough) return;
  if (others.is_closed && closed.curves.size() < kEnough) {
    throw InvalidShape("fewer than four closed curves cross fewer than four closed ones: four are needed in one direction");
  }
  std::array<std::optional<NurbsCurve>, 2> none;
  make_compatible(closed, none);
  const NurbsPatch loft = through(closed, across_by(others, none), none);
  for (std::size_t at = 1; at < 2 * count; at += 2) {
    const auto place = static_cast<std::ptrdiff_t>(at);
    const double middle = 0.5 * (closed.wanted[at - 1] + closed.wanted[at]);
    const NurbsCurve line = isocurve(loft, Axis::u, middle);
    closed.wanted.insert(closed.wanted.begin() + place, middle);
    others.curves.insert(others.curves.begin() + place, line);
  }
}

/// Of a patch of polynomials, whose weights are 1 but for rounding.
NurbsPatch with_weights_one(const NurbsPatch& patch) {
  std::vector<glm::dvec4> points(patch.points().begin(), patch.points().end());
  for (glm::dvec4& p : points) p.w = 1.0;
  return patch.with_points(std::move(points));
}

/// Places that lie closer towards the ends of every span of a curve and of a line of the patch, and of what paces it.
std::vector<double> span_places(const NurbsCurve& curve, const NurbsCurve& line, std::span<const double> crossings) {
  constexpr int kInSpan = 12;
  const Interval domain = curve.domain();
  std::vector<double> ends{domain.start, domain.end};
  const auto add = [&](std::span<const double> some) {
    for (const double at : some) {
      if (at > domain.start && at < domain.end) ends.push_back(at);
    }
  };
  add(curve.knot_vector().knots());
  add(line.knot_vector().knots());
  add(crossings);
  return places_of_spans(std::move(ends), kInSpan);
}

/// Distances of curve i of a family from a line of the patch; 0 where a point of either lies at infinity.
std::vector<double> distances_at(const PacedFamily& family, std::size_t i, const NurbsCurve& line, const std::vector<double>& at) {
  const std::vector<glm::dvec3> wanted = given_points(family, i, at);
  std::vector<glm::dvec3> found(at.size());
  evaluate(line, at, {&found.front().x, 3 * found.size()}, {.side = Side::left, .at_infinity = AtInfinity::nan});
  std::vector<double> distances;
  for (std::size_t k = 0; k < at.size(); ++k) {
    distances.push_back(is_finite(wanted[k]) && is_finite(found[k]) ? distance_of(wanted[k], found[k]) : 0.0);
  }
  return distances;
}

/// How far a curve of the family that is missed most is off, which one that is, and where along it.
struct FarthestOff {
  double distance = 0.0;
  bool is_u = false;
  std::size_t curve = 0;
  double share = 0.0;
};

/// The largest distance of curves from the lines of the patch on which they are to lie, looked for closer about where it is.
FarthestOff farthest_off(const NurbsPatch& patch, const PacedFamily& family, std::span<const double> others, Axis axis) {
  constexpr int kParts = 24;
  FarthestOff found;
  for (std::size_t i = 0; i < family.curves.size(); ++i) {
    const NurbsCurve line = isocurve(patch, axis, others[i]);
    const std::vector<double> places = span_places(family.curves[i], line, family.wanted);
    breathe(places.size());
    const std::vector<double> distances = distances_at(family, i, line, places);
    const auto at = static_cast<std::size_t>(std::ranges::max_element(distances) - distances.begin());
    const double from = places[at > 0 ? at - 1 : 0];
    const double to = places[std::min(at + 1, places.size() - 1)];
    std::vector<double> closer;
    for (int k = 1; k < kParts; ++k) closer.push_back(from + (to - from) * k / kParts);
    const double distance = std::max(distances[at], std::ranges::max(distances_at(family, i, line, closer)));
    if (!(distance > found.distance)) continue;
    const Interval domain = family.curves[i].domain();
    found = {distance, axis == Axis::v, i, (places[at] - domain.start) / domain.length()};
  }
  return found;
}

std::vector<glm::dvec4> points_of(std::span<const NurbsCurve> a, std::span<const NurbsCurve> b) {
  std::vector<glm::dvec4> all;
  for (const auto& curves : {a, b}) {
    for (const NurbsCurve& curve : curves) all.insert(all.end(), curve.points().begin(), curve.points().end());
  }
  return all;
}

bool is_rational(const PacedFamily& family) { return std::ranges::any_of(family.curves, &NurbsCurve::rational); }

/// Lets curves meet at the same parameters with the same weights, as polynomials where that is so wanted or the only way:
/// then so near that directions hardly change.
void let_meet(GordonNet& net, bool as_polynomials, double tolerance) {
  const double within = as_polynomials ? 0x1p-9 * tolerance : 0.5 * tolerance;
  const bool are_there = net.u.is_there() && net.v.is_there();
  const bool are_rational = is_rational(net.u) || is_rational(net.v);
  if (are_there && !are_rational) return;
  if (are_there && !as_polynomials && reconcile_weights(net.u, net.v)) return;
  if (are_rational && !as_polynomials && let_meet_with_weights(net.u, net.v, within)) return;
  for (PacedFamily* family : {&net.u, &net.v}) repace(*family, within);
}

void require_neighbors(std::span<const LoftNeighbor> neighbors) {
  for (std::size_t i = 0; i < neighbors.size(); ++i) {
    if (neighbors[i].continuity == 1) continue;
    throw InvalidShape("neighbors" + index_text(i) + " has continuity " + std::to_string(neighbors[i].continuity) +
                       ": a network continues with tangent planes, 1");
  }
}

/// What curves are to keep to, in their space, and how long 1 is outside.
struct NetworkTask {
  const NetworkCurves& curves;
  const std::vector<LoftNeighbor>& beyond;
  double fit;     ///< how near curves are run through that do not meet the others as they are
  double within;  ///< how far the surface may lie from them
  double unit;
};

struct BorderedPatch {
  NurbsPatch patch;
  NetworkBorders borders;
};

struct FoundSurface {
  GordonNet net;
  BorderedPatch made;
  FarthestOff off;
};

BorderedPatch patch_of(GordonNet whole, const NetworkTask& task) {
  add_others_to_closed(whole.u, whole.v);
  add_others_to_closed(whole.v, whole.u);
  whole.borders = network_borders(whole.u, whole.v, task.beyond, task.within, task.unit);
  make_compatible(whole.u, whole.borders.along_u);
  make_compatible(whole.v, whole.borders.along_v);
  NurbsPatch patch = summed(whole);
  return {std::move(patch), std::move(whole.borders)};
}

bool are_positive(const PacedFamily& family) {
  return std::ranges::all_of(family.own, [](const NurbsCurve& curve) { return have_positive_weights(curve.points()); });
}

/// @param fit  how near curves are run through that do not meet the others as they are
FoundSurface found_surface(const NetworkTask& task, double fit) {
  const NetworkFamily& u = task.curves.u;
  const NetworkFamily& v = task.curves.v;
  GordonNet net{paced(u, !v.is_closed), paced(v, !u.is_closed), {}};
  let_meet(net, !task.beyond.empty(), fit);
  BorderedPatch made = patch_of(net, task);
  NurbsPatch& patch = made.patch;
  if (!have_positive_weights(patch.points()) && are_positive(net.u) && are_positive(net.v)) {
    for (PacedFamily* family : {&net.u, &net.v}) repace(*family, 0.5 * fit);
    made = patch_of(net, task);
  }
  if (!is_rational(net.u) && !is_rational(net.v)) patch = with_weights_one(patch);
  const auto off_of = [&](const NurbsPatch& one) {
    const FarthestOff of_u = farthest_off(one, net.u, net.v.wanted, Axis::v);
    const FarthestOff of_v = farthest_off(one, net.v, net.u.wanted, Axis::u);
    return of_u.distance >= of_v.distance ? of_u : of_v;
  };
  FarthestOff off = off_of(patch);
  if (off.distance <= task.within) {
    patch = with_outermost(patch, net.u, net.v);
    off = off_of(patch);
  }
  return {std::move(net), std::move(made), off};
}

/// Of the neighbor from which a curve is to go on there; none where there is none.
std::string neighbor_left(const NetworkBorders& borders, const FarthestOff& off) {
  const std::array<std::string, 2>& crossed = off.is_u ? borders.names_v : borders.names_u;
  const std::array<std::string, 2>& beside = off.is_u ? borders.names_u : borders.names_v;
  const std::size_t nearer = off.share < 0.5 ? 0 : 1;
  for (const std::string& name : {crossed[nearer], crossed[1 - nearer], beside[0], beside[1]}) {
    if (!name.empty()) return name;
  }
  return {};
}

std::string reason_of(const NetworkTask& task, const FoundSurface& found) {
  const NetworkFamily& family = found.off.is_u ? task.curves.u : task.curves.v;
  const std::string curve = (found.off.is_u ? "along_u" : "along_v") + index_text(family.order[found.off.curve]);
  const std::string left = neighbor_left(found.made.borders, found.off);
  if (!left.empty()) {
    return curve + " is missed: it does not leave " + left + " in its tangent plane, or lies too near others for that";
  }
  return curve +
         " is missed: curves that lie near each other do not meet those that cross them alike, so that no surface has them all";
}

/// Where curves pass one another the sum runs between them, and swings by more where they lie unevenly.
constexpr double kMissed = 8.0;

/// Fits that the sum makes worse are made closer.
FoundSurface surface_within(const NetworkTask& task) {
  constexpr double kCloser = 0x1p-4;
  FoundSurface found = found_surface(task, task.fit);
  const auto are_given = [](const PacedFamily& family) { return family.is_there() && !is_rational(family); };
  const bool is_fitted = !are_given(found.net.u) || !are_given(found.net.v);
  if (found.off.distance > task.within && is_fitted) found = found_surface(task, kCloser * task.fit);
  if (found.off.distance <= task.within) return found;
  throw ToleranceNotReached(reason_of(task, found), task.within, found.off.distance);
}

}  // namespace

NetworkSurface network(std::span<const NurbsCurve> along_u, std::span<const NurbsCurve> along_v,
                                  std::optional<double> tolerance, std::span<const LoftNeighbor> neighbors,
                       std::optional<double> gap) {
  if (tolerance) require_positive(*tolerance);
  if (gap) require_positive(*gap, "gap");
  require_neighbors(neighbors);
  const std::vector<glm::dvec4> all = points_of(along_u, along_v);
  const NearSpace space(all);
  const auto entered = [&](std::span<const NurbsCurve> curves) {
    std::vector<NurbsCurve> near;
    for (const NurbsCurve& curve : curves) near.push_back(curve.with_points(space.enter(curve.points())));
    return near;
  };
  std::vector<LoftNeighbor> beyond(neighbors.begin(), neighbors.end());
  for (LoftNeighbor& one : beyond) one.patch = one.patch.with_points(space.enter(one.patch.points()));
  const double unit = space.length(1.0);
  const double fit = tolerance ? *tolerance / unit : 0x1p-20;
  const NetworkCurves curves = network_curves(entered(along_u), entered(along_v), gap ? *gap / unit : fit, unit);
  const double within = gap ? fit + kMissed * curves.missed : fit;
  const FoundSurface found = said_outside(space, [&] { return surface_within({curves, beyond, fit, within, unit}); });
  std::array<std::optional<double>, 4> paces = distances_of_paces(found.made.patch, found.net.u, found.net.v);
  for (auto& distance : paces) {
    if (distance) distance = space.length(*distance);
  }
  const NurbsPatch begun = begun_as_given(found.made.patch, curves);
  return {begun.with_points(space.leave(begun.points())), space.length(found.off.distance), paces};
}

}  // namespace splinecore
