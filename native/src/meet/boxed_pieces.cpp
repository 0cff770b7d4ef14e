#include "boxed_pieces.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <numeric>

#include "base/one_sign.hpp"
#include "base/quotient.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

/// How far a part may bend by its size, and how much its weights may differ, before it is halved: so few parts in boxes so
/// thin take the least time.
constexpr double kBendOfCurve = 0.3;
constexpr double kBendOfPatch = 0.2;
constexpr double kUneven = 2.0;
/// So often it is halved for that, and so often for weights of both signs.
constexpr int kDeepest = 5;
constexpr int kDeepestAtInfinity = 10;

/// The largest second difference of the control points along an axis: four times as far a part is from straight lines.
double bend_of(const BernsteinNet<glm::dvec4>& net, Axis axis) {
  const std::size_t step = axis == Axis::u ? net.columns : 1;
  const std::size_t count = net.count(axis);
  double most = 0.0;
  for (std::size_t at = 0; at < net.values.size(); ++at) {
    if (at / step % count + 2 >= count) continue;
    const glm::dvec3 middle = project(net.values[at + step]);
    const glm::dvec3 bend = project(net.values[at]) - middle + (project(net.values[at + 2 * step]) - middle);
    most = std::max(most, glm::length(bend));
  }
  return most;
}

double unevenness(const BernsteinNet<glm::dvec4>& net) {
  double least = std::abs(net.values.front().w);
  double most = least;
  for (const glm::dvec4& h : net.values) {
    least = std::min(least, std::abs(h.w));
    most = std::max(most, std::abs(h.w));
  }
  return most / least;
}

TurnedBoxGroup group_of(std::span<const PiecePart> parts) {
  constexpr double kEverywhere = 0x1p1000;  // a width that is infinite, and its sums are numbers
  TurnedBoxGroup group{};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const PieceBox& box = parts[i].box;
    for (int axis = 0; axis < 3; ++axis) {
      group.center[axis][i] = box.center[axis];
      group.half[axis][i] = parts[i].is_boxed ? box.half[axis] : kEverywhere;
      for (int c = 0; c < 3; ++c) group.axes[axis][c][i] = box.axes[axis][c];
    }
  }
  return group;
}

/// The bits of two numbers in turn: neighbors in a plane are mostly neighbors so (Morton 1966).
std::uint64_t interleaved(std::uint64_t a, std::uint64_t b) {
  std::uint64_t code = 0;
  for (int bit = 0; bit < 32; ++bit) code |= (a >> bit & 1U) << (2 * bit + 1) | (b >> bit & 1U) << (2 * bit);
  return code;
}

}  // namespace

BoxedPieces::BoxedPieces(const NurbsCurve& curve)
    : space_(curve.points()), rows_(static_cast<std::size_t>(curve.degree()) + 1), columns_(1), tree_([&] {
        const KnotVector& knots = curve.knot_vector();
        const auto homogeneous = curve.homogeneous_points();
        const auto own = space_.homogeneous(curve.points(), homogeneous, curve.points().size(), homogeneous.size());
        for (int i = 0; i < static_cast<int>(knots.spans().size()); ++i) {
          cut(bezier_piece(knots, i, own.data()), {knots.span_interval(i), Interval{}}, {}, 0);
        }
        return tree_of_groups();
      }()) {}

