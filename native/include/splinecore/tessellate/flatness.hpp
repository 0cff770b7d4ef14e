#pragma once

#include <array>
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

  /// How far the piece may lie from any triangle in its parameters whose corners are points of it
  /// (Filip, Magedson, Markot 1986, for triangles that lie in any way: by the variance of their corners).
  double distance() const noexcept { return (uu + 2.0 * uv + vv) / 8.0; }
};

Bends bends(const Net& net);

/// The longer of a piece's two sides along each direction, from corner to corner by way of the middle.
struct Lengths {
  double u = 0.0;
  double v = 0.0;
};

/// Largest angles between unit normals at 3 x 3 places of a piece, along each direction and of all; where a
/// normal vanishes that of a place beside it counts.
struct Turns {
  double u = 0.0;
  double v = 0.0;
  double all = 0.0;
};

/// Values and slopes of the Bernstein polynomials at one place.
struct BernsteinRow {
  BernsteinRow(int degree, double t);
  std::vector<double> values;
  std::vector<double> slopes;
};

/// Looks at pieces of one bidegree at 0, 1/2 and 1 of each direction.
class Probe {
 public:
  Probe(int degree_u, int degree_v);
  Lengths lengths(const Net& net) const;
  Turns turns(const Net& net) const;

 private:
  std::array<BernsteinRow, 3> u_;
  std::array<BernsteinRow, 3> v_;
};

}  // namespace splinecore
