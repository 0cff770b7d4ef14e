#include "splinecore/surface/sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <iterator>
#include <numbers>
#include <optional>
#include <string>

#include "base/length.hpp"
#include "base/quotient.hpp"
#include "base/require.hpp"
#include "base/rounding.hpp"
#include "build/fit_options.hpp"
#include "closes.hpp"
#include "fitted_rows.hpp"
#include "kink.hpp"
#include "meet/near_space.hpp"
#include "meet/said_outside.hpp"
#include "numbers_along.hpp"
#include "prepared_rail.hpp"
#include "rail_frames.hpp"
#include "rail_sections.hpp"
#include "scale_along.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/measure/arc_length.hpp"
#include "splinecore/measure/length.hpp"
#include "splinecore/patch/ends.hpp"

namespace splinecore {

namespace {

constexpr double kQuarter = 0.5 * std::numbers::pi;
constexpr int kMostQuarters = 4096;

void require_options(const SweepOptions& options) {
  if (options.tolerance) require_positive(*options.tolerance);
  if (!(options.end_scale > 0.0 && std::isfinite(options.end_scale))) {
    throw InvalidShape("end_scale = " + text_of(options.end_scale) + ": above 0 is expected");
  }
  if (!std::isfinite(options.twist)) throw InvalidShape("twist = " + text_of(options.twist) + " is not finite");
  if (std::abs(options.twist) > kMostQuarters * kQuarter) {
    throw InvalidShape("twist = " + text_of(options.twist) + ": at most " + std::to_string(kMostQuarters / 4) +
                       " turns are expected");
  }
  require_upright(options);
}

/// Angles at which a kink moves no point of a section by what is seen of a tolerance.
double negligible_angle(std::span<const RailSection> sections, const SweepOptions& options, double tolerance) {
  double reach = 0.0;
  for (const RailSection& section : sections) {
    for (const glm::dvec4& p : section.curve.points()) reach = std::max(reach, length_of(glm::dvec3(p)));
  }
  reach *= std::max(1.0, options.end_scale);
  double scale = options.scales.empty() ? 1.0 : 0.0;
  for (const RailNumber& one : options.scales) scale = std::max(scale, one.value);
  if (options.scale) {
    scale *= std::ranges::max(options.scale->points(), {}, [](const glm::dvec4& p) { return p.x; }).x;
  }
  return reach * scale > 0.0 ? kKinkShare * tolerance / (reach * scale) : 0.0;
}

bool is_straight(const NurbsCurve& rail) {
  const auto points = rail.points();
  if (std::ranges::any_of(points, [](const glm::dvec4& p) { return p.w <= 0.0; })) return false;
  const glm::dvec3 way = glm::dvec3(points.back()) - glm::dvec3(points.front());
  const double length = length_of(way);
  if (!(length > 0.0)) return false;
  double reached = 0.0;
  for (const glm::dvec4& p : points) {
    const glm::dvec3 from = glm::dvec3(p) - glm::dvec3(points.front());
    const double along = glm::dot(from, way) / length;
    if (along < reached || length_of(from - along / length * way) > kRoundingOfShape * length) return false;
    reached = along;
  }
  return true;
}

/// The sum of a section in a frame and the rail, less where the frame is.
NurbsPatch sum_of(const NurbsCurve& rail, const RailSections& sections, const MovingFrame& frame, double scale) {
  const double start = rail.domain().start;
  const std::vector<glm::dvec4> section = as_given(sections.at(std::span(&start, 1)));
  std::vector<glm::dvec4> net;
  for (const glm::dvec4& q : section) {
    const glm::dvec3 out = in_frame(frame, scale * glm::dvec3(q));
    for (const glm::dvec4& c : rail.points()) {
      if (q.w == 0.0 || c.w == 0.0) {
        net.emplace_back(q.w == 0.0 ? c.w * out : q.w * glm::dvec3(c), 0.0);
      } else {
        net.emplace_back(glm::dvec3(c) + out, q.w * c.w);
      }
    }
  }
  return NurbsPatch::make(sections.knots(), rail.knot_vector(), std::move(net));
}

NumbersAlong scales_of(const SweepOptions& options, const NurbsCurve& rail) {
  const RailNumber one{rail.domain().start, 1.0};
  const std::span<const RailNumber> given = options.scales.empty() ? std::span(&one, 1) : std::span(options.scales);
  return NumbersAlong(given, rail.domain(), rail.periodic(), "scale");
}

/// What sections are on their way along a rail, whose corners are mitered.
class Sweeping {
 public:
  /// @param scale       of the options, or none
  /// @param negligible  angles of corners that are none
  Sweeping(const NurbsCurve& rail, const RailSections& sections, const SweepOptions& options, const ScaleAlong* scale,
           double negligible)
      : rail_(rail), sections_(sections), options_(options), scales_(scales_of(options, rail)), scale_(scale), places_(rail, options),
        corners_(corners_above(rail, negligible)), begins_in_corner_(begins_in_corner()) {}

