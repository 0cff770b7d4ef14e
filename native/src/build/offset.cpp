#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <numbers>
#include <string>

#include "base/rounding.hpp"
#include "bezier_runs.hpp"
#include "cubics_along.hpp"
#include "meet/near_space.hpp"
#include "offset_parts.hpp"
#include "offset_piece.hpp"
#include "sharp_tips.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/convert/to_bezier.hpp"
#include "standstill.hpp"
#include "trimmed_offset.hpp"

namespace splinecore {

namespace {

/// A corner whose tangents meet farther away than so many distances is not sharp.
constexpr double kLongestCorner = 4.0;

/// How much of the direction at an end of a piece may be rounding: of what is short, and begins slowly, much.
double direction_noise(const BezierCurve& piece) {
  const double degree = piece.degree();
  return kRoundingOfShape * degree * degree / length_of(piece);
}

/// Runs of pieces that follow each other, offset; what is at their joints.
class CurveOffset {
 public:
  CurveOffset(const BezierPieces& pieces, const SideStep& step, OffsetCorner corner)
      : pieces_(pieces), step_(step), corner_(corner) {}

  std::vector<BezierPieces> runs() {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (i == 0 || glm::distance(end_of(pieces_[i - 1]), start_of(pieces_[i])) > kSamePlace) {
        runs_.emplace_back();
      } else {
        turn(pieces_[i - 1], pieces_[i]);
      }
      for (BezierCurve& made : offset_piece(pieces_[i], step_)) follow(std::move(made));
    }
    if (runs_.size() == 1 && glm::distance(end_of(pieces_.back()), start_of(pieces_.front())) <= kSamePlace) {
      turn(pieces_.back(), pieces_.front());
    }
    std::erase_if(runs_, [](const BezierPieces& run) { return run.empty(); });
    return std::move(runs_);
  }

  /// Of the corners that are sharp, when the runs are made.
  std::vector<SharpTip> tips() { return std::move(tips_); }

 private:
  /// Of a piece that is little more than rounding the direction is, too: what is left open behind it is closed.
  void follow(BezierCurve piece) {
    BezierPieces& run = runs_.back();
    if (!run.empty() && glm::distance(end_of(run.back()), start_of(piece)) > kSamePlace) {
      run.push_back(bezier_line(end_of(run.back()), start_of(piece)));
    }
    run.push_back(std::move(piece));
  }

  /// What joins the offsets of two pieces at their corner.
  void turn(const BezierCurve& before, const BezierCurve& behind) {
    const OffsetPlace a = offset_place(before, 1.0, step_);
    const OffsetPlace b = offset_place(behind, 0.0, step_);
    if (glm::distance(a.moved, b.moved) <= kSamePlace) return;
    const double sine = glm::dot(glm::cross(a.tangent, b.tangent), step_.normal);
    const double cosine = glm::dot(a.tangent, b.tangent);
    double angle = std::atan2(sine, cosine);
    // Where the curve turns back its offset goes round its tip.
    constexpr double kBack = 1e-9;
    const double unsure = direction_noise(before) + direction_noise(behind);
    if (cosine < 0.0 && std::abs(sine) <= std::max(kBack, unsure)) angle = step_.distance > 0.0 ? -std::numbers::pi : std::numbers::pi;
    // On the inner side of a corner offsets cross; a line between them is nearer to the curve than they are.
    if (angle * step_.distance > 0.0) {
      follow(bezier_line(a.moved, b.moved));
    } else if (corner_ == OffsetCorner::sharp && 1.0 < kLongestCorner * std::cos(0.5 * angle)) {
      const glm::dvec3 tip = a.moved + std::abs(step_.distance) * std::tan(0.5 * std::abs(angle)) * a.tangent;
      follow(bezier_line(a.moved, tip));
      follow(bezier_line(tip, b.moved));
      tips_.push_back({a.point, a.moved, tip, b.moved});
    } else {
      arc(a, angle);
    }
  }

  void arc(const OffsetPlace& from, double angle) {
    const int count = static_cast<int>(std::ceil(std::abs(angle) / (0.5 * std::numbers::pi) - 1e-9));
    const double half = 0.5 * std::abs(angle) / count;
    const glm::dvec3 x = from.moved - from.point;
    const glm::dvec3 y = glm::cross(step_.normal, x) * (angle < 0.0 ? -1.0 : 1.0);
    const auto at = [&](double turn, double stretch) {
      return from.point + stretch * (std::cos(turn) * x + std::sin(turn) * y);
    };
    for (int i = 0; i < count; ++i) {
      const double start = 2.0 * half * i;
      follow(BezierCurve::make({glm::dvec4(at(start, 1.0), 1.0),
                                glm::dvec4(at(start + half, 1.0 / std::cos(half)), std::cos(half)),
                                glm::dvec4(at(start + 2.0 * half, 1.0), 1.0)}));
    }
  }

