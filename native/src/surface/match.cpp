#include "splinecore/surface/match.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "aligned_sections.hpp"
#include "going_on.hpp"
#include "kept_continuity.hpp"
#include "least_going_on.hpp"
#include "meet/near_space.hpp"
#include "numeric/linear_equations.hpp"
#include "overshoot.hpp"
#include "patch/lines.hpp"
#include "ribbon.hpp"
#include "side_first.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/basis/samples.hpp"
#include "splinecore/curve/compatible.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/patch/degree.hpp"
#include "splinecore/patch/distance.hpp"
#include "splinecore/patch/ends.hpp"
#include "splinecore/patch/join.hpp"

namespace splinecore {

namespace {

void require_options(const MatchOptions& options) {
  if (options.continuity < 0 || options.continuity > 3) {
    throw InvalidShape("continuity " + std::to_string(options.continuity) + ": 0 to 3 is expected");
  }
  if (options.rows != 0 && options.rows <= options.continuity) {
    throw InvalidShape(std::to_string(options.rows) + " rows may move: continuity " + std::to_string(options.continuity) +
                       " takes " + std::to_string(options.continuity + 1));
  }
  if (!(options.strength > 0.0 && std::isfinite(options.strength))) {
    throw InvalidShape("strength = " + text_of(options.strength) + ": above 0 is expected");
  }
}

/// Rows of control points, homogeneous, row 0 along the side; all on the same knots.
struct MovingRows {
  KnotVector along;
  KnotVector across;
  std::vector<std::vector<glm::dvec4>> rows;
  bool are_rational;
};

MovingRows rows_of(const NurbsPatch& patch, const Ribbon& onto) {
  const auto is_rational = [](const NurbsCurve& row) { return row.rational(); };
  MovingRows made{patch.knot_vector(Axis::u), patch.knot_vector(Axis::v), {}, patch.rational() || std::ranges::any_of(onto.rows, is_rational)};
  const std::vector<glm::dvec4> net = homogeneous(patch.points());
  const auto count_u = static_cast<std::size_t>(patch.count(Axis::u));
  const auto count_v = static_cast<std::size_t>(patch.count(Axis::v));
  for (std::size_t j = 0; j < count_v; ++j) {
    std::vector<glm::dvec4> row;
    for (std::size_t i = 0; i < count_u; ++i) row.push_back(net[i * count_v + j]);
    made.rows.push_back(std::move(row));
  }
  return made;
}

NurbsPatch patch_of(const MovingRows& moved) {
  const std::size_t count_v = moved.rows.size();
  const std::size_t count_u = moved.rows.front().size();
  std::vector<glm::dvec4> net(count_u * count_v);
  for (std::size_t j = 0; j < count_v; ++j) {
    for (std::size_t i = 0; i < count_u; ++i) net[i * count_v + j] = moved.rows[j][i];
  }
  return NurbsPatch::from_homogeneous(moved.along, moved.across, net);
}

/// The rows of the other patch from its side on, and the patch, with one degree and the same knots along the side.
void make_compatible(NurbsPatch& patch, Ribbon& onto) {
  const KnotVector& own = patch.knot_vector(Axis::u);
  const NurbsCurve side = NurbsCurve::make(own, std::vector<glm::dvec4>(static_cast<std::size_t>(own.count()), glm::dvec4(0.0, 0.0, 0.0, 1.0)));
  std::vector<NurbsCurve> all{side};
  all.insert(all.end(), onto.rows.begin(), onto.rows.end());
  const std::vector<NurbsCurve> made = compatible(all);
  onto.rows.assign(made.begin() + 1, made.end());
  patch = along(patch, Axis::u, [&](const NurbsCurve& line) {
    const NurbsCurve two[] = {line, side, onto.rows.front()};
    return compatible(two).front();
  });
}

/// Those beside the side that have these derivatives there.
void write_rows(MovingRows& moved, const std::vector<std::vector<glm::dvec4>>& derivatives) {
  const double start[] = {moved.across.domain().start};
  const int order = static_cast<int>(derivatives.size()) - 1;
  const Samples at_start = Samples::make(moved.across, start, order);
  for (int k = 0; k <= order; ++k) {
    const auto weights = at_start.weights(0, k);
    std::vector<glm::dvec4> row = derivatives[static_cast<std::size_t>(k)];
    for (std::size_t i = 0; i < row.size(); ++i) {
      for (int j = 0; j < k; ++j) row[i] -= weights[j] * moved.rows[j][i];
      row[i] /= weights[k];
    }
    moved.rows[k] = std::move(row);
  }
}

/// Rows that may move go with those that must, so that second differences of the ways are least in the sum of squares.
void fade(MovingRows& moved, const std::vector<std::vector<glm::dvec4>>& before, std::size_t first, std::size_t end) {
  if (end <= first) return;
  const std::size_t count = end - first;
  const std::size_t width = moved.rows.front().size();
  const auto way = [&](std::size_t j) {
    std::vector<glm::dvec4> d(width);
    for (std::size_t i = 0; i < width; ++i) d[i] = moved.rows[j][i] - before[j][i];
    return d;
  };
  LinearEquations equations(count, 4 * width);
  for (std::size_t r = first < 2 ? 1 : 0; r < count + 2; ++r) {
    std::vector<double> left(count);
    std::vector<double> right(4 * width);
    for (std::size_t k = 0; k < 3; ++k) {
      const double factor = k == 1 ? -2.0 : 1.0;
      if (r + k >= count + 2) continue;
      if (r + k >= 2) {
        left[r + k - 2] = factor;
        continue;
      }
      const std::vector<glm::dvec4> known = way(first + r + k - 2);
      for (std::size_t i = 0; i < width; ++i) {
        for (int c = 0; c < 4; ++c) right[4 * i + c] -= factor * known[i][c];
      }
    }
    equations.add(left, right);
  }
  const std::vector<double> ways = equations.least_squares();
  for (std::size_t j = 0; j < count; ++j) {
    for (std::size_t i = 0; i < width; ++i) {
      for (int c = 0; c < 4; ++c) moved.rows[first + j][i][c] += ways[4 * (width * j + i) + c];
    }
  }
}

/// By what the weights of the patch are multiplied so that on average they are those of the other one along the side.
double weight_factor(const std::vector<glm::dvec4>& own, const std::vector<glm::dvec4>& other) {
  double sum = 0.0;
  double of_other = 0.0;
  for (std::size_t i = 0; i < own.size(); ++i) {
    sum += own[i].w;
    of_other += other[i].w;
  }
  return sum != 0.0 && of_other != 0.0 ? of_other / sum : 1.0;
}

/// Of the first span, in which speed may change at most by what it is.
constexpr double kRoom = 0.6;

/// The rows of a patch with these derivatives at the side.
MovingRows moved_to(const MovingRows& before, const std::vector<glm::dvec4>& edge, LeavingRows derivatives, std::size_t must,
                    std::size_t may) {
  MovingRows moved = before;
  derivatives.insert(derivatives.begin(), edge);
  write_rows(moved, derivatives);
  fade(moved, before.rows, must, may);
  for (auto& row : moved.rows) {
    for (glm::dvec4& p : row) p.w = moved.are_rational ? p.w : 1.0;
  }
  return moved;
}

/// The rows of a patch that go on from the other one's, `pace` times as fast.
MovingRows moved_onto(const MovingRows& before, const std::vector<glm::dvec4>& edge, const LeavingRows& out, double pace,
                      std::size_t must, std::size_t may) {
  const double room = kRoom * before.across.span_interval(0).length();
  return moved_to(before, edge, out.empty() ? LeavingRows{} : going_on(edge, out, pace, room), must, may);
}

double least_weight(const MovingRows& moved) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& row : moved.rows) {
    for (const glm::dvec4& p : row) least = std::min(least, p.w);
  }
  return least;
}

