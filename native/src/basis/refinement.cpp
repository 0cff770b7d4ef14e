#include "refinement.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <string>

#include "blossom.hpp"
#include "blossom_point.hpp"
#include "old_knots.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

/// A knot of the refined vector; an inserted one has no old index.
struct Merged {
  double value;
  std::ptrdiff_t old_index;
  bool inserted;
};

/// In order, with room for one more.
std::vector<double> admitted(const KnotVector& knots, std::span<const double> inserted) {
  const Interval domain = knots.domain();
  std::vector<double> values;
  values.reserve(inserted.size() + 1);
  for (std::size_t i = 0; i < inserted.size(); ++i) {
    const double u = inserted[i];
    values.push_back(u > domain.start && u < domain.end ? u : knots.admit(u, Side::right, i, "knots"));
  }
  if (!std::ranges::is_sorted(values)) std::ranges::sort(values);
  return values;
}

/// @throws InvalidShape if a value would be there too often.
void require_multiplicities(const KnotVector& knots, std::span<const double> values) {
  for (std::size_t i = 0; i < values.size();) {
    std::size_t end = i;
    while (end < values.size() && values[end] == values[i]) ++end;
    const std::ptrdiff_t times = static_cast<std::ptrdiff_t>(end - i) + multiplicity(knots, values[i]);
    if (times > knots.degree() + 1) {
      throw InvalidShape("knots: " + text_of(values[i]) + " would have multiplicity " +
                         std::to_string(times) + ", above degree + 1 = " +
                         std::to_string(knots.degree() + 1));
    }
    i = end;
  }
}

/// Old and inserted knots in order. An inserted knot stands after old ones of its value, but at
/// the end of a plain domain before them, so that every window with it lies inside the vector.
std::vector<Merged> merge(const KnotVector& knots, const OldKnots& old,
                          const std::vector<double>& inserted) {
  const bool periodic = knots.periodic();
  const std::ptrdiff_t reach = periodic ? knots.degree() + 1 : 0;
  const std::ptrdiff_t last = periodic ? knots.count() + reach : static_cast<std::ptrdiff_t>(old.values.size()) - 1;
  std::vector<Merged> kept;
  kept.reserve(last + reach + 1);
  for (std::ptrdiff_t i = -reach; i <= last; ++i) kept.push_back({*old.at(i), i, false});
  const double low = kept.front().value;
  const double high = kept.back().value;
  std::vector<Merged> added;
  added.reserve(inserted.size());
  const std::ptrdiff_t turns = periodic ? reach / knots.count() + 1 : 0;
  for (std::ptrdiff_t turn = -turns; turn <= turns; ++turn) {
    for (const double value : inserted) {
      const double image = periodic ? periodic_image(knots.knots(), value, turn) : value;
      if (image >= low && image <= high) added.push_back({image, 0, true});
    }
  }
  const double end = knots.domain().end;
  const auto rank = [&](const Merged& knot) {
    if (!knot.inserted) return 1;
    return !periodic && knot.value == end ? 0 : 2;
  };
  std::vector<Merged> merged(kept.size() + added.size());
  std::ranges::merge(kept, added, merged.begin(), [&](const Merged& a, const Merged& b) {
    return a.value != b.value ? a.value < b.value : rank(a) < rank(b);
  });
  return merged;
}

/// Calls visit(first, arguments) for the `count` windows of `degree` knots from `start` on: the
/// inserted knots of each, and the first of the old points that carry all its old knots.
template <class Visit>
void for_each_window(const std::vector<Merged>& merged, std::ptrdiff_t start, int count, int degree, Visit visit) {
  const auto is_old = [](const Merged& k) { return !k.inserted; };
  std::ptrdiff_t next_old = std::find_if(merged.rend() - start, merged.rend(), is_old)->old_index + 1;
  std::vector<double> arguments;
  for (int j = 0; j < count; ++j) {
    arguments.clear();
    for (const Merged& knot : std::span(merged.data() + start + j, degree)) {
      if (knot.inserted) arguments.push_back(knot.value);
    }
    breathe(static_cast<std::size_t>(degree) + 4 * arguments.size() * arguments.size());
    visit(next_old - 1 - static_cast<std::ptrdiff_t>(arguments.size()), arguments);
    if (is_old(merged[start + j])) next_old = merged[start + j].old_index + 1;
  }
}

}  // namespace

