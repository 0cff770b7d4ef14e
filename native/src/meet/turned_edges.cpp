#include "turned_edges.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "touching_place.hpp"

namespace splinecore {

namespace {

class EdgeCuts {
 public:
  EdgeCuts(const TwoPatches& patches, const SectionTrace& whole, const PatchContact& contact, double tolerance)
      : patches_(patches), whole_(whole), contact_(contact), tolerance_(tolerance) {
    for (const SectionPlace& place : whole.places) sines_.push_back(sine_at(place));
  }

  std::optional<SharedEdges> cut() {
    if (touches_along()) return {};
    SectionTrace edge{{places().front()}, false};
    std::size_t told = 0;
    for (std::size_t i = 1; i < places().size(); ++i) {
      const bool turns = tells(i) && tells(told) && (sines_[i] < 0.0) != (sines_[told] < 0.0);
      if (turns && i == told + 1 && is_joint(i)) {
        end(edge, places()[i]);
      } else if (turns && i == told + 1) {
        const SectionPlace turn = turn_between(places()[told], places()[i]);
        turn_at(edge, turn);
        edge.places.push_back(places()[i]);
      } else if (turns) {
        edge.places.push_back(places()[i]);
        cut_untold(edge, i - told);
      } else if (is_joint(i) && is_corner(places()[i - 1], places()[i])) {
        end(edge, places()[i]);
      } else {
        edge.places.push_back(places()[i]);
      }
      if (tells(i)) told = i;
    }
    end(edge, places().back());
    if (whole_.is_closed) close();
    return std::move(found_);
  }

 private:
  const std::vector<SectionPlace>& places() const { return whole_.places; }

  /// Of the angle between both, with a sign that tells to which side of the edge they part.
  double sine_at(const SectionPlace& place) const {
    return glm::dot(meeting_at(patches_, place.at).along, place.tangent);
  }

  bool tells(std::size_t i) const {
    constexpr double kNothing = 0x1p-30;
    return std::abs(sines_[i]) > kNothing;
  }

  bool is_joint(std::size_t i) const { return !places()[i - 1].has_pieces_of(places()[i]); }

  bool touches_along() const {
    constexpr double kPlainly = 0x1p-7;
    constexpr double kTolerances = 64.0;
    if (std::ranges::none_of(sines_, [](double sine) { return std::abs(sine) >= kPlainly; })) return true;
    for (std::size_t i = 1; i < places().size(); ++i) {
      if (tells(i - 1) || tells(i)) continue;
      if (glm::distance(places()[i - 1].point, places()[i].point) > kTolerances * tolerance_) return true;
    }
    return false;
  }

  bool is_corner(const SectionPlace& before, const SectionPlace& after) const {
    constexpr double kOne = 1e-9;
    const PatchMeeting here = meeting_at(patches_, before.at);
    const PatchMeeting there = meeting_at(patches_, after.at);
    const auto bends = [](const glm::dvec3& one, const glm::dvec3& other) { return glm::length(glm::cross(one, other)) > kOne; };
    return bends(here.normal_a, there.normal_a) || bends(here.normal_b, there.normal_b) ||
           bends(before.tangent, after.tangent);
  }

  /// The place between two others where the sine is zero.
  SectionPlace turn_between(const SectionPlace& from, const SectionPlace& to) const {
    constexpr int kHalvings = 48;
    const SectionStep step(from, to);
    const bool is_below = sine_at(from) < 0.0;
    Interval range{0.0, 1.0};
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = range.middle();
      ((sine_at(place_of(step, middle)) < 0.0) == is_below ? range.start : range.end) = middle;
    }
    return place_of(step, range.middle());
  }

  SectionPlace place_of(const SectionStep& step, double s) const {
    const glm::dvec3 way = glm::normalize(step.to.point - step.from.point);
    SectionPlace between{step.spots(s), step.point(s), way, {}};
    const auto at = contact_near(patches_, between.at, contact_, way, InPlane{between.point, way});
    if (at) between.at = *at;
    for (std::size_t i = 0; i < 4; ++i) between.at[i] = std::clamp(between.at[i], 0.0, 1.0);
    const auto found = touching_place(patches_, between.at, contact_, way, tolerance_);
    return found ? *found : between;
  }

  void end(SectionTrace& edge, const SectionPlace& next) {
    if (edge.places.size() > 1) found_.traces.push_back(std::move(edge));
    edge = {{next}, false};
  }

  void turn_at(SectionTrace& edge, const SectionPlace& turn) {
    edge.places.push_back(turn);
    found_.turns.push_back({turn.at, turn.point});
    end(edge, turn);
  }

  /// It turns at a place, or over so short a way, that nothing is told of.
  void cut_untold(SectionTrace& edge, std::size_t back) {
    const std::size_t begin = edge.places.size() - std::min(back, edge.places.size() - 1);
    SectionTrace rest{{edge.places.begin() + static_cast<std::ptrdiff_t>(begin), edge.places.end()}, false};
    edge.places.resize(begin);
    const SectionPlace turn = rest.places.front();
    turn_at(edge, turn);
    edge = std::move(rest);
  }

  /// Of one that goes round what is before its first cut goes on from what is behind the last one.
  void close() {
    std::vector<SectionTrace>& traces = found_.traces;
    if (traces.size() == 1 && found_.turns.empty()) {
      traces.front().is_closed = true;
      return;
    }
    if (traces.size() < 2 || is_corner(places().back(), places().front())) return;
    SectionTrace last = std::move(traces.back());
    traces.pop_back();
    std::vector<SectionPlace>& first = traces.front().places;
    if (last.places.back().has_pieces_of(first.front())) last.places.pop_back();
    first.insert(first.begin(), last.places.begin(), last.places.end());
  }

  TwoPatches patches_;
  const SectionTrace& whole_;
  PatchContact contact_;
  double tolerance_;
  std::vector<double> sines_;
  SharedEdges found_;
};

}  // namespace

std::optional<SharedEdges> cut_at_turns(const TwoPatches& patches, const SectionTrace& whole, const PatchContact& contact,
                                        double tolerance) {
  return EdgeCuts(patches, whole, contact, tolerance).cut();
}

}  // namespace splinecore
