#include "knot_removal.hpp"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <limits>
#include <queue>
#include <tuple>

#include "base/length.hpp"
#include "base/rounding.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {


double largest(const glm::dvec4& p) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z), std::abs(p.w)});
}

/// What the points of one line of the rows tell about a removal.
class LineCost {
 public:
  /// A point of the window.
  void add(const glm::dvec4& point) {
    least_ = std::min(least_, point.w);
    most_ = std::max(most_, point.w);
    size_ = std::max(size_, largest(point));
  }

  /// A point that moves by a residue.
  void add(const glm::dvec4& point, const glm::dvec4& residue) {
    biggest_ = std::max(biggest_, largest(residue));
    if (point.w == 0.0) return;
    const glm::dvec3 way = glm::dvec3(residue) - residue.w * (glm::dvec3(point) / point.w);
    way_ = std::max(way_, length_of(way));
  }

  /// A point that comes out.
  void add_new(const glm::dvec4& point) { is_of_one_sign_ = is_of_one_sign_ && point.w * least_ > 0.0; }

  double result() const {
    const double weight = std::max(std::abs(least_), std::abs(most_));
    const double smallest = std::min(std::abs(least_), std::abs(most_));
    const bool is_sure = is_of_one_sign_ && least_ * most_ > 0.0 && smallest > kRoundingOfShape * weight;
    if (is_sure) return way_ / smallest;
    // Where the weight may be zero, but for rounding, lengths tell nothing, but what is rounding is nothing.
    return biggest_ <= kRoundingOfShape * size_ && weight > 0.0 ? biggest_ / weight : HUGE_VAL;
  }

 private:
  double least_ = HUGE_VAL;
  double most_ = -HUGE_VAL;
  double size_ = 0.0;
  double biggest_ = 0.0;
  double way_ = 0.0;
  bool is_of_one_sign_ = true;
};

}  // namespace

/// The knots and rows around one that may go. Row 0 and the last stay; between them are the equations
/// row[j] = share[j] * new[j] + rest[j] * new[j - 1], one more than there are new rows.
struct KnotList::Window {
  std::vector<int> nodes;  ///< of rows 0 … and of the knots after them
  std::size_t rows = 0;    ///< 0 …, the kept ones with them
  int copies = 0;
  std::vector<double> share;
  std::vector<double> rest;
  std::vector<double> direction;  ///< the combination of the equations in which no new row has a part
  double length = 0.0;            ///< its squared length
  std::size_t dropped = 0;        ///< the equation that follows from the others

  std::size_t equations() const { return rows - 2; }
};

KnotList::KnotList(const KnotVector& knots, std::vector<glm::dvec4> rows, std::size_t width)
    : degree_(knots.degree()), width_(width), domain_(knots.domain()), rows_(std::move(rows)) {
  const auto given = knots.knots();
  const int count = static_cast<int>(given.size());
  for (int i = 0; i < count; ++i) nodes_.push_back({given[i], i - 1, i + 1 < count ? i + 1 : -1, i});
  rows_.resize(given.size() * width);
}

bool KnotList::is_inner(int i) const noexcept {
  const Node& node = nodes_[i];
  return node.knot > domain_.start && node.knot < domain_.end && nodes_[node.after].knot > node.knot;
}

double KnotList::rounding() const {
  double weight = 0.0;
  for (const glm::dvec4& p : rows_) weight = std::max(weight, std::abs(p.w));
  double largest = 0.0;
  for (const glm::dvec4& p : rows_) {
    if (std::abs(p.w) <= kRoundingOfShape * weight) continue;
    for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, std::abs(p[axis] / p.w));
  }
  return kRoundingOfShape * largest;
}

std::vector<int> KnotList::inner() const {
  std::vector<int> found;
  for (int i = 0; i >= 0; i = nodes_[i].after) {
    if (is_inner(i)) found.push_back(i);
  }
  return found;
}

