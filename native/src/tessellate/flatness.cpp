#include "splinecore/tessellate/flatness.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "splinecore/base/quotient.hpp"
#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

Net net_of(const BezierPatch& patch) {
  const NurbsPatch& form = patch.nurbs();
  return {patch.count(Axis::u), patch.count(Axis::v),
          {form.homogeneous_points().begin(), form.homogeneous_points().end()}};
}

std::pair<Net, Net> halved(const Net& net, Axis axis) {
  const int count = axis == Axis::u ? net.rows : net.columns;
  const int lines = axis == Axis::u ? net.columns : net.rows;
  Net before = net;
  Net after = net;
  for (int line = 0; line < lines; ++line) {
    const auto place = [&](Net& in, int k) -> glm::dvec4& { return axis == Axis::u ? in.at(k, line) : in.at(line, k); };
    for (int level = 1; level < count; ++level) {
      for (int k = count - 1; k >= level; --k) {
        place(before, k) = 0.5 * (place(before, k - 1) + place(before, k));
      }
      place(after, count - 1 - level) = place(before, count - 1);
    }
  }
  // `before` ends as its own diagonal: row k holds the first point of level k.
  return {std::move(before), std::move(after)};
}

namespace {

/// Largest length of x, y, z and largest |w| over differences of the net, each times a factor.
struct Largest {
  double point = 0.0;
  double weight = 0.0;

  void take(const glm::dvec4& p) {
    point = std::max(point, glm::length(glm::dvec3(p)));
    weight = std::max(weight, std::abs(p.w));
  }
  Largest times(double factor) const { return {factor * point, factor * weight}; }
};

struct Differences {
  Largest u, v, uu, uv, vv;
};

Differences differences(const Net& net) {
  Differences found;
  for (int i = 0; i < net.rows; ++i) {
    for (int j = 0; j < net.columns; ++j) {
      const glm::dvec4& p = net.at(i, j);
      const bool in_u = i + 1 < net.rows;
      const bool in_v = j + 1 < net.columns;
      if (in_u) found.u.take(net.at(i + 1, j) - p);
      if (in_v) found.v.take(net.at(i, j + 1) - p);
      if (in_u && in_v) found.uv.take(net.at(i + 1, j + 1) - net.at(i + 1, j) - net.at(i, j + 1) + p);
      if (i + 2 < net.rows) found.uu.take(net.at(i + 2, j) - 2.0 * net.at(i + 1, j) + p);
      if (j + 2 < net.columns) found.vv.take(net.at(i, j + 2) - 2.0 * net.at(i, j + 1) + p);
    }
  }
  const double p = net.rows - 1;
  const double q = net.columns - 1;
  return {found.u.times(p), found.v.times(q), found.uu.times(p * (p - 1)), found.uv.times(p * q),
          found.vv.times(q * (q - 1))};
}

/// The net seen from one of its points, so that sizes are those of the piece.
Net centred(Net net) {
  const glm::dvec3 centre = project(net.at(net.rows / 2, net.columns / 2));
  for (glm::dvec4& p : net.points) p = glm::dvec4(glm::dvec3(p) - p.w * centre, p.w);
  return net;
}

}  // namespace

Bends bends(const Net& net) {
  const double least = std::ranges::min(net.points, {}, &glm::dvec4::w).w;
  if (!(least > 0.0)) return {HUGE_VAL, HUGE_VAL, HUGE_VAL};
  const Net seen = centred(net);
  double reach = 0.0;
  for (const glm::dvec4& p : seen.points) reach = std::max(reach, glm::length(glm::dvec3(p)) / p.w);
  const Differences d = differences(seen);
  // The quotient rule, term by term: S_uu = (A_uu - 2 W_u S_u - W_uu S) / W.
  const double su = (d.u.point + d.u.weight * reach) / least;
  const double sv = (d.v.point + d.v.weight * reach) / least;
  return {(d.uu.point + 2.0 * d.u.weight * su + d.uu.weight * reach) / least,
          (d.uv.point + d.u.weight * sv + d.v.weight * su + d.uv.weight * reach) / least,
          (d.vv.point + 2.0 * d.v.weight * sv + d.vv.weight * reach) / least};
}

Bends bends_along(const Net& net, const glm::dvec3& normal) {
  Net heights = centred(net);
  for (glm::dvec4& p : heights.points) p = glm::dvec4(glm::dot(normal, glm::dvec3(p)), 0.0, 0.0, p.w);
  return bends(heights);
}

double side_distance(const Net& net, int side) {
  Net line;
  line.rows = side < 2 ? 1 : net.rows;
  line.columns = side < 2 ? net.columns : 1;
  const int at = side % 2 == 0 ? 0 : (side < 2 ? net.rows : net.columns) - 1;
  for (int k = 0; k < line.rows * line.columns; ++k) line.points.push_back(side < 2 ? net.at(at, k) : net.at(k, at));
  return bends(line).distance();
}

