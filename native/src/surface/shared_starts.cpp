#include "shared_starts.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "curve/near_knot.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

/// How far knots may be apart that are one, as a part of the period.
double same_of(const NurbsCurve& curve) {
  constexpr double kSame = 0x1p-40;
  return std::max(kSame, knot_rounding(curve.domain()));
}

struct KnotShare {
  double at;
  double knot;
};

/// Each knot of a period once.
std::vector<KnotShare> shares_of(const NurbsCurve& curve) {
  const Interval domain = curve.domain();
  std::vector<KnotShare> found;
  for (const double knot : curve.knot_vector().knots()) {
    const double share = (knot - domain.start) / domain.length();
    if (knot < domain.end && (found.empty() || knot != found.back().knot)) found.push_back({share, knot});
  }
  return found;
}

/// Of numbers in order the least in size among those of which most are one.
/// @param same  how far those may be apart
double of_most(const std::vector<double>& numbers, double same) {
  std::size_t most = 0;
  double best = 0.0;
  for (std::size_t i = 0, end = 0; i < numbers.size(); ++i) {
    while (end < numbers.size() && numbers[end] <= numbers[i] + same) ++end;
    const std::size_t count = end - i;
    if (count < most || (count == most && std::abs(numbers[i]) >= std::abs(best))) continue;
    most = count;
    best = numbers[i];
  }
  return best;
}

}  // namespace

void SharedStarts::add(const NurbsCurve& curve) {
  const double same = same_of(curve);
  const std::vector<KnotShare> own = shares_of(curve);
  std::vector<double> all = std::move(shares_);
  const auto middle = static_cast<std::ptrdiff_t>(all.size());
  for (const KnotShare& one : own) all.push_back(one.at);
  std::inplace_merge(all.begin(), all.begin() + middle, all.end());
  shares_.clear();
  for (const double share : all) {
    if (shares_.empty() || share - shares_.back() > same) shares_.push_back(share);
  }
  most_ = std::max(most_, own.size());
}

double SharedStarts::start_near(const NurbsCurve& curve, double best) const {
  constexpr double kOfPeriod = 0x1p-9;
  constexpr double kOfSpan = 0x1p-4;
  const Interval domain = curve.domain();
  const std::vector<KnotShare> own = shares_of(curve);
  const double reach = std::min(kOfPeriod, kOfSpan / static_cast<double>(std::max(most_, own.size())));
  const double wanted = (best - domain.start) / domain.length();
  std::vector<double> offs;
  for (const KnotShare& one : own) {
    breathe(1);
    const double place = one.at - wanted;
    const double from = place - std::floor(place);
    for (const double turn : {-1.0, 0.0, 1.0}) {
      const auto end = std::ranges::upper_bound(shares_, from + turn + reach);
      for (auto share = std::ranges::lower_bound(shares_, from + turn - reach); share != end; ++share) {
        offs.push_back(from + turn - *share);
      }
    }
  }
  if (offs.empty()) return best;
  std::ranges::sort(offs);
  const double same = same_of(curve);
  const double off = of_most(offs, same);
  for (const KnotShare& one : own) {
    const double by = one.at - wanted - off;
    if (std::abs(by - std::round(by)) <= same) return one.knot;
  }
  return best + off * domain.length();
}

}  // namespace splinecore
