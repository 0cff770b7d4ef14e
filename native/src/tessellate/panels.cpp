#include "splinecore/tessellate/panels.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>

#include "splinecore/base/points.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/patch/isocurve.hpp"

namespace splinecore {

namespace {

/// The curve of a side over the part of its domain that the panel has.
struct SideCurve {
  std::size_t panel;
  int side;
  NurbsCurve curve;
  Interval range;

  double at(double t, bool reversed) const {
    const double forward = reversed ? 1.0 - t : t;
    return forward == 1.0 ? range.end : range.start + forward * range.length();
  }
  glm::dvec3 point(double t, bool reversed = false) const {
    const double u = at(t, reversed);
    glm::dvec3 found;
    const Side from = u == range.end ? Side::left : Side::right;
    evaluate(curve, {&u, 1}, std::span(&found.x, 3), {from, AtInfinity::nan});
    return found;
  }
};

/// The places where a direction begins, has a gap, or ends.
std::vector<Place> gaps(const KnotVector& knots) {
  const auto count = static_cast<Place>(knots.spans().size());
  std::vector<Place> found{0};
  for (Place i = 1; i < count; ++i) {
    const double u = knots.span_interval(static_cast<int>(i)).start;
    if (multiplicity(knots, u) > knots.degree()) found.push_back(i * kSpan);
  }
  found.push_back(count * kSpan);
  return found;
}

SideCurve side_curve(const PatchSet& set, const Panel& panel, std::size_t number, int side) {
  const NurbsPatch& patch = nurbs_of(set.patch(panel.patch));
  const bool is_u = side < 2;
  const bool is_end = side % 2 == 1;
  const Cell& cell = panel.whole;
  const Axis across = is_u ? Axis::u : Axis::v;
  const KnotVector& along = patch.knot_vector(is_u ? Axis::v : Axis::u);
  const Place line = is_u ? (is_end ? cell.u1 : cell.u0) : (is_end ? cell.v1 : cell.v0);
  const double at = parameter_at(patch.knot_vector(across), line);
  const auto [from, to] = is_u ? std::pair{cell.v0, cell.v1} : std::pair{cell.u0, cell.u1};
  return {number, side, isocurve(patch, across, at, is_end ? Side::left : Side::right),
          {parameter_at(along, from), parameter_at(along, to)}};
}

std::vector<double> scaled_knots(const SideCurve& side, bool reversed) {
  std::vector<double> found{0.0, 1.0};
  for (const double u : side.curve.knot_vector().unrolled()) {
    if (u <= side.range.start || u >= side.range.end) continue;
    const double t = (u - side.range.start) / side.range.length();
    found.push_back(reversed ? 1.0 - t : t);
  }
  return found;
}

bool near(const glm::dvec3& a, const glm::dvec3& b, double tolerance) { return glm::length(a - b) <= tolerance; }

bool is_one_curve(const SideCurve& a, const SideCurve& b, bool reversed, double tolerance) {
  constexpr double kOneKnot = 0x1p-40;
  std::vector<double> knots = scaled_knots(a, false);
  const std::vector<double> others = scaled_knots(b, reversed);
  knots.insert(knots.end(), others.begin(), others.end());
  std::ranges::sort(knots);
  const int count = a.curve.degree() + b.curve.degree() + 1;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const double length = knots[i] - knots[i - 1];
    if (length <= kOneKnot) continue;
    for (int k = 0; k < count; ++k) {
      const double t = knots[i - 1] + length * (k + 0.5) / count;
      if (!near(a.point(t), b.point(t, reversed), tolerance)) return false;
    }
  }
  return near(a.point(0), b.point(0, reversed), tolerance) && near(a.point(1), b.point(1, reversed), tolerance);
}

/// Whether the side is a point: all that it depends on lies in one place.
bool is_point(const SideCurve& side, double tolerance) {
  const auto points = side.curve.points();
  const bool has_directions = std::ranges::any_of(points, [](const glm::dvec4& p) { return p.w == 0.0; });
  return !has_directions && extent(points) <= tolerance;
}

/// Numbers the edges: each side takes the edge of the first side before it that is the same curve.
void match(std::vector<Panel>& panels, std::vector<SideCurve> sides, double tolerance) {
  const auto middle = [](const SideCurve& side) {
    const double x = side.point(0.5).x;
    return std::isnan(x) ? std::numeric_limits<double>::infinity() : x;
  };
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < sides.size(); ++i) order.emplace_back(middle(sides[i]), i);
  std::ranges::sort(order);
  int edges = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const SideCurve& side = sides[order[i].second];
    PanelSide& found = panels[side.panel].sides[side.side];
    for (std::size_t k = i; k-- > 0 && found.edge < 0 && order[i].first - order[k].first <= tolerance;) {
      const SideCurve& other = sides[order[k].second];
      const PanelSide& known = panels[other.panel].sides[other.side];
      for (const bool reversed : {false, true}) {
        if (found.edge < 0 && is_one_curve(other, side, reversed, tolerance)) {
          found = {known.edge, known.reversed != reversed};
        }
      }
    }
    if (found.edge < 0) found = {edges++, false};
  }
}

}  // namespace

std::vector<Panel> panels_of(const PatchSet& set, double tolerance) {
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < set.patches().size(); ++i) {
    const NurbsPatch& patch = nurbs_of(set.patch(i));
    const std::vector<Place> u = gaps(patch.knot_vector(Axis::u));
    const std::vector<Place> v = gaps(patch.knot_vector(Axis::v));
    for (std::size_t j = 1; j < u.size(); ++j) {
      for (std::size_t k = 1; k < v.size(); ++k) panels.push_back({i, {u[j - 1], u[j], v[k - 1], v[k]}, {}});
    }
  }
  std::vector<SideCurve> sides;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    for (int side = 0; side < 4; ++side) {
      SideCurve curve = side_curve(set, panels[i], i, side);
      if (!is_point(curve, tolerance)) sides.push_back(std::move(curve));
    }
  }
  match(panels, std::move(sides), tolerance);
  return panels;
}

}  // namespace splinecore
