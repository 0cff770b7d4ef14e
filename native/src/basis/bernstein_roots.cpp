#include "bernstein_roots.hpp"

#include <algorithm>

#include "base/one_sign.hpp"
#include "bernstein_net.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

using BernsteinPolynomial = BernsteinNet<double>;

class RootSearch {
 public:
  RootSearch(std::span<const double> coefficients, double noise) : whole_(coefficients), noise_(noise) {
    visit(BernsteinPolynomial::of_curve({coefficients.begin(), coefficients.end()}), {0.0, 1.0}, 0);
  }

  std::vector<Interval> found() const {
    std::vector<Interval> roots;
    for (const Interval& zero : found_) {
      if (zero == Interval{0.0, 1.0}) return {zero};
      const double at = zero.start == 0.0 ? 0.0 : zero.end == 1.0 ? 1.0 : zero.middle();
      roots.push_back({at, at});
    }
    return roots;
  }

 private:
  static constexpr int kDeepest = 60;

  void visit(BernsteinPolynomial piece, Interval range, int depth) {
    if (has_one_sign(piece.values, {}, noise_)) return;
    const auto [low, high] = piece.range();
    if ((low >= -noise_ && high <= noise_) || depth == kDeepest) return keep(range);
    if (changes_sign_once(piece.values)) return keep(bisected(range, piece.values.front() < 0.0));
    BernsteinPolynomial after;
    piece.halve(Axis::u, after);
    visit(std::move(piece), {range.start, range.middle()}, depth + 1);
    visit(std::move(after), {range.middle(), range.end}, depth + 1);
  }

  /// From above the noise to below it, or the other way, with nothing but noise between.
  bool changes_sign_once(const std::vector<double>& values) const {
    const double sign = values.front() < 0.0 ? -1.0 : 1.0;
    const auto is_first = [&](double value) { return sign * value > noise_; };
    const auto is_last = [&](double value) { return sign * value < -noise_; };
    const auto middle = std::ranges::find_if_not(values, is_first);
    const auto last = std::find_if(middle, values.end(), is_last);
    return middle != values.begin() && last != values.end() && std::none_of(middle, last, is_first) &&
           std::all_of(last, values.end(), is_last);
  }

  /// The root between parameters where the signs differ.
  Interval bisected(Interval range, bool is_rising) const {
    while (true) {
      const double middle = range.middle();
      if (!(middle > range.start && middle < range.end)) return range;
      const double value = bernstein_value(whole_, middle);
      if (value == 0.0) return {middle, middle};
      ((value < 0.0) == is_rising ? range.start : range.end) = middle;
    }
  }

  void keep(Interval range) {
    if (!found_.empty() && found_.back().end >= range.start) {
      found_.back().end = range.end;
    } else {
      found_.push_back(range);
    }
  }

  std::span<const double> whole_;
  double noise_;
  std::vector<Interval> found_;  ///< neighbors do not touch
};

}  // namespace

std::vector<Interval> bernstein_zeros(std::span<const double> coefficients, double noise) {
  return RootSearch(coefficients, noise).found();
}

double bernstein_value(std::span<const double> coefficients, double t) {
  const std::size_t order = coefficients.size();
  breathe(order * order);
  std::vector<double> row(coefficients.begin(), coefficients.end());
  const double s = 1.0 - t;
  for (std::size_t last = order - 1; last > 0; --last) {
    for (std::size_t i = 0; i < last; ++i) row[i] = s * row[i] + t * row[i + 1];
  }
  return row.front();
}

}  // namespace splinecore
