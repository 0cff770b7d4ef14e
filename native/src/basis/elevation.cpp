#include "elevation.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

#include "blossom.hpp"
#include "old_knots.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

namespace {

/// A distinct old knot, which has old indices first … first + count - 1 and one copy more afterwards.
struct KnotRun {
  double value;
  std::ptrdiff_t first;
  int count;
};

/// A new knot: which copy of which run.
struct Copy {
  int run;
  int copy;
};

std::vector<KnotRun> runs_of(const OldKnots& old) {
  std::vector<KnotRun> runs;
  for (std::size_t i = 0; i < old.values.size(); ++i) {
    if (runs.empty() || runs.back().value != old.values[i]) {
      runs.push_back({old.values[i], old.begin + static_cast<std::ptrdiff_t>(i), 0});
    }
    ++runs.back().count;
  }
  return runs;
}

std::vector<Copy> copies_of(const std::vector<KnotRun>& runs) {
  std::vector<Copy> copies;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    for (int copy = 0; copy <= runs[run].count; ++copy) copies.push_back({static_cast<int>(run), copy});
  }
  return copies;
}

/// The new knot vector as copies[begin] … copies[end - 1].
struct Part {
  std::ptrdiff_t begin;
  std::ptrdiff_t end;
};

Part plain_part(const KnotVector& knots, const std::vector<KnotRun>& runs, const std::vector<Copy>& copies) {
  const int degree = knots.degree() + 1;
  const Interval domain = knots.domain();
  const auto value = [&](const Copy& copy) { return runs[copy.run].value; };
  const auto after_start = std::ranges::upper_bound(copies, domain.start, {}, value);
  const auto at_end = std::ranges::lower_bound(copies, domain.end, {}, value);
  return {after_start - copies.begin() - degree - 1, at_end - copies.begin() + degree + 1};
}

Part periodic_part(const KnotVector& knots, const std::vector<KnotRun>& runs, const std::vector<Copy>& copies) {
  const auto holds_origin = [](const KnotRun& run) { return run.first <= 0 && 0 < run.first + run.count; };
  const auto origin = std::ranges::find_if(runs, holds_origin);
  const int copy = static_cast<int>(-origin->first);
  const auto is_first = [&](const Copy& one) { return one.run == origin - runs.begin() && one.copy == copy; };
  const std::ptrdiff_t begin = std::ranges::find_if(copies, is_first) - copies.begin();
  const auto given = knots.knots();
  const auto distinct = std::ranges::count_if(runs, [&](const KnotRun& run) {
    return given.front() <= run.value && run.value < given.back();
  });
  return {begin, begin + static_cast<std::ptrdiff_t>(given.size()) + distinct};
}

/// The runs that a new point's knots come from, and how many of each.
struct KnotWindow {
  std::vector<int> runs;
  std::vector<int> counts;
  int first_copy = 0;
};

void find_window(const std::vector<Copy>& copies, std::ptrdiff_t begin, int size, KnotWindow& window) {
  window.runs.clear();
  window.counts.clear();
  window.first_copy = copies[begin].copy;
  for (std::ptrdiff_t i = begin; i < begin + size; ++i) {
    if (window.runs.empty() || window.runs.back() != copies[i].run) {
      window.runs.push_back(copies[i].run);
      window.counts.push_back(0);
    }
    ++window.counts.back();
  }
}

/// A point of a refined curve: the arguments that its blossom has beside old knots, which begin at `shared`.
struct Blossom {
  std::vector<double> arguments;
  std::ptrdiff_t shared = 0;
};

/// The blossom whose arguments are the knots of the window without one copy of a run.
void find_blossom_without(const KnotWindow& window, std::size_t removed, const std::vector<KnotRun>& runs,
                          Blossom& blossom) {
  blossom.arguments.clear();
  bool is_begun = false;
  for (std::size_t i = 0; i < window.runs.size(); ++i) {
    const KnotRun& run = runs[window.runs[i]];
    const int count = window.counts[i] - (i == removed ? 1 : 0);
    const int old = std::min(count, run.count);
    if (count > old) blossom.arguments.push_back(run.value);
    if (is_begun || old == 0) continue;
    is_begun = true;
    if (window.runs.size() == 1) {
      blossom.shared = run.first + std::min(window.first_copy, run.count - old);
    } else {
      blossom.shared = i == 0 ? run.first + run.count - old : run.first;
    }
  }
}

