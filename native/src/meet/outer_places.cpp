#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/rounding.hpp"
#include "patch_places.hpp"
#include "piece_side.hpp"
#include "stationary_line.hpp"

namespace splinecore {

namespace {

using Net = BernsteinNet<glm::dvec4>;

/// A side of all pieces of a span of an axis.
struct SpanSide {
  Axis axis;
  std::size_t span;
  bool is_end;

  Axis along() const noexcept { return axis == Axis::u ? Axis::v : Axis::u; }

  PiecePlace place(std::size_t i, double t) const noexcept {
    const double at = is_end ? 1.0 : 0.0;
    return axis == Axis::u ? PiecePlace{{span, i}, {at, t}} : PiecePlace{{i, span}, {t, at}};
  }
};

/// Where a patch ends or has an edge, and what is on either side.
using EdgeLine = std::vector<SpanSide>;

/// Borders, and knots of full multiplicity: what lies beside these is one line, or two where the patch is torn.
std::vector<EdgeLine> lines_of(const NearPatch& patch, Axis axis) {
  const KnotVector& knots = patch.knots(axis);
  const std::size_t count = patch.spans(axis);
  std::vector<EdgeLine> lines;
  for (std::size_t i = 0; i < count; ++i) {
    const SpanSide right{axis, i, false};
    const SpanSide left{axis, i > 0 ? i - 1 : count - 1, true};
    const int times = multiplicity(knots, patch.span(axis, i).start);
    if (i == 0 && !knots.periodic()) {
      lines.push_back({right});
      if (patch.is_closed(axis)) lines.back().push_back(left);
    } else if (times > knots.degree()) {
      lines.push_back({left});
      lines.push_back({right});
    } else if (times == knots.degree()) {
      lines.push_back({right, left});
    }
  }
  if (!knots.periodic() && !patch.is_closed(axis)) lines.push_back({{axis, count - 1, true}});
  return lines;
}

/// Whether the distance from the point rises (1) or falls (-1) from a line into the patch on one side; 0 where rounding
/// does not tell.
int inward_sign(const NearPatch& patch, const SpanSide& side, std::size_t i, double t) {
  constexpr double kFlat = 0x1p-40;
  const Slopes<2> here = patch.slopes(side.place(i, t));
  const glm::dvec3& way = here.first[static_cast<std::size_t>(side.axis)];
  const double slope = glm::dot(here.offset, way) * (side.is_end ? -1.0 : 1.0);
  const double wrong = kFlat * glm::length(here.offset) + kRoundingOfSum + patch.rounding();
  if (std::abs(slope) <= wrong * glm::length(way)) return 0;
  return slope > 0.0 ? 1 : -1;
}

/// The signs on the sides of a line: none, one kind or both.
struct LineSigns {
  bool rises = false;
  bool falls = false;

  void add(int sign) noexcept {
    rises = rises || sign > 0;
    falls = falls || sign < 0;
  }
};

class LineSearch {
 public:
  LineSearch(PatchPlaces& places, const EdgeLine& line)
      : places_(places), patch_(places.patch()), line_(line), along_(line.front().along()) {
    for (std::size_t i = 0; i < patch_.spans(along_); ++i) {
      edges_.push_back(side_of(net(line.front(), i), piece_side(line.front())));
    }
  }

  void add_pole() {
    if (!is_pole()) return;
    PoleSigns all;
    all.is_stationary = true;
    for (const SpanSide& side : line_) {
      for (std::size_t i = 0; i < edges_.size(); ++i) {
        const PoleSigns signs = pole_signs(net(side, i), piece_side(side), patch_.point(), patch_.rounding());
        all.rises = all.rises || signs.rises;
        all.falls = all.falls || signs.falls;
        all.is_stationary = all.is_stationary && signs.is_stationary;
      }
    }
    const bool counts = all.is_stationary || !(all.rises && all.falls);
    const Stationary kind = kind_of(all.falls ? 1 : -1, all.rises ? 1 : -1);
    places_.add_pole(line_.front().axis, line_.front().place(0, 0.0), counts ? std::optional(kind) : std::nullopt);
  }

  void add_places() {
    if (is_pole()) return;
    const auto constant = [&](std::size_t i) { pass_constant(i); };
    const PieceLine pieces{patch_.knots(along_), patch_.is_closed(along_), edges_};
    for (const LinePlace& place : stationary_places(pieces, patch_.point(), patch_.rounding(), constant)) {
      add(place);
    }
  }

 private:
  static PieceSide piece_side(const SpanSide& side) noexcept { return {side.axis, side.is_end}; }
  const Net& net(const SpanSide& side, std::size_t i) const noexcept { return patch_.net(side.place(i, 0.0).piece); }

  bool is_point(std::size_t i) const {
    return splinecore::is_point(net(line_.front(), i), piece_side(line_.front()), patch_.rounding());
  }

  bool is_pole() const {
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      if (!is_point(i)) return false;
    }
    return true;
  }

  void add(const LinePlace& place) {
    LineSigns signs;
    for (const SpanSide& side : line_) {
      signs.add(inward_sign(patch_, side, place.piece, place.t));
      const bool goes_on = place.t == 0.0 && place.before != 0;
      if (goes_on) signs.add(inward_sign(patch_, side, place.piece > 0 ? place.piece - 1 : edges_.size() - 1, 1.0));
    }
    const Stationary kind = kind_of(place.before, place.after);
    const bool is_extreme = (kind == Stationary::minimum && !signs.falls) ||
                            (kind == Stationary::maximum && !signs.rises);
    if (is_extreme) places_.add_outer(line_.front().place(place.piece, place.t), kind);
  }

  /// A line at one distance matters where that is an extreme one.
  void pass_constant(std::size_t i) const {
    if (is_point(i)) return;
    for (const double t : {0.25, 0.5, 0.75}) {
      LineSigns signs;
      for (const SpanSide& side : line_) signs.add(inward_sign(patch_, side, i, t));
      const PiecePlace place = line_.front().place(i, t);
      if (!(signs.rises && signs.falls) && !places_.is_too_far(place)) places_.refuse_curve(place);
    }
  }

  PatchPlaces& places_;
  const NearPatch& patch_;
  const EdgeLine& line_;
  Axis along_;
  std::vector<Net> edges_;
};

}  // namespace

void add_poles(PatchPlaces& places) {
  for (const Axis axis : {Axis::u, Axis::v}) {
    for (const EdgeLine& line : lines_of(places.patch(), axis)) LineSearch(places, line).add_pole();
  }
}

void add_outer_places(PatchPlaces& places) {
  for (const Axis axis : {Axis::u, Axis::v}) {
    for (const EdgeLine& line : lines_of(places.patch(), axis)) LineSearch(places, line).add_places();
  }
}

}  // namespace splinecore
