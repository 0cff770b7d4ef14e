#include "matched_parts.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

namespace splinecore {

namespace {

using PlaceNet = BernsteinNet<glm::dvec3>;

double largest(const PlaceNet& net) {
  double most = 0.0;
  for (const glm::dvec3& value : net.values) most = std::max(most, glm::length(value));
  return most;
}

double mean(const BernsteinNet<double>& net) {
  if (net.values.empty()) return 0.0;
  return std::accumulate(net.values.begin(), net.values.end(), 0.0) / static_cast<double>(net.values.size());
}

Interval range_along(const PlaceNet& net, const glm::dvec3& axis) {
  const auto [low, high] = net.range([&](const glm::dvec3& value) { return glm::dot(value, axis); });
  return {low, high};
}

double size_of(const Interval& range) { return std::max(std::abs(range.start), std::abs(range.end)); }

glm::dvec3 sum_of(const PlaceNet& net) { return std::accumulate(net.values.begin(), net.values.end(), glm::dvec3(0.0)); }

glm::dvec3 mean_of(const PlaceNet& net) { return sum_of(net) / static_cast<double>(net.values.size()); }

/// Largest derivatives by both parameters, and by both twice.
struct Bounds {
  std::array<double, 2> first{};
  std::array<double, 3> second{};  ///< uu, vv, uv

  explicit Bounds(const PlaceNet& net) {
    const PlaceNet u = net.derivative(Axis::u);
    const PlaceNet v = net.derivative(Axis::v);
    first = {largest(u), largest(v)};
    second = {u.rows > 1 ? largest(u.derivative(Axis::u)) : 0.0, v.columns > 1 ? largest(v.derivative(Axis::v)) : 0.0,
              u.columns > 1 ? largest(u.derivative(Axis::v)) : 0.0};
  }

  double change(const std::array<double, 2>& way) const { return first[0] * way[0] + first[1] * way[1]; }

  /// What a linear polynomial leaves.
  double bent(const std::array<double, 2>& way) const {
    return 0.5 * second[0] * way[0] * way[0] + second[2] * way[0] * way[1] + 0.5 * second[1] * way[1] * way[1];
  }
  double change_of(std::size_t k, const std::array<double, 2>& way) const {
    return k == 0 ? second[0] * way[0] + second[2] * way[1] : second[2] * way[0] + second[1] * way[1];
  }
};

/// Both parts over a box, and by how much at most parameters differ of places of both that are one, or right above each other.
struct Compared {
  PlaceNet a;
  PlaceNet gap;
  double rounding;
  std::array<PlaceNet, 2> tangents;
  glm::dvec3 up;
  std::array<glm::dvec3, 2> across;  ///< at right angles to up, and to tangents along the other parameter
  std::array<double, 2> least;       ///< of tangents along these
  std::array<double, 2> most;        ///< of the others along these
  std::array<double, 2> slide{};

