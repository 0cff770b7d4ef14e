#include "extraordinary_fan.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <numbers>

#include "base/rounding.hpp"
#include "greville.hpp"
#include "regular_net.hpp"
#include "rows_beside.hpp"
#include "splinecore/patch/evaluate.hpp"
#include "star.hpp"
#include "star_claims.hpp"

namespace splinecore {

namespace {

constexpr int kFanDegree = 7;
constexpr int kOrders = 3;

/// Half of a side of a face: a regular face of the finer mesh, u along the side or v.
struct HalfSide {
  NurbsPatch patch;
  Axis along;
};

/// A side of a face of the mesh, in two halves, and derivatives across it.
class OuterSide {
 public:
  OuterSide(HalfSide first, HalfSide second) : halves_{std::move(first), std::move(second)} {}

  /// For orders 0 to 2 of derivatives across, at places from 0 to 1 along the side.
  std::vector<std::vector<glm::dvec3>> across(const std::vector<double>& places) const {
    std::vector<std::vector<glm::dvec3>> found(kOrders);
    for (const double s : places) {
      const bool is_second = s > 0.5;
      const auto values = across_half(halves_[is_second], 2.0 * s - (is_second ? 1.0 : 0.0));
      double scale = 1.0;
      for (std::size_t k = 0; k < kOrders; ++k, scale *= 2.0) found[k].push_back(scale * values[k]);
    }
    return found;
  }

 private:
  static std::array<glm::dvec3, kOrders> across_half(const HalfSide& half, double s) {
    const bool is_along_u = half.along == Axis::u;
    const double u[] = {is_along_u ? s : 0.0};
    const double v[] = {is_along_u ? 0.0 : s};
    std::array<glm::dvec3, kOrders * kOrders> values;
    derivatives(half.patch, u, v, kOrders - 1, std::span(&values.front().x, 3 * values.size()));
    const std::size_t step = is_along_u ? 1 : kOrders;
    return {values[0], values[step], values[2 * step]};
  }

  std::array<HalfSide, 2> halves_;
};

class Fan {
 public:
  Fan(const ControlMesh& mesh, const MeshTopology& topology, const ControlMesh& finer, const MeshTopology& finer_topology, int point)
      : mesh_(mesh), topology_(topology), finer_(finer), finer_topology_(finer_topology), point_(point),
        star_{std::vector(topology.fan(point).size(), KnotPair{knots_, knots_}), topology.is_on_border(point), kOrders} {}

  std::vector<NurbsPatch> patches() const {
    StarClaims claims(star_);
    for (std::size_t k = 0; k < star_.count(); ++k) claim_sides(claims, k);
    if (star_.is_open) claim_borders(claims);
    claims.add(0, kFanDegree, kFanDegree, limit(), 0);
    std::vector<glm::dvec3> points = solved_star(star_, claims.points());
    if (has_normal()) {
      claim_normal(claims, points);
      points = solved_star(star_, claims.points());
    }
    std::vector<NurbsPatch> made;
    for (std::size_t k = 0; k < star_.count(); ++k) {
      std::vector<glm::dvec4> net;
      for (std::size_t i = 0; i <= kFanDegree; ++i) {
        for (std::size_t j = 0; j <= kFanDegree; ++j) net.emplace_back(points[star_.at(k, i, j)], 1.0);
      }
      made.push_back(NurbsPatch::make(knots_, knots_, std::move(net)));
    }
    return made;
  }

 private:
  int spoke(std::size_t k) const { return topology_.fan(point_)[k]; }
  const glm::dvec3& at(int i) const { return mesh_.points[static_cast<std::size_t>(i)]; }

  /// The part of a face at its corner where a side begins, from the `turn`-th of its own corners on.
  HalfSide part(int side, int turn, Axis along) const {
    return {regular_patch(finer_, finer_topology_, finer_topology_.first_side(side) + turn), along};
  }

  void claim_sides(StarClaims& claims, std::size_t k) const {
    const int across = topology_.next(topology_.next(spoke(k)));  // begins at the corner across from the point
    const OuterSide first(part(across, 0, Axis::u), part(topology_.next(across), 3, Axis::u));
    const OuterSide second(part(across, 0, Axis::v), part(topology_.before(across), 1, Axis::v));
    const std::vector<double> places = interpolation_places(knots_);
    const auto along_u = rows_beside(knots_, knots_, first.across(places));
    const auto along_v = rows_beside(knots_, knots_, second.across(places));
    for (std::size_t r = 0; r < kOrders; ++r) {
      for (std::size_t i = 0; i <= kFanDegree; ++i) {
        claims.add(k, i, r, along_u[r][i], static_cast<int>(r));
        claims.add(k, r, i, along_v[r][i], static_cast<int>(r));
      }
    }
  }

