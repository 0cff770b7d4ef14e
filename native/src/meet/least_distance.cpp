#include "splinecore/meet/least_distance.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
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
#include "base/rounding.hpp"
#include "box_tree.hpp"
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

/// The larger part is, and first those that run through infinity.
bool is_cut_first(const auto& a, const auto& b) {
  if (a.is_boxed != b.is_boxed) return !a.is_boxed;
  return a.is_boxed ? size_of(a) >= size_of(b) : width_of(a) >= width_of(b);
}

/// A shape, or the patches of a set.
template <class Shape>
using Members = std::vector<const Shape*>;

Members<NurbsCurve> members_of(const NurbsCurve& curve) { return {&curve}; }
Members<NurbsPatch> members_of(const NurbsPatch& patch) { return {&patch}; }
Members<NurbsPatch> members_of(const PatchSet& set) {
  Members<NurbsPatch> found;
  for (std::size_t i = 0; i < set.patches().size(); ++i) found.push_back(&nurbs_of(set.patch(i)));
  return found;
}

template <class A, class B>
std::vector<glm::dvec4> points_of(const Members<A>& a, const Members<B>& b) {
  std::vector<glm::dvec4> points;
  for (const A* one : a) points.insert(points.end(), one->points().begin(), one->points().end());
  for (const B* one : b) points.insert(points.end(), one->points().begin(), one->points().end());
  return points;
}

/// The box about a tree.
TreeBox box_of(const BoxTree& tree) {
  const std::size_t top = tree.levels() - 1;
  std::vector<TreeBox> boxes;
  for (std::size_t i = 0; i < tree.count(top); ++i) {
    const BoxTree::Group& group = tree.group(top, i / BoxTree::kGroup);
    const std::size_t k = i % BoxTree::kGroup;
    const glm::dvec3 middle(group.middle[0][k], group.middle[1][k], group.middle[2][k]);
    const glm::dvec3 half(group.half[0][k], group.half[1][k], group.half[2][k]);
    boxes.push_back({middle - half, middle + half});
  }
  return around(boxes);
}

/// No points in the boxes are nearer; 0 where a box has no bounds.
double gap_between(const TreeBox& a, const TreeBox& b) {
  double sum = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double gap = std::max({0.0, a.low[k] - b.high[k], b.low[k] - a.high[k]});
    sum += gap * gap;
  }
  return std::max(0.0, std::sqrt(sum) - kRoundingOfPlace);
}

/// Pairs of members are searched from those whose boxes are nearest on, until no box is near enough.
template <class A, class B>
class LeastDistanceSearch {
 public:
  LeastDistanceSearch(Members<A> a, Members<B> b, std::optional<double> tolerance)
      : members_a_(std::move(a)), members_b_(std::move(b)), space_(points_of(members_a_, members_b_)),
        tolerance_(place_tolerance(space_, tolerance)) {
    for (const A* one : members_a_) all_a_.emplace_back(*one, space_);
    for (const B* one : members_b_) all_b_.emplace_back(*one, space_);
  }

  LeastDistance found() {
    for (const auto& [gap, i, j] : pairs_in_order()) {
      if (least_ <= tolerance_ || gap > least_ - tolerance_) break;
      chosen_ = {i, j};
      if (!(least_ < std::numeric_limits<double>::infinity())) begin();
      const double near = std::max(least_ - tolerance_, 0.0);
      for_near_pairs(pieces_a().tree(), pieces_b().tree(), near, [&](std::size_t k, std::size_t l) {
        pair(whole_part(pieces_a(), k), whole_part(pieces_b(), l));
      });
    }
    return best_;
  }

 private:
  using PiecesA = std::conditional_t<std::is_same_v<A, NurbsCurve>, CurvePieces, PatchPieces>;
  using PiecesB = std::conditional_t<std::is_same_v<B, NurbsCurve>, CurvePieces, PatchPieces>;

  struct Pair {
    double gap;
    std::size_t i;
    std::size_t j;
  };