  double area() const { return least[0] * least[1] - most[0] * most[1]; }
};

std::optional<Compared> compared(const MatchedNets& nets, const RangesOfTwo& box, double rounding) {
  auto [a, gap, rounded] = nets.over(box);
  Compared found{std::move(a), std::move(gap), rounding + rounded, {}, {}, {}, {}, {}};
  found.tangents = {found.a.derivative(Axis::u), found.a.derivative(Axis::v)};
  const glm::dvec3 u = sum_of(found.tangents[0]);
  const glm::dvec3 v = sum_of(found.tangents[1]);
  const glm::dvec3 normal = glm::cross(u, v);
  if (!(glm::length(normal) > 0.0)) return {};
  found.up = glm::normalize(normal);
  found.across = {glm::normalize(glm::cross(v, found.up)), glm::normalize(glm::cross(found.up, u))};
  std::array<double, 2> apart{};
  for (std::size_t k = 0; k < 2; ++k) {
    found.least[k] = range_along(found.tangents[k], found.across[k]).start;
    found.most[k] = size_of(range_along(found.tangents[1 - k], found.across[k]));
    apart[k] = size_of(range_along(found.gap, found.across[k])) + found.rounding;
  }
  if (!(std::min(found.least[0], found.least[1]) > 0.0) || !(found.area() > 0.0)) return {};
  for (std::size_t k = 0; k < 2; ++k) {
    found.slide[k] = (apart[k] * found.least[1 - k] + apart[1 - k] * found.most[k]) / found.area();
  }
  return found;
}

Interval common(const Interval& range, const Interval& other, double beyond) {
  return {std::max(range.start, other.start - beyond), std::min(range.end, other.end + beyond)};
}

RangesOfTwo hull(const RangesOfTwo& a, const RangesOfTwo& b, const std::array<double, 2>& beyond) {
  RangesOfTwo found;
  for (std::size_t k = 0; k < 2; ++k) {
    found[k] = {std::min(a[k].start, b[k].start) - beyond[k], std::max(a[k].end, b[k].end) + beyond[k]};
  }
  return found;
}

/// In parameters of the first part: what of both may have places in common.
struct CommonBoxes {
  RangesOfTwo a;
  RangesOfTwo b;
  bool are_beside = false;
};

bool is_near(const RangesOfTwo& box) {
  constexpr double kFar = 4.0;
  return std::ranges::all_of(box, [](const Interval& range) { return range.start > -kFar && range.end < 1.0 + kFar; });
}

std::optional<CommonBoxes> common_boxes(const MatchedNets& nets, double rounding) {
  constexpr int kMostRounds = 6;
  CommonBoxes boxes{{Interval{}, Interval{}}, nets.range_of_b()};
  for (int round = 0; round < kMostRounds; ++round) {
    const RangesOfTwo all = hull(boxes.a, boxes.b, {0.0, 0.0});
    if (!is_near(all)) return {};
    const std::optional<Compared> both = compared(nets, all, rounding);
    if (!both) return round == 0 ? std::nullopt : std::optional(boxes);
    bool is_less = false;
    for (std::size_t k = 0; k < 2; ++k) {
      const double beyond = both->slide[k] * all[k].length();
      const Interval of_a = common(boxes.a[k], boxes.b[k], beyond);
      const Interval of_b = common(boxes.b[k], boxes.a[k], beyond);
      boxes.are_beside = boxes.are_beside || of_a.start > of_a.end || of_b.start > of_b.end;
      if (boxes.are_beside) return boxes;
      is_less = is_less || of_a.length() < 0.75 * boxes.a[k].length() || of_b.length() < 0.75 * boxes.b[k].length();
      boxes.a[k] = of_a;
      boxes.b[k] = of_b;
    }
    if (!is_less) break;
  }
  return boxes;
}

/// How the height of the second part over the first one goes with the parameters of the first one.
class HeightOverPart {
 public:
  explicit HeightOverPart(const Compared& both)
      : both_(both), normals_(cross_product(both.tangents[0], both.tangents[1])), heights_(scalar_product(normals_, both.gap)),
        of_a_(both.a), of_normals_(normals_), of_gap_(both.gap) {}

  HeightDifference difference(const MatchedNets& nets) const {
    const double longest = largest(normals_);
    const double shortest = range_along(normals_, both_.up).start;
    const auto [low, high] = heights_.range();
    const double off = longest * (of_a_.bent(both_.slide) + both_.rounding);
    HeightDifference found;
    found.range = {low - off, high + off};
    if (!(shortest > 0.0)) return {{-1e300, 1e300}, 0.0, 0.0, {}, false};
    found.range.start /= found.range.start > 0.0 ? longest : shortest;
    found.range.end /= found.range.end < 0.0 ? longest : shortest;
    found.bend = bend(longest);
    add_slope(found, nets, size_of(found.range), longest);
    return found;
  }

 private:
  double speed(std::size_t k) const { return of_a_.first[k]; }

  double bend(double longest) const {
    const auto of = [&](Axis one, Axis other) {
      const auto first = heights_.derivative(one);
      if (first.count(other) < 2) return 0.0;
      const double size = speed(one == Axis::u ? 0 : 1) * speed(other == Axis::u ? 0 : 1);
      return std::abs(mean(first.derivative(other))) / (size * longest);
    };
    return std::max({of(Axis::u, Axis::u), of(Axis::u, Axis::v), of(Axis::v, Axis::v)});
  }

  /// How far the derivative of the height, times the length of the normal, is from that of what it is compared by.
  double wrong_slope(std::size_t k, double height) const {
    const std::array<double, 2>& slide = both_.slide;
    const double up = size_of(range_along(normals_.derivative(k == 0 ? Axis::u : Axis::v), both_.up));
    return of_normals_.bent(slide) * of_a_.first[k] + of_normals_.change(slide) * of_gap_.first[k] +
           of_normals_.first[k] * of_a_.bent(slide) + height * up;
  }