  /// The point before one on the border, or behind it; reflected at a corner.
  glm::dvec3 further(int border, bool is_before) const {
    const auto& fan = topology_.fan(border);
    if (fan.size() == 1) return 2.0 * at(border) - at(point_);
    return at(is_before ? topology_.side(topology_.before(fan.back())).from : topology_.to(fan.front()));
  }

  /// The border from a point beside the extraordinary one up to that.
  std::vector<glm::dvec3> border(int beside, int behind, bool is_before) const {
    const std::array<glm::dvec3, 4> p{further(beside, is_before), at(beside), at(point_), at(behind)};
    std::vector<glm::dvec3> points;
    for (const double s : interpolation_places(knots_)) {
      const double t = 1.0 - s;
      points.push_back((t * t * t * p[0] + (3.0 * s * s * s - 6.0 * s * s + 4.0) * p[1] +
                        (3.0 * t * t * t - 6.0 * t * t + 4.0) * p[2] + s * s * s * p[3]) / 6.0);
    }
    return rows_beside(knots_, knots_, {points})[0];
  }

  int first_beside() const { return topology_.to(topology_.fan(point_).front()); }
  int last_beside() const { return topology_.side(topology_.before(topology_.fan(point_).back())).from; }

  void claim_borders(StarClaims& claims) const {
    const auto first = border(first_beside(), last_beside(), false);
    const auto last = border(last_beside(), first_beside(), true);
    for (std::size_t i = 0; i <= kFanDegree; ++i) {
      claims.add(0, i, kFanDegree, first[i], 0);
      claims.add(star_.count() - 1, kFanDegree, i, last[i], 0);
    }
  }

  /// Where an edge leads to, from the point, of which an open star has one more than faces.
  glm::dvec3 edge(std::size_t k) const {
    return (k < star_.count() ? at(topology_.to(spoke(k))) : at(last_beside())) - at(point_);
  }

  /// To the corner across a face.
  glm::dvec3 face(std::size_t k) const {
    return at(topology_.side(topology_.next(topology_.next(spoke(k)))).from) - at(point_);
  }

  /// Where more than three faces meet on the border, what is across it comes closer no faster than what is along it: the
  /// scheme has no tangent plane there.
  bool has_normal() const { return !star_.is_open || star_.count() == 3; }

  /// Across both limit tangents of the surface at the point, but not of unit length.
  glm::dvec3 limit_normal() const {
    const std::array<glm::dvec3, 2> tangents = star_.is_open ? tangents_on_border() : tangents_inside();
    const double size = glm::length(tangents[0]) * glm::length(tangents[1]);
    return size > 0.0 ? glm::cross(tangents[0], tangents[1]) / size : glm::dvec3(0.0);
  }

  /// How much edges count beside faces, where those are as far apart as an angle says (Halstead, Kass and DeRose 1993).
  static double edge_weight(double angle) {
    return 1.0 + std::cos(angle) + std::cos(0.5 * angle) * std::sqrt(2.0 * (9.0 + std::cos(angle)));
  }

  std::array<glm::dvec3, 2> tangents_inside() const {
    const double angle = 2.0 * std::numbers::pi / static_cast<double>(star_.count());
    const double weight = edge_weight(angle);
    std::array<glm::dvec3, 2> tangents{glm::dvec3(0.0), glm::dvec3(0.0)};
    for (std::size_t k = 0; k < star_.count(); ++k) {
      const double a = angle * static_cast<double>(k);
      tangents[0] += weight * std::cos(a) * edge(k) + (std::cos(a) + std::cos(a + angle)) * face(k);
      tangents[1] += weight * std::sin(a) * edge(k) + (std::sin(a) + std::sin(a + angle)) * face(k);
    }
    return tangents;
  }

