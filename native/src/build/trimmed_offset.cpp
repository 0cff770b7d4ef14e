#include "trimmed_offset.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <utility>

#include "base/rounding.hpp"
#include "curve_parts.hpp"
#include "offset_loops.hpp"
#include "splinecore/base/interval.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/convert/to_bezier.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/meet/intersections.hpp"
#include "splinecore/meet/nearest.hpp"

namespace splinecore {

namespace {

/// A parameter that runs on over the end of a closed curve.
double inside(const NurbsCurve& curve, double parameter) {
  const Interval domain = curve.domain();
  return parameter > domain.end ? std::min(parameter - domain.length(), domain.end) : parameter;
}

/// Where a curve at the distance is cut, and its stretches that another one runs along, too, in the same direction.
struct Cuts {
  std::vector<double> at;
  std::vector<Interval> doubled;

  bool are_doubled(const Interval& between) const {
    return std::ranges::any_of(doubled, [&](const Interval& range) { return between.middle() > range.start && between.middle() < range.end; });
  }
};

/// Where curves at the distance meet.
std::vector<Cuts> cuts_of(const std::vector<NurbsCurve>& raw, std::size_t count) {
  std::vector<Cuts> cuts(raw.size());
  const auto add = [&](const CurveIntersections& found, std::size_t i, std::size_t j) {
    for (const CurveIntersection& place : found.places) {
      cuts[i].at.push_back(place.a);
      cuts[j].at.push_back(place.b);
    }
    for (const CurveOverlap& overlap : found.overlaps) {
      const double end = inside(raw[j], overlap.b.end);
      cuts[i].at.insert(cuts[i].at.end(), {overlap.a.start, inside(raw[i], overlap.a.end)});
      cuts[j].at.insert(cuts[j].at.end(), {overlap.b.start, end});
      if (overlap.is_reversed || j >= count) continue;
      const Interval domain = raw[j].domain();
      if (end < overlap.b.start) {
        cuts[j].doubled.insert(cuts[j].doubled.end(), {{overlap.b.start, domain.end}, {domain.start, end}});
      } else {
        cuts[j].doubled.push_back({overlap.b.start, end});
      }
    }
  };
  for (std::size_t i = 0; i < count; ++i) {
    add(self_intersections(raw[i]), i, i);
    for (std::size_t j = i + 1; j < raw.size(); ++j) add(intersections(raw[i], raw[j]), i, j);
  }
  return cuts;
}

/// In order, those that are farther from the one before than that; the last one stays.
std::vector<double> distinct(std::vector<double> values, double same) {
  std::ranges::sort(values);
  const double last = values.back();
  const auto are_one = [&](double a, double b) { return b - a <= same; };
  values.erase(std::unique(values.begin(), values.end(), are_one), values.end());
  values.back() = last;
  return values;
}

std::vector<glm::dvec3> places_of(const NurbsCurve& curve, std::span<const double> at) {
  std::vector<glm::dvec3> points(at.size());
  evaluate(curve, at, std::span(&points[0].x, 3 * points.size()));
  return points;
}

/// Part of a curve that is far enough from another: whole between cuts, or not.
struct FarStretch {
  Interval range;
  bool is_whole;
};

/// Finds stretches of a curve that are far enough from another.
class FarStretches {
 public:
  /// @param enough  distances in the space: from the least one on it is far enough, beyond the greatest one on tips alone
  FarStretches(const NurbsCurve& curve, const NearSpace& space, const NurbsCurve& raw, const SharpTips& tips, const Interval& enough)
      : curve_(curve), space_(space), raw_(raw), tips_(tips), enough_(enough) {}

  /// Between cuts a curve is seldom far in one part and near in another: where it only touches what it is cut with.
  void add(const Interval& between, std::vector<FarStretch>& out) const {
    const std::vector<double> places = places_in(between);
    const std::vector<bool> far = are_far(places);
    if (std::ranges::find(far, false) == far.end()) {
      const bool goes_on = !out.empty() && out.back().is_whole && out.back().range.end == between.start;
      if (goes_on) {
        out.back().range.end = between.end;
      } else {
        out.push_back({between, true});
      }
      return;
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (!far[i]) continue;
      const double start = i == 0 ? between.start : border(places[i], places[i - 1]);
      while (i + 1 < places.size() && far[i + 1]) ++i;
      const double end = i + 1 == places.size() ? between.end : border(places[i], places[i + 1]);
      out.push_back({{start, end}, false});
    }
  }

