#include "network_borders.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <string>
#include <utility>
#include <vector>

#include "base/length.hpp"
#include "fit/row_spline.hpp"
#include "fitted_together.hpp"
#include "greville.hpp"
#include "side_first.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/fit/project.hpp"
#include "splinecore/meet/nearest.hpp"
#include "splinecore/patch/ends.hpp"
#include "tangent_field.hpp"

namespace splinecore {

namespace {

/// What tangent planes may be off those of neighbors, in radians.
constexpr double kAngle = 1e-4;
/// Of that for each field: what it is off where curves cross the network takes away, and so adds to between them.
constexpr double kShare = 1.0 / 3.0;
constexpr int kCubic = 3;

using FieldPair = std::array<std::optional<TangentField>, 2>;

/// How far a curve lies from a side of a patch, at places along it.
double distance_between(const NurbsCurve& curve, const NurbsCurve& side) {
  constexpr int kPlaces = 33;
  const Interval domain = curve.domain();
  std::vector<double> at;
  for (int k = 0; k + 1 < kPlaces; ++k) at.push_back(domain.start + domain.length() * k / (kPlaces - 1));
  at.push_back(domain.end);
  std::vector<glm::dvec3> points(kPlaces);
  evaluate(curve, at, {&points.front().x, 3 * points.size()});
  std::vector<NearestOnCurve> found(kPlaces);
  nearest(side, points, found);
  return std::ranges::max_element(found, {}, &NearestOnCurve::distance)->distance;
}

/// Derivatives of the other family where it crosses a border, into the network.
std::vector<glm::dvec3> derivatives_across(const PacedFamily& others, std::size_t border) {
  std::vector<glm::dvec3> found;
  for (const NurbsCurve& curve : others.curves) {
    const Interval domain = curve.domain();
    const double at[] = {border == 0 ? domain.start : domain.end};
    glm::dvec3 jet[2];
    derivatives(curve, at, 1, std::span(&jet[0].x, 6), {.side = border == 0 ? Side::right : Side::left});
    found.push_back(border == 0 ? jet[1] : -jet[1]);
  }
  return found;
}

/// A family and, for the borders along it, the neighbors that lie there.
struct Edges {
  const PacedFamily& family;
  const PacedFamily& others;
  const char* others_name;
  FieldPair fields{};

