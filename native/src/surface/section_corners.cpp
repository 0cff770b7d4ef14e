#include "section_corners.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <utility>

#include "fitted_together.hpp"
#include "kink.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

constexpr double kSeen = 0.02;      // radians
constexpr double kSame = 0x1p-40;   // of a domain
constexpr double kAsNear = 1e-12;   // of the sizes of curves

std::vector<double> corners_at_level(const NurbsCurve& curve, CornerLevel level, bool is_cyclic) {
  const Interval domain = curve.domain();
  std::vector<double> found = level == CornerLevel::all ? corners_of({&curve, 1}) : corners_above(curve, kSeen);
  for (double& u : found) u = u == domain.end ? domain.start : u;
  std::ranges::sort(found);
  const auto repeated = std::ranges::unique(found);
  found.erase(repeated.begin(), repeated.end());
  if (!is_cyclic) std::erase(found, domain.start);
  return found;
}

/// Points of the pieces between corners, as many in each; of periodic curves from the first corner on.
using PiecePlaces = std::vector<std::vector<glm::dvec3>>;

PiecePlaces places_of(const NurbsCurve& curve, const std::vector<double>& corners, bool is_cyclic) {
  constexpr int kInPiece = 16;
  const Interval domain = curve.domain();
  std::vector<double> ends = corners;
  if (is_cyclic) {
    ends.push_back(corners.front() + domain.length());
  } else {
    ends.insert(ends.begin(), domain.start);
    ends.push_back(domain.end);
  }
  PiecePlaces places;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    breathe(kInPiece);
    std::vector<double> at;
    for (int k = 0; k < kInPiece; ++k) {
      const double u = ends[i] + (ends[i + 1] - ends[i]) * (k + 0.5) / kInPiece;
      at.push_back(u < domain.end ? u : is_cyclic ? u - domain.length() : domain.end);
    }
    std::vector<glm::dvec3> points(at.size());
    evaluate(curve, at, {&points.front().x, 3 * points.size()});
    places.push_back(std::move(points));
  }
  return places;
}

PiecePlaces about_middle(PiecePlaces places) {
  glm::dvec3 middle(0.0);
  double count = 0.0;
  for (const auto& piece : places) {
    for (const glm::dvec3& p : piece) middle += p;
    count += static_cast<double>(piece.size());
  }
  for (auto& piece : places) {
    for (glm::dvec3& p : piece) p -= middle / count;
  }
  return places;
}

/// Of pieces with those of another curve from a place on.
double product(const PiecePlaces& a, const PiecePlaces& b, std::size_t shift) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto& other = b[(i + shift) % b.size()];
    for (std::size_t k = 0; k < a[i].size(); ++k) sum += glm::dot(a[i][k], other[k]);
  }
  return sum;
}

struct Candidate {
  SectionTurn turn;
  double nearness;
};

/// How a curve that runs one way is best begun beside another one.
std::optional<Candidate> nearest(const PiecePlaces& before, const NurbsCurve& curve, const SectionCorners& kind, bool is_reversed) {
  const std::vector<double> corners = corners_at_level(curve, kind.level, kind.is_cyclic);
  if (corners.size() != kind.at[0].size()) return {};
  const PiecePlaces own = about_middle(places_of(curve, corners, kind.is_cyclic));
  if (!kind.is_cyclic) return Candidate{{is_reversed, {}}, product(before, own, 0)};
  std::optional<Candidate> best;
  for (std::size_t shift = 0; shift < own.size(); ++shift) {
    const double nearness = product(before, own, shift);
    if (best && !(nearness > best->nearness)) continue;
    const double at = corners[shift];
    best = Candidate{{is_reversed, at == curve.domain().start ? std::nullopt : std::optional(at)}, nearness};
  }
  return best;
}

double size_of(const PiecePlaces& places) { return std::sqrt(product(places, places, 0)); }

/// The knots, each moved as the piece moves that it lies in.
std::vector<double> moved(std::span<const double> knots, const std::vector<double>& from, const std::vector<double>& to) {
  std::vector<double> places;
  for (const double knot : knots) {
    const auto after = std::ranges::upper_bound(from, knot) - from.begin();
    const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after - 1, 0, std::ssize(from) - 2));
    const bool is_break = knot == from[i] || knot == from[i + 1];
    const double share = (knot - from[i]) / (from[i + 1] - from[i]);
    places.push_back(is_break ? (knot == from[i] ? to[i] : to[i + 1]) : to[i] + share * (to[i + 1] - to[i]));
  }
  for (std::size_t i = 1; i < knots.size(); ++i) {
    if ((knots[i] > knots[i - 1]) == (places[i] > places[i - 1])) continue;
    throw InvalidShape("a section has knots that lie so near to each other that they would coincide where its corners are matched");
  }
  return places;
}

}  // namespace