BoxedPieces::BoxedPieces(const NurbsPatch& patch)
    : space_(patch.points()), rows_(static_cast<std::size_t>(patch.knot_vector(Axis::u).degree()) + 1),
      columns_(static_cast<std::size_t>(patch.knot_vector(Axis::v).degree()) + 1), tree_([&] {
        const KnotVector& u = patch.knot_vector(Axis::u);
        const KnotVector& v = patch.knot_vector(Axis::v);
        const auto own = space_.homogeneous(patch.points(), patch.homogeneous_points(),
                                            static_cast<std::size_t>(v.count()),
                                            static_cast<std::size_t>(v.unrolled_count()));
        std::vector<std::uint64_t> codes;
        for (int i = 0; i < static_cast<int>(u.spans().size()); ++i) {
          for (int j = 0; j < static_cast<int>(v.spans().size()); ++j) {
            cut(bezier_piece(u, i, v, j, own.data()), {u.span_interval(i), v.span_interval(j)}, {}, 0);
            while (codes.size() < parts_.size()) {
              constexpr double kSteps = 1 << kDeepestAtInfinity;
              const auto& range = parts_[codes.size()].range;
              codes.push_back(interleaved(static_cast<std::uint64_t>((i + range[0].middle()) * kSteps),
                                          static_cast<std::uint64_t>((j + range[1].middle()) * kSteps)));
            }
          }
        }
        put_in_order(codes);
        return tree_of_groups();
      }()) {}

void BoxedPieces::put_in_order(std::span<const std::uint64_t> codes) {
  std::vector<std::size_t> order(parts_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return codes[i]; });
  std::vector<PiecePart> parts;
  std::vector<glm::dvec4> net_points;
  std::vector<TreeBox> boxes;
  parts.reserve(parts_.size());
  net_points.reserve(points_.size());
  boxes.reserve(boxes_.size());
  for (const std::size_t i : order) {
    parts.push_back(parts_[i]);
    boxes.push_back(boxes_[i]);
    net_points.insert(net_points.end(), points(i), points(i + 1));
  }
  parts_ = std::move(parts);
  points_ = std::move(net_points);
  boxes_ = std::move(boxes);
}

BoxTree BoxedPieces::tree_of_groups() {
  std::vector<TreeBox> leaves;
  for (std::size_t first = 0; first < parts_.size(); first += kGroup) {
    const std::size_t count = std::min(kGroup, parts_.size() - first);
    groups_.push_back(group_of(std::span(parts_).subspan(first, count)));
    leaves.push_back(around(std::span(boxes_).subspan(first, count)));
  }
  boxes_ = {};
  return BoxTree(leaves);
}

void BoxedPieces::cut(const Net& net, const std::array<Interval, 2>& domain, const std::array<Interval, 2>& range,
                      int depth) {
  breathe(32 * net.values.size());
  const bool is_boxed = has_one_sign(net.values, &glm::dvec4::w);
  const PieceBox box = is_boxed ? piece_box(net) : PieceBox{};
  const double bend_u = is_boxed ? bend_of(net, Axis::u) : range[0].length();
  const double bend_v = columns_ == 1 ? 0.0 : is_boxed ? bend_of(net, Axis::v) : range[1].length();
  const double most_bend = columns_ == 1 ? kBendOfCurve : kBendOfPatch;
  const bool is_bent = !is_boxed || std::max(bend_u, bend_v) > most_bend * box.half.x || unevenness(net) > kUneven;
  if (!is_bent || depth >= (is_boxed ? kDeepest : kDeepestAtInfinity)) {
    parts_.push_back({domain, range, is_boxed, box});
    boxes_.push_back(box_of(net));
    points_.insert(points_.end(), net.values.begin(), net.values.end());
    return;
  }
  const Axis axis = bend_v > bend_u ? Axis::v : Axis::u;
  const auto a = static_cast<std::size_t>(axis);
  Net first = net;
  Net second;
  first.halve(axis, second);
  std::array<Interval, 2> half = range;
  half[a].end = range[a].middle();
  cut(first, domain, half, depth + 1);
  half[a] = {range[a].middle(), range[a].end};
  cut(second, domain, half, depth + 1);
}

const BoxedPieces& boxed_pieces(const NurbsCurve& curve) {
  return curve.boxed_pieces().get([&] { return std::make_unique<const BoxedPieces>(curve); });
}

const BoxedPieces& boxed_pieces(const NurbsPatch& patch) {
  return patch.boxed_pieces().get([&] { return std::make_unique<const BoxedPieces>(patch); });
}

}  // namespace splinecore