KnotList::Window KnotList::window_of(int i) const {
  Window window;
  int first = i;
  for (int node = i; nodes_[node].knot == nodes_[i].knot; node = nodes_[node].before) ++window.copies;
  for (int step = 0; step <= degree_; ++step) first = nodes_[first].before;
  window.rows = degree_ - window.copies + 3;
  const std::size_t count = window.rows + degree_ + 1;
  for (int node = first; node >= 0 && window.nodes.size() < count; node = nodes_[node].after) {
    window.nodes.push_back(node);
  }
  const double u = nodes_[i].knot;
  const std::size_t equations = window.equations();
  double direction = 1.0;
  for (std::size_t j = 1; j <= equations; ++j) {
    const double low = nodes_[window.nodes[j]].knot;
    const double high = nodes_[window.nodes[j + degree_ + 1]].knot;
    window.share.push_back((u - low) / (high - low));
    window.rest.push_back((high - u) / (high - low));
    if (j > 1) direction *= -window.share[j - 2] / window.rest[j - 1];
    window.direction.push_back(direction);
    window.length += direction * direction;
    if (std::abs(direction) > std::abs(window.direction[window.dropped])) window.dropped = j - 1;
  }
  return window;
}

namespace {

/// The rows of one line that come out of a window, and how far each equation misses.
struct Solution {
  std::vector<glm::dvec4> made;
  std::vector<glm::dvec4> residues;
};

template <class Window>
Solution solved(const Window& window, const std::vector<glm::dvec4>& rows) {
  const std::size_t equations = window.equations();
  const glm::dvec4& first = rows.front();
  const glm::dvec4& last = rows.back();
  if (equations == 0) return {{0.5 * first + 0.5 * last}, {0.5 * first - 0.5 * last}};
  glm::dvec4 missed(0.0);
  for (std::size_t j = 0; j < equations; ++j) {
    glm::dvec4 side = rows[j + 1];
    if (j == 0) side -= window.rest[0] * first;
    if (j == equations - 1) side -= window.share[j] * last;
    missed += window.direction[j] * side;
  }
  Solution solution{std::vector<glm::dvec4>(equations - 1), {}};
  for (const double direction : window.direction) solution.residues.push_back(direction / window.length * missed);
  for (std::size_t j = 0; j < window.dropped; ++j) {
    const glm::dvec4& before = j == 0 ? first : solution.made[j - 1];
    solution.made[j] = (rows[j + 1] - solution.residues[j] - window.rest[j] * before) / window.share[j];
  }
  for (std::size_t j = equations - 1; j > window.dropped; --j) {
    const glm::dvec4& after = j == equations - 1 ? last : solution.made[j];
    solution.made[j - 1] = (rows[j + 1] - solution.residues[j] - window.share[j] * after) / window.rest[j];
  }
  return solution;
}

}  // namespace

double KnotList::cost(int i) const {
  const Window window = window_of(i);
  breathe(16 * window.rows * width_);
  std::vector<glm::dvec4> line(window.rows);
  double most = 0.0;
  for (std::size_t k = 0; k < width_; ++k) {
    LineCost cost;
    for (std::size_t j = 0; j < window.rows; ++j) cost.add(line[j] = row(window.nodes[j])[k]);
    const Solution solution = solved(window, line);
    for (std::size_t j = 0; j < solution.residues.size(); ++j) {
      cost.add(window.equations() == 0 ? solution.made[0] : line[j + 1], solution.residues[j]);
    }
    for (const glm::dvec4& point : solution.made) cost.add_new(point);
    const double here = cost.result();
    most = here >= 0.0 ? std::max(most, here) : HUGE_VAL;
  }
  return most;
}

double KnotList::reach(int i) const {
  const Window window = window_of(i);
  return nodes_[window.nodes.back()].knot - nodes_[window.nodes.front()].knot;
}

int KnotList::remove(int i) {
  const Window window = window_of(i);
  const std::size_t changed = window.equations() == 0 ? 0 : 1;  // where the new rows begin
  std::vector<glm::dvec4> line(window.rows);
  const std::size_t made = window.equations() == 0 ? 1 : window.equations() - 1;
  for (std::size_t k = 0; k < width_; ++k) {
    for (std::size_t j = 0; j < window.rows; ++j) line[j] = row(window.nodes[j])[k];
    const Solution solution = solved(window, line);
    for (std::size_t j = 0; j < made; ++j) row(window.nodes[changed + j])[k] = solution.made[j];
  }
  if (window.equations() > 0 || !std::equal(row(window.nodes[0]), row(window.nodes[0]) + width_, row(window.nodes[1]))) {
    for (std::size_t j = 0; j < made; ++j) nodes_[window.nodes[changed + j]].origin = -1;
  }
  // Every row after them belongs to a knot one before.
  for (int node = window.nodes[changed + made]; node != i; node = nodes_[node].after) {
    const int next = nodes_[node].after;
    std::copy_n(row(next), width_, row(node));
    nodes_[node].origin = nodes_[next].origin;
  }
  const Node gone = nodes_[i];
  nodes_[gone.before].after = gone.after;
  nodes_[gone.after].before = gone.before;
  nodes_[gone.before].error = std::max(nodes_[gone.before].error, gone.error);
  return gone.before;
}

