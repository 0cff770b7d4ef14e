#include "joined_traces.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

/// End 2 i of trace i is its first place, end 2 i + 1 the last one.
constexpr std::size_t opposite(std::size_t end) { return end ^ 1U; }

class TraceJoints {
 public:
  TraceJoints(const TwoPatches& patches, const std::vector<SectionTrace>& traces, const IsCurveEnd& is_end,
              double distance)
      : patches_(patches), traces_(traces), is_end_(is_end), distance_(distance), partners_(2 * traces.size()),
        is_used_(traces.size(), false) {}

  std::vector<SectionTrace> joined() {
    find_partners();
    std::vector<SectionTrace> found;
    for (const bool is_round : {false, true}) {
      for (std::size_t i = 0; i < traces_.size(); ++i) {
        if (is_used_[i] || (!is_round && partners_[2 * i] && partners_[2 * i + 1])) continue;
        found.push_back(chain_from(partners_[2 * i] ? 2 * i + 1 : 2 * i));
      }
    }
    return found;
  }

 private:
  const SectionPlace& place(std::size_t end) const {
    const std::vector<SectionPlace>& places = traces_[end / 2].places;
    return end % 2 == 0 ? places.front() : places.back();
  }
  glm::dvec3 way_out(std::size_t end) const { return end % 2 == 0 ? -place(end).tangent : place(end).tangent; }

  /// Each end has one partner at most.
  void find_partners() {
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < traces_.size(); ++i) {
      if (traces_[i].is_closed || traces_[i].places.size() < 2) continue;
      ends.push_back(2 * i);
      ends.push_back(2 * i + 1);
    }
    std::ranges::stable_sort(ends, {}, [&](std::size_t end) { return place(end).point.x; });
    std::vector<std::vector<std::size_t>> near(partners_.size());
    for (std::size_t i = 0; i < ends.size(); ++i) {
      for (std::size_t k = i + 1; k < ends.size(); ++k) {
        breathe(4);
        if (place(ends[k]).point.x - place(ends[i]).point.x > distance_) break;
        if (glm::distance(place(ends[k]).point, place(ends[i]).point) > distance_) continue;
        near[ends[i]].push_back(ends[k]);
        near[ends[k]].push_back(ends[i]);
      }
    }
    for (const std::size_t end : ends) {
      if (near[end].size() != 1 || near[near[end].front()].size() != 1) continue;
      if (go_on(end, near[end].front())) partners_[end] = near[end].front();
    }
  }

  bool go_on(std::size_t one, std::size_t other) const {
    constexpr double kBack = 0.9;
    if (!(glm::dot(way_out(one), way_out(other)) < kBack)) return false;
    if (one == opposite(other) && !is_long(traces_[one / 2])) return false;
    const SectionPlace& from = place(one);
    const SectionPlace& to = place(other);
    if (is_end_(from.point) || is_end_(to.point)) return false;
    return are_beside(patches_.a, from.at.a, to.at.a) && are_beside(patches_.b, from.at.b, to.at.b);
  }

  bool is_long(const SectionTrace& trace) const {
    const glm::dvec3& start = trace.places.front().point;
    return std::ranges::any_of(trace.places, [&](const SectionPlace& at) {
      return glm::distance(at.point, start) > 4.0 * distance_;
    });
  }

  static bool are_beside(const PatchPieces& pieces, const PatchSpot& one, const PatchSpot& other) {
    constexpr double kNear = 0x1p-8;
    return std::ranges::any_of(pieces.twins(one, kNear), [&](const PatchSpot& twin) {
      return twin.piece == other.piece && std::abs(twin.at[0] - other.at[0]) <= kNear &&
             std::abs(twin.at[1] - other.at[1]) <= kNear;
    });
  }

  /// All that follows from an end, which is the first place.
  SectionTrace chain_from(std::size_t first) {
    SectionTrace chain{{}, traces_[first / 2].is_closed};
    std::size_t end = first;
    while (true) {
      is_used_[end / 2] = true;
      append(chain.places, end);
      const std::optional<std::size_t> next = partners_[opposite(end)];
      if (!next) return chain;
      if (is_used_[*next / 2]) break;
      end = *next;
    }
    chain.is_closed = true;
    settle(chain.places.back(), chain.places.front());
    return chain;
  }

  void append(std::vector<SectionPlace>& places, std::size_t end) const {
    std::vector<SectionPlace> more = traces_[end / 2].places;
    if (end % 2 == 1) {
      std::ranges::reverse(more);
      for (SectionPlace& at : more) at = at.backwards();
    }
    if (!places.empty()) {
      if (more.front().has_pieces_of(places.back())) places.pop_back();
      else settle(more.front(), places.back());
    }
    places.insert(places.end(), more.begin(), more.end());
  }

  /// Two places of a joint are one point.
  static void settle(SectionPlace& place, const SectionPlace& other) {
    if (place.has_pieces_of(other)) {
      place = other;
    } else {
      place.point = other.point;
    }
  }

  TwoPatches patches_;
  const std::vector<SectionTrace>& traces_;
  const IsCurveEnd& is_end_;
  double distance_;
  std::vector<std::optional<std::size_t>> partners_;
  std::vector<bool> is_used_;
};

}  // namespace

std::vector<SectionTrace> joined_traces(const TwoPatches& patches, const std::vector<SectionTrace>& traces,
                                        const IsCurveEnd& is_end, double distance) {
  return TraceJoints(patches, traces, is_end, distance).joined();
}

}  // namespace splinecore
