#include "seam_jets.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

namespace splinecore {

namespace {

/// Inside a span, where weights that differ squeeze what happens towards its ends: evenly by the logarithm of t / (1 - t), in
/// which such curves are moved, not squeezed.
std::vector<double> squeezed_shares(double spread, int degree) {
  constexpr double kBeyond = 3.0;
  constexpr double kEven = 4.0;
  if (spread <= kEven) return {};
  const double reach = std::log(spread) + kBeyond;
  const int count = static_cast<int>(std::ceil(reach * degree / 3.0));
  std::vector<double> shares;
  for (int k = -count; k <= count; ++k) shares.push_back(1.0 / (1.0 + std::exp(-reach * k / count)));
  return shares;
}

/// Evenly spaced in each span of either, its ends from within it.
std::vector<SeamPlace> dense_places(const Flank& a, const Flank& b) {
  std::vector<double> knots{0.0, 1.0};
  for (const Flank* flank : {&a, &b}) std::ranges::copy(flank->inner_knots(), std::back_inserter(knots));
  std::ranges::sort(knots);
  const int count = 2 * (a.degree_along() + b.degree_along()) + 3;
  std::vector<SeamPlace> places;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const double length = knots[i + 1] - knots[i];
    if (length <= kSameShare) continue;
    const double middle = knots[i] + 0.5 * length;
    const double spread = std::max(a.weight_spread(middle), b.weight_spread(middle));
    std::vector<double> shares = squeezed_shares(spread, a.degree_along() + b.degree_along());
    for (int k = 1; k < count; ++k) shares.push_back(static_cast<double>(k) / count);
    std::ranges::sort(shares);
    places.push_back({knots[i], Side::right});
    for (const double share : shares) places.push_back({knots[i] + length * share, Side::right});
    places.push_back({knots[i + 1], Side::left});
  }
  return places;
}

void take_normal(const SeamJet& from, SeamJet& to) {
  to.normal = from.normal;
  to.curvature = from.curvature;
  to.rise = from.rise;
}

/// Which one is largest, if it is more than rounding.
std::size_t largest_at(const SeamJets& jets, SeamMeasure measure) {
  constexpr double kNegligible = 1e-9;
  double largest = kNegligible;
  std::size_t found = jets.places.size();
  for (std::size_t i = 0; i < jets.places.size(); ++i) {
    const double value = measure(jets.a[i], jets.b[i]);
    if (!(value > largest)) continue;
    largest = value;
    found = i;
  }
  return found;
}

/// Whether a measure is the same, but for rounding, at both places beside one.
bool is_level_at(const SeamJets& jets, SeamMeasure measure, std::size_t at) {
  constexpr double kRounding = 1e-12;
  const double value = measure(jets.a[at], jets.b[at]);
  const auto is_same = [&](std::size_t i) { return std::abs(measure(jets.a[i], jets.b[i]) - value) <= kRounding * value; };
  return (at == 0 || is_same(at - 1)) && (at + 1 == jets.places.size() || is_same(at + 1));
}

/// So many peaks of a measure are looked at more closely, for a spike may be higher than where it was met.
constexpr std::size_t kFew = 8;

/// Places at which a measure is larger than beside them, no more than `most`: nearly as large as anywhere, or among the few
/// largest of these.
std::vector<std::size_t> peaks_of(const SeamJets& jets, SeamMeasure measure, std::size_t most) {
  constexpr double kHigh = 0.7;
  const std::size_t top = largest_at(jets, measure);
  const std::size_t count = jets.places.size();
  if (top == count) return {};
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(measure(jets.a[i], jets.b[i]));
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_lower = (i > 0 && values[i - 1] > values[i]) || (i + 1 < count && values[i + 1] > values[i]);
    if (!is_lower && values[i] > 0.0 && !is_level_at(jets, measure, i)) found.push_back(i);
  }
  const auto high = std::ranges::count_if(found, [&](std::size_t i) { return values[i] >= kHigh * values[top]; });
  const std::size_t wanted = std::min({found.size(), std::max(kFew, static_cast<std::size_t>(high)), most});
  const auto is_before = [&](std::size_t i, std::size_t j) {
    return values[i] > values[j] || (values[i] == values[j] && i < j);
  };
  std::ranges::nth_element(found, found.begin() + static_cast<std::ptrdiff_t>(wanted), is_before);
  found.resize(wanted);
  return found;
}

/// For each place whether one beside the step from there to the next one, which has a length, is such a peak of a measure.
std::vector<bool> steps_beside_peaks(const SeamJets& jets, std::span<const SeamMeasure> measures, std::size_t most) {
  const auto& places = jets.places;
  std::vector<bool> chosen(places.size(), false);
  for (const SeamMeasure measure : measures) {
    for (const std::size_t at : peaks_of(jets, measure, most)) {
      const auto is_there = [&](std::size_t i) { return std::abs(places[i].share - places[at].share) <= kSameShare; };
      std::size_t before = at;
      std::size_t behind = at;
      while (before > 0 && is_there(before)) --before;
      while (behind + 1 < places.size() && is_there(behind + 1)) ++behind;
      if (!is_there(before)) chosen[before] = true;
      if (behind + 1 < places.size()) chosen[behind] = true;
    }
  }
  return chosen;
}