  /// By how much the way of the first part's parameters turns from that of the parameters both are compared by.
  double turn() const {
    double sum = 0.0;
    for (std::size_t k = 0; k < 2; ++k) sum += (of_gap_.first[k] + of_a_.change_of(k, both_.slide)) / speed(k);
    return 2.0 * sum * speed(0) * speed(1) / both_.area();
  }

  void add_slope(HeightDifference& found, const MatchedNets& nets, double height, double longest) const {
    std::array<double, 2> middle{};
    double spread = 0.0;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto [low, high] = heights_.derivative(k == 0 ? Axis::u : Axis::v).range();
      const double wrong = wrong_slope(k, height) + longest * both_.rounding;
      middle[k] = 0.5 * (low + high) / speed(k);
      spread = std::hypot(spread, (0.5 * (high - low) + wrong) / speed(k));
    }
    const double slope = std::hypot(middle[0], middle[1]);
    if (!(slope > spread)) return;
    const glm::dvec3 way = middle[0] * speed(0) * mean_of(both_.tangents[1]) - middle[1] * speed(1) * mean_of(both_.tangents[0]);
    found.least_slope = (1.0 - spread / slope) * glm::length(way) / (longest * longest);
    const double angle = std::asin(spread / slope) + turn();
    const std::array<int, 2> ways = nets.ways();
    const double turned = (ways[0] * ways[1] < 0) != nets.is_exchanged() ? -1.0 : 1.0;
    const std::array<double, 2> along{turned * middle[1] / slope, -turned * middle[0] / slope};
    for (std::size_t k = 0; k < 2; ++k) {
      const double least = std::asin(std::min(1.0, std::abs(along[k]))) - angle;
      const double lead = least > 0.0 ? std::copysign(std::sin(least), along[k]) : 0.0;
      found.leads[k] = lead;
      found.leads[2 + (nets.is_exchanged() ? 1 - k : k)] = ways[k] * lead;
    }
  }

  const Compared& both_;
  PlaceNet normals_;
  BernsteinNet<double> heights_;
  Bounds of_a_;
  Bounds of_normals_;
  Bounds of_gap_;
};

bool lie_along(const PatchPart& a, const PatchPart& b) {
  constexpr double kMostSpread = 1.2;
  constexpr double kParallel = 0.8;
  const VectorCone& of_a = a.normals();
  const VectorCone& of_b = b.normals();
  return of_a.spread < kMostSpread && of_b.spread < kMostSpread && std::abs(glm::dot(of_a.along, of_b.along)) >= kParallel;
}

}  // namespace

std::optional<MatchedParts> matched_parts(const PatchPart& a, const PatchPart& b, double rounding) {
  constexpr std::size_t kMostPoints = 64;
  constexpr double kWider = 4.0;
  if (!a.is_boxed || !b.is_boxed || std::max(a.points.size(), b.points.size()) > kMostPoints) return {};
  if (!lie_along(a, b)) return {};
  const std::optional<MatchedNets> nets = MatchedNets::of(a, b);
  if (!nets) return {};
  const std::optional<CommonBoxes> boxes = common_boxes(*nets, rounding);
  if (!boxes) return {};
  MatchedParts found{boxes->are_beside, nets->of_a(boxes->a), nets->of_b(boxes->b), {{-1e300, 1e300}, 0.0, 0.0, {}, false}};
  if (found.are_beside) return found;
  const RangesOfTwo least = hull(boxes->a, boxes->b, {0.0, 0.0});
  const std::optional<Compared> before = compared(*nets, least, rounding);
  if (!before) return {};
  std::array<double, 2> beyond{};
  for (std::size_t k = 0; k < 2; ++k) beyond[k] = kWider * before->slide[k] * least[k].length();
  const RangesOfTwo all = hull(boxes->a, boxes->b, beyond);
  const std::optional<Compared> both = is_near(all) ? compared(*nets, all, rounding) : std::nullopt;
  if (!both) return {};
  for (std::size_t k = 0; k < 2; ++k) {
    if (!(both->slide[k] * all[k].length() <= beyond[k])) return {};
  }
  found.difference = HeightOverPart(*both).difference(*nets);
  return found;
}

}  // namespace splinecore