  /// Along the border, and across it: the left eigenvector of a round whose right one is 0 on the border.
  std::array<glm::dvec3, 2> tangents_on_border() const {
    const double angle = std::numbers::pi / static_cast<double>(star_.count());
    const double weight = edge_weight(angle);
    const double factor = (weight + 4.0) / 16.0;  // of a round
    glm::dvec3 across(0.0);
    double faces = 0.0;
    double edges = 0.0;
    for (std::size_t k = 0; k < star_.count(); ++k) {
      const double a = angle * static_cast<double>(k);
      across += weight * std::sin(a) * edge(k) + (std::sin(a) + std::sin(a + angle)) * face(k);
      edges += weight * std::sin(a);
      faces += std::sin(a) + std::sin(a + angle);
    }
    // What ends of the border count with makes it an eigenvector, with that of the point itself.
    const double beside = std::sin(angle) / 4.0 + weight * std::sin(angle) / 16.0;
    const double own = faces / 4.0 + 3.0 * edges / 8.0;
    const double end = (beside * (factor - 0.75) + own / 8.0) / ((factor - 0.5) * (factor - 0.75) - 0.125);
    across += end * (edge(0) + edge(star_.count()));
    return {edge(star_.count()) - edge(0), across};
  }

  /// Whether some way and the one behind it turn against the normal, so that patches between them would lie face down.
  static bool are_folded(const std::vector<glm::dvec3>& ways, const glm::dvec3& normal) {
    for (std::size_t k = 0; k < ways.size(); ++k) {
      if (!(glm::dot(glm::cross(ways[k], ways[(k + 1) % ways.size()]), normal) > 0.0)) return true;
    }
    return false;
  }

  /// Those of the surface, but on average as long as others.
  std::vector<glm::dvec3> limit_ways(const std::vector<glm::dvec3>& others) const {
    const std::array<glm::dvec3, 2> tangents = tangents_inside();
    std::vector<glm::dvec3> ways;
    double own = 0.0;
    double wanted = 0.0;
    for (std::size_t k = 0; k < star_.count(); ++k) {
      const double a = 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(star_.count());
      ways.push_back(std::cos(a) * tangents[0] + std::sin(a) * tangents[1]);
      own += glm::length(ways.back());
      wanted += glm::length(others[k]);
    }
    for (glm::dvec3& way : ways) way *= wanted / own;
    return ways;
  }

  /// The points next to the middle, as they were found, are moved into the tangent plane of the surface; where they are
  /// folded there, to its own tangents.
  void claim_normal(StarClaims& claims, const std::vector<glm::dvec3>& points) const {
    const glm::dvec3 normal = limit_normal();
    const double size = glm::length(normal);
    if (!(size > kRoundingOfPlace)) return;
    const glm::dvec3 middle = limit();
    std::vector<glm::dvec3> ways;
    for (std::size_t k = 0; k < star_.inner_spokes(); ++k) {
      const glm::dvec3 way = points[star_.at(k, kFanDegree, kFanDegree - 1)] - middle;
      ways.push_back(way - glm::dot(way, normal) / size * (normal / size));
    }
    if (!star_.is_open && are_folded(ways, normal)) ways = limit_ways(ways);
    for (std::size_t k = 0; k < ways.size(); ++k) claims.add(k, kFanDegree, kFanDegree - 1, middle + ways[k], 0);
  }

  /// Where the point converges to.
  glm::dvec3 limit() const {
    if (star_.is_open) return (at(first_beside()) + 4.0 * at(point_) + at(last_beside())) / 6.0;
    const auto n = static_cast<double>(star_.count());
    glm::dvec3 sum = n / (n + 5.0) * at(point_);
    for (const int side : topology_.fan(point_)) {
      const int across = topology_.next(topology_.next(side));
      sum += (4.0 * at(topology_.to(side)) + at(topology_.side(across).from)) / (n * (n + 5.0));
    }
    return sum;
  }

  const ControlMesh& mesh_;
  const MeshTopology& topology_;
  const ControlMesh& finer_;
  const MeshTopology& finer_topology_;
  int point_;
  KnotVector knots_ = KnotVector::bezier(kFanDegree);
  Star star_;
};

}  // namespace

std::vector<NurbsPatch> extraordinary_fan(const ControlMesh& mesh, const MeshTopology& topology, const ControlMesh& finer,
                                          const MeshTopology& finer_topology, int point) {
  return Fan(mesh, topology, finer, finer_topology, point).patches();
}

}  // namespace splinecore
