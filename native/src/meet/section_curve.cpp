#include "section_curve.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace splinecore {

namespace {

/// A place, and its derivative, in space or in the parameters of a patch.
struct SectionKnot {
  glm::dvec3 value;
  glm::dvec3 slope;
};

bool are_equal(const glm::dvec3& a, const glm::dvec3& b) {
  constexpr double kSame = 1e-9;
  return glm::length(a - b) <= kSame * std::max(glm::length(a), glm::length(b));
}

/// Places of one curve, and where it is smooth.
struct SectionChain {
  std::vector<SectionKnot> starts;  ///< of every step
  std::vector<SectionKnot> ends;

  bool is_smooth(std::size_t joint) const { return are_equal(ends[joint].slope, starts[joint + 1].slope); }
};

NurbsCurve curve_of(const SectionChain& chain, const KnotVector& knots, const std::vector<double>& lengths,
                    const std::vector<bool>& smooth) {
  std::vector<glm::dvec4> points{{chain.starts.front().value, 1.0}};
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    if (i > 0 && !smooth[i - 1]) points.emplace_back(chain.starts[i].value, 1.0);
    points.emplace_back(chain.starts[i].value + lengths[i] / 3.0 * chain.starts[i].slope, 1.0);
    points.emplace_back(chain.ends[i].value - lengths[i] / 3.0 * chain.ends[i].slope, 1.0);
  }
  points.emplace_back(chain.ends.back().value, 1.0);
  return NurbsCurve::make(knots, std::move(points));
}

KnotVector knots_of(const std::vector<double>& lengths, const std::vector<bool>& smooth) {
  std::vector<double> knots(4, 0.0);
  double at = 0.0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    at += lengths[i];
    knots.insert(knots.end(), i + 1 == lengths.size() ? 4U : smooth[i] ? 2U : 3U, at);
  }
  return KnotVector::make(3, std::move(knots), false);
}

/// The images of a trace in the parameters of one of the patches, over seams beyond the domain.
class Images {
 public:
  Images(const PatchPieces& pieces, std::size_t first) : pieces_(pieces), first_(first) {}

  SectionKnot at(const SectionPlace& place) {
    const PatchSpot& spot = first_ == 0 ? place.at.a : place.at.b;
    const std::array<double, 2> own = pieces_.parameters(spot);
    SectionKnot knot{glm::dvec3(0.0), glm::dvec3(0.0)};
    for (std::size_t i = 0; i < 2; ++i) {
      const Axis axis = i == 0 ? Axis::u : Axis::v;
      const auto k = static_cast<int>(i);
      const double turn = pieces_.knots(axis).domain().length();
      if (has_last_) before_[i] += std::round((last_[i] - before_[i] - own[i]) / turn) * turn;
      last_[i] = own[i] + before_[i];
      knot.value[k] = last_[i];
      knot.slope[k] = place.slopes[first_ + i] * pieces_.span_length(spot.piece, axis);
    }
    has_last_ = true;
    return knot;
  }

 private:
  const PatchPieces& pieces_;
  std::size_t first_;
  bool has_last_ = false;
  std::array<double, 2> last_{};
  std::array<double, 2> before_{};
};

}  // namespace

SectionCurve section_curve(const SectionTrace& trace, const TwoPatches& patches, const NearSpace& space) {
  constexpr double kNothing = 0x1p-35;
  SectionChain in_space;
  SectionChain on_a;
  SectionChain on_b;
  std::vector<double> lengths;
  Images of_a(patches.a, 0);
  Images of_b(patches.b, 2);
  const double unit = space.length(1.0);
  const auto put = [&](std::vector<SectionKnot> SectionChain::*which, const SectionPlace& place) {
    (in_space.*which).push_back({space.leave(place.point), place.tangent});
    (on_a.*which).push_back(of_a.at(place));
    (on_b.*which).push_back(of_b.at(place));
    for (SectionKnot* image : {&(on_a.*which).back(), &(on_b.*which).back()}) image->slope /= unit;
  };
  for (std::size_t i = 0; i + 1 < trace.places.size(); ++i) {
    const SectionPlace& from = trace.places[i];
    const SectionPlace& to = trace.places[i + 1];
    if (!from.has_pieces_of(to) || glm::distance(from.point, to.point) <= kNothing) continue;
    lengths.push_back(space.length(glm::distance(from.point, to.point)));
    put(&SectionChain::starts, from);
    put(&SectionChain::ends, to);
  }
  std::vector<bool> smooth;
  for (std::size_t i = 0; i + 1 < lengths.size(); ++i) {
    smooth.push_back(in_space.is_smooth(i) && on_a.is_smooth(i) && on_b.is_smooth(i));
  }
  const KnotVector knots = knots_of(lengths, smooth);
  return {curve_of(in_space, knots, lengths, smooth), curve_of(on_a, knots, lengths, smooth),
          curve_of(on_b, knots, lengths, smooth), trace.is_closed, SectionKind::crossing};
}

}  // namespace splinecore
