#include "splinecore/meet/least_distance.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat2x3.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/length.hpp"
#include "curve_part.hpp"
#include "curve_pieces.hpp"
#include "hull_extent.hpp"
#include "near_space.hpp"
#include "patch_part.hpp"
#include "patch_pieces.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/meet/nearest.hpp"
#include "splinecore/patch/evaluate.hpp"
#include "tree_pairs.hpp"

namespace splinecore {

namespace {

constexpr std::size_t kMostPairs = std::size_t{1} << 22;
/// So narrow parts that run through infinity have no points but where weights are zero.
constexpr double kNarrow = 0x1p-24;

struct Foot {
  std::array<double, 2> parameters;
  glm::dvec3 point;
  double distance;
};

Foot foot_on(const NurbsCurve& curve, const glm::dvec3& point) {
  NearestOnCurve found;
  nearest(curve, std::span(&point, 1), std::span(&found, 1), 1);
  return {{found.parameter, 0.0}, found.point, found.distance};
}

Foot foot_on(const NurbsPatch& patch, const glm::dvec3& point) {
  NearestOnPatch found;
  nearest(patch, std::span(&point, 1), std::span(&found, 1), 1);
  return {{found.u, found.v}, found.point, found.distance};
}

/// The derivatives along u and v; of a curve the second is zero.
glm::dmat2x3 ways_at(const NurbsCurve& curve, const std::array<double, 2>& at) {
  std::array<glm::dvec3, 2> found;
  derivatives(curve, std::span(at.data(), 1), 1, std::span(&found[0].x, 6));
  return {found[1], glm::dvec3(0.0)};
}

glm::dmat2x3 ways_at(const NurbsPatch& patch, const std::array<double, 2>& at) {
  std::array<glm::dvec3, 3> found;
  first_derivatives(patch, std::span(at.data(), 1), std::span(at.data() + 1, 1), std::span(&found[0].x, 9));
  return {found[1], found[2]};
}

glm::dvec3 moved_along(const NurbsCurve& curve, std::array<double, 2> at, const glm::dvec2& by) {
  const Interval domain = curve.domain();
  at[0] = std::clamp(at[0] + by.x, domain.start, domain.end);
  glm::dvec3 point;
  evaluate(curve, std::span(at.data(), 1), std::span(&point.x, 3));
  return point;
}

glm::dvec3 moved_along(const NurbsPatch& patch, std::array<double, 2> at, const glm::dvec2& by) {
  for (int k = 0; k < 2; ++k) {
    const Interval domain = patch.knot_vector(k == 0 ? Axis::u : Axis::v).domain();
    at[static_cast<std::size_t>(k)] = std::clamp(at[static_cast<std::size_t>(k)] + by[k], domain.start, domain.end);
  }
  glm::dvec3 point;
  evaluate(patch, std::span(at.data(), 1), std::span(at.data() + 1, 1), std::span(&point.x, 3));
  return point;
}

CurvePart whole_part(const CurvePieces& pieces, std::size_t i) { return CurvePart(i, {}, pieces.piece(i), pieces.sums(i)); }
PatchPart whole_part(const PatchPieces& pieces, std::size_t i) { return PatchPart(i, {}, pieces.piece(i)); }

double size_of(const CurvePart& part) { return part.size; }
double size_of(const PatchPart& part) { return part.largest_size(); }

double width_of(const CurvePart& part) { return part.range.length(); }
double width_of(const PatchPart& part) { return std::max(part.range[0].length(), part.range[1].length()); }

bool is_lost(const auto& part) { return !part.is_boxed && width_of(part) <= kNarrow; }

glm::dvec3 middle_of(const CurvePieces& pieces, const CurvePart& part) {
  return pieces.at({part.piece, part.range.middle()}).point;
}
glm::dvec3 middle_of(const PatchPieces& pieces, const PatchPart& part) {
  return pieces.at({part.piece, part.middle()}).point;
}

/// Along the way from one middle to the other hulls of small parts are as far apart as they are. Those of which one runs
/// through infinity tell nothing here.
template <class A, class B>
bool are_parts_apart(const A& a, const B& b, const glm::dvec3& way, double distance) {
  if (!a.is_boxed || !b.is_boxed) return false;
  const double length = glm::length(way);
  return (length > 0.0 && are_apart_along(a.points, b.points, std::array{way / length}, distance)) || are_apart(a, b, distance);
}

template <class A, class B>
class LeastDistanceSearch {
 public:
  LeastDistanceSearch(const A& a, const B& b, std::optional<double> tolerance)
      : a_(a), b_(b), space_(together(a.points(), b.points())), pieces_a_(a, space_), pieces_b_(b, space_),
        tolerance_(place_tolerance(space_, tolerance)) {}

  LeastDistance found() {
    begin();
    for_near_pairs(pieces_a_.tree(), pieces_b_.tree(), std::max(least_ - tolerance_, 0.0), [&](std::size_t i, std::size_t j) {
      pair(whole_part(pieces_a_, i), whole_part(pieces_b_, j));
    });
    return best_;
  }

