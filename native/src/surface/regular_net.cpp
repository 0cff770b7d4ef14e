#include "regular_net.hpp"

#include <array>
#include <cstddef>

namespace splinecore {

namespace {

/// The 4 x 4 control points of a bicubic span.
class RegularNet {
 public:
  glm::dvec3& at(int i, int j) { return points_[static_cast<std::size_t>(4 * i + j)]; }
  const glm::dvec3& at(int i, int j) const { return points_[static_cast<std::size_t>(4 * i + j)]; }

 private:
  std::array<glm::dvec3, 16> points_{};
};

struct NetPlace {
  int i;
  int j;
};

NetPlace operator+(const NetPlace& a, const NetPlace& b) { return {a.i + b.i, a.j + b.j}; }
NetPlace operator-(const NetPlace& a) { return {-a.i, -a.j}; }

/// Corners of the face, and the way out across the side that begins there.
constexpr std::array<NetPlace, 4> kCorners{{{1, 1}, {2, 1}, {2, 2}, {1, 2}}};
constexpr std::array<NetPlace, 4> kOut{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};

class RegularFace {
 public:
  RegularFace(const ControlMesh& mesh, const MeshTopology& topology, int side) : mesh_(mesh), topology_(topology) {
    for (int k = 0; k < 4; ++k, side = topology.next(side)) sides_[static_cast<std::size_t>(k)] = side;
    for (int k = 0; k < 4; ++k) at(kCorners[static_cast<std::size_t>(k)]) = point(topology.side(side_of(k)).from);
    for (int k = 0; k < 4; ++k) write_across(k);
    for (int k = 0; k < 4; ++k) write_corner(k);
  }

  const RegularNet& net() const { return net_; }

 private:
  glm::dvec3& at(const NetPlace& place) { return net_.at(place.i, place.j); }
  int side_of(int k) const { return sides_[static_cast<std::size_t>(k % 4)]; }
  int twin_of(int k) const { return topology_.side(side_of(k)).twin; }
  const glm::dvec3& point(int i) const { return mesh_.points[static_cast<std::size_t>(i)]; }

  void reflect(const NetPlace& place, const NetPlace& in) { at(place) = 2.0 * at(place + in) - at(place + in + in); }

  /// The two points beyond a side.
  void write_across(int k) {
    const NetPlace out = kOut[static_cast<std::size_t>(k)];
    const NetPlace first = kCorners[static_cast<std::size_t>(k)] + out;
    const NetPlace second = kCorners[static_cast<std::size_t>((k + 1) % 4)] + out;
    const int twin = twin_of(k);
    if (twin < 0) {
      reflect(first, -out);
      reflect(second, -out);
      return;
    }
    at(first) = point(topology_.to(topology_.next(twin)));
    at(second) = point(topology_.side(topology_.before(twin)).from);
  }

  /// The point beyond a corner, across both of its sides.
  void write_corner(int k) {
    const NetPlace out = kOut[static_cast<std::size_t>(k)];
    const NetPlace other = kOut[static_cast<std::size_t>((k + 3) % 4)];
    const NetPlace place = kCorners[static_cast<std::size_t>(k)] + out + other;
    if (twin_of(k) < 0) {
      reflect(place, -out);
    } else if (twin_of(k + 3) < 0) {
      reflect(place, -other);
    } else {
      const int beyond = topology_.side(topology_.next(twin_of(k))).twin;
      at(place) = point(topology_.to(topology_.next(topology_.next(beyond))));
    }
  }

  const ControlMesh& mesh_;
  const MeshTopology& topology_;
  std::array<int, 4> sides_{};
  RegularNet net_;
};

/// Bezier points of a uniform cubic span from its four points.
std::array<glm::dvec3, 4> bezier_points(const std::array<glm::dvec3, 4>& p) {
  const glm::dvec3 before = (p[0] + p[1] * 4.0 + p[2]) / 6.0;
  const glm::dvec3 after = (p[1] + p[2] * 4.0 + p[3]) / 6.0;
  return {before, (2.0 * p[1] + p[2]) / 3.0, (p[1] + 2.0 * p[2]) / 3.0, after};
}

}  // namespace

NurbsPatch regular_patch(const ControlMesh& mesh, const MeshTopology& topology, int side) {
  RegularNet net = RegularFace(mesh, topology, side).net();
  for (int i = 0; i < 4; ++i) {
    const auto line = bezier_points({net.at(i, 0), net.at(i, 1), net.at(i, 2), net.at(i, 3)});
    for (int j = 0; j < 4; ++j) net.at(i, j) = line[static_cast<std::size_t>(j)];
  }
  std::vector<glm::dvec4> points(16);
  for (int j = 0; j < 4; ++j) {
    const auto line = bezier_points({net.at(0, j), net.at(1, j), net.at(2, j), net.at(3, j)});
    for (int i = 0; i < 4; ++i) points[static_cast<std::size_t>(4 * i + j)] = glm::dvec4(line[static_cast<std::size_t>(i)], 1.0);
  }
  return NurbsPatch::make(KnotVector::bezier(3), KnotVector::bezier(3), std::move(points));
}

}  // namespace splinecore
