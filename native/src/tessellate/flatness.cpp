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

std::vector<double> values(int degree, double t) {
  std::vector<double> found(degree + 1);
  bernstein(degree, t, 1.0 - t, found);
  return found;
}

std::vector<double> slopes(int degree, double t) {
  const std::vector<double> lower = values(degree - 1, t);
  std::vector<double> found(degree + 1, 0.0);
  for (int i = 0; i < degree; ++i) {
    found[i] -= degree * lower[i];
    found[i + 1] += degree * lower[i];
  }
  return found;
}

glm::dvec3 normal_at(const Net& net, double s, double t) {
  const auto values_u = values(net.rows - 1, s);
  const auto values_v = values(net.columns - 1, t);
  const glm::dvec4 h = blended(net, values_u, values_v);
  const glm::dvec4 hu = blended(net, slopes(net.rows - 1, s), values_v);
  const glm::dvec4 hv = blended(net, values_u, slopes(net.columns - 1, t));
  const glm::dvec3 su = glm::dvec3(hu) * h.w - hu.w * glm::dvec3(h);
  const glm::dvec3 sv = glm::dvec3(hv) * h.w - hv.w * glm::dvec3(h);
  const glm::dvec3 normal = glm::cross(su, sv);
  const double length = glm::length(normal);
  constexpr double kNothing = 0x1p-40;
  return length > kNothing * glm::length(su) * glm::length(sv) && length > 0.0 ? normal / length : glm::dvec3(0.0);
}

/// The normal there, or where it vanishes, as at a pole, the one a little farther inside.
glm::dvec3 normal_near(const Net& net, double s, double t) {
  constexpr double kInside = 0x1p-10;
  const glm::dvec3 normal = normal_at(net, s, t);
  if (normal != glm::dvec3(0.0)) return normal;
  return normal_at(net, std::clamp(s, kInside, 1.0 - kInside), std::clamp(t, kInside, 1.0 - kInside));
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  if (a == glm::dvec3(0.0) || b == glm::dvec3(0.0)) return 0.0;
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

glm::dvec3 point_at(const Net& net, double s, double t) {
  return project(blended(net, values(net.rows - 1, s), values(net.columns - 1, t)));
}

}  // namespace

Lengths lengths(const Net& net) {
  Lengths found;
  for (const double side : {0.0, 1.0}) {
    const auto along = [&](auto at) { return glm::length(at(0.5) - at(0.0)) + glm::length(at(1.0) - at(0.5)); };
    found.u = std::max(found.u, along([&](double s) { return point_at(net, s, side); }));
    found.v = std::max(found.v, along([&](double t) { return point_at(net, side, t); }));
  }
  return found;
}

Turns turns(const Net& net) {
  std::array<std::array<glm::dvec3, 3>, 3> normals;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) normals[i][j] = normal_near(net, 0.5 * i, 0.5 * j);
  }
  Turns found;
  for (int i = 0; i < 9; ++i) {
    for (int j = 0; j < i; ++j) {
      const double angle = angle_between(normals[i / 3][i % 3], normals[j / 3][j % 3]);
      found.all = std::max(found.all, angle);
      if (i % 3 == j % 3) found.u = std::max(found.u, angle);
      if (i / 3 == j / 3) found.v = std::max(found.v, angle);
    }
  }
  return found;
}

}  // namespace splinecore
