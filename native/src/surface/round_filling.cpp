#include "round_filling.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <tuple>

#include "base/length.hpp"
#include "end_cubic.hpp"
#include "end_scale.hpp"
#include "fit/row_spline.hpp"
#include "greville.hpp"
#include "homogeneous_places.hpp"
#include "raised_knots.hpp"
#include "splinecore/base/errors.hpp"
#include "turned_alike.hpp"

namespace splinecore {

namespace {

/// A point, and derivatives by t from 0 to 1 at both ends of the line to the apex.
struct Meridian {
  glm::dvec3 from;
  glm::dvec3 to;
  glm::dvec3 start;
  glm::dvec3 start_2;
  glm::dvec3 end;

  glm::dvec3 cubic_start_2() const { return 6.0 * (to - from) - 4.0 * start - 2.0 * end; }
  glm::dvec3 cubic_end_2() const { return -6.0 * (to - from) + 2.0 * start + 4.0 * end; }

  std::array<glm::dvec3, 4> cubic() const { return {from, from + start / 3.0, to - end / 3.0, to}; }
  std::array<glm::dvec3, 6> quintic() const {
    return {from, from + start / 5.0, from + 0.4 * start + start_2 / 20.0,
            to - 0.4 * end + cubic_end_2() / 20.0, to - end / 5.0, to};
  }
};

/// A side beside another, where they meet.
struct BesideEnd {
  const HoleSide& side;
  double pace;  ///< of the other one by this one's
};

BesideEnd beside_end(const Hole& hole, std::size_t i, bool is_end) {
  const HoleSide& beside = hole.sides[is_end ? hole.after(i) : hole.before(i)];
  const double own = length_of(hole.sides[i].place(is_end ? 1.0 : 0.0).along);
  return {beside, own / length_of(beside.place(is_end ? 0.0 : 1.0).along)};
}

/// How a side without a neighbor leaves, between the sides beside it.
EndCubic<glm::dvec3> leaving_between(const Hole& hole, const Apex& apex, std::size_t i) {
  EndCubic<glm::dvec3> made;
  for (const bool is_end : {false, true}) {
    const HolePlace here = hole.sides[i].place(is_end ? 1.0 : 0.0);
    const BesideEnd beside = beside_end(hole, i, is_end);
    const bool goes_on = beside.side.continuity() > 0;
    made.values[is_end] = goes_on ? beside.side.jet(!is_end).first[0] : leaving(here, apex);
    made.slopes[is_end] = goes_on ? beside.pace * beside.side.jet(!is_end).first[1] : -here.along;
  }
  return made;
}

/// The lines from a side to the apex.
class Meridians {
 public:
  Meridians(const Hole& hole, const Apex& apex, std::size_t i) : side_(hole.sides[i]), apex_(apex) {
    if (side_.continuity() == 0) free_ = leaving_between(hole, apex, i);
    if (side_.continuity() < 2) bent_ = bent_between(hole, i);
  }

  std::vector<Meridian> at(std::span<const double> s) const {
    const std::vector<glm::dvec3> points = side_.points(s);
    const std::vector<glm::dvec3> first = side_.continuity() > 0 ? side_.across(s, 1) : std::vector<glm::dvec3>();
    const std::vector<glm::dvec3> second = side_.continuity() == 2 ? side_.across(s, 2) : std::vector<glm::dvec3>();
    std::vector<Meridian> made;
    for (std::size_t k = 0; k < s.size(); ++k) {
      Meridian one{points[k], apex_.point, first.empty() ? free_.at(s[k]) : first[k], {}, apex_.arriving(points[k])};
      one.start_2 = second.empty() ? one.cubic_start_2() + bent_.at(s[k]) : second[k];
      made.push_back(one);
    }
    return made;
  }

  /// The derivative by s at an end.
  Meridian change(bool is_end) const {
    const glm::dvec3 along = side_.place(is_end ? 1.0 : 0.0).along;
    Meridian one{along, glm::dvec3(0.0), free_.slopes[is_end], {}, apex_.arriving_changes(along)};
    if (side_.continuity() > 0) one.start = side_.jet(is_end).first[1];
    one.start_2 = side_.continuity() == 2 ? side_.jet(is_end).second[1] : one.cubic_start_2() + bent_.slopes[is_end];
    return one;
  }

 private:
  /// What second derivatives of sides beside this one, with curvatures that go on, are off its own ones.
  EndCubic<glm::dvec3> bent_between(const Hole& hole, std::size_t i) const {
    EndCubic<glm::dvec3> made;
    for (const bool is_end : {false, true}) {
      const BesideEnd beside = beside_end(hole, i, is_end);
      if (beside.side.continuity() < 2) continue;
      const double end[] = {is_end ? 1.0 : 0.0};
      const AcrossJet jet = beside.side.jet(!is_end);
      made.values[is_end] = jet.second[0] - at(end)[0].start_2;
      made.slopes[is_end] = beside.pace * jet.second[1] - change(is_end).start_2;
    }
    return made;
  }

