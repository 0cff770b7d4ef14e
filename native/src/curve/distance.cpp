#include "splinecore/curve/distance.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <queue>

#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/base/quotient.hpp"
#include "splinecore/curve/degree.hpp"

namespace splinecore {

namespace {

/// Two Bezier pieces of one degree on the same parameters, homogeneous.
struct Pair {
  std::vector<glm::dvec4> a;
  std::vector<glm::dvec4> b;
  double smallest_weight;  // what counts as finite
  double bound = 0.0;
  bool operator<(const Pair& other) const { return bound < other.bound; }
};

double largest_weight(const std::vector<glm::dvec4>& points) {
  double largest = 0.0;
  for (const glm::dvec4& p : points) largest = std::max(largest, std::abs(p.w));
  return largest;
}

/// The least |W| on the piece as far as its hull tells; 0 where the sign may change.
double least_weight(const std::vector<glm::dvec4>& points) {
  const auto [low, high] = std::ranges::minmax(points, {}, &glm::dvec4::w);
  if (low.w > 0.0) return low.w;
  return high.w < 0.0 ? -high.w : 0.0;
}

/// Largest |A/W_A − B/W_B| over the hull: the difference is ((W_B − W_A) (A/W_A − c) + (A − c W_A) − (B − c W_B)) / W_B
/// for any centre c.
double hull_bound(const Pair& pair) {
  const double least_a = least_weight(pair.a);
  const double least_b = least_weight(pair.b);
  if (least_a == 0.0 || least_b == 0.0) return HUGE_VAL;
  const glm::dvec3 centre = project(pair.a[pair.a.size() / 2]);
  double radius = 0.0;
  double difference = 0.0;
  double weights = 0.0;
  for (std::size_t i = 0; i < pair.a.size(); ++i) {
    const glm::dvec4& a = pair.a[i];
    const glm::dvec4& b = pair.b[i];
    radius = std::max(radius, glm::length(project(a) - centre));
    weights = std::max(weights, std::abs(b.w - a.w));
    difference = std::max(difference, glm::length(glm::dvec3(a) - glm::dvec3(b) + centre * (b.w - a.w)));
  }
  return (weights * radius + difference) / least_b;
}

double end_distance(const Pair& pair) {
  const auto at = [&](const glm::dvec4& a, const glm::dvec4& b) {
    if (std::abs(a.w) < pair.smallest_weight || std::abs(b.w) < pair.smallest_weight) return 0.0;
    return glm::length(project(a) - project(b));
  };
  return std::max(at(pair.a.front(), pair.b.front()), at(pair.a.back(), pair.b.back()));
}

/// de Casteljau at the middle.
void halve(const std::vector<glm::dvec4>& whole, std::vector<glm::dvec4>& left, std::vector<glm::dvec4>& right) {
  std::vector<glm::dvec4> row = whole;
  left.clear();
  right.resize(whole.size());
  for (std::size_t size = row.size(); size > 0; --size) {
    left.push_back(row.front());
    right[size - 1] = row[size - 1];
    for (std::size_t i = 0; i + 1 < size; ++i) row[i] = 0.5 * (row[i] + row[i + 1]);
  }
}

bool is_off_to_infinity(const Pair& pair) {
  const auto is_small = [&](const auto& points) { return largest_weight(points) < pair.smallest_weight; };
  return is_small(pair.a) || is_small(pair.b);
}

/// Both curves as pieces of one degree on all the knots of both.
std::vector<Pair> pairs_of(NurbsCurve a, NurbsCurve b) {
  if (a.degree() < b.degree()) a = elevated(a, b.degree() - a.degree());
  if (b.degree() < a.degree()) b = elevated(b, a.degree() - b.degree());
  const int degree = a.degree();
  const auto chopped = [degree](const NurbsCurve& curve, const NurbsCurve& other) {
    std::vector<double> missing;
    const Interval domain = curve.domain();
    const auto add = [&](double u) {
      if (!missing.empty() && missing.back() == u) return;
      missing.insert(missing.end(), degree + 1 - multiplicity(curve.knot_vector(), u), u);
    };
    std::vector<double> knots(curve.knot_vector().knots().begin(), curve.knot_vector().knots().end());
    knots.insert(knots.end(), other.knot_vector().knots().begin(), other.knot_vector().knots().end());
    std::ranges::sort(knots);
    for (const double u : knots) {
      if (domain.start <= u && u <= domain.end) add(u);
    }
    return missing.empty() ? curve : refine(curve, missing);
  };
  const NurbsCurve pieces_a = chopped(a, b);
  const NurbsCurve pieces_b = chopped(b, a);
  std::vector<Pair> pairs;
  const std::size_t order = degree + 1;
  const auto starts = pieces_a.knot_vector().spans();
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const auto take = [&](const NurbsCurve& curve) {
      const auto begin = curve.homogeneous_points().begin() + (curve.knot_vector().spans()[i] - degree);
      return std::vector<glm::dvec4>(begin, begin + static_cast<long>(order));
    };
    Pair pair{take(pieces_a), take(pieces_b), 0.0};
    pair.smallest_weight = std::max(largest_weight(pair.a), largest_weight(pair.b)) / 16.0;
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

}  // namespace

double largest_distance(const NurbsCurve& a, const NurbsCurve& b) {
  if (a.domain() != b.domain()) throw InvalidShape("the domains differ");
  constexpr double kSlack = 1.01;
  constexpr double kRounding = 0x1p-48;  // of the largest coordinate: no piece tells more
  constexpr int kMaxHalvings = 100'000;
  const double rounding = kRounding * std::max(largest_coordinate(a.points()), largest_coordinate(b.points()));
  const auto plain = [](const NurbsCurve& curve) { return curve.periodic() ? unrolled(curve) : curve; };
  double certain = 0.0;
  std::priority_queue<Pair> open;
  const auto push = [&](Pair pair) {
    if (is_off_to_infinity(pair)) return;
    certain = std::max(certain, end_distance(pair));
    pair.bound = hull_bound(pair);
    open.push(std::move(pair));
  };
  for (Pair& pair : pairs_of(plain(a), plain(b))) push(std::move(pair));
  for (int halvings = 0; halvings < kMaxHalvings && !open.empty(); ++halvings) {
    const Pair worst = open.top();
    if (worst.bound <= std::max(kSlack * certain, rounding)) break;
    open.pop();
    Pair left{{}, {}, worst.smallest_weight};
    Pair right = left;
    halve(worst.a, left.a, right.a);
    halve(worst.b, left.b, right.b);
    push(std::move(left));
    push(std::move(right));
  }
  return open.empty() ? certain : std::max(certain, open.top().bound);
}

}  // namespace splinecore
