#include "turned_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "base/rounding.hpp"
#include "touching_place.hpp"

namespace splinecore {

namespace {

/// How the patches part at a place of a step, of which 1 is its end.
struct EdgeSample {
  std::size_t step;
  double s;
  double sine;  ///< of the angle between both, with a sign that tells to which side of the edge they part
};

class EdgeCuts {
 public:
  EdgeCuts(const TwoPatches& patches, const SectionTrace& whole, const PatchContact& contact, double tolerance)
      : patches_(patches), whole_(whole), contact_(contact), tolerance_(tolerance) {}

  std::optional<SharedEdges> cut() {
    take_samples();
    find_touching();
    if (!crosses_plainly()) return {};
    edge_.places.push_back(places().front());
    auto sample = samples_.begin();
    for (std::size_t i = 1; i < places().size(); ++i) {
      for (; sample != samples_.end() && sample->step == i - 1; ++sample) {
        if (!touches_[i - 1]) go_to(*sample);
      }
      if (touches_[i - 1]) {
        edge_ = {{places()[i]}, false};
        told_ = {};
        if (i < touches_.size() && !touches_[i]) turn_at(places()[i]);
      } else if (is_joint(i) && is_end(i)) {
        if (touches_after(i)) turn_at(places()[i - 1]);
        end(places()[i]);
        told_ = {};
      } else {
        edge_.places.push_back(places()[i]);
      }
    }
    end(places().back());
    if (whole_.is_closed) close();
    return std::move(found_);
  }

 private:
  const std::vector<SectionPlace>& places() const { return whole_.places; }

  void take_samples() {
    for (std::size_t i = 0; i + 1 < places().size(); ++i) {
      if (is_joint(i + 1)) continue;
      const SectionStep step(places()[i], places()[i + 1]);
      if (i == 0 || is_joint(i)) samples_.push_back({i, 0.0, sine_at(step.from)});
      for (const double s : between_ends(step)) samples_.push_back({i, s, sine_at(place_of(step, s))});
      samples_.push_back({i, 1.0, sine_at(step.to)});
    }
  }

  /// More where a step goes along much of a piece, and close to ends at which nothing tells, as poles are.
  std::vector<double> between_ends(const SectionStep& step) const {
    constexpr double kOfPiece = 24.0;
    constexpr int kHalvings = 12;
    const std::size_t along = contact_.border.parameter ^ 1U;
    const int count = 2 + static_cast<int>(kOfPiece * std::abs(step.to.at[along] - step.from.at[along]));
    std::vector<double> found;
    if (!tells({0, 0.0, sine_at(step.from)})) {
      for (int k = kHalvings; k > 0; --k) found.push_back(std::ldexp(1.0, -k) / count);
    }
    for (int k = 1; k < count; ++k) found.push_back(static_cast<double>(k) / count);
    if (!tells({0, 1.0, sine_at(step.to)})) {
      for (int k = 1; k <= kHalvings; ++k) found.push_back(1.0 - std::ldexp(1.0, -k) / count);
    }
    return found;
  }

  /// 0 where one has no normal up to rounding, as at poles.
  double sine_at(const SectionPlace& place) const {
    const PatchMeeting here = meeting_at(patches_, place.at);
    if (!has_normal(here.a, patches_.a) || !has_normal(here.b, patches_.b)) return 0.0;
    return glm::dot(here.along, place.tangent);
  }

  static bool has_normal(const Slopes<2>& at, const PatchPieces& pieces) {
    const double longer = std::max(glm::length(at.first[0]), glm::length(at.first[1]));
    return glm::length(glm::cross(at.first[0], at.first[1])) > kRoundingOfTouch * longer * pieces.extent();
  }

  static bool tells(const EdgeSample& sample) {
    constexpr double kNothing = 0x1p-30;
    return std::abs(sample.sine) > kNothing;
  }

  bool is_joint(std::size_t i) const { return !places()[i - 1].has_pieces_of(places()[i]); }

  /// The steps in pieces along which the patches touch, as beside a level face of terrain. A joint does as the step before it.
  void find_touching() {
    touches_.assign(places().size() - 1, false);
    for (std::size_t first = 0; first < touches_.size();) {
      std::size_t end = first + 1;
      while (end < touches_.size() && !is_joint(end + 1)) ++end;
      if (end < touches_.size()) ++end;
      std::fill(touches_.begin() + static_cast<std::ptrdiff_t>(first), touches_.begin() + static_cast<std::ptrdiff_t>(end),
                touches_along({first, end}));
      first = end;
    }
  }