  bool is_open() const { return !others.is_closed; }
  const NurbsCurve& border(std::size_t i) const { return i == 0 ? family.curves.front() : family.curves.back(); }
};

/// Gives a neighbor to the border that it lies along.
void place(const LoftNeighbor& neighbor, const std::string& name, std::array<Edges*, 2> all, double tolerance,
           double unit) {
  const NurbsPatch beyond = clamped(with_side_first(neighbor.patch, neighbor.side), Axis::v);
  const NurbsCurve side = boundary(beyond, Border::v_start);
  Edges* nearest_edges = nullptr;
  std::size_t nearest_border = 0;
  double least = 0.0;
  for (Edges* edges : all) {
    for (std::size_t i = 0; i < 2 && edges->is_open(); ++i) {
      const double distance = distance_between(edges->border(i), side);
      if (nearest_edges && distance >= least) continue;
      nearest_edges = edges;
      nearest_border = i;
      least = distance;
    }
  }
  if (!nearest_edges || least > tolerance) {
    const std::string far = ": the nearest one comes to within " + text_of(unit * least) + ", the tolerance is " +
                            text_of(unit * tolerance);
    throw InvalidShape(name + " lies along none of the outermost curves" + (nearest_edges ? far : ""));
  }
  std::optional<TangentField>& field = nearest_edges->fields[nearest_border];
  if (field) throw InvalidShape(name + " lies along a curve that has a neighbor already");
  field.emplace(nearest_edges->border(nearest_border), beyond, nearest_edges->family.wanted,
                derivatives_across(nearest_edges->others, nearest_border), name, nearest_edges->others_name);
}

/// The derivative of a field at an end of its border, by differences of the fourth order.
glm::dvec3 slope_of(const TangentField& field, bool is_end) {
  constexpr double kStep = 0x1p-10;
  constexpr std::array kWeights{-25.0 / 12.0, 4.0, -3.0, 4.0 / 3.0, -0.25};
  const Interval domain = field.border().domain();
  const double step = (is_end ? -kStep : kStep) * domain.length();
  std::vector<double> at;
  for (int k = 0; k < 5; ++k) at.push_back((is_end ? domain.end : domain.start) + k * step);
  const std::vector<glm::dvec3> vectors = field.vectors(at);
  glm::dvec3 sum(0.0);
  for (std::size_t k = 0; k < 5; ++k) sum += kWeights[k] / step * vectors[k];
  return sum;
}

/// The cubic on these knots through a field, which has these slopes at its ends.
NurbsCurve through(const TangentField& field, const std::array<glm::dvec3, 2>& slopes, const KnotVector& knots) {
  std::vector<double> at = greville_places(knots);
  at.erase(at.end() - 2);
  at.erase(at.begin() + 1);
  const auto numbers = [](const glm::dvec3& p) { return std::vector{p.x, p.y, p.z}; };
  RowConditions given{at, {}, {numbers(slopes[0])}, {numbers(slopes[1])}};
  for (const glm::dvec3& vector : field.vectors(at)) given.rows.push_back(numbers(vector));
  const RowSpline spline =
      spline_through(given, knots.degree(), Closing::open, {knots.knots().begin(), knots.knots().end()});
  std::vector<glm::dvec4> points;
  for (std::size_t i = 0; i < spline.controls.size(); i += 3) {
    points.emplace_back(spline.controls[i], spline.controls[i + 1], spline.controls[i + 2], 1.0);
  }
  return NurbsCurve::make(spline.knots, std::move(points));
}

/// The most that a curve is off a field by its part away from the border, at places inside its spans: no less than the angle
/// between the tangent planes.
double angle_from(const TangentField& field, const NurbsCurve& curve) {
  constexpr int kPlaces = 5;
  std::vector<double> at;
  const KnotVector& knots = curve.knot_vector();
  for (int i = 0; i < static_cast<int>(knots.spans().size()); ++i) {
    const Interval span = knots.span_interval(i);
    for (int k = 0; k < kPlaces; ++k) at.push_back(span.start + span.length() * (k + 0.5) / kPlaces);
  }
  std::vector<glm::dvec3> found(at.size());
  evaluate(curve, at, {&found.front().x, 3 * at.size()});
  const std::vector<glm::dvec3> wanted = field.vectors(at);
  const std::vector<PlaneFrame> frames = field.frames(at);
  double largest = 0.0;
  for (std::size_t k = 0; k < at.size(); ++k) {
    const double away = std::abs(glm::dot(wanted[k], frames[k].out));
    largest = std::max(largest, length_of(wanted[k] - found[k]) / away);
  }
  return largest;
}

using EndSlopes = std::array<std::array<glm::dvec3, 2>, 2>;  ///< [border][end]

EndSlopes slopes_of(const FieldPair& fields) {
  EndSlopes slopes{};
  for (std::size_t i = 0; i < 2; ++i) {
    if (!fields[i] || fields[i]->border().periodic()) continue;
    for (std::size_t end = 0; end < 2; ++end) slopes[i][end] = slope_of(*fields[i], end == 1);
  }
  return slopes;
}

/// Errors of fits along neighbors are angles, which have no unit of length.
/// @param hardest  the name of the neighbor that is farthest off
template <class Fit, class Name>
auto along_neighbors(const Fit& fit, const Name& hardest) {
  try {
    return fit();
  } catch (const ToleranceNotReached& error) {
    throw InvalidShape("tangent planes of " + hardest() + " turn so sharply along its side that the surface would be off them by " +
                       text_of(error.error()) + " radians: a smoother edge, or no neighbor there, can be had");
  }
}

/// Cubics near the fields of a family, both on the same knots, as derivatives by the other parameter.
std::array<std::optional<NurbsCurve>, 2> fitted(const FieldPair& fields, const EndSlopes& slopes) {
  std::array<std::optional<NurbsCurve>, 2> made;
  std::vector<std::size_t> which;
  std::vector<NurbsCurve> borders;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!fields[i]) continue;
    which.push_back(i);
    borders.push_back(fields[i]->border());
  }
  if (which.empty()) return made;
  const FitTogether what{which.size(), kCubic,           borders[0].domain(), borders[0].periodic(),
                         corners_of(borders), kShare * kAngle};
  std::vector<double> errors(which.size(), 0.0);
  const auto fit = [&](std::size_t i, const KnotVector& knots) -> Approximation<NurbsCurve> {
    const TangentField& field = *fields[which[i]];
    const auto vectors_at = [&](std::span<const double> at, std::span<glm::dvec3> vectors) {
      std::ranges::copy(field.vectors(at), vectors.begin());
    };
    NurbsCurve curve = knots.periodic() ? project(vectors_at, knots).value : through(field, slopes[which[i]], knots);
    errors[i] = angle_from(field, curve);
    return {std::move(curve), errors[i]};
  };
  const std::vector<NurbsCurve> curves = along_neighbors(
      [&] { return fitted_together(what, fit).value; },
      [&] {
        const auto worst = static_cast<std::size_t>(std::ranges::max_element(errors) - errors.begin());
        return fields[which[worst]]->name();
      });
  for (std::size_t i = 0; i < which.size(); ++i) {
    std::vector<glm::dvec4> vectors(curves[i].points().begin(), curves[i].points().end());
    for (glm::dvec4& p : vectors) p = glm::dvec4(which[i] == 1 ? -glm::dvec3(p) : glm::dvec3(p), 1.0);
    made[which[i]] = curves[i].with_points(std::move(vectors));
  }
  return made;
}

