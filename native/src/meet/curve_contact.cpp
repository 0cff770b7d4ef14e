#include "curve_contact.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <vector>

#include "contact_place.hpp"

namespace splinecore {

namespace {

/// From a place of the first curve to the foot on the second one, by Newton's method from one that is near.
glm::dvec3 gap_at(const TwoCurves& curves, double place, const CurveSpot& near) {
  constexpr int kRounds = 4;
  const glm::dvec3 point = curves.a.at(curves.a.spot(place)).point;
  double foot = curves.b.place(near);
  Slopes<1> b = curves.b.at(near, point);
  const auto along = [&] {
    const double square = glm::dot(b.first[0], b.first[0]);
    return square > 0.0 ? glm::dot(b.offset, b.first[0]) / square : 0.0;
  };
  for (int round = 0; round < kRounds; ++round) {
    foot -= along();
    b = curves.b.at(curves.b.spot(foot), point);
  }
  return b.offset - along() * b.first[0];
}

/// Places in an interval as the parameter of a curve runs, whose pieces have more or less of it: from 0 to 1.
class EvenPace {
 public:
  EvenPace(const CurvePieces& curve, const Interval& along) : places_{along.start}, shares_{0.0} {
    while (places_.back() < along.end) {
      const double end = std::min(curve.end_behind(places_.back()), along.end);
      const std::size_t piece = curve.spot(0.5 * (places_.back() + end)).piece;
      shares_.push_back(shares_.back() + (end - places_.back()) * curve.span_length(piece));
      places_.push_back(end);
    }
    for (double& share : shares_) share /= shares_.back();
  }

  double share(double place) const { return between(places_, place, shares_); }
  double place(double share) const { return between(shares_, share, places_); }

 private:
  static double between(const std::vector<double>& of, double x, const std::vector<double>& to) {
    std::size_t i = 1;
    while (i + 1 < of.size() && x > of[i]) ++i;
    const double part = (x - of[i - 1]) / (of[i] - of[i - 1]);
    return to[i - 1] + part * (to[i] - to[i - 1]);
  }

  std::vector<double> places_;
  std::vector<double> shares_;
};

}  // namespace

std::optional<double> contact_in(const CurveCluster& cluster, const TwoCurves& curves, const Interval& near) {
  if (!(near.length() > 0.0)) return {};
  const EvenPace pace(curves.a, near);
  const Interval part = cluster.longest_in_pieces(near);
  const auto contact = contact_place({Interval{}, {pace.share(part.start), pace.share(part.end)}}, [&](double share) {
    const double place = pace.place(share);
    return gap_at(curves, place, cluster.at(curves, place).b);
  });
  return contact ? std::optional(pace.place(*contact)) : std::nullopt;
}

}  // namespace splinecore