/// The rows that go on from the other one's and move least: at the pace that suits all, or the first of them where the
/// surface then moves less than half as far, as it may where weights differ much.
MovingRows moved_least(const MovingRows& before, const std::vector<glm::dvec4>& edge, const LeavingRows& out, double strength,
                       std::size_t must, std::size_t may) {
  if (out.empty()) return moved_to(before, edge, {}, must, may);
  const double start[] = {before.across.domain().start};
  const int order = static_cast<int>(out.size());
  const Samples at_start = Samples::make(before.across, start, order);
  OwnRows own{before.rows, before.are_rational};
  for (int k = 1; k <= order; ++k) {
    const auto weights = at_start.weights(0, k);
    for (int j = 0; j <= k; ++j) own.coefficients[static_cast<std::size_t>(k)][static_cast<std::size_t>(j)] = weights[j];
  }
  const auto moved_for = [&](PaceFor rows) {
    return moved_to(before, edge, least_going_on(edge, out, own, rows, strength), must, may);
  };
  MovingRows by_first = moved_for(PaceFor::first_row);
  if (order == 1) return by_first;
  MovingRows by_all = moved_for(PaceFor::all_rows);
  if (!(least_weight(by_first) > 0.0) || !(least_weight(by_all) > 0.0)) return by_all;
  const NurbsPatch was = patch_of(before);
  const double of_first = largest_distance(was, patch_of(by_first));
  return of_first < 0.5 * largest_distance(was, patch_of(by_all)) ? by_first : by_all;
}

/// How fast the patch leaves its side, by how fast the other one does.
double own_pace(const MovingRows& before, const std::vector<glm::dvec4>& edge, const LeavingRows& out) {
  const double start[] = {before.across.domain().start};
  const Samples at_start = Samples::make(before.across, start, 1);
  std::vector<glm::dvec4> own(edge.size());
  for (std::size_t i = 0; i < own.size(); ++i) own[i] = at_start.weights(0, 1)[1] * (before.rows[1][i] - before.rows[0][i]);
  const double speed = speed_of(before.rows.front(), own);
  const double given = speed_of(edge, out.front());
  if (!(given > 0.0 && speed > 0.0)) throw InvalidShape("a patch has a zero derivative across its side: it cannot be continued there");
  return speed / given;
}

