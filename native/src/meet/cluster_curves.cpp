#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "base/sort_by.hpp"
#include "curve_cluster.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

/// So many pairs of findings, of which all in one place are compared.
constexpr std::size_t kMostCompared = std::size_t{1} << 25;
constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// A finding: a stretch, or a crossing.
struct Node {
  const CurveStretch* stretch;
  const SpotPair* crossing;
  Interval a;  ///< places
  Interval b;
  Interval wide_a;  ///< with those around that may be within the tolerance
  Interval wide_b;

  int way() const noexcept { return stretch ? stretch->way : 0; }
  bool is_trivial() const noexcept { return stretch && stretch->is_trivial; }
};

/// Another finding that goes on where one is, if it is counted so many places further.
struct Link {
  std::size_t to;
  Turns turns;
};

/// A finding in a cluster, and where it is counted there.
struct LaidFinding {
  std::size_t node;
  Turns turns;
};

Interval moved(const Interval& in, double by) { return {in.start + by, in.end + by}; }
bool do_touch(const Interval& a, const Interval& b) { return a.start <= b.end && b.start <= a.end; }

class Gathering {
 public:
  Gathering(const TwoCurves& curves, const PairFindings& findings, double tolerance)
      : curves_(curves), tolerance_(tolerance), wide_(kWide * tolerance) {
    nodes_.reserve(findings.stretches.size() + findings.crossings.size());
    for (const CurveStretch& stretch : findings.stretches) nodes_.push_back(node_of(stretch));
    for (const SpotPair& crossing : findings.crossings) nodes_.push_back(node_of(crossing));
    links_.resize(nodes_.size());
    cluster_.assign(nodes_.size(), kNone);
    seen_by_.assign(nodes_.size(), kNone);
    turns_.resize(nodes_.size());
    hangs_on_.resize(nodes_.size());
    std::iota(hangs_on_.begin(), hangs_on_.end(), std::size_t{0});
  }

  std::vector<CurveCluster> clusters() {
    link_all();
    for (const std::size_t i : longest_first()) gather(i);
    for (std::size_t i = 0; i < nodes_.size(); ++i) gather(i);
    merge();
    std::vector<CurveCluster> found;
    for (const std::vector<LaidFinding>& members : members_) {
      if (!members.empty()) found.push_back(made_of(members));
    }
    return found;
  }