  const BezierPieces& pieces_;
  const SideStep& step_;
  OffsetCorner corner_;
  std::vector<BezierPieces> runs_;
  std::vector<SharpTip> tips_;
};

/// A circle about a point.
BezierPieces circle_about(const glm::dvec3& center, const SideStep& step) {
  const glm::dvec3 across = std::abs(step.normal.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 x = std::abs(step.distance) * glm::normalize(glm::cross(step.normal, across));
  const glm::dvec3 y = glm::cross(step.normal, x);
  BezierPieces circle;
  for (const auto& [a, b] : {std::pair{x, y}, std::pair{y, -x}, std::pair{-x, -y}, std::pair{-y, x}}) {
    const glm::dvec4 corner(center + a + b, std::numbers::sqrt2 / 2.0);
    circle.push_back(BezierCurve::make({glm::dvec4(center + a, 1.0), corner, glm::dvec4(center + b, 1.0)}));
  }
  return circle;
}

/// Whether two pieces that follow each other have a corner between them.
bool turns(const BezierCurve& before, const BezierCurve& behind, const SideStep& step) {
  return glm::distance(offset_place(before, 1.0, step).moved, offset_place(behind, 0.0, step).moved) > kSamePlace;
}

/// What bounds the places that are nearer to a curve than its offset, beside that: about corners that are sharp there, too.
std::vector<BezierPieces> other_bounds(const BezierPieces& pieces, const SideStep& step, OffsetCorner corner) {
  const SideStep other{step.normal, -step.distance, step.tolerance};
  std::vector<BezierPieces> bounds = CurveOffset(pieces, other, OffsetCorner::round).runs();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const BezierCurve& next = pieces[(i + 1) % pieces.size()];
    if (glm::distance(end_of(pieces[i]), start_of(next)) <= kSamePlace) {
      if (corner == OffsetCorner::sharp && turns(pieces[i], next, step)) {
        bounds.push_back(circle_about(end_of(pieces[i]), step));
      }
      continue;
    }
    bounds.push_back(circle_about(end_of(pieces[i]), step));
    bounds.push_back(circle_about(start_of(next), step));
  }
  return bounds;
}

void require_plane(const BezierPieces& pieces, const SideStep& step, const NearSpace& space) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const BezierCurve& piece : pieces) {
    for (const glm::dvec4& p : piece.points()) {
      if (p.w == 0.0) continue;
      const double height = glm::dot(glm::dvec3(p), step.normal);
      low = std::min(low, height);
      high = std::max(high, height);
    }
  }
  if (high - low > step.tolerance) {
    throw InvalidShape("the curve is not in a plane with this normal: its points differ by " +
                       std::to_string(space.length(high - low)) + " along it");
  }
}

}  // namespace

std::vector<NurbsCurve> offset_parts(const NurbsCurve& curve, double distance, const OffsetOptions& options) {
  if (!std::isfinite(distance) || distance == 0.0) throw InvalidShape("the distance must be finite and not 0");
  const double length = glm::length(options.normal);
  if (!(length > 0.0) || !std::isfinite(length)) throw InvalidShape("the normal is zero or not finite");
  if (options.tolerance && !(*options.tolerance > 0.0)) throw InvalidShape("the tolerance is not above 0");
  const NearSpace space(curve.points());
  const SideStep step{options.normal / length, distance / space.length(1.0), cubics_tolerance(space, options.tolerance)};
  BezierPieces pieces;
  for (const BezierCurve& piece : to_bezier(curve)) {
    const BezierCurve near = piece.with_points(space.enter(piece.points()));
    constexpr double kNothing = 0x1p-46;
    if (!(length_of(near) > kNothing)) continue;
    for (BezierCurve& part : cut_where_still(near)) {
      pieces.push_back(std::move(part));
    }
  }
  constexpr double kMostRounding = 0x1p-8;  // of what is about 1 large: it is rounding, but for a few bits
  if (pieces.empty() || space.rounding() > kMostRounding) {
    throw InvalidShape("the curve is a point: there is nothing beside it");
  }
  require_plane(pieces, step, space);
  const SideStep fine{step.normal, step.distance, options.trimmed ? 0.5 * step.tolerance : step.tolerance};
  CurveOffset untrimmed(pieces, fine, options.corner);
  std::vector<BezierPieces> runs = untrimmed.runs();
  if (options.trimmed) runs = trimmed_offset(curve, space, step, runs, other_bounds(pieces, fine, options.corner), untrimmed.tips());
  std::vector<NurbsCurve> found;
  for (const BezierPieces& run : runs) {
    const NurbsCurve near = curve_of(run);
    found.push_back(near.with_points(space.leave(near.points())));
  }
  return found;
}

std::vector<NurbsCurve> offset(const NurbsCurve& curve, double distance, const OffsetOptions& options) {
  std::vector<NurbsCurve> found = offset_parts(curve, distance, options);
  if (found.empty()) {
    throw InvalidShape("nothing is left of the offset: on that side no place is as far from all of the curve as the distance");
  }
  return found;
}

}  // namespace splinecore