  const HoleSide& side_;
  const Apex& apex_;
  EndCubic<glm::dvec3> free_;  ///< of a side without a neighbor
  EndCubic<glm::dvec3> bent_;  ///< added to second derivatives of one without curvatures that go on
};

/// Control points of a line, and a weight that multiplies them, as numbers.
template <std::size_t kRows>
std::vector<double> row_of(const std::array<glm::dvec3, kRows>& points, double weight) {
  std::vector<double> row;
  for (const glm::dvec3& p : points) row.insert(row.end(), {weight * p.x, weight * p.y, weight * p.z});
  row.push_back(weight);
  return row;
}

/// The derivative of such a row.
template <std::size_t kRows>
std::vector<double> row_change(const std::array<glm::dvec3, kRows>& points, double weight_change,
                               const std::array<glm::dvec3, kRows>& changes) {
  std::vector<double> row = row_of(points, weight_change);
  const std::vector<double> more = row_of(changes, 1.0);
  for (std::size_t k = 0; k + 1 < row.size(); ++k) row[k] += more[k];
  return row;
}

template <std::size_t kRows>
NurbsPatch patch_through(const KnotVector& knots, const RowConditions& given, const glm::dvec3& apex, bool is_rational) {
  const RowSpline spline = spline_through(given, knots.degree(), Closing::open, {knots.knots().begin(), knots.knots().end()});
  std::vector<glm::dvec4> net;
  for (int i = 0; i < knots.count(); ++i) {
    const double* const p = &spline.controls[static_cast<std::size_t>(i) * (3 * kRows + 1)];
    const double weight = is_rational ? p[3 * kRows] : 1.0;
    if (!(weight > 0.0)) throw InvalidShape("a side of the round hole has a weight that is not above 0");
    for (std::size_t r = 0; r + 1 < kRows; ++r) {
      net.emplace_back(glm::dvec3(p[3 * r], p[3 * r + 1], p[3 * r + 2]) / weight, weight);
    }
    net.emplace_back(apex, weight);
  }
  return NurbsPatch::make(knots, KnotVector::bezier(static_cast<int>(kRows) - 1), std::move(net));
}

/// @param points  of a Meridian: an array
template <class PointsOf>
NurbsPatch patch_beside(const HoleSide& side, const Meridians& meridians, const KnotVector& knots, const PointsOf& points) {
  constexpr std::size_t kRows = std::tuple_size_v<decltype(points(Meridian{}))>;
  const NurbsCurve curve = side.curve();
  const EndScale scale = EndScale::of(curve);
  RowConditions given{interpolation_places_between_slopes(knots), {}, {}, {}};
  const std::vector<glm::dvec4> weighted = homogeneous_places(curve, given.parameters);
  const std::vector<Meridian> lines = meridians.at(given.parameters);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const bool is_end = k == 0 || k + 1 == lines.size();
    given.rows.push_back(row_of(points(lines[k]), is_end ? 1.0 : weighted[k].w * scale.at(given.parameters[k])));
  }
  const std::array<double, 2> slopes = scaled_weight_slopes(curve);
  given.start = {row_change(points(lines.front()), slopes[0], points(meridians.change(false)))};
  given.end = {row_change(points(lines.back()), slopes[1], points(meridians.change(true)))};
  return patch_through<kRows>(knots, given, lines.front().to, curve.rational());
}

/// Patches with the same points along the lines that they have in common.
void share_points(std::vector<NurbsPatch>& patches) {
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const std::size_t next = (k + 1) % patches.size();
    std::vector<glm::dvec4> here(patches[k].points().begin(), patches[k].points().end());
    std::vector<glm::dvec4> there(patches[next].points().begin(), patches[next].points().end());
    const auto rows = static_cast<std::size_t>(patches[k].knot_vector(Axis::v).count());
    const std::size_t last = here.size() - rows;
    for (std::size_t r = 0; r < rows; ++r) here[last + r] = there[r] = 0.5 * (here[last + r] + there[r]);
    patches[k] = patches[k].with_points(std::move(here));
    patches[next] = patches[next].with_points(std::move(there));
  }
}

}  // namespace

bool is_round(const Hole& hole) {
  for (std::size_t i = 0; i < hole.sides.size(); ++i) {
    if (!goes_on_at_end(hole, i)) return false;
  }
  return true;
}

void agree_round(Hole& hole, const Apex& apex) {
  for (HoleSide& side : hole.sides) {
    if (side.continuity() == 0) continue;
    for (const bool is_end : {false, true}) {
      const HolePlace here = side.place(is_end ? 1.0 : 0.0);
      const Meridian line{here.point, apex.point, leaving(here, apex), {}, apex.arriving(here.point)};
      side.set_end(is_end, line.start, line.cubic_start_2());
    }
  }
  for (std::size_t i = 0; i < hole.sides.size(); ++i) {
    HoleSide& side = hole.sides[i];
    HoleSide& next = hole.sides[hole.after(i)];
    if (side.continuity() > 0 && next.continuity() > 0) turn_alike(side, next);
  }
  for (HoleSide& side : hole.sides) {
    if (side.continuity() > 0) side.bend_onward(1.0);
  }
}

std::vector<NurbsPatch> round_filling(const Hole& hole, const Apex& apex, int degree) {
  std::vector<NurbsPatch> patches;
  for (std::size_t i = 0; i < hole.sides.size(); ++i) {
    const HoleSide& side = hole.sides[i];
    const Meridians lines(hole, apex, i);
    const KnotVector knots = raised_knots(side.knots(), degree, side.continuity() > 0 ? 1 : 0);
    patches.push_back(hole.continuity() == 2
                          ? patch_beside(side, lines, knots, [](const Meridian& line) { return line.quintic(); })
                          : patch_beside(side, lines, knots, [](const Meridian& line) { return line.cubic(); }));
  }
  share_points(patches);
  return patches;
}

}  // namespace splinecore
