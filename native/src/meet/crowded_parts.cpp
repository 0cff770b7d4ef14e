#include "crowded_parts.hpp"

#include <algorithm>
#include <utility>

#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

/// So many parts that are near are few.
constexpr std::size_t kFew = 12;
/// Of fewer parts all pairs are looked at as fast.
constexpr std::size_t kLeastParts = 256;
constexpr int kMostHalvings = 7;

std::vector<CurvePart> parts_of(const CurvePieces& curve) {
  std::vector<CurvePart> parts;
  parts.reserve(curve.size());
  for (std::size_t i = 0; i < curve.size(); ++i) parts.emplace_back(i, Interval{}, curve.piece(i), curve.sums(i));
  return parts;
}

/// How often parts are to be halved so that they are near but a few of others: what bends is four times as thin then.
std::vector<int> halvings(const BundledParts& in, const CurveBundles& others, double distance) {
  std::vector<int> found(in.parts().size(), 0);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const CurvePart& part = in.parts()[i];
    if (!part.is_boxed || !(part.spread * part.size > distance)) continue;
    for (std::size_t near = others.count_near(in.bundles().of_part(i), distance); near > kFew; near /= 4) ++found[i];
    found[i] = std::min(found[i], kMostHalvings);
  }
  return found;
}

bool has_any(const std::vector<int>& times) { return std::ranges::any_of(times, [](int n) { return n > 0; }); }

void add_halved(std::vector<CurvePart>& into, CurvePart part, int times) {
  breathe(16 * part.net.rows);
  if (times == 0) return into.push_back(std::move(part));
  auto [first, second] = part.halves();
  add_halved(into, std::move(first), times - 1);
  add_halved(into, std::move(second), times - 1);
}

}  // namespace

BundledParts::BundledParts(const CurvePieces& curve) : parts_(parts_of(curve)) { bundles_.emplace(parts_); }

void BundledParts::halve(const std::vector<int>& times) {
  std::size_t count = 0;
  for (const int n : times) count += std::size_t{1} << n;
  std::vector<CurvePart> parts;
  parts.reserve(count);
  for (std::size_t i = 0; i < parts_.size(); ++i) add_halved(parts, std::move(parts_[i]), times[i]);
  parts_ = std::move(parts);
  bundles_.emplace(parts_);
}

void halve_crowded(BundledParts& parts, double distance) {
  if (parts.parts().size() < kLeastParts) return;
  const std::vector<int> times = halvings(parts, parts.bundles(), distance);
  if (has_any(times)) parts.halve(times);
}

void halve_crowded(BundledParts& a, BundledParts& b, double distance) {
  if (std::min(a.parts().size(), b.parts().size()) < kLeastParts) return;
  const std::vector<int> of_a = halvings(a, b.bundles(), distance);
  const std::vector<int> of_b = halvings(b, a.bundles(), distance);
  if (has_any(of_a)) a.halve(of_a);
  if (has_any(of_b)) b.halve(of_b);
}

}  // namespace splinecore
