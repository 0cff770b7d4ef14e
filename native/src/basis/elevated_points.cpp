#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "blossom_point.hpp"
#include "elevation.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

/// A plain vector and its points while their degree grows.
struct RaisedLine {
  int degree = 0;
  std::vector<double> knots;
  std::vector<glm::dvec4> points;
  std::vector<int> copied;
};

/// The distinct knots, and where the copies of each begin.
struct Runs {
  std::vector<double> values;
  std::vector<int> begins;  ///< and the end of all

  explicit Runs(const std::vector<double>& knots) {
    values.reserve(knots.size());
    begins.reserve(knots.size() + 1);
    for (std::size_t i = 0; i < knots.size(); ++i) {
      if (i > 0 && knots[i] == knots[i - 1]) continue;
      values.push_back(knots[i]);
      begins.push_back(static_cast<int>(i));
    }
    begins.push_back(static_cast<int>(knots.size()));
  }

  int count(int run) const { return begins[run + 1] - begins[run]; }
  int raised(int run) const { return count(run) + 1; }
};

/// A knot of the raised vector: which copy of which run.
struct RunCopy {
  int run;
  int copy;

  void advance(const Runs& runs) {
    if (++copy < runs.raised(run)) return;
    ++run;
    copy = 0;
  }
};

/// The raised knots from one place to another.
struct RunWindow {
  RunCopy first;
  RunCopy last;

  bool is_one_run() const { return first.run == last.run; }
  int count(int run, const Runs& runs) const {
    return (run == last.run ? last.copy + 1 : runs.raised(run)) - (run == first.run ? first.copy : 0);
  }
};

/// The blossoms of a line whose arguments are all but one knot of a window, of line.degree + 1 knots. Of a run that is
/// there with all its copies one is no old knot.
class Blossoms {
 public:
  Blossoms(const RaisedLine& line, const Runs& runs) : line_(line), runs_(runs), scratch_(line.degree + 1) {
    arguments_.reserve(line.degree + 1);
  }

  /// Of one run: which old point they are, each with as many knots of it.
  int point_in(const RunWindow& window) const {
    const int run = window.first.run;
    return runs_.begins[run] + std::min(window.first.copy, runs_.count(run) - line_.degree) - 1;
  }

  PairedPoint without_first(const RunWindow& window) {
    const int run = window.first.run;
    const int kept = runs_.raised(run) - window.first.copy - 1;
    return at(runs_.begins[run + 1] - kept, runs_.values.data() + run + 1, window.last.run - run - 1 + is_full(window.last));
  }

  PairedPoint without_last(const RunWindow& window) {
    const int begin = window.first.run + (window.first.copy == 0 ? 0 : 1);
    return at(shared(window), runs_.values.data() + begin, window.last.run - begin);
  }

  /// Without one knot of a run between the first and the last.
  PairedPoint without(int removed, const RunWindow& window) {
    arguments_.clear();
    for (int run = window.first.run + (window.first.copy == 0 ? 0 : 1); run < window.last.run; ++run) {
      if (run != removed) arguments_.push_back(runs_.values[run]);
    }
    if (is_full(window.last) != 0) arguments_.push_back(runs_.values[window.last.run]);
    return at(shared(window), arguments_.data(), static_cast<int>(arguments_.size()));
  }

 private:
  int is_full(const RunCopy& last) const { return last.copy == runs_.count(last.run) ? 1 : 0; }

  /// The first old knot of a window that keeps those of its first run.
  int shared(const RunWindow& window) const {
    return std::max(runs_.begins[window.first.run + 1] - (runs_.raised(window.first.run) - window.first.copy),
                    runs_.begins[window.first.run]);
  }

  PairedPoint at(int shared_begin, const double* arguments, int number) {
    if (number > 2) breathe(4 * static_cast<std::size_t>(number) * static_cast<std::size_t>(number));
    const int point = shared_begin - 1 - number;
    return blossom_point(line_.knots.data() + point, line_.degree, arguments, number, line_.points.data() + point,
                         scratch_.data());
  }