std::vector<double> largest_of(const SeamJets& jets, std::span<const SeamMeasure> measures) {
  std::vector<double> found;
  for (const SeamMeasure measure : measures) {
    const std::size_t at = largest_at(jets, measure);
    found.push_back(at < jets.places.size() ? measure(jets.a[at], jets.b[at]) : 0.0);
  }
  return found;
}

/// Whether a spike is narrower than what lies between the places.
bool grows(const std::vector<double>& before, const std::vector<double>& tops) {
  constexpr double kLittle = 1.005;
  for (std::size_t i = 0; i < tops.size(); ++i) {
    if (tops[i] > kLittle * before[i]) return true;
  }
  return false;
}

/// With more places in these steps.
SeamJets closer(const Flank& a, const Flank& b, SeamDepth depth, const SeamJets& jets, const std::vector<bool>& steps) {
  constexpr int kParts = 5;
  std::vector<SeamPlace> more;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (!steps[i]) continue;
    const double from = jets.places[i].share;
    const double length = jets.places[i + 1].share - from;
    for (int k = 1; k < kParts; ++k) more.push_back({from + length * k / kParts, Side::right});
  }
  const SeamJets between = seam_jets(a, b, std::move(more), depth);
  SeamJets all;
  std::size_t next = 0;
  const auto take = [&](const SeamJets& from, std::size_t i) {
    all.places.push_back(from.places[i]);
    all.a.push_back(from.a[i]);
    all.b.push_back(from.b[i]);
  };
  for (std::size_t i = 0; i < steps.size(); ++i) {
    take(jets, i);
    for (int k = 1; steps[i] && k < kParts; ++k) take(between, next++);
  }
  return all;
}

}  // namespace

// Where a normal is the limit of many, as at the end of a meridian, both are those a little way on along the seam, if there
// are such: the limit along it, nearly.
SeamJets seam_jets(const Flank& a, const Flank& b, std::vector<SeamPlace> places, SeamDepth depth) {
  constexpr double kWay = 1e-3;
  SeamJets here{std::move(places), {}, {}};
  here.a = a.jets(here.places, depth);
  here.b = b.jets(here.places, depth);
  std::vector<std::size_t> singular;
  std::vector<SeamPlace> beside;
  for (std::size_t i = 0; i < here.places.size(); ++i) {
    if (here.a[i].is_regular && here.b[i].is_regular) continue;
    const SeamPlace& place = here.places[i];
    const double way = kWay * std::min(a.room(place), b.room(place));
    singular.push_back(i);
    beside.push_back({place.share + (place.side == Side::right ? way : -way), place.side});
  }
  if (singular.empty()) return here;
  const std::vector<SeamJet> of_a = a.jets(beside, depth);
  const std::vector<SeamJet> of_b = b.jets(beside, depth);
  for (std::size_t i = 0; i < singular.size(); ++i) {
    if (!of_a[i].is_regular || !of_b[i].is_regular) continue;
    take_normal(of_a[i], here.a[singular[i]]);
    take_normal(of_b[i], here.b[singular[i]]);
  }
  return here;
}

SeamJets dense_seam_jets(const Flank& a, const Flank& b, SeamDepth depth, std::span<const SeamMeasure> measures) {
  constexpr int kRounds = 4;
  constexpr int kMostRounds = 8;
  SeamJets jets = seam_jets(a, b, dense_places(a, b), depth);
  std::vector<double> tops = largest_of(jets, measures);
  for (int round = 0; round < kMostRounds; ++round) {
    const std::size_t most = round < kRounds ? jets.places.size() : kFew;     // what is rounding has very many
    const std::vector<bool> steps = steps_beside_peaks(jets, measures, most);
    if (std::ranges::find(steps, true) == steps.end()) break;
    jets = closer(a, b, depth, jets, steps);
    const std::vector<double> before = std::exchange(tops, largest_of(jets, measures));
    if (round + 1 >= kRounds && !grows(before, tops)) break;
  }
  return jets;
}

double largest_along(const Flank& a, const Flank& b, SeamDepth depth, SeamMeasure measure) {
  constexpr int kParts = 3;
  constexpr int kRounds = 3;
  const SeamJets dense = seam_jets(a, b, dense_places(a, b), depth);
  const std::size_t at = largest_at(dense, measure);
  double largest = 0.0;
  for (std::size_t i = 0; i < dense.places.size(); ++i) largest = std::max(largest, measure(dense.a[i], dense.b[i]));
  if (at == dense.places.size()) return largest;
  double place = dense.places[at].share;
  double step = 0.0;
  for (const SeamPlace& other : dense.places) {
    const double way = std::abs(other.share - place);
    if (way > kSameShare && (step == 0.0 || way < step)) step = way;
  }
  for (int round = 0; round < kRounds; ++round) {
    std::vector<SeamPlace> more;
    for (int k = 1 - kParts; k < kParts; ++k) {
      const double share = place + step * k / kParts;
      if (k != 0 && share > 0.0 && share < 1.0) more.push_back({share, Side::right});
    }
    const SeamJets jets = seam_jets(a, b, std::move(more), depth);
    for (std::size_t i = 0; i < jets.places.size(); ++i) {
      const double value = measure(jets.a[i], jets.b[i]);
      if (!(value > largest)) continue;
      largest = value;
      place = jets.places[i].share;
    }
    step /= kParts;
  }
  return largest;
}

}  // namespace splinecore