 private:
  using PiecesA = std::conditional_t<std::is_same_v<A, NurbsCurve>, CurvePieces, PatchPieces>;
  using PiecesB = std::conditional_t<std::is_same_v<B, NurbsCurve>, CurvePieces, PatchPieces>;

  /// From the middles of some pieces.
  void begin() {
    constexpr std::size_t kMost = 16;
    const std::size_t step = pieces_a_.size() / kMost + 1;
    for (std::size_t i = 0; i < pieces_a_.size(); i += step) {
      const glm::dvec3 point = middle_of(pieces_a_, whole_part(pieces_a_, i));
      if (std::isfinite(point.x + point.y + point.z)) approach(space_.leave(point));
    }
    if (!(least_ < std::numeric_limits<double>::infinity())) approach(foot_on(a_, glm::dvec3(b_.points().front())).point);
  }

  /// Goes from a point to the foot on one shape and from there to that on the other, as long as they come nearer.
  void approach(const glm::dvec3& from) {
    constexpr int kMost = 64;
    constexpr double kLess = 1.0 - 0x1p-48;
    Foot on_b = foot_on(b_, from);
    Foot on_a = foot_on(a_, on_b.point);
    for (int i = 0; i < kMost; ++i) {
      const Foot next_b = foot_on(b_, on_a.point);
      const Foot next_a = foot_on(a_, next_b.point);
      const bool is_done = !(next_a.distance < kLess * on_a.distance);
      if (next_a.distance <= on_a.distance) {
        on_b = next_b;
        on_a = next_a;
      }
      if (is_done) break;
    }
    if (keep(on_a, on_b)) cross();
  }

  /// Where shapes cross feet come near to the place slowly: Newton's method by the shortest steps comes there at once.
  void cross() {
    constexpr int kMost = 8;
    for (int i = 0; i < kMost && best_.distance > 0.0; ++i) {
      const glm::dmat2x3 a = ways_at(a_, best_.a);
      const glm::dmat2x3 b = ways_at(b_, best_.b);
      const glm::dmat3 across = a * glm::transpose(a) + b * glm::transpose(b);
      const double scale = across[0][0] + across[1][1] + across[2][2];
      constexpr double kFlat = 0x1p-40;
      if (!(std::abs(glm::determinant(across)) > kFlat * scale * scale * scale)) return;
      const glm::dvec3 share = glm::inverse(across) * (best_.point_b - best_.point_a);
      const glm::dvec3 from = moved_along(a_, best_.a, share * a);
      const Foot on_b = foot_on(b_, from);
      if (!keep(foot_on(a_, on_b.point), on_b)) return;
    }
  }

  /// @returns false unless they are nearer than what was found
  bool keep(const Foot& on_a, const Foot& on_b) {
    const double near = distance_of(on_a.point, on_b.point);
    if (!(near < best_.distance)) return false;
    best_ = {near, on_a.parameters, on_b.parameters, on_a.point, on_b.point};
    least_ = near / space_.length(1.0);
    return true;
  }

  void pair(const auto& a, const auto& b) {
    if (least_ <= tolerance_ || is_lost(a) || is_lost(b)) return;
    breathe(64);
    if (++pairs_ > kMostPairs) {
      throw InvalidShape("more than " + std::to_string(kMostPairs) + " pairs of parts are within the tolerance of the least "
                         "distance: the shapes are as near all along, or it is too small");
    }
    const glm::dvec3 middle = middle_of(pieces_a_, a);
    const glm::dvec3 way = middle_of(pieces_b_, b) - middle;
    if (glm::length(way) < least_) approach(space_.leave(middle));
    if (least_ <= tolerance_ || are_parts_apart(a, b, way, least_ - tolerance_)) return;
    const bool is_first = a.is_boxed == b.is_boxed ? (a.is_boxed ? size_of(a) >= size_of(b) : width_of(a) >= width_of(b))
                                                   : !a.is_boxed;
    if (is_first) {
      const auto [before, behind] = a.halves();
      pair(before, b);
      pair(behind, b);
    } else {
      const auto [before, behind] = b.halves();
      pair(a, before);
      pair(a, behind);
    }
  }

  const A& a_;
  const B& b_;
  NearSpace space_;
  PiecesA pieces_a_;
  PiecesB pieces_b_;
  double tolerance_;
  LeastDistance best_{std::numeric_limits<double>::infinity(), {}, {}, {}, {}};
  double least_ = std::numeric_limits<double>::infinity();  ///< in the space
  std::size_t pairs_ = 0;
};

}  // namespace

LeastDistance least_distance(const NurbsCurve& a, const NurbsCurve& b, std::optional<double> tolerance) {
  return LeastDistanceSearch(a, b, tolerance).found();
}

LeastDistance least_distance(const NurbsCurve& a, const NurbsPatch& b, std::optional<double> tolerance) {
  return LeastDistanceSearch(a, b, tolerance).found();
}

LeastDistance least_distance(const NurbsPatch& a, const NurbsPatch& b, std::optional<double> tolerance) {
  return LeastDistanceSearch(a, b, tolerance).found();
}

}  // namespace splinecore