  const RaisedLine& line_;
  const Runs& runs_;
  std::vector<double> arguments_;
  std::vector<PairedPoint> scratch_;
};

/// The knots with one copy more of each, as far as a domain needs them; the place of the first.
RunCopy raise_knots(const RaisedLine& line, const Runs& runs, Interval domain, std::vector<double>& raised) {
  raised.resize(line.knots.size() + runs.values.size());
  double* end = raised.data();
  for (std::size_t run = 0; run < runs.values.size(); ++run) {
    end = std::fill_n(end, runs.raised(static_cast<int>(run)), runs.values[run]);
  }
  const std::ptrdiff_t after_start = std::ranges::upper_bound(raised, domain.start) - raised.begin();
  const std::ptrdiff_t at_end = std::ranges::lower_bound(raised, domain.end) - raised.begin();
  const std::ptrdiff_t left_out = after_start - line.degree - 2;
  raised.resize(at_end + line.degree + 2);
  raised.erase(raised.begin(), raised.begin() + left_out);
  RunCopy first{0, 0};
  for (std::ptrdiff_t i = 0; i < left_out; ++i) first.advance(runs);
  return first;
}

/// The line in one degree more: each point is the mean of the blossoms without one of its knots.
RaisedLine raised(const RaisedLine& line, Interval domain) {
  constexpr std::size_t kBlock = 256;
  const Runs runs(line.knots);
  RaisedLine made{line.degree + 1, {}, {}, {}};
  RunWindow window{raise_knots(line, runs, domain, made.knots), {}};
  const std::size_t count = made.knots.size() - made.degree - 1;
  made.points.resize(count);
  made.copied.assign(count, -1);
  std::vector<double> shares(made.degree + 1);
  for (int n = 0; n <= made.degree; ++n) shares[n] = static_cast<double>(n) / made.degree;
  // Point j has the knots j + 1 … j + degree.
  window.first.advance(runs);
  window.last = window.first;
  for (int i = 1; i < made.degree; ++i) window.last.advance(runs);
  Blossoms blossoms(line, runs);
  PairedPoint before = window.is_one_run() ? PairedPoint{} : blossoms.without_last(window);
  for (std::size_t j = 0; j < count; ++j) {
    if (j % kBlock == 0) breathe(8 * kBlock * static_cast<std::size_t>(made.degree));
    if (window.is_one_run()) {
      const int point = blossoms.point_in(window);
      made.points[j] = line.points[point];
      made.copied[j] = line.copied[point];
      before = PairedPoint::of(line.points[point]);
    } else {
      // Without its first knot it is the next window without its last one.
      const PairedPoint after = blossoms.without_first(window);
      PairedPoint sum = shares[window.count(window.first.run, runs)] * after +
                        shares[window.last.copy + 1] * before;
      for (int run = window.first.run + 1; run < window.last.run; ++run) {
        sum = sum + shares[runs.raised(run)] * blossoms.without(run, window);
      }
      made.points[j] = sum.point();
      before = after;
    }
    window.first.advance(runs);
    if (j + 1 < count) window.last.advance(runs);
  }
  return made;
}

}  // namespace

ElevatedPoints elevated(const KnotVector& knots, std::span<const glm::dvec4> points, int times) {
  const auto given = knots.knots();
  RaisedLine line{knots.degree(), {given.begin(), given.end()}, {points.begin(), points.end()}, {}};
  line.copied.resize(knots.count());
  std::iota(line.copied.begin(), line.copied.end(), 0);
  for (int i = 0; i < times; ++i) line = raised(line, knots.domain());
  return {KnotVector::make(line.degree, std::move(line.knots)), std::move(line.points), std::move(line.copied)};
}

}  // namespace splinecore
