#include "branch_search.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <string>

#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

constexpr std::size_t kMostLooks = std::size_t{1} << 20;
/// So many of its sizes beyond a part a place of it is looked for.
constexpr double kBeyond = 1.0;

}  // namespace

void BranchSearch::explore(const CrossingPart& part) {
  breathe(64 * (part.a.net.values.size() + part.b.net.values.size()));
  if (++looks_ > kMostLooks) {
    throw InvalidShape("the shapes are nearly one where they cross: more than " + std::to_string(kMostLooks) +
                       " pairs of parts are neither apart nor on a curve that was found");
  }
  if (are_apart(part.a, part.b, slack_) || are_edges_apart(part.a, part.b, slack_)) return;
  if (is_known_pair(part.a, part.b) || are_heights_apart(part)) return;
  const std::vector<Interval> gaps = traced_.gaps(part);
  if (gaps.size() == 1 && gaps.front() == part.range(part.lead)) return search(part);
  for (const Interval& gap : gaps) explore(within(part, part.lead, gap));
}

/// Parts whose normals do not differ are told by what their heights do.
bool BranchSearch::are_heights_apart(const CrossingPart& part) const {
  if (do_normals_differ(part.a, part.b, slack_)) return false;
  const auto difference = height_difference(part.a, part.b, slack_);
  return difference && difference->are_apart(slack_);
}

/// Looks for a curve in a part in which none is known.
void BranchSearch::search(const CrossingPart& part) {
  if (part.size() <= smallest_) return on_contact({{part.a.piece, part.a.middle()}, {part.b.piece, part.b.middle()}});
  const std::optional<SectionPlace> seed = place_near_part(part, part.range(part.lead).middle());
  if (!seed) return halve(part);
  if (!traced_.holds(*seed) && on_seed(*seed) == SeedFate::traced) {
    const std::vector<Interval> gaps = traced_.gaps(part);
    const bool is_new = gaps.size() != 1 || gaps.front() != part.range(part.lead);
    return is_new ? explore(part) : halve(part);
  }
  if (part.holds(parameters_of(seed->at)) && is_known_all_along(part)) return;
  halve(part);
}

void BranchSearch::halve(const CrossingPart& part) {
  const auto [first, second] = halves(part);
  explore(first);
  explore(second);
}

/// Whether the places of a part are on curves whose steps, by a rounding, are not in it.
bool BranchSearch::is_known_all_along(const CrossingPart& part) const {
  constexpr int kLooks = 8;
  const Interval& range = part.range(part.lead);
  for (int i = 0; i <= kLooks; ++i) {
    const auto place = place_near_part(part, range.start + range.length() * i / kLooks);
    if (!place || !part.holds(parameters_of(place->at)) || is_known_place(place->at)) continue;
    if (!traced_.holds(*place)) return false;
  }
  return true;
}

/// A place with that value of the leading parameter, in the pieces of a part and maybe a little beyond it.
std::optional<SectionPlace> BranchSearch::place_near_part(const CrossingPart& part, double of_lead) const {
  const PatchSpots start{{part.a.piece, part.a.middle()}, {part.b.piece, part.b.middle()}};
  std::array<Interval, 4> box;
  for (std::size_t i = 0; i < 4; ++i) {
    const Interval& range = part.range(i);
    box[i] = {range.start - kBeyond * range.length(), range.end + kBeyond * range.length()};
  }
  std::optional<PatchSpots> at = place_near(patches_, start, OnFace{part.lead, of_lead}, box);
  if (!at || !enters(*at)) return {};
  return section_place(patches_, *at);
}

}  // namespace splinecore