namespace {

/// The sum of the net with these factors along u and v.
glm::dvec4 blended(const Net& net, std::span<const double> along_u, std::span<const double> along_v) {
  glm::dvec4 sum(0.0);
  for (int i = 0; i < net.rows; ++i) {
    glm::dvec4 row(0.0);
    for (int j = 0; j < net.columns; ++j) row += along_v[j] * net.at(i, j);
    sum += along_u[i] * row;
  }
  return sum;
}

/// Largest coordinate times the weight: what rounding is relative to.
double magnitude(const Net& net) {
  double found = 0.0;
  for (const glm::dvec4& p : net.points) found = std::max(found, glm::length(glm::dvec3(p)));
  return found;
}

/// The unit normal, or (0, 0, 0) where a derivative is no more than rounding.
glm::dvec3 normal_at(const Net& net, const BernsteinRow& u, const BernsteinRow& v, double magnitude) {
  const glm::dvec4 h = blended(net, u.values, v.values);
  const glm::dvec4 hu = blended(net, u.slopes, v.values);
  const glm::dvec4 hv = blended(net, u.values, v.slopes);
  const glm::dvec3 su = glm::dvec3(hu) - hu.w / h.w * glm::dvec3(h);
  const glm::dvec3 sv = glm::dvec3(hv) - hv.w / h.w * glm::dvec3(h);
  const glm::dvec3 normal = glm::cross(su, sv);
  const double length = glm::length(normal);
  constexpr double kNothing = 0x1p-40;
  const double least = kNothing * magnitude;
  const bool is_noise = !(glm::length(su) > least) || !(glm::length(sv) > least) ||
                        !(length > kNothing * glm::length(su) * glm::length(sv));
  return is_noise ? glm::dvec3(0.0) : normal / length;
}

/// The normal a little inside, for places where it vanishes, as at a pole.
glm::dvec3 normal_near(const Net& net, double s, double t, double magnitude) {
  constexpr double kInside = 0x1p-10;
  const auto inside = [&](double place) { return std::clamp(place, kInside, 1.0 - kInside); };
  return normal_at(net, BernsteinRow(net.rows - 1, inside(s)), BernsteinRow(net.columns - 1, inside(t)), magnitude);
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  if (a == glm::dvec3(0.0) || b == glm::dvec3(0.0)) return 0.0;
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

std::array<BernsteinRow, 3> rows_of(int degree) {
  return {BernsteinRow(degree, 0.0), BernsteinRow(degree, 0.5), BernsteinRow(degree, 1.0)};
}

}  // namespace

BernsteinRow::BernsteinRow(int degree, double t) : values(degree + 1), slopes(degree + 1, 0.0) {
  bernstein(degree, t, 1.0 - t, values);
  std::vector<double> lower(degree);
  bernstein(degree - 1, t, 1.0 - t, lower);
  for (int i = 0; i < degree; ++i) {
    slopes[i] -= degree * lower[i];
    slopes[i + 1] += degree * lower[i];
  }
}

Turns Look::turns() const {
  Turns found;
  for (int i = 0; i < 9; ++i) {
    for (int j = 0; j < i; ++j) {
      const double angle = angle_between(normals[i], normals[j]);
      found.all = std::max(found.all, angle);
      if (i % 3 == j % 3) found.u = std::max(found.u, angle);
      if (i / 3 == j / 3) found.v = std::max(found.v, angle);
    }
  }
  return found;
}

std::pair<double, double> Look::lengths(Axis axis) const {
  const auto along = [&](int line) {
    const glm::dvec3& middle = point(axis, line, 1);
    return glm::length(middle - point(axis, line, 0)) + glm::length(point(axis, line, 2) - middle);
  };
  return std::minmax(along(0), along(2));
}

double Look::sagitta(Axis axis) const {
  double found = 0.0;
  for (int line = 0; line < 3; ++line) {
    found = std::max(found, glm::length(point(axis, line, 1) - 0.5 * (point(axis, line, 0) + point(axis, line, 2))));
  }
  return found;
}

Probe::Probe(int degree_u, int degree_v) : u_(rows_of(degree_u)), v_(rows_of(degree_v)) {}

Look Probe::look(const Net& net) const {
  const double size = magnitude(net);
  Look found;
  for (int k = 0; k < 9; ++k) {
    const BernsteinRow& u = u_[k / 3];
    const BernsteinRow& v = v_[k % 3];
    found.points[k] = project(blended(net, u.values, v.values));
    found.normals[k] = normal_at(net, u, v, size);
    if (found.normals[k] == glm::dvec3(0.0)) found.normals[k] = normal_near(net, 0.5 * (k / 3), 0.5 * (k % 3), size);
  }
  return found;
}

}  // namespace splinecore