  std::vector<Pair> pairs_in_order() const {
    const auto boxes_of = [](const auto& all) {
      std::vector<TreeBox> boxes;
      for (const auto& pieces : all) boxes.push_back(box_of(pieces.tree()));
      return boxes;
    };
    const std::vector<TreeBox> boxes_a = boxes_of(all_a_);
    const std::vector<TreeBox> boxes_b = boxes_of(all_b_);
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < boxes_a.size(); ++i) {
      breathe(8 * boxes_b.size());
      for (std::size_t j = 0; j < boxes_b.size(); ++j) pairs.push_back({gap_between(boxes_a[i], boxes_b[j]), i, j});
    }
    std::ranges::stable_sort(pairs, {}, &Pair::gap);
    return pairs;
  }

  const A& a() const { return *members_a_[chosen_[0]]; }
  const B& b() const { return *members_b_[chosen_[1]]; }
  const PiecesA& pieces_a() const { return all_a_[chosen_[0]]; }
  const PiecesB& pieces_b() const { return all_b_[chosen_[1]]; }

  /// From the middles of some pieces.
  void begin() {
    constexpr std::size_t kMost = 16;
    const std::size_t step = pieces_a().size() / kMost + 1;
    for (std::size_t i = 0; i < pieces_a().size(); i += step) {
      const glm::dvec3 point = middle_of(pieces_a(), whole_part(pieces_a(), i));
      if (std::isfinite(point.x + point.y + point.z)) approach(space_.leave(point));
    }
    if (!(least_ < std::numeric_limits<double>::infinity())) approach(foot_on(a(), glm::dvec3(b().points().front())).point);
  }

  /// Goes from a point to the foot on one shape and from there to that on the other, as long as they come nearer.
  void approach(const glm::dvec3& from) {
    constexpr int kMost = 64;
    constexpr double kLess = 1.0 - 0x1p-48;
    Foot on_b = foot_on(b(), from);
    Foot on_a = foot_on(a(), on_b.point);
    for (int i = 0; i < kMost; ++i) {
      const Foot next_b = foot_on(b(), on_a.point);
      const Foot next_a = foot_on(a(), next_b.point);
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
      const glm::dmat2x3 ways_a = ways_at(a(), best_.a);
      const glm::dmat2x3 ways_b = ways_at(b(), best_.b);
      const glm::dmat3 across = ways_a * glm::transpose(ways_a) + ways_b * glm::transpose(ways_b);
      const double scale = across[0][0] + across[1][1] + across[2][2];
      constexpr double kFlat = 0x1p-40;
      if (!(std::abs(glm::determinant(across)) > kFlat * scale * scale * scale)) return;
      const glm::dvec3 share = glm::inverse(across) * (best_.point_b - best_.point_a);
      const glm::dvec3 from = moved_along(a(), best_.a, share * ways_a);
      const Foot on_b = foot_on(b(), from);
      if (!keep(foot_on(a(), on_b.point), on_b)) return;
    }
  }

  /// @returns false unless they are nearer than what was found
  bool keep(const Foot& on_a, const Foot& on_b) {
    const double near = distance_of(on_a.point, on_b.point);
    if (!(near < best_.distance)) return false;
    best_ = {near, on_a.parameters, on_b.parameters, on_a.point, on_b.point, chosen_[0], chosen_[1]};
    least_ = near / space_.length(1.0);
    return true;
  }

  void pair(const auto& of_a, const auto& of_b) {
    if (least_ <= tolerance_ || is_lost(of_a) || is_lost(of_b)) return;
    breathe(64);
    if (++pairs_ > kMostPairs) {
      throw InvalidShape("more than " + std::to_string(kMostPairs) + " pairs of parts are within the tolerance of the least "
                         "distance: the shapes are as near all along, or it is too small");
    }
    const glm::dvec3 middle = middle_of(pieces_a(), of_a);
    const glm::dvec3 way = middle_of(pieces_b(), of_b) - middle;
    if (glm::length(way) < least_) approach(space_.leave(middle));
    if (least_ <= tolerance_ || are_parts_apart(of_a, of_b, way, least_ - tolerance_)) return;
    if (is_cut_first(of_a, of_b)) {
      const auto [before, behind] = of_a.halves();
      pair(before, of_b);
      pair(behind, of_b);
    } else {
      const auto [before, behind] = of_b.halves();
      pair(of_a, before);
      pair(of_a, behind);
    }
  }

  const Members<A> members_a_;
  const Members<B> members_b_;
  NearSpace space_;
  std::deque<PiecesA> all_a_;
  std::deque<PiecesB> all_b_;
  std::array<std::size_t, 2> chosen_{};  ///< members that are searched
  double tolerance_;
  LeastDistance best_{std::numeric_limits<double>::infinity(), {}, {}, {}, {}};
  double least_ = std::numeric_limits<double>::infinity();  ///< in the space
  std::size_t pairs_ = 0;
};

LeastDistance between_members(const auto& a, const auto& b, std::optional<double> tolerance) {
  return LeastDistanceSearch(members_of(a), members_of(b), tolerance).found();
}

}  // namespace

LeastDistance least_distance(const NurbsCurve& a, const NurbsCurve& b, std::optional<double> tolerance) {
  return between_members(a, b, tolerance);
}

LeastDistance least_distance(const NurbsCurve& a, const NurbsPatch& b, std::optional<double> tolerance) {
  return between_members(a, b, tolerance);
}

LeastDistance least_distance(const NurbsPatch& a, const NurbsPatch& b, std::optional<double> tolerance) {
  return between_members(a, b, tolerance);
}

LeastDistance least_distance(const NurbsCurve& a, const PatchSet& b, std::optional<double> tolerance) {
  return between_members(a, b, tolerance);
}

LeastDistance least_distance(const NurbsPatch& a, const PatchSet& b, std::optional<double> tolerance) {
  return between_members(a, b, tolerance);
}

LeastDistance least_distance(const PatchSet& a, const PatchSet& b, std::optional<double> tolerance) {
  return between_members(a, b, tolerance);
}

}  // namespace splinecore