PointMatrix refinement(const KnotVector& knots, std::span<const double> inserted) {
  const OldKnots old = reachable(knots, 2 * knots.degree() + 2);
  const std::vector<double> added = admitted(knots, inserted);
  require_multiplicities(knots, added);
  const std::vector<Merged> merged = merge(knots, old, added);
  const auto is_origin = [](const Merged& k) { return !k.inserted && k.old_index == 0; };
  const std::ptrdiff_t origin = std::ranges::find_if(merged, is_origin) - merged.begin();
  std::vector<double> values;
  values.reserve(knots.knots().size() + inserted.size());
  for (std::size_t i = 0; i < knots.knots().size() + inserted.size(); ++i) {
    values.push_back(merged[origin + i].value);
  }
  const int degree = knots.degree();
  KnotVector refined = KnotVector::make(degree, std::move(values), knots.periodic());

  // The window of new point j: the knots after knot j where plain, up to knot j where periodic.
  const std::ptrdiff_t start = origin + (knots.periodic() ? 1 - degree : 1);
  PointMatrix::Rows rows{degree + 1, {}, {}};
  const std::size_t count = refined.count();
  rows.first.reserve(count);
  rows.weights.assign(count * (degree + 1), 0.0);
  double* row = rows.weights.data();
  for_each_window(merged, start, refined.count(), degree, [&](std::ptrdiff_t first, const auto& arguments) {
    blossom_weights(old.at(first), degree, arguments, row);
    rows.first.push_back(first + (knots.periodic() ? degree : 0));
    row += degree + 1;
  });
  return {knots, std::move(refined), std::move(rows)};
}

namespace {

/// The knots of a refined plain vector, and how many old ones stand before each.
struct MergedKnots {
  std::vector<double> knots;
  std::vector<int> old_before;
};

/// @param inserted  in order; gets an infinity at its end
MergedKnots merged_line(const KnotVector& knots, std::vector<double>& inserted) {
  const auto old = knots.knots();
  // After the old ones of its value, but at the end of the domain before them.
  const std::size_t last = std::ranges::lower_bound(old, knots.domain().end) - old.begin();
  const std::size_t count = old.size() + inserted.size();
  const std::size_t merged = last + inserted.size();
  MergedKnots line{std::vector<double>(count), std::vector<int>(count)};
  inserted.push_back(std::numeric_limits<double>::infinity());
  std::size_t taken = 0;
  for (std::size_t i = 0; i < merged; ++i) {
    line.old_before[i] = static_cast<int>(taken);
    const double kept = old[taken];
    const double added = inserted[i - taken];
    const bool is_new = (added < kept) | (taken == last);
    line.knots[i] = is_new ? added : kept;
    taken += is_new ? 0 : 1;
  }
  std::ranges::copy(old.subspan(last), line.knots.begin() + merged);
  std::iota(line.old_before.begin() + merged, line.old_before.end(), static_cast<int>(last));
  return line;
}

/// @throws InvalidShape naming the inserted value that would be there too often.
KnotVector checked(const KnotVector& knots, std::vector<double> merged, std::span<const double> inserted) {
  try {
    return KnotVector::make(knots.degree(), std::move(merged));
  } catch (const InvalidShape&) {
    require_multiplicities(knots, inserted);
    throw;
  }
}

/// Which of the old points that it was made of a new one is equal to, or -1.
int copied_of(const glm::dvec4& made, std::span<const glm::dvec4> points, int first, int number) {
  int copied = -1;
  for (int i = first; i <= first + number; ++i) {
    if (made == points[i]) copied = i;
  }
  return copied;
}

}  // namespace

RefinedPoints refined(const KnotVector& knots, std::span<const glm::dvec4> points, std::span<const double> inserted,
                      bool with_copies) {
  constexpr std::size_t kBlock = 256;
  const int degree = knots.degree();
  const double* const old = knots.knots().data();
  std::vector<double> added = admitted(knots, inserted);
  MergedKnots line = merged_line(knots, added);
  KnotVector made_knots = checked(knots, std::move(line.knots), std::span(added).first(inserted.size()));
  const std::size_t count = made_knots.count();
  std::vector<glm::dvec4> made(count);
  std::vector<int> copied(with_copies ? count : 0);
  std::vector<PairedPoint> scratch(degree + 1);
  // The window of knots j + 1 … j + degree: what is new of it lies together among the inserted ones.
  const int* const before = line.old_before.data() + 1;
  for (std::size_t j = 0; j < count; ++j) {
    if (j % kBlock == 0) breathe(8 * kBlock * static_cast<std::size_t>(degree));
    const int number = degree - (before[j + degree] - before[j]);
    const double* const arguments = added.data() + (j + 1 - before[j]);
    const int first = before[j] - 1 - number;
    made[j] = blossom_point(old + first, degree, arguments, number, points.data() + first, scratch.data()).point();
    if (with_copies) copied[j] = number == 0 ? first : copied_of(made[j], points, first, number);
  }
  return {std::move(made_knots), std::move(made), std::move(copied)};
}

std::vector<double> missing_inside(const KnotVector& knots, const KnotVector& other) {
  const Interval domain = knots.domain();
  const auto inside = [&](const KnotVector& vector) {
    const auto all = vector.knots();
    return std::ranges::subrange(std::ranges::upper_bound(all, domain.start),
                                 std::ranges::lower_bound(all, domain.end));
  };
  std::vector<double> missing;
  std::ranges::set_difference(inside(other), inside(knots), std::back_inserter(missing));
  return missing;
}

std::vector<double> knot_copies(const KnotVector& knots, double u, int times) {
  if (times < 1 || times > knots.degree() + 1) {
    throw InvalidShape("times = " + std::to_string(times) + " is outside [1, " +
                       std::to_string(knots.degree() + 1) + "]");
  }
  return std::vector<double>(times, u);
}

}  // namespace splinecore