  bool is_level() const {
    return sections_.is_one() && options_.end_scale == 1.0 && options_.twist == 0.0 && scales_.is_one() && (!scale_ || scale_->is_one());
  }

  /// Those of the start.
  MovingFrame first_frame() {
    const double start = rail_.domain().start;
    return places_.at(std::span(&start, 1), rail_.domain())[0].frame;
  }

  double scale() const { return scale_at(rail_.domain().start); }

  RowDomain domain() const {
    std::vector<double> breaks = corners_;
    if (scale_) std::ranges::copy(scale_->corners(rail_.domain()), std::back_inserter(breaks));
    std::ranges::sort(breaks);
    breaks.erase(std::ranges::unique(breaks).begin(), breaks.end());
    const bool is_smooth_round = !scale_ || (scale_->goes_round() && breaks.empty());
    const bool goes_round = rail_.periodic() && options_.end_scale == 1.0 && options_.twist == 0.0 && is_smooth_round;
    RowDomain domain{{rail_.domain().start}, joints_at(rail_.knot_vector()), goes_round ? Closing::closed : Closing::open};
    for (const double corner : breaks) {
      if (corner > rail_.domain().start && corner < rail_.domain().end) domain.breaks.push_back(corner);
    }
    domain.breaks.push_back(rail_.domain().end);
    std::ranges::copy(sections_.joints(), std::back_inserter(domain.joints));
    if (!scales_.is_one()) {
      for (const double at : scales_.joints()) domain.joints.push_back({at, kSlopes});
    }
    if (scale_) std::ranges::copy(scale_->joints(rail_.domain()), std::back_inserter(domain.joints));
    const int turns = twist_steps();
    for (int k = 1; k < turns; ++k) domain.joints.push_back({rail_.domain().start + rail_.domain().length() * k / turns, 1});
    return domain;
  }

  std::vector<glm::dvec4> rows_at(std::span<const double> at, const Interval& stretch) {
    const std::vector<RailPlace> places = places_.at(at, stretch);
    const std::vector<double> shares = shares_at(at);
    std::vector<glm::dvec4> rows = sections_.at(at);
    const std::size_t width = rows.size() / at.size();
    const Miter miter = miter_of(stretch);
    for (std::size_t i = 0; i < at.size(); ++i) {
      for (std::size_t j = 0; j < width; ++j) {
        glm::dvec4& p = rows[i * width + j];
        const glm::dvec3 out = in_frame(places[i].frame, scale_at(at[i]) * turned(glm::dvec3(p), shares[i]));
        p = glm::dvec4(out + p.w * places[i].point + slide(miter, places[i], out, p.w) * places[i].frame.tangent, p.w);
      }
    }
    return rows;
  }

 private:
  /// Knots of a cubic where there is no second derivative.
  static constexpr int kSlopes = 2;

  double scale_at(double parameter) const { return scales_.at(parameter) * (scale_ ? scale_->at(parameter) : 1.0); }

  /// Parts in which sections do not turn too far to be seen turning.
  int twist_steps() const { return static_cast<int>(std::ceil(std::abs(options_.twist) / kQuarter)); }

  /// The planes that halve the corners at both ends of a stretch, by their normals; 0 where there is none.
  struct Miter {
    glm::dvec3 start{0.0};
    glm::dvec3 end{0.0};
    glm::dvec3 from{0.0};
    double length = 0.0;
  };