/// Memory that is kept from one row to the next.
struct Scratch {
  KnotWindow window;
  Blossom blossom;
  std::vector<std::ptrdiff_t> firsts;
  std::vector<std::vector<double>> parts;
};

/// The linear function with two values at the ends of a domain.
struct Linear {
  Interval domain;
  double start;
  double end;

  double at(double u) const {
    const double t = (u - domain.start) / (domain.end - domain.start);
    return t <= 0.5 ? start + t * (end - start) : end - (1.0 - t) * (end - start);
  }
};

/// Adds rows to the matrix: the weights of old points, from the lowest that any blossom needs.
void add_row(const std::vector<KnotRun>& runs, const OldKnots& old, int degree, bool periodic, const Linear& factor,
             Scratch& scratch, PointMatrix::Rows& rows) {
  const KnotWindow& window = scratch.window;
  std::vector<std::ptrdiff_t>& firsts = scratch.firsts;
  std::vector<std::vector<double>>& parts = scratch.parts;
  firsts.clear();
  parts.resize(std::max(parts.size(), window.runs.size()));
  for (std::size_t i = 0; i < window.runs.size(); ++i) {
    Blossom& blossom = scratch.blossom;
    find_blossom_without(window, i, runs, blossom);
    const std::ptrdiff_t first = blossom.shared - 1 - static_cast<std::ptrdiff_t>(blossom.arguments.size());
    std::vector<double>& part = parts[i];
    part.resize(blossom.arguments.size() + 1);
    breathe(static_cast<std::size_t>(degree) + 4 * part.size() * part.size());
    blossom_weights(old.at(first), degree, blossom.arguments, part.data());
    firsts.push_back(first);
  }
  const std::ptrdiff_t lowest = std::ranges::min(firsts);
  rows.weights.resize(rows.weights.size() + rows.width);
  double* row = rows.weights.data() + rows.weights.size() - rows.width;
  for (std::size_t i = 0; i < firsts.size(); ++i) {
    const double share = static_cast<double>(window.counts[i]) / (degree + 1) * factor.at(runs[window.runs[i]].value);
    for (std::size_t r = 0; r < parts[i].size(); ++r) row[firsts[i] - lowest + r] += share * parts[i][r];
  }
  rows.first.push_back(lowest + (periodic ? degree : 0));
}

}  // namespace

PointMatrix elevation(const KnotVector& knots) { return elevation(knots, 1.0, 1.0); }

PointMatrix elevation(const KnotVector& knots, double start, double end) {
  const int degree = knots.degree();
  if (degree >= kMaxDegree) throw InvalidShape("the degree would exceed " + std::to_string(kMaxDegree));
  const OldKnots old = reachable(knots, 3 * knots.degree() + 3);
  const std::vector<KnotRun> runs = runs_of(old);
  const std::vector<Copy> copies = copies_of(runs);
  const bool periodic = knots.periodic();
  const Part part = periodic ? periodic_part(knots, runs, copies) : plain_part(knots, runs, copies);
  std::vector<double> values;
  for (std::ptrdiff_t i = part.begin; i < part.end; ++i) values.push_back(runs[copies[i].run].value);
  KnotVector elevated = KnotVector::make(degree + 1, std::move(values), periodic);

  PointMatrix::Rows rows{std::ptrdiff_t{2} * degree + 2, {}, {}};
  rows.first.reserve(elevated.count());
  rows.weights.reserve(elevated.count() * rows.width);
  const Linear factor{knots.domain(), start, end};
  Scratch scratch;
  for (int j = 0; j < elevated.count(); ++j) {
    const std::ptrdiff_t begin = part.begin + j + (periodic ? -degree : 1);
    find_window(copies, begin, degree + 1, scratch.window);
    add_row(runs, old, degree, periodic, factor, scratch, rows);
  }
  return {knots, std::move(elevated), std::move(rows)};
}

}  // namespace splinecore