 private:
  /// Stretches with a way: what hangs together with several ways belongs to the longest.
  std::vector<std::size_t> longest_first() const {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (nodes_[i].way() != 0) order.push_back(i);
    }
    sort_by(order, [&](std::size_t i) {
      const CurveStretch& on = *nodes_[i].stretch;
      return -glm::distance(curves_.a.at({on.piece_a, on.a.start}).point, curves_.a.at({on.piece_a, on.a.end}).point);
    });
    return order;
  }

  Interval widened(const CurvePieces& curve, const Interval& in) const {
    return {in.start - curve.reach(in.start, -1.0, wide_), in.end + curve.reach(in.end, 1.0, wide_)};
  }

  Node node_of(const CurveStretch& s) const {
    breathe(256);
    const auto along = [](const CurvePieces& curve, std::size_t piece, const Interval& in) {
      const double start = curve.place({piece, 0.0});
      return Interval{start + in.start, start + in.end};
    };
    const Interval a = along(curves_.a, s.piece_a, s.a);
    const Interval b = along(curves_.b, s.piece_b, s.b);
    return {&s, nullptr, a, b, widened(curves_.a, a), widened(curves_.b, b)};
  }

  /// Curves that cross are within the tolerance as far as straight lines are.
  Node node_of(const SpotPair& at) const {
    breathe(256);
    const glm::dvec3 a = curves_.a.at(at.a).first[0];
    const glm::dvec3 b = curves_.b.at(at.b).first[0];
    const double area = glm::length(glm::cross(a, b));
    const double far = wide_ * (glm::length(a) * glm::length(b) / area);
    const auto widened_by = [&](const CurvePieces& curve, double place) {
      constexpr double kMost = 0.5;
      if (!(area > 0.0)) return Interval{place - kMost, place + kMost};
      return Interval{place - std::min(curve.reach(place, -1.0, far), kMost),
                      place + std::min(curve.reach(place, 1.0, far), kMost)};
    };
    const auto [place_a, place_b] = curves_.places(at);
    return {nullptr, &at, {place_a, place_a}, {place_b, place_b}, widened_by(curves_.a, place_a),
            widened_by(curves_.b, place_b)};
  }

  /// Along the first curve each finding is compared with those that are not yet behind.
  void link_all() {
    struct Laid {
      std::size_t node;
      double turn;
    };
    std::vector<Laid> order;
    const double turn = curves_.a.is_closed() ? curves_.a.turn() : 0.0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      order.push_back({i, 0.0});
      if (turn > 0.0 && nodes_[i].wide_a.start <= 0.0) order.push_back({i, turn});
    }
    sort_by(order, [&](const Laid& laid) { return nodes_[laid.node].wide_a.start + laid.turn; });
    std::vector<Laid> open;
    for (const Laid& laid : order) {
      breathe(16 * (open.size() + 1));
      compared_ += open.size();
      if (compared_ > kMostCompared) refuse();
      const Interval wide = moved(nodes_[laid.node].wide_a, laid.turn);
      std::erase_if(open, [&](const Laid& other) {
        return nodes_[other.node].wide_a.end + other.turn < wide.start;
      });
      for (const Laid& other : open) {
        if (other.node != laid.node) link(other.node, laid.node, laid.turn - other.turn);
      }
      open.push_back(laid);
    }
  }

  [[noreturn]] static void refuse() {
    throw InvalidShape("more than " + std::to_string(kMostCompared) +
                       " pairs of parts are within the tolerance in few places: they are one along too much of them, "
                       "or it is too small");
  }

  /// What a finding hangs on by way of others that go its way.
  std::size_t root_of(std::size_t i) {
    while (hangs_on_[i] != i) i = hangs_on_[i] = hangs_on_[hangs_on_[i]];
    return i;
  }

  bool go_one_way(std::size_t i, std::size_t j) const {
    return !nodes_[i].stretch == !nodes_[j].stretch && nodes_[i].way() == nodes_[j].way();
  }

  void link(std::size_t i, std::size_t j, double turn_a) {
    const Node& one = nodes_[i];
    const Node& other = nodes_[j];
    if (go_one_way(i, j) && root_of(i) == root_of(j)) return;
    const double turn_b = curves_.b.is_closed() ? curves_.b.turn() : 0.0;
    for (const double turns : {0.0, 1.0, -1.0}) {
      if (turns != 0.0 && turn_b == 0.0) break;
      const Turns by{turn_a, turns * turn_b};
      if (!do_touch(one.wide_b, moved(other.wide_b, by.b))) continue;
      if (!do_meet(one, other, by)) continue;
      links_[i].push_back({j, by});
      links_[j].push_back({i, {-by.a, -by.b}});
      if (go_one_way(i, j)) hangs_on_[root_of(j)] = root_of(i);
      return;
    }
  }

  /// Whether findings whose surroundings touch are one: stretches are, crossings where the curves are near all the way.
  bool do_meet(const Node& one, const Node& other, const Turns& by) const {
    if (one.stretch && other.stretch) return one.way() * other.way() <= 0 || do_go_on(one, other, by);
    const auto nearest = [](const Interval& in, const Interval& to) {
      return std::clamp(to.start, in.start, in.end);
    };
    const Interval other_a = moved(other.a, by.a);
    const Interval other_b = moved(other.b, by.b);
    const std::array<double, 2> from{nearest(one.a, other_a), nearest(one.b, other_b)};
    const std::array<double, 2> to{nearest(other_a, one.a), nearest(other_b, one.b)};
    constexpr double kSame = 0x1p-40;
    if (std::max(std::abs(from[0] - to[0]), std::abs(from[1] - to[1])) <= kSame) return true;
    return are_joined(curves_, from, to, wide_);
  }

  /// Whether stretches that go the same way have places of the second curve in common, too, where they have those of
  /// the first one: where a curve comes by a place more than once they may not.
  bool do_go_on(const Node& one, const Node& other, const Turns& by) const {
    const Interval other_a = moved(other.a, by.a);
    const Interval both{std::max(one.a.start, other_a.start), std::min(one.a.end, other_a.end)};
    const auto place_in = [&](const Interval& own) {
      return both.start <= both.end ? both.middle() : std::clamp(both.start, own.start, own.end);
    };
    const double of_one = beside(one, place_in(one.a));
    const double of_other = beside(other, place_in(other_a) - by.a) + by.b;
    const auto margin = [](const Node& node) {
      return std::max(node.b.start - node.wide_b.start, node.wide_b.end - node.b.end);
    };
    // Where the second curve stands still places far apart are one.
    return std::abs(of_one - of_other) <= margin(one) + margin(other) ||
           curves_.b.are_one(curves_.b.spot(of_one), curves_.b.spot(of_other), wide_);
  }

  /// The place of the second curve beside one of the first one in a stretch.
  double beside(const Node& node, double place) const {
    const CurveStretch& on = *node.stretch;
    const double t = std::clamp(place - curves_.a.place({on.piece_a, 0.0}), on.a.start, on.a.end);
    return curves_.b.place({on.piece_b, foot_of(curves_.b, on.piece_b, on.b, curves_.a.at({on.piece_a, t}).point)});
  }

  /// A new cluster of a finding and all that hang together with it, and do not go the other way. Findings without a
  /// way, as at a cusp, belong to all that they hang together with.
  void gather(std::size_t first) {
    if (cluster_[first] != kNone) return;
    const int way = nodes_[first].way();
    const std::size_t own = members_.size();
    members_.push_back({{first, {}}});
    cluster_[first] = own;
    turns_[first] = {};
    seen_by_[first] = own;
    for (std::size_t k = 0; k < members_[own].size(); ++k) {
      const LaidFinding from = members_[own][k];
      if (way != 0 && nodes_[from.node].crossing) continue;
      for (const Link& link : links_[from.node]) {
        const int way_there = nodes_[link.to].way();
        const bool is_free = cluster_[link.to] == kNone || (way != 0 && way_there == 0);
        if (!is_free || seen_by_[link.to] == own || way_there * way < 0) continue;
        const Turns turns{from.turns.a + link.turns.a, from.turns.b + link.turns.b};
        seen_by_[link.to] = own;
        members_[own].push_back({link.to, turns});
        if (cluster_[link.to] != kNone) continue;
        cluster_[link.to] = own;
        turns_[link.to] = turns;
      }
    }
  }

  /// Clusters that hang together and go opposite ways are two only where both are overlaps; what is none is a part of
  /// one that is.
  void merge() {
    are_overlaps_.assign(members_.size(), {});
    joined_into_.resize(members_.size());
    for (std::size_t i = 0; i < members_.size(); ++i) joined_into_[i] = {i, {}};
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      for (const Link& link : links_[i]) {
        const Link into = now_in(cluster_[i]);
        const Link from = now_in(cluster_[link.to]);
        if (into.to == from.to || (is_overlap(into.to) && is_overlap(from.to))) continue;
        const Turns here = plus(turns_[i], into.turns);
        const Turns there = plus(turns_[link.to], from.turns);
        join(into.to, from.to, {here.a + link.turns.a - there.a, here.b + link.turns.b - there.b});
      }
    }
  }

  static Turns plus(const Turns& one, const Turns& other) { return {one.a + other.a, one.b + other.b}; }

  /// The cluster that one was joined into, if it was, and where it is counted there.
  Link now_in(std::size_t cluster) {
    Link at{cluster, {}};
    while (joined_into_[at.to].to != at.to) {
      Link& step = joined_into_[at.to];
      const Link& next = joined_into_[step.to];
      if (next.to != step.to) step = {next.to, plus(step.turns, next.turns)};
      at = {step.to, plus(at.turns, step.turns)};
    }
    return at;
  }

  void join(std::size_t into, std::size_t from, const Turns& by) {
    const bool is_against = way_of(into) * way_of(from) < 0;
    const bool is_part = is_against && (is_overlap(into) || is_overlap(from));
    const bool is_left = is_part && is_overlap(into);
    std::vector<LaidFinding> joined = std::move(members_[from]);
    members_[from].clear();
    joined_into_[from] = {into, by};
    if (is_left) return;
    for (LaidFinding& member : joined) member.turns = plus(member.turns, by);
    if (is_part) {
      members_[into] = std::move(joined);
    } else {
      members_[into].insert(members_[into].end(), joined.begin(), joined.end());
    }
    are_overlaps_[into].reset();
  }

  int way_of(std::size_t cluster) const { return nodes_[members_[cluster].front().node].way(); }

  bool is_overlap(std::size_t cluster) {
    std::optional<bool>& known = are_overlaps_[cluster];
    if (!known) known = overlap_of(made_of(members_[cluster]), curves_, tolerance_).has_value();
    return *known;
  }

  CurveCluster made_of(const std::vector<LaidFinding>& members) const {
    CurveCluster cluster;
    for (const auto& [i, turns] : members) {
      const Node& node = nodes_[i];
      if (node.is_trivial()) cluster.set_trivial();
      if (node.crossing) {
        cluster.add(*node.crossing);
      } else {
        cluster.add(LaidStretch{*node.stretch, turns, moved(node.a, turns.a), moved(node.b, turns.b)});
      }
    }
    return cluster;
  }

  TwoCurves curves_;
  double tolerance_;
  double wide_;
  std::vector<Node> nodes_;
  std::vector<std::vector<Link>> links_;           ///< without those of what hangs together by others that go its way
  std::vector<std::size_t> hangs_on_;
  std::size_t compared_ = 0;
  std::vector<std::vector<LaidFinding>> members_;       ///< of clusters
  std::vector<std::optional<bool>> are_overlaps_;   ///< of clusters, where that is known
  std::vector<std::size_t> cluster_;               ///< of nodes
  std::vector<Link> joined_into_;                  ///< of clusters, themselves where they were not
  std::vector<std::size_t> seen_by_;               ///< the last cluster that a node was looked at for
  std::vector<Turns> turns_;                       ///< of nodes in their clusters
};

}  // namespace

std::vector<CurveCluster> clusters_of(const TwoCurves& curves, const PairFindings& findings, double tolerance) {
  return Gathering(curves, findings, tolerance).clusters();
}

}  // namespace splinecore