 private:
  /// Cuts are as far as the distance: places beside them tell.
  std::vector<double> places_in(const Interval& between) const {
    constexpr int kLooks = 8;
    constexpr double kBeside = 0x1p-6;
    std::vector<double> ends{between.start};
    for (const int span : raw_.knot_vector().spans()) {
      const double knot = raw_.knot_vector().knots()[static_cast<std::size_t>(span)];
      if (knot > between.start && knot < between.end) ends.push_back(knot);
    }
    ends.push_back(between.end);
    std::vector<double> places;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const auto at = [&](double s) { return std::lerp(ends[i], ends[i + 1], s); };
      if (i > 0) places.push_back(ends[i]);
      places.push_back(at(kBeside));
      for (int k = 1; k < kLooks; ++k) places.push_back(at(static_cast<double>(k) / kLooks));
      places.push_back(at(1.0 - kBeside));
    }
    return places;
  }

  std::vector<bool> are_far(std::span<const double> at) const {
    breathe(at.size());
    const std::vector<glm::dvec3> places = places_of(raw_, at);
    std::vector<glm::dvec3> points;
    for (const glm::dvec3& place : places) points.push_back(space_.leave(place));
    std::vector<NearestOnCurve> found(points.size());
    nearest(curve_, points, found, 1);
    std::vector<bool> far;
    for (std::size_t i = 0; i < places.size(); ++i) far.push_back(is_far(places[i], found[i].distance / space_.length(1.0)));
    return far;
  }

  bool is_far(const glm::dvec3& place, double distance) const {
    return distance >= enough_.start && !tips_.cover(place) && (distance <= enough_.end || tips_.hold(place));
  }

  /// The last place that is far on the way to one that is not.
  double border(double far, double near) const {
    constexpr int kHalvings = 44;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (far + near);
      (are_far(std::span(&middle, 1))[0] ? far : near) = middle;
    }
    return far;
  }

  const NurbsCurve& curve_;
  const NearSpace& space_;
  const NurbsCurve& raw_;
  const SharpTips& tips_;
  Interval enough_;
};

/// Parts that stay.
class KeptParts {
 public:
  explicit KeptParts(double tolerance) : tolerance_(tolerance) {}

  /// What begins at a cut and comes too near, or is shorter than the tolerance, stays if no other part is there.
  void add(const NurbsCurve& raw, const FarStretch& stretch) {
    NurbsCurve part = part_of(raw, stretch.range);
    (stretch.is_whole && is_long(part) ? parts_ : doubtful_).push_back(std::move(part));
  }

  std::vector<BezierPieces> pieces() {
    for (NurbsCurve& part : doubtful_) {
      if (!is_covered(part, parts_, tolerance_)) parts_.push_back(std::move(part));
    }
    std::vector<BezierPieces> found;
    for (const NurbsCurve& part : parts_) found.push_back(to_bezier(part));
    return found;
  }

 private:
  bool is_long(const NurbsCurve& part) const {
    const std::vector<glm::dvec3> samples = samples_of(part);
    return std::ranges::any_of(samples, [&](const glm::dvec3& p) { return glm::distance(p, samples[0]) > tolerance_; });
  }

  double tolerance_;
  std::vector<NurbsCurve> parts_;
  std::vector<NurbsCurve> doubtful_;
};

/// For each part that which begins where it ends; as many as there are if there is none.
std::vector<std::size_t> followers_of(const std::vector<BezierPieces>& parts, double near) {
  struct Joint {
    double gap;
    std::size_t before;
    std::size_t behind;
  };
  std::vector<Joint> joints;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = 0; j < parts.size(); ++j) {
      const double gap = glm::distance(end_of(parts[i].back()), start_of(parts[j].front()));
      if (gap <= near && i != j) joints.push_back({gap, i, j});
    }
  }
  std::ranges::stable_sort(joints, {}, &Joint::gap);
  std::vector<std::size_t> next(parts.size(), parts.size());
  std::vector<bool> has_before(parts.size(), false);
  for (const Joint& joint : joints) {
    if (next[joint.before] != parts.size() || has_before[joint.behind]) continue;
    next[joint.before] = joint.behind;
    has_before[joint.behind] = true;
  }
  return next;
}

/// Whether what goes on at a place leads back along the end of a curve.
bool leads_back(const BezierCurve& curve, const glm::dvec3& place) {
  const glm::dvec3 gap = place - end_of(curve);
  const auto points = curve.points();
  const glm::dvec3 way = end_of(curve) - glm::dvec3(points[points.size() - 2]);
  return glm::dot(gap, way) < 0.0;
}

/// Ends a run where it is nearest to a place that it has gone past.
void end_beside(BezierPieces& run, const glm::dvec3& place) {
  while (leads_back(run.back(), place)) {
    const NurbsCurve last = curve_of({run.back()});
    NearestOnCurve found;
    nearest(last, std::span(&place, 1), std::span(&found, 1), 1);
    const Interval domain = last.domain();
    const double apart = kSamePlace * domain.length();
    if (found.parameter > domain.start + apart) {
      if (found.parameter < domain.end - apart) run.back() = to_bezier(split(last, found.parameter).first).front();
      return;
    }
    if (run.size() == 1) return;
    run.pop_back();
  }
}

