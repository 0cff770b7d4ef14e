#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <utility>
#include <vector>

#include "splinecore/patch/bezier_patch.hpp"

namespace splinecore {

/// A Bezier piece of a patch over [0, 1]²: homogeneous points, row after row, rows along u.
struct Net {
  int rows = 0;
  int columns = 0;
  std::vector<glm::dvec4> points;

  const glm::dvec4& at(int i, int j) const { return points[static_cast<std::size_t>(i) * columns + j]; }
  glm::dvec4& at(int i, int j) { return points[static_cast<std::size_t>(i) * columns + j]; }
};

Net net_of(const BezierPatch& patch);

/// Both halves of a piece, by de Casteljau at the middle of one direction.
std::pair<Net, Net> halved(const Net& net, Axis axis);

/// Bounds of |S_uu|, |S_uv| and |S_vv| over a piece; infinite where a weight is not above 0.
struct Bends {
  double uu = 0.0;
  double uv = 0.0;
  double vv = 0.0;

  /// How far a point of the piece may lie from the point with its parameters on any triangle in them whose corners
  /// are points of the piece (Filip, Magedson, Markot 1986, for triangles that lie in any way: by the variance of
  /// their corners).
  double distance() const noexcept { return (uu + 2.0 * uv + vv) / 8.0; }
};

Bends bends(const Net& net);

/// bends() of the heights of a piece over a plane with this unit normal.
Bends bends_along(const Net& net, const glm::dvec3& normal);

/// How far a side of a piece may lie from its chord; the sides are u = 0, u = 1, v = 0, v = 1.
double side_distance(const Net& net, int side);

/// Values and slopes of the Bernstein polynomials at one place.
struct BernsteinRow {
  BernsteinRow(int degree, double t);
  std::vector<double> values;
  std::vector<double> slopes;
};

/// Largest angles between unit normals, along each direction and of all.
struct Turns {
  double u = 0.0;
  double v = 0.0;
  double all = 0.0;
};

/// A piece at 3 x 3 places: 0, 1/2 and 1 of each direction, u first. Where a normal vanishes that of a place beside it
/// stands for it, or (0, 0, 0).
struct Look {
  std::array<glm::dvec3, 9> points;
  std::array<glm::dvec3, 9> normals;

  Turns turns() const;
  /// The shorter and the longer of the two sides along a direction, by way of their middles.
  std::pair<double, double> lengths(Axis axis) const;
  /// How far the middle of a line along a direction lies from that of its chord, at most.
  double sagitta(Axis axis) const;

 private:
  const glm::dvec3& point(Axis axis, int line, int k) const {
    return points[axis == Axis::u ? 3 * k + line : 3 * line + k];
  }
};

/// Looks at pieces of one bidegree.
class Probe {
 public:
  Probe(int degree_u, int degree_v);
  Look look(const Net& net) const;

 private:
  std::array<BernsteinRow, 3> u_;
  std::array<BernsteinRow, 3> v_;
};

}  // namespace splinecore