glm::dvec2 parts_in(const PlaneFrame& plane, const glm::dvec3& vector) {
  return {glm::dot(vector, plane.out), glm::dot(vector, plane.along)};
}

}  // namespace

NetworkBorders network_borders(const PacedFamily& u, const PacedFamily& v, std::span<const LoftNeighbor> neighbors,
                               double tolerance, double unit) {
  Edges along_u{u, v, "along_v"};
  Edges along_v{v, u, "along_u"};
  for (std::size_t i = 0; i < neighbors.size(); ++i) {
    place(neighbors[i], "neighbors" + index_text(i), {&along_u, &along_v}, tolerance, unit);
  }
  const auto in_corners = [&](auto&& act) {
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t j = 0; j < 2; ++j) {
        if (along_u.fields[j] && along_v.fields[i]) act(i, j);
      }
    }
  };
  const auto sign_at = [](std::size_t end) { return end == 1 ? -1.0 : 1.0; };
  const auto place_at = [](const Interval& domain, std::size_t end) { return end == 1 ? domain.end : domain.start; };
  in_corners([&](std::size_t i, std::size_t j) {  // slopes that are set stay when others are
    along_u.fields[j]->bend(i == 1, glm::dvec2(0.0));
    along_v.fields[i]->bend(j == 1, glm::dvec2(0.0));
  });
  EndSlopes slopes_u = slopes_of(along_u.fields);
  EndSlopes slopes_v = slopes_of(along_v.fields);
  in_corners([&](std::size_t i, std::size_t j) {
    TangentField& of_u = *along_u.fields[j];
    TangentField& of_v = *along_v.fields[i];
    const glm::dvec3 apart = sign_at(i) * slopes_v[i][j] - sign_at(j) * slopes_u[j][i];
    const PlaneFrame plane_u = of_u.frame(place_at(u.curves[0].domain(), i));
    const PlaneFrame plane_v = of_v.frame(place_at(v.curves[0].domain(), j));
    of_u.bend(i == 1, 0.5 * sign_at(j) * parts_in(plane_u, apart));
    of_v.bend(j == 1, -0.5 * sign_at(i) * parts_in(plane_v, apart));
  });
  slopes_u = slopes_of(along_u.fields);
  slopes_v = slopes_of(along_v.fields);
  NetworkBorders made;
  in_corners([&](std::size_t i, std::size_t j) {
    made.twists[i][j] = 0.5 * (sign_at(i) * slopes_v[i][j] + sign_at(j) * slopes_u[j][i]);
    slopes_v[i][j] = sign_at(i) * made.twists[i][j];
    slopes_u[j][i] = sign_at(j) * made.twists[i][j];
  });
  for (std::size_t i = 0; i < 2; ++i) {
    if (along_u.fields[i]) made.names_u[i] = along_u.fields[i]->name();
    if (along_v.fields[i]) made.names_v[i] = along_v.fields[i]->name();
  }
  made.along_u = fitted(along_u.fields, slopes_u);
  made.along_v = fitted(along_v.fields, slopes_v);
  return made;
}

}  // namespace splinecore
