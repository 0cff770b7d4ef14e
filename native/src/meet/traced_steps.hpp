#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <vector>

#include "crossing_part.hpp"
#include "patch_march.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Curves that two patches have in common, as far as they are known, and in which pieces their steps are.
class TracedSteps {
 public:
  TracedSteps(const TwoPatches& patches, double tolerance) : patches_(patches), tolerance_(tolerance) {}

  void add(SectionTrace trace);
  const std::vector<SectionTrace>& traces() const noexcept { return traces_; }

  /// Whether a place is on one of the curves.
  bool holds(const SectionPlace& place) const;

  /// Whether one of the curves goes through a place and has its tangent there.
  bool holds_along(const SectionPlace& place) const;

  /// What of a curve does not run along others that are known, by one of which it was passed by at a place where patches touch.
  /// Nothing is left where all of it does.
  SectionTrace without_known_ends(SectionTrace trace) const;

  /// Whether a curve is so near to a point.
  bool are_near(const glm::dvec3& point, double distance) const;

  /// Ranges of the leading parameter for which no curve is in the part, though the part may have one.
  std::vector<Interval> gaps(const CrossingPart& part) const;

 private:
  static constexpr std::size_t kSamples = 5;

  struct Step {
    std::size_t trace;
    std::size_t step;
    std::array<FourParameters, kSamples> at;  ///< from its start to its end
  };
  using Pieces = std::array<std::size_t, 2>;

  void put(const Pieces& pieces, const Step& step);
  const std::vector<Step>* steps_in(const Pieces& pieces) const;
  bool runs_along(const SectionPlace& place) const;
  bool is_on(const Step& which, const SectionPlace& place, double sine) const;
  bool is_within(const Step& which, const SectionPlace& place, double sine) const;

  TwoPatches patches_;
  double tolerance_;
  std::vector<SectionTrace> traces_;
  std::map<Pieces, std::vector<Step>> steps_;
};

}  // namespace splinecore
#pragma GCC visibility pop