void KnotList::add_error(int i, double error) {
  for (const int node : window_of(i).nodes) nodes_[node].error += error;
}

double KnotList::error_around(int i) const {
  double most = 0.0;
  for (const int node : window_of(i).nodes) most = std::max(most, nodes_[node].error);
  return most;
}

std::vector<int> KnotList::around(int before) const {
  int node = before;
  const int steps = 2 * degree_ + 2;
  for (int k = 0; k < steps && nodes_[node].before >= 0; ++k) node = nodes_[node].before;
  std::vector<int> found;
  for (int k = 0; k < 2 * steps && node >= 0; ++k, node = nodes_[node].after) {
    if (nodes_[node].after >= 0 && is_inner(node)) found.push_back(node);
  }
  return found;
}

KnotList::Rest KnotList::rest_of(const std::vector<int>& nodes) const {
  std::vector<double> knots;
  for (const int node : nodes) knots.push_back(nodes_[node].knot);
  Rest rest{KnotVector::make(degree_, std::move(knots)), {}, {}};
  for (int i = 0; i < rest.knots.count(); ++i) {
    rest.rows.insert(rest.rows.end(), row(nodes[i]), row(nodes[i]) + width_);
    rest.origins.push_back(nodes_[nodes[i]].origin);
  }
  return rest;
}

KnotList::Rest KnotList::rest() const {
  std::vector<int> nodes;
  for (int i = 0; i >= 0; i = nodes_[i].after) nodes.push_back(i);
  return rest_of(nodes);
}

KnotList::Rest KnotList::around_of(int i) const {
  const Window window = window_of(i);
  int first = window.nodes.front();
  int last = window.nodes.back();
  for (int step = 0; step < degree_ && nodes_[first].before >= 0; ++step) first = nodes_[first].before;
  for (int step = 0; step < degree_ && nodes_[last].after >= 0; ++step) last = nodes_[last].after;
  std::vector<int> nodes{first};
  while (nodes.back() != last) nodes.push_back(nodes_[nodes.back()].after);
  return rest_of(nodes);
}

std::vector<int> removal_order(KnotList list, double tolerance, std::span<const double> kept, const Judge& judge) {
  // Costs that are rounding count alike, and then the shortest reach goes first: so steps stay of like size.
  const double rounding = list.rounding();
  // Residues alternate: the sum of them may be smaller than the largest by the condition of the functions.
  const double doubtful = std::ldexp(tolerance, list.degree());
  struct Candidate {
    double rank;
    double cost;
    double reach;
    int knot;
    int stamp;
    bool operator<(const Candidate& other) const {
      return std::tie(rank, reach, knot) > std::tie(other.rank, other.reach, other.knot);
    }
  };
  std::priority_queue<Candidate> candidates;
  std::vector<int> stamps;
  const auto consider = [&](int i) {
    stamps.resize(std::max(stamps.size(), static_cast<std::size_t>(i) + 1));
    const int stamp = ++stamps[i];
    if (std::ranges::binary_search(kept, list.knot(i))) return;
    double cost = list.cost(i);
    if (cost > tolerance && (cost <= doubtful || !std::isfinite(cost))) cost = std::min(cost, judge(list, i));
    if (cost <= tolerance) candidates.push({cost <= rounding ? 0.0 : cost, cost, list.reach(i), i, stamp});
  };
  for (const int i : list.inner()) consider(i);
  std::vector<int> order;
  while (!candidates.empty()) {
    const Candidate best = candidates.top();
    candidates.pop();
    if (best.stamp != stamps[best.knot]) continue;
    if (!(list.error_around(best.knot) + best.cost <= tolerance)) continue;
    list.add_error(best.knot, best.cost);
    order.push_back(best.knot);
    stamps[best.knot] = -1;
    for (const int i : list.around(list.remove(best.knot))) consider(i);
  }
  return order;
}

}  // namespace splinecore