bool SectionCorners::are_as_many() const {
  return !at.empty() && !at[0].empty() &&
         std::ranges::all_of(at, [&](const std::vector<double>& one) { return one.size() == at[0].size(); });
}

SectionCorners section_corners(std::span<const NurbsCurve> curves, bool has_free_seams) {
  const bool is_cyclic = has_free_seams && std::ranges::all_of(curves, &NurbsCurve::periodic);
  SectionCorners found{CornerLevel::all, is_cyclic, {}};
  for (const CornerLevel level : {CornerLevel::all, CornerLevel::seen}) {
    found.level = level;
    found.at.clear();
    for (const NurbsCurve& curve : curves) found.at.push_back(corners_at_level(curve, level, is_cyclic));
    if (found.are_as_many()) break;
  }
  return found;
}

std::vector<SectionTurn> turns_by_corners(const std::vector<NurbsCurve>& curves, const SectionCorners& corners) {
  std::vector<SectionTurn> turns;
  NurbsCurve before = curves[0];
  for (std::size_t i = 0; i < curves.size(); ++i) {
    SectionTurn best;
    if (i == 0) {
      const double first = corners.at[0].front();
      if (corners.is_cyclic && first != curves[0].domain().start) best.seam = first;
    } else {
      const auto own = corners_at_level(before, corners.level, corners.is_cyclic);
      const PiecePlaces places = about_middle(places_of(before, own, corners.is_cyclic));
      const auto along = nearest(places, curves[i], corners, false);
      const auto against = nearest(places, reversed(curves[i]), corners, true);
      if (!along && !against) throw InvalidShape("a section's corners cannot be told apart");
      const double slack = along && against ? kAsNear * size_of(places) * size_of(places_of(curves[i], corners.at[i], corners.is_cyclic)) : 0.0;
      best = !along || (against && against->nearness > along->nearness + slack) ? against->turn : along->turn;
    }
    turns.push_back(best);
    before = turned(curves[i], best);
  }
  return turns;
}

NurbsCurve repaced(const NurbsCurve& given, std::span<const double> from, std::span<const double> to, Interval domain) {
  NurbsCurve curve = with_whole_seam(given);
  const Interval own = curve.domain();
  std::vector<double> missing;
  const auto add = [&](double u, std::ptrdiff_t copies) {
    missing.insert(missing.end(), static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, curve.degree() - copies)), u);
  };
  const auto knots = curve.knot_vector().knots();
  if (curve.periodic()) add(own.start, std::ranges::count(knots, own.start));
  for (const double u : from) add(u, std::ranges::count(knots, u));
  if (!missing.empty()) curve = with_whole_seam(refine(curve, missing));
  std::vector<double> before{own.start};
  std::vector<double> after{domain.start};
  before.insert(before.end(), from.begin(), from.end());
  after.insert(after.end(), to.begin(), to.end());
  before.push_back(own.end);
  after.push_back(domain.end);
  if (before == after) return curve;
  KnotVector paced = KnotVector::make(curve.degree(), moved(curve.knot_vector().knots(), before, after), curve.periodic());
  return NurbsCurve::make(std::move(paced), {curve.points().begin(), curve.points().end()});
}

std::vector<double> mean_corners(std::span<const NurbsCurve> curves, const SectionCorners& corners) {
  const Interval domain = curves[0].domain();
  const auto share = [&](std::size_t i, std::size_t k) {
    return (corners.at[i][k] - curves[i].domain().start) / curves[i].domain().length();
  };
  std::vector<double> means;
  bool is_one = true;
  for (std::size_t k = 0; k < corners.at[0].size(); ++k) {
    double sum = 0.0;
    for (std::size_t i = 0; i < curves.size(); ++i) {
      sum += share(i, k);
      is_one = is_one && std::abs(share(i, k) - share(0, k)) <= kSame;
    }
    means.push_back(domain.start + domain.length() * (sum / static_cast<double>(curves.size())));
  }
  return is_one ? corners.at[0] : means;
}

}  // namespace splinecore