void append(BezierPieces& run, const BezierPieces& part) {
  if (!run.empty() && glm::distance(end_of(run.back()), start_of(part.front())) > kSamePlace) {
    end_beside(run, start_of(part.front()));
    run.push_back(bezier_line(end_of(run.back()), start_of(part.front())));
  }
  run.insert(run.end(), part.begin(), part.end());
}

/// What goes round ends where it begins.
void close(BezierPieces& run) {
  const glm::dvec3 start = start_of(run.front());
  if (glm::distance(end_of(run.back()), start) <= kSamePlace) return;
  end_beside(run, start);
  if (glm::distance(end_of(run.back()), start) > kSamePlace) run.push_back(bezier_line(end_of(run.back()), start));
}

/// Parts that begin where others end put together.
std::vector<BezierPieces> joined_ends(const std::vector<BezierPieces>& parts, double near) {
  const std::vector<std::size_t> next = followers_of(parts, near);
  std::vector<bool> has_before(parts.size(), false);
  for (const std::size_t behind : next) {
    if (behind < parts.size()) has_before[behind] = true;
  }
  std::vector<BezierPieces> joined;
  std::vector<bool> is_done(parts.size(), false);
  // First those that nothing comes before; what is left goes round.
  for (const bool is_round : {false, true}) {
    for (std::size_t first = 0; first < parts.size(); ++first) {
      if (is_done[first] || has_before[first] != is_round) continue;
      joined.emplace_back();
      for (std::size_t i = first; i < parts.size() && !is_done[i]; i = next[i]) {
        append(joined.back(), parts[i]);
        is_done[i] = true;
      }
      if (is_round) close(joined.back());
    }
  }
  return joined;
}

/// Whether a run is open and no farther than that from where it begins: what the tolerance alone leaves.
bool is_speck(const BezierPieces& run, double near) {
  const glm::dvec3 start = start_of(run.front());
  if (end_of(run.back()) == start) return false;
  const std::vector<glm::dvec3> samples = samples_of(curve_of(run));
  return std::ranges::all_of(samples, [&](const glm::dvec3& place) { return glm::distance(place, start) <= near; });
}

}  // namespace

std::vector<BezierPieces> trimmed_offset(const NurbsCurve& curve, const NearSpace& space, const SideStep& step,
                                         const std::vector<BezierPieces>& runs,
                                         const std::vector<BezierPieces>& others, std::vector<SharpTip> tips) {
  std::vector<NurbsCurve> raw;
  for (const BezierPieces& run : runs) raw.push_back(curve_of(run));
  for (const BezierPieces& other : others) raw.push_back(curve_of(other));
  const std::vector<Cuts> cuts = cuts_of(raw, runs.size());
  constexpr double kShort = 0.5;  // of the tolerance: the rest is that of the lines that join parts
  const double distance = std::abs(step.distance);
  const double rounding = space.rounding() + kRoundingOfShape * (1.0 + distance);
  const double slack = kShort * step.tolerance + rounding;
  const NurbsCurve near_curve = curve.with_points(space.enter(curve.points()));
  const SharpTips sharp(near_curve, std::move(tips), rounding);
  KeptParts kept(step.tolerance);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Interval domain = raw[i].domain();
    std::vector<double> ends = cuts[i].at;
    ends.insert(ends.end(), {domain.start, domain.end});
    ends = distinct(std::move(ends), kSamePlace * domain.length());
    std::vector<FarStretch> far;
    const FarStretches stretches(curve, space, raw[i], sharp, {distance - slack, distance + 2.0 * slack});
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      const Interval between{ends[k], ends[k + 1]};
      if (!cuts[i].are_doubled(between)) stretches.add(between, far);
    }
    for (const FarStretch& stretch : far) {
      if (stretch.range.length() > kSamePlace * domain.length()) kept.add(raw[i], stretch);
    }
  }
  constexpr double kJoined = 4.0;  // tolerances: where parts meet at a small angle both end before they do
  const double near = std::max(kJoined * step.tolerance, 0x1p-30);
  std::vector<BezierPieces> joined = joined_ends(kept.pieces(), near);
  for (BezierPieces& run : joined) {
    run = ended_at_start(without_specks(without_loops(run, step.tolerance), step.tolerance));
  }
  std::erase_if(joined, [&](const BezierPieces& run) { return is_speck(run, near); });
  return joined;
}

}  // namespace splinecore
