#include "aligned_sections.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "curve/near_knot.hpp"
#include "kink.hpp"
#include "section_nearness.hpp"
#include "shared_starts.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/ends.hpp"

namespace splinecore {

namespace {

/// How much less near than the nearest a beginning may be that is a knot, or where the curve begins already.
constexpr double kAsNear = 1e-12;

/// An angle that one sees, and that imports do not make.
constexpr double kSeen = 0.02;

bool begins_at_corner(const NurbsCurve& curve) {
  const Interval domain = curve.domain();
  return std::ranges::any_of(corners_above(curve, kSeen), [&](double u) { return u == domain.start || u == domain.end; });
}

struct Beginning {
  double at;
  double nearness;
};

/// How a curve runs best beside the one before it, and the angles by which it is turned from that, as it is and as it runs best.
struct BestTurn {
  SectionTurn turn;
  double angle_as_it_is;
  double angle;
  bool is_at_corner = false;
};

Beginning nearest_of(const std::vector<double>& places, const SectionNearness& nearness) {
  Beginning best{places.front(), nearness.at(places.front())};
  for (const double place : places) {
    const Beginning one{place, nearness.at(place)};
    if (one.nearness > best.nearness) best = one;
  }
  return best;
}

/// Where a periodic curve best begins.
Beginning beginning_of(const NurbsCurve& curve, const SectionNearness& nearness) {
  const double best = nearness.best();
  const Beginning found{best, nearness.at(best)};
  const double start = curve.domain().start;
  const Beginning as_it_is{start, nearness.at(start)};
  if (as_it_is.nearness >= found.nearness - kAsNear) return as_it_is;
  const auto knots = curve.knot_vector().knots();
  const Beginning at_knot = nearest_of({knots.begin(), knots.end() - 1}, nearness);
  return at_knot.nearness >= found.nearness - kAsNear ? at_knot : found;
}

double angle_of(double nearness) { return std::acos(std::clamp(nearness, -1.0, 1.0)); }

BestTurn best_turn(const NurbsCurve& before, const NurbsCurve& curve) {
  const NurbsCurve other_way = reversed(curve);
  const SectionNearness along(before, curve);
  const SectionNearness against(before, other_way);
  const double as_it_is = along.at(curve.domain().start);
  if (!curve.periodic()) {
    const double back = against.at(other_way.domain().start);
    const bool is_reversed = back > as_it_is + kAsNear;
    return {{is_reversed, {}}, angle_of(as_it_is), angle_of(is_reversed ? back : as_it_is)};
  }
  const std::vector<double> corners = corners_above(curve, kSeen);
  const bool from_corner = !corners.empty() && before.periodic() && begins_at_corner(before);
  const auto best_of = [&](const NurbsCurve& way, const SectionNearness& nearness) {
    return from_corner ? nearest_of(corners_above(way, kSeen), nearness) : beginning_of(way, nearness);
  };
  const Beginning first = best_of(curve, along);
  const Beginning second = best_of(other_way, against);
  const bool is_reversed = second.nearness > first.nearness + kAsNear;
  const Beginning& best = is_reversed ? second : first;
  const double start = (is_reversed ? other_way : curve).domain().start;
  return {{is_reversed, best.at == start ? std::nullopt : std::optional(best.at)}, angle_of(as_it_is), angle_of(best.nearness),
          from_corner};
}

/// The turn with a beginning that shares knots with those that are there.
SectionTurn sharing(const BestTurn& best, const NurbsCurve& curve, const SharedStarts& shared) {
  if (!curve.periodic() || best.is_at_corner) return best.turn;
  const NurbsCurve run = best.turn.is_reversed ? reversed(curve) : curve;
  const Interval domain = run.domain();
  const double start = shared.start_near(run, best.turn.seam.value_or(domain.start));
  const bool is_own = start == domain.start || start == domain.end;
  return {best.turn.is_reversed, is_own ? std::nullopt : std::optional(start)};
}

/// Begun later by a part of the domain.
NurbsCurve begun_later(const NurbsCurve& curve, double share) {
  const Interval domain = curve.domain();
  const double by = (share - std::floor(share)) * domain.length();
  constexpr double kSame = 0x1p-40;
  const double near = std::max(kSame, knot_rounding(domain)) * domain.length();
  const double start = near_knot(curve.knot_vector(), domain.start + by, near);
  return start > domain.start && start < domain.end ? with_seam_at(curve, start) : curve;
}

}  // namespace

NurbsCurve turned(const NurbsCurve& curve, const SectionTurn& turn) {
  const NurbsCurve run = turn.is_reversed ? reversed(curve) : curve;
  return turn.seam ? with_seam_at(run, *turn.seam) : run;
}

std::vector<SectionTurn> turns_of(const std::vector<NurbsCurve>& curves) {
  std::vector<SectionTurn> turns;
  SharedStarts shared;
  std::optional<NurbsCurve> before;  // begun as is best, so that what is left of turns does not add up
  for (const NurbsCurve& curve : curves) {
    const BestTurn best = before ? best_turn(*before, curve) : BestTurn{};
    turns.push_back(before ? sharing(best, curve, shared) : SectionTurn{});
    shared.add(turned(curve, turns.back()));
    before = turned(curve, best.turn);
  }
  return turns;
}

double turn_left(const NurbsCurve& last, const NurbsCurve& first) {
  constexpr double kSeen = 0.2;      // radians more than need be: less is no harm
  constexpr double kReversed = 1.0;  // few sections about a ring may lie as near in the other order
  const BestTurn closing = best_turn(last, first);
  const double more = closing.angle_as_it_is - closing.angle;
  SharedStarts shared;
  shared.add(last);
  const SectionTurn turn = sharing(closing, first, shared);
  if (turn.is_reversed ? more <= kReversed : !turn.seam || more <= kSeen) return 0.0;
  if (turn.is_reversed || (last.periodic() && begins_at_corner(last) && !corners_above(first, kSeen).empty())) {
    throw InvalidShape(
        "around the loop the sections come back turned: the last one runs beside the first one as that would run from another "
        "beginning, or backwards. An open loft, or sections that turn by whole turns, can be made; so can they as they are, "
        "unaligned");
  }
  const Interval domain = first.domain();
  const double share = (*turn.seam - domain.start) / domain.length();
  return share - std::round(share);
}

std::vector<NurbsCurve> turned_evenly(const std::vector<NurbsCurve>& curves, double share) {
  std::vector<NurbsCurve> made;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    made.push_back(begun_later(curves[i], -share * static_cast<double>(i) / static_cast<double>(curves.size())));
  }
  return made;
}

}  // namespace splinecore
