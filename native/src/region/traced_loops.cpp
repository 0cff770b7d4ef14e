#include "traced_loops.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <map>
#include <span>

#include "measure/signs.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

std::size_t start_of(const Arrangement& all, const GroupedEdge& one) {
  const ArrangedEdge& edge = all.edges[one.edge];
  return one.is_reversed ? edge.to : edge.from;
}

std::size_t end_of(const Arrangement& all, const GroupedEdge& one) {
  const ArrangedEdge& edge = all.edges[one.edge];
  return one.is_reversed ? edge.from : edge.to;
}

/// An edge as it is seen from one of its ends.
class EdgeWay {
 public:
  EdgeWay(const NurbsCurve& curve, bool is_from_end, const glm::dvec3& vertex) : curve_(curve), is_from_end_(is_from_end), vertex_(vertex) {
    for (int k = 1; k <= kLooks; ++k) far_ = std::max(far_, glm::length(way_at(static_cast<double>(k) / kLooks)));
  }

  /// How far it goes.
  double reach() const { return far_; }

  /// The way to where it is first so far.
  glm::dvec3 way_to(double radius) const {
    double near = 0.0;
    double far = 1.0;
    for (int k = 1; k <= kLooks; ++k) {
      const double t = static_cast<double>(k) / kLooks;
      far = t;
      if (glm::length(way_at(t)) >= radius) break;
      near = t;
    }
    constexpr int kHalvings = 50;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (near + far);
      (glm::length(way_at(middle)) >= radius ? far : near) = middle;
    }
    return way_at(far);
  }

 private:
  static constexpr int kLooks = 64;

  glm::dvec3 way_at(double t) const {
    const Interval domain = curve_.domain();
    const double at = std::lerp(domain.start, domain.end, is_from_end_ ? 1.0 - t : t);
    glm::dvec3 point;
    evaluate(curve_, {&at, 1}, std::span(&point.x, 3));
    return point - vertex_;
  }

  const NurbsCurve& curve_;
  bool is_from_end_;
  const glm::dvec3& vertex_;
  double far_ = 0.0;
};

/// Whether the way from the middle to a is turned less from x than that to b.
bool comes_before(const glm::dvec2& a, const glm::dvec2& b) {
  const auto is_below = [](const glm::dvec2& p) { return p.y < 0.0 || (p.y == 0.0 && p.x < 0.0); };
  if (is_below(a) != is_below(b)) return is_below(b);
  return a.x * b.y - a.y * b.x > 0.0;
}

/// An edge at a vertex.
struct VertexEnd {
  std::size_t edge;  ///< of those that are put together
  bool comes_in;
  glm::dvec2 way;
};

class LoopTracer {
 public:
  LoopTracer(const Arrangement& all, const std::vector<GroupedEdge>& edges, const glm::dvec3& normal)
      : all_(all), edges_(edges), view_(normal), next_(edges.size(), edges.size()) {}

  std::vector<std::vector<GroupedEdge>> loops() {
    follow();
    std::vector<std::vector<GroupedEdge>> found;
    std::vector<bool> is_done(edges_.size(), false);
    for (std::size_t first = 0; first < edges_.size(); ++first) {
      std::vector<GroupedEdge> round;
      for (std::size_t i = first; !is_done[i]; i = next_[i]) {
        is_done[i] = true;
        round.push_back(edges_[i]);
      }
      if (round.empty()) continue;
      for (auto& loop : cut_at_repeated_vertices(all_, round)) found.push_back(std::move(loop));
    }
    return found;
  }

 private:
  void follow() {
    std::map<std::size_t, std::vector<VertexEnd>> vertices;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      vertices[start_of(all_, edges_[i])].push_back({i, false, {}});
      vertices[end_of(all_, edges_[i])].push_back({i, true, {}});
    }
    for (auto& [vertex, ends] : vertices) {
      if (ends.size() > 2) put_in_order(vertex, ends);
      for (std::size_t k = 0; k < ends.size(); ++k) {
        // What is inside lies between an edge that comes in and the next one clockwise.
        const VertexEnd& end = ends[k];
        const VertexEnd& other = ends[(k + ends.size() - 1) % ends.size()];
        if (end.comes_in == other.comes_in) throw InvalidShape(kUndecided);
        if (end.comes_in) next_[end.edge] = other.edge;
      }
    }
  }

  void put_in_order(std::size_t vertex, std::vector<VertexEnd>& ends) const {
    std::vector<EdgeWay> rays;
    double radius = std::numeric_limits<double>::infinity();
    for (const VertexEnd& end : ends) {
      const GroupedEdge& edge = edges_[end.edge];
      rays.emplace_back(all_.edges[edge.edge].curve, end.comes_in != edge.is_reversed, all_.vertices[vertex]);
      radius = std::min(radius, 0.5 * rays.back().reach());
    }
    for (std::size_t k = 0; k < ends.size(); ++k) ends[k].way = view_.seen(rays[k].way_to(radius));
    std::ranges::stable_sort(ends, comes_before, &VertexEnd::way);
  }

  static constexpr const char* kUndecided =
      "outlines run along each other within the tolerance so that it does not tell what lies between them: another tolerance may";

  const Arrangement& all_;
  const std::vector<GroupedEdge>& edges_;
  View view_;
  std::vector<std::size_t> next_;
};

}  // namespace

std::vector<std::vector<GroupedEdge>> cut_at_repeated_vertices(const Arrangement& arrangement,
                                                               const std::vector<GroupedEdge>& round) {
  std::vector<std::vector<GroupedEdge>> loops;
  std::vector<GroupedEdge> path;
  for (const GroupedEdge& edge : round) {
    path.push_back(edge);
    const std::size_t here = end_of(arrangement, edge);
    const auto begins = [&](const GroupedEdge& one) { return start_of(arrangement, one) == here; };
    const auto from = std::ranges::find_if(path, begins);
    if (from == path.end()) continue;
    loops.emplace_back(from, path.end());
    path.erase(from, path.end());
  }
  return loops;
}

std::vector<std::vector<GroupedEdge>> traced_loops(const Arrangement& arrangement, const std::vector<GroupedEdge>& edges,
                                                   const glm::dvec3& normal) {
  return LoopTracer(arrangement, edges, normal).loops();
}

}  // namespace splinecore