  /// Whether steps of one piece lie along a curve of touch: so far nothing tells.
  bool touches_along(const std::array<std::size_t, 2>& steps) const {
    constexpr double kTolerances = 64.0;
    const auto is_here = [&](const EdgeSample& of) { return of.step >= steps[0] && of.step < steps[1]; };
    const auto point = [&](const EdgeSample& of) {
      return SectionStep(places()[of.step], places()[of.step + 1]).point(of.s);
    };
    for (std::size_t i = 1; i < samples_.size(); ++i) {
      if (!is_here(samples_[i - 1]) || !is_here(samples_[i]) || tells(samples_[i - 1]) || tells(samples_[i])) continue;
      if (glm::distance(point(samples_[i - 1]), point(samples_[i])) > kTolerances * tolerance_) return true;
    }
    return false;
  }

  /// Beside a piece along which they touch, which ends at a crease, a smaller angle tells.
  bool crosses_plainly() const {
    constexpr double kPlainly = 0x1p-7;
    constexpr double kTolerances = 64.0;
    const bool has_crease = std::ranges::any_of(touches_, [](bool is) { return is; });
    const double least = has_crease ? std::min(kPlainly, kTolerances * tolerance_) : kPlainly;
    return std::ranges::any_of(samples_, [&](const EdgeSample& of) {
      return !touches_[of.step] && std::abs(of.sine) >= least;
    });
  }

  bool touches_after(std::size_t joint) const { return joint < touches_.size() && touches_[joint]; }

  bool is_end(std::size_t joint) const {
    return touches_after(joint) || is_corner(places()[joint - 1], places()[joint]);
  }

  /// Where the patches part from a curve of touch, or come to one.
  void turn_at(const SectionPlace& place) { found_.turns.push_back({place.at, place.point}); }

  void go_to(const EdgeSample& sample) {
    if (!tells(sample)) return;
    const std::optional<EdgeSample> before = std::exchange(told_, sample);
    if (!before || (before->sine < 0.0) == (sample.sine < 0.0)) return;
    const SectionStep step(places()[sample.step], places()[sample.step + 1]);
    const double from = before->step == sample.step ? before->s : 0.0;
    const SectionPlace turn = turn_between(step, {from, sample.s}, before->sine < 0.0);
    edge_.places.push_back(turn);
    turn_at(turn);
    end(turn);
  }

  bool is_corner(const SectionPlace& before, const SectionPlace& after) const {
    constexpr double kOne = 1e-9;
    const PatchMeeting here = meeting_at(patches_, before.at);
    const PatchMeeting there = meeting_at(patches_, after.at);
    const auto bends = [](const glm::dvec3& one, const glm::dvec3& other) { return glm::length(glm::cross(one, other)) > kOne; };
    return bends(here.normal_a, there.normal_a) || bends(here.normal_b, there.normal_b) ||
           bends(before.tangent, after.tangent);
  }

  /// The place within a range of a step where the sine is zero.
  SectionPlace turn_between(const SectionStep& step, Interval range, bool is_below) const {
    constexpr int kHalvings = 48;
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

  void end(const SectionPlace& next) {
    if (edge_.places.size() > 1) found_.traces.push_back(std::move(edge_));
    edge_ = {{next}, false};
  }

  /// Of one that goes round what is before its first cut goes on from what is behind the last one.
  void close() {
    std::vector<SectionTrace>& traces = found_.traces;
    if (touches_.front() != touches_.back()) turn_at(touches_.front() ? places().back() : places().front());
    if (touches_.front() || touches_.back()) return;
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
  std::vector<EdgeSample> samples_;
  std::vector<bool> touches_;       ///< steps
  std::optional<EdgeSample> told_;  ///< the last sample that tells
  SectionTrace edge_{{}, false};    ///< since the last cut
  SharedEdges found_;
};

}  // namespace

std::optional<SharedEdges> cut_at_turns(const TwoPatches& patches, const SectionTrace& whole, const PatchContact& contact,
                                        double tolerance) {
  return EdgeCuts(patches, whole, contact, tolerance).cut();
}

}  // namespace splinecore