/// Lets closed rows begin where they are nearest to a closed side.
/// @param may_turn  whether they may run the other way for that
void begin_beside(const NurbsCurve& side, Ribbon& ribbon, bool may_turn) {
  const SectionTurn turn = turns_of({side, ribbon.rows.front()})[1];
  if (turn.is_reversed && !may_turn) return;
  for (NurbsCurve& row : ribbon.rows) row = turned(row, turn);
}

NurbsPatch moved_onto(NurbsPatch patch, Ribbon onto, const MatchOptions& options) {
  constexpr int kHalvings = 30;
  const auto must = static_cast<std::size_t>(options.continuity) + 1;
  const std::size_t may = std::max(must, static_cast<std::size_t>(options.rows));
  const int more = static_cast<int>(may) + 1 - patch.count(Axis::v);
  const int raise = std::max(more, options.continuity - patch.knot_vector(Axis::v).degree());
  if (raise > 0) patch = elevated(patch, Axis::v, raise);
  make_compatible(patch, onto);
  MovingRows before = rows_of(patch, onto);
  const std::vector<glm::dvec4> edge = homogeneous(onto.rows.front().points());
  const double factor = weight_factor(before.rows.front(), edge);
  for (auto& row : before.rows) row = scaled(factor, std::move(row));
  LeavingRows out;
  for (int k = 1; k <= options.continuity; ++k) out.push_back(derivative_out(onto, k));
  const double own = out.empty() ? 1.0 : own_pace(before, edge, out);
  double pace = out.empty() ? 1.0 : options.strength * own;
  MovingRows moved = moved_least(before, edge, out, options.strength, must, may);
  constexpr double kKept = 0.125;  // of the least weight: with less, points are far off, and lose digits
  constexpr double kMostBeside = 1.5;  // of the way out, or what there was: with more, rows shoot out beyond all that is beside them
  const double least = kKept * least_weight(before);
  const auto beside = [&](const MovingRows& one, double at_pace) {
    return out.size() < 2 ? 0.0 : overshoot(one.across, one.rows, scaled(at_pace, out.front()), must);
  };
  const double most_beside = least > 0.0 ? std::max(kMostBeside, beside(before, own)) : kMostBeside;
  const auto are_kept = [&](const MovingRows& one, double at_pace) {
    return least_weight(one) >= least && beside(one, at_pace) <= most_beside;
  };
  if (!(least > 0.0) || are_kept(moved, out.empty() ? pace : own_pace(moved, edge, out))) return patch_of(moved);
  moved = moved_onto(before, edge, out, pace, must, may);
  if (are_kept(moved, pace)) return patch_of(moved);
  double low = pace;
  for (int i = 0; i < kHalvings && !are_kept(moved, low); ++i) {
    pace = low;
    low *= 0.5;
    moved = moved_onto(before, edge, out, low, must, may);
  }
  if (!are_kept(moved, low)) {
    throw InvalidShape(least_weight(moved) < least
                           ? "the weights of the patches differ so much that beside the side some would not stay positive"
                           : "the other patch bends so sharply at the side that its continuation would shoot out: a "
                             "lower continuity has less of that");
  }
  for (int i = 0; i < kHalvings; ++i) {  // to the largest pace with which they are, which changes little where a patch does
    const double middle = 0.5 * (low + pace);
    MovingRows between = moved_onto(before, edge, out, middle, must, may);
    const bool is_slow = are_kept(between, middle);
    (is_slow ? low : pace) = middle;
    if (is_slow) moved = std::move(between);
  }
  return patch_of(moved);
}

}  // namespace

Approximation<NurbsPatch> matched(const NurbsPatch& patch, Border side, const NurbsPatch& onto, Border onto_side,
                                  const MatchOptions& options) {
  require_options(options);
  if (patch.knot_vector(axis_of(side)).periodic()) throw InvalidShape("the side is the seam of a periodic direction: it is not an edge");
  const bool are_closed = patch.knot_vector(across(axis_of(side))).periodic() && onto.knot_vector(across(axis_of(onto_side))).periodic();
  const bool finds_way = are_closed && !options.is_reversed;
  const bool is_reversed = !finds_way && options.is_reversed.value_or(run_against(onto, onto_side, patch, side));
  const NearSpace space(together(patch.points(), onto.points()));
  const NurbsPatch near = clamped(patch.with_points(space.enter(patch.points())), axis_of(side));
  Ribbon ribbon = ribbon_of(onto.with_points(space.enter(onto.points())), onto_side);
  if (is_reversed) {
    for (NurbsCurve& row : ribbon.rows) row = reversed(row);
  }
  const NurbsPatch first = with_side_first(near, side);
  if (are_closed) begin_beside(boundary(first, Border::v_start), ribbon, finds_way);
  const NurbsPatch made = with_side_back(moved_onto(first, std::move(ribbon), options), side);
  const NurbsPatch goal = onto.with_points(space.enter(onto.points()));
  require_continuity(made, side, {goal, onto_side, options.continuity}, "the other one", finds_way ? std::nullopt : std::optional(is_reversed));
  return {made.with_points(space.leave(made.points())), space.length(largest_distance(near, made))};
}

}  // namespace splinecore