  /// How much of the rail's length lies before each parameter; 0 where nothing grows or turns by that.
  std::vector<double> shares_at(std::span<const double> at) const {
    if (options_.end_scale == 1.0 && options_.twist == 0.0) return std::vector<double>(at.size(), 0.0);
    std::vector<double> shares = lengths_at_parameters(rail_, at);
    const double whole = length(rail_).value;
    for (std::size_t i = 0; i < at.size(); ++i) {
      shares[i] = at[i] == rail_.domain().end ? 1.0 : shares[i] / whole;  // of a periodic one it is the start, too
    }
    return shares;
  }

  /// A closed rail with corners begins in one of them.
  bool is_corner(double v) const {
    const Interval domain = rail_.domain();
    const bool is_end = v == domain.start || v == domain.end;
    return is_end ? begins_in_corner_ : std::ranges::count(corners_, v) > 0;
  }

  bool begins_in_corner() const {
    const std::vector<double> ends{rail_.domain().start, rail_.domain().end};
    if (rail_.periodic() || corners_.empty() || !is_closed(rail_)) return false;
    std::array<glm::dvec3, 4> jets;
    derivatives(rail_, ends, 1, std::span(&jets[0].x, 12), {.side = Side::left});
    constexpr double kStraight = 1e-9;
    return length_of(glm::cross(jets[1], jets[3])) > kStraight * length_of(jets[1]) * length_of(jets[3]);
  }

  /// Sections grow and turn about the rail.
  glm::dvec3 turned(const glm::dvec3& q, double share) const {
    const double size = 1.0 + share * (options_.end_scale - 1.0);
    const double angle = share * options_.twist;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {size * (c * q.x - s * q.y), size * (s * q.x + c * q.y), q.z};
  }

  Miter miter_of(const Interval& stretch) {
    Miter miter;
    const bool has_start = is_corner(stretch.start);
    const bool has_end = is_corner(stretch.end);
    if (!has_start && !has_end) return miter;
    const double ends[] = {stretch.start, stretch.end};
    const std::vector<RailPlace> own = places_.at(ends, stretch);
    miter.from = own[0].point;
    miter.length = length_of(own[1].point - own[0].point);
    require_straight(stretch, own);
    if (has_start) miter.start = half_plane(own[0].frame.tangent, stretch.start, Side::left);
    if (has_end) miter.end = half_plane(own[1].frame.tangent, stretch.end, Side::right);
    return miter;
  }

  /// Between two tangents at a corner.
  glm::dvec3 half_plane(const glm::dvec3& tangent, double at, Side other) {
    constexpr double kTurnsBack = 0.2;  // of two unit tangents: a miter reaches out by 10 times the section
    const Interval whole = rail_.domain();
    if (other == Side::left && at == whole.start) at = whole.end;
    if (other == Side::right && at == whole.end) at = whole.start;
    const Interval beyond = other == Side::left ? Interval{whole.start, at} : Interval{at, whole.end};
    const glm::dvec3 next = places_.at(std::span(&at, 1), beyond)[0].frame.tangent;
    const glm::dvec3 normal = tangent + next;
    if (!(length_of(normal) > kTurnsBack)) {
      const double angle = 2.0 * std::acos(std::min(1.0, 0.5 * length_of(normal))) * (180.0 / std::numbers::pi);
      constexpr double kBack = 179.5;
      if (angle > kBack) throw InvalidShape("the rail turns back at " + text_of(at));
      throw InvalidShape("the rail turns by " + std::to_string(std::lround(angle)) + " degrees at " + text_of(at) +
                         ": a miter there would reach too far. Round the corner first");
    }
    return normal / length_of(normal);
  }

  void require_straight(const Interval& stretch, const std::vector<RailPlace>& ends) {
    constexpr double kRounding = 1e-9;
    const double middle = stretch.start + 0.5 * stretch.length();
    const RailPlace between = places_.at(std::span(&middle, 1), stretch)[0];
    const bool is_straight_there = length_of(ends[0].frame.tangent - ends[1].frame.tangent) <= kRounding &&
                                   length_of(between.frame.tangent - ends[0].frame.tangent) <= kRounding;
    if (is_straight_there) return;
    throw InvalidShape("the rail has a corner beside a curved stretch, from " + text_of(stretch.start) + " to " +
                       text_of(stretch.end) + ": round the corner first");
  }

  /// How far, times its weight, a point moves along a straight stretch to be in the planes at its ends.
  double slide(const Miter& miter, const RailPlace& place, const glm::dvec3& out, double weight) const {
    if (miter.length == 0.0 || weight == 0.0) return 0.0;
    const auto to_plane = [&](const glm::dvec3& normal) {
      return normal == glm::dvec3(0.0) ? 0.0 : -glm::dot(out, normal) / glm::dot(place.frame.tangent, normal);
    };
    const double share = length_of(place.point - miter.from) / miter.length;
    return (1.0 - share) * to_plane(miter.start) + share * to_plane(miter.end);
  }

  const NurbsCurve& rail_;
  const RailSections& sections_;
  const SweepOptions& options_;
  NumbersAlong scales_;
  const ScaleAlong* scale_;
  RailPlaces places_;
  std::vector<double> corners_;
  bool begins_in_corner_;
};

bool is_same(const RailNumber& a, const RailNumber& b) { return a.value == b.value; }
bool is_same(const RailSection& a, const RailSection& b) { return a.curve == b.curve; }

/// Places on a closed rail that begins elsewhere now. What was given for its start and its end is one.
template <class Placed>
std::vector<Placed> placed_on(const NurbsCurve& rail, std::span<const Placed> given, double old_start) {
  std::vector<Placed> found(given.begin(), given.end());
  const double old_end = old_start + rail.domain().length();
  if (found.size() > 1 && found.front().at == old_start && found.back().at == old_end) {
    if (!is_same(found.front(), found.back())) {
      throw InvalidShape("the rail is closed: its end needs the same values as its start");
    }
    found.erase(found.begin());
  }
  const Interval domain = rail.domain();
  const auto is_before = [&](const Placed& one) { return one.at < domain.start; };
  const auto behind = std::ranges::find_if_not(found, is_before);
  for (auto one = found.begin(); one != behind; ++one) one->at += domain.length();
  std::rotate(found.begin(), behind, found.end());
  return found;
}

}  // namespace

Approximation<NurbsPatch> sweep(const NurbsCurve& rail, std::span<const RailSection> given, const SweepOptions& wanted) {
  require_options(wanted);
  const NearSpace space(rail.points());
  const double tolerance = wanted.tolerance.value_or(space.length(0x1p-20));
  const double negligible = negligible_angle(given, wanted, tolerance);
  std::optional<ScaleAlong> scale;
  if (wanted.scale) scale.emplace(*wanted.scale, rail.domain(), closes(rail));
  const NurbsCurve whole = prepared_rail(rail, negligible);
  const NurbsCurve near = whole.with_points(space.enter(whole.points()));
  const bool begins_elsewhere = near.domain().start != rail.domain().start;
  SweepOptions options = wanted;
  if (begins_elsewhere) options.scales = placed_on<RailNumber>(near, wanted.scales, rail.domain().start);
  const std::vector<RailSection> sections =
      begins_elsewhere ? placed_on(near, given, rail.domain().start) : std::vector<RailSection>(given.begin(), given.end());
  const RailSections along(sections, near, space.length(1.0));
  const auto left = [&](const NurbsPatch& patch) { return patch.with_points(space.leave(patch.points())); };
  Sweeping sweeping(near, along, options, scale ? &*scale : nullptr, negligible);
  if (sweeping.is_level() && (options.frame == RailFrame::parallel || is_straight(near))) {
    return {left(sum_of(near, along, sweeping.first_frame(), sweeping.scale())), 0.0};
  }
  if (options.frame == RailFrame::parallel) {
    throw InvalidShape("parallel sections keep their size and turn: one section, without scale and twist");
  }
  constexpr double kHalf = 0.5 / kKinkShare;  // of the tolerance
  constexpr double kLeastTurn = 0x1p-30;      // less a smooth rail may turn there
  if (const auto at = negligible > 0.0 ? hidden_turn(near, std::max(kHalf * negligible, kLeastTurn)) : std::nullopt) {
    throw InvalidShape("the rail turns at " + text_of(*at) +
                       " within less than parameters can tell apart: remove knots that nearly coincide there, or make a corner of it");
  }
  const double within = tolerance / space.length(1.0);
  const auto rows_at = [&](std::span<const double> at, const Interval& stretch) { return sweeping.rows_at(at, stretch); };
  const FittedRows rows = said_outside(space, [&] { return fitted_rows(rows_at, sweeping.domain(), within); });
  along.require_weights(rows);
  return {left(patch_of(along.knots(), rows)), space.length(rows.error)};
}

}  // namespace splinecore
