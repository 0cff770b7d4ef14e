#include "plane_zeros.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/one_sign.hpp"
#include "basis/bernstein_row.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

using ScalarNet = BernsteinNet<double>;

/// A part no longer than this is not halved.
constexpr double kShortest = 0x1p-18;
/// Zeros that reach farther are a curve.
constexpr double kWideCell = 0x1p-6;
constexpr std::size_t kMost = 1 << 16;

double size_of(const ScalarNet& net) noexcept {
  const auto [low, high] = net.range();
  return std::max(-low, high);
}

bool is_noise(const SlopeForm& form) noexcept { return size_of(form.net) <= form.noise; }

bool crosses_zero(const SlopeForm& form) noexcept {
  const auto [low, high] = std::ranges::minmax(form.net.corners());
  return low < -form.noise && high > form.noise;
}

/// The least and the greatest of differences of neighbors along an axis, times the degree.
std::pair<double, double> slope_range(const ScalarNet& net, Axis axis) noexcept {
  const std::size_t step = axis == Axis::u ? net.columns : 1;
  const std::size_t rows = axis == Axis::u ? net.rows - 1 : net.rows;
  const std::size_t columns = axis == Axis::u ? net.columns : net.columns - 1;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t k = i * net.columns; k < i * net.columns + columns; ++k) {
      low = std::min(low, net.values[k + step] - net.values[k]);
      high = std::max(high, net.values[k + step] - net.values[k]);
    }
  }
  const double degree = net.degree(axis);
  return {degree * low, degree * high};
}

double steepness(const ScalarNet& net, Axis axis) noexcept {
  const auto [low, high] = slope_range(net, axis);
  return std::max(-low, high);
}

/// The mean slope along an axis between the corners.
double mean_slope(const ScalarNet& net, Axis axis) noexcept {
  const auto [a, b, c, d] = net.corners();
  return axis == Axis::u ? 0.5 * (c - a + (d - b)) : 0.5 * (b - a + (d - c));
}

SlopeForm combined(const SlopeForm& a, double s, const SlopeForm& b, double t) {
  SlopeForm sum = a;
  for (std::size_t i = 0; i < sum.net.values.size(); ++i) {
    sum.net.values[i] = s * a.net.values[i] + t * b.net.values[i];
  }
  sum.noise = std::abs(s) * a.noise + std::abs(t) * b.noise;
  return sum;
}

/// Combinations of two polynomials whose slopes are about (1, 0) and (0, 1).
std::optional<std::array<SlopeForm, 2>> straightened(const SlopeForm& a, const SlopeForm& b) {
  constexpr double kFlat = 0x1p-40;
  const double au = mean_slope(a.net, Axis::u), av = mean_slope(a.net, Axis::v);
  const double bu = mean_slope(b.net, Axis::u), bv = mean_slope(b.net, Axis::v);
  const double determinant = au * bv - av * bu;
  if (!(std::abs(determinant) > kFlat * (std::abs(au * bv) + std::abs(av * bu)))) return {};
  return std::array{combined(a, bv / determinant, b, -av / determinant),
                    combined(a, -bu / determinant, b, au / determinant)};
}

/// Whether no two places have the same values: everywhere the slopes are nearer to (1, 0) and (0, 1) than to others.
bool tells_places_apart(const std::array<SlopeForm, 2>& forms) noexcept {
  for (const Axis axis : {Axis::u, Axis::v}) {
    const SlopeForm& form = forms[static_cast<std::size_t>(axis)];
    const Axis other = axis == Axis::u ? Axis::v : Axis::u;
    const double noise = 4.0 * form.noise * static_cast<double>(form.net.rows + form.net.columns);
    if (!(slope_range(form.net, axis).first > steepness(form.net, other) + noise)) return false;
  }
  return true;
}

/// Value and slopes.
std::array<double, 3> jet_of(const ScalarNet& net, const BernsteinRow& u, const BernsteinRow& v) {
  std::array<double, 3> jet{};
  for (std::size_t i = 0; i < net.rows; ++i) {
    double value = 0.0;
    double slope = 0.0;
    for (std::size_t j = 0; j < net.columns; ++j) {
      value += v.values[j] * net.at(i, j);
      slope += v.slopes[j] * net.at(i, j);
    }
    jet[0] += u.values[i] * value;
    jet[1] += u.slopes[i] * value;
    jet[2] += u.values[i] * slope;
  }
  return jet;
}

/// The zero in [0, 1]², by Newton's method; none where it ends elsewhere.
std::optional<std::array<double, 2>> single_zero(const std::array<SlopeForm, 2>& forms) {
  constexpr int kMostSteps = 20;
  constexpr double kLastStep = 0x1p-40;
  constexpr double kSlack = 0x1p-30;
  const ScalarNet& a = forms[0].net;
  const ScalarNet& b = forms[1].net;
  std::array<double, 2> at{0.5, 0.5};
  for (int i = 0; i < kMostSteps; ++i) {
    const BernsteinRow u(a.degree(Axis::u), at[0]);
    const BernsteinRow v(a.degree(Axis::v), at[1]);
    const auto [x, xu, xv] = jet_of(a, u, v);
    const auto [y, yu, yv] = jet_of(b, u, v);
    const double determinant = xu * yv - xv * yu;
    const std::array to{at[0] - (x * yv - y * xv) / determinant, at[1] - (y * xu - x * yu) / determinant};
    const std::array<double, 2> inside{std::clamp(to[0], 0.0, 1.0), std::clamp(to[1], 0.0, 1.0)};
    const double step = std::max(std::abs(inside[0] - at[0]), std::abs(inside[1] - at[1]));
    const double out = std::max(std::abs(inside[0] - to[0]), std::abs(inside[1] - to[1]));
    if (!(step <= 1.0)) return {};
    at = inside;
    if (step <= kLastStep) return out <= kSlack ? std::optional(at) : std::nullopt;
  }
  return {};
}

class ZeroSearch {
 public:
  explicit ZeroSearch(const std::function<bool(const PlaneRange&)>& is_out) : is_out_(is_out) {}

  void visit(SlopeForm a, SlopeForm b, const PlaneRange& range) {
    if (found_.curve) return;
    breathe(32 * a.net.values.size());
    if (++looks_ == kMost) return refuse(range);
    if (has_one_sign(a.net.values, {}, a.noise) || has_one_sign(b.net.values, {}, b.noise)) return;
    if (is_out_ && is_out_(range)) return;
    const double size = std::max(range[0].length(), range[1].length());
    const bool is_flat = is_noise(a);
    if (is_flat && is_noise(b)) return keep(range);
    if (!is_out_ && size > kWideCell && ((is_flat && crosses_zero(b)) || (is_noise(b) && crosses_zero(a)))) return refuse(range);
    if (const auto forms = straightened(a, b)) {
      if (has_one_sign((*forms)[0].net.values, {}, (*forms)[0].noise)) return;
      if (has_one_sign((*forms)[1].net.values, {}, (*forms)[1].noise)) return;
      const auto zero = tells_places_apart(*forms) ? single_zero(*forms) : std::nullopt;
      if (zero) return keep(*zero, range);
    }
    if (size <= kShortest) return keep(range);
    halve(std::move(a), std::move(b), range);
  }

  PlaneZeros found() && {
    for (const PlaneRange& range : clusters_) {
      const double reach = std::max(range[0].length(), range[1].length()) + 4.0 * kShortest;
      found_.zeros.push_back({{range[0].middle(), range[1].middle()}, reach, false});
    }
    return std::move(found_);
  }

 private:
  void halve(SlopeForm a, SlopeForm b, const PlaneRange& range) {
    const Axis axis = axis_of(a.net, b.net, range);
    const auto k = static_cast<std::size_t>(axis);
    SlopeForm second_a{{}, a.noise};
    SlopeForm second_b{{}, b.noise};
    a.net.halve(axis, second_a.net);
    b.net.halve(axis, second_b.net);
    PlaneRange half = range;
    half[k].end = range[k].middle();
    visit(std::move(a), std::move(b), half);
    half[k] = {range[k].middle(), range[k].end};
    visit(std::move(second_a), std::move(second_b), half);
  }

  /// That along which the polynomials change more, if the part is not much longer along the other.
  static Axis axis_of(const ScalarNet& a, const ScalarNet& b, const PlaneRange& range) noexcept {
    constexpr double kLonger = 16.0;
    if (range[0].length() > kLonger * range[1].length()) return Axis::u;
    if (range[1].length() > kLonger * range[0].length()) return Axis::v;
    const double of_a = 1.0 / std::max(size_of(a), std::numeric_limits<double>::min());
    const double of_b = 1.0 / std::max(size_of(b), std::numeric_limits<double>::min());
    const auto change = [&](Axis axis) { return steepness(a, axis) * of_a + steepness(b, axis) * of_b; };
    return change(Axis::v) > change(Axis::u) ? Axis::v : Axis::u;
  }

  void keep(const std::array<double, 2>& zero, const PlaneRange& range) {
    constexpr double kReach = 0x1p-28;
    const std::array at{std::lerp(range[0].start, range[0].end, zero[0]),
                        std::lerp(range[1].start, range[1].end, zero[1])};
    found_.zeros.push_back({at, kReach, true});
  }

  /// Parts that touch are one place.
  void keep(PlaneRange range) {
    const auto touch = [&](const PlaneRange& other) {
      return std::ranges::all_of(std::array{0, 1}, [&](int k) {
        return other[k].start <= range[k].end + kShortest && range[k].start <= other[k].end + kShortest;
      });
    };
    for (auto other = std::ranges::find_if(clusters_, touch); other != clusters_.end();
         other = std::ranges::find_if(clusters_, touch)) {
      for (std::size_t k = 0; k < 2; ++k) {
        range[k] = {std::min(range[k].start, (*other)[k].start), std::max(range[k].end, (*other)[k].end)};
      }
      clusters_.erase(other);
    }
    if (std::max(range[0].length(), range[1].length()) > kWideCell) return refuse(range);
    clusters_.push_back(range);
  }

  void refuse(const PlaneRange& range) { found_.curve = {range[0].middle(), range[1].middle()}; }

  const std::function<bool(const PlaneRange&)>& is_out_;
  PlaneZeros found_;
  std::vector<PlaneRange> clusters_;
  std::size_t looks_ = 0;
};

SlopeForm near_one(const SlopeForm& form, std::size_t rows, std::size_t columns) {
  SlopeForm out{elevated(form.net, rows, columns), form.noise};
  const double size = size_of(out.net);
  if (!(size > 0.0)) return out;
  for (double& value : out.net.values) value /= size;
  out.noise /= size;
  return out;
}

}  // namespace

PlaneZeros plane_zeros(const SlopeForm& a, const SlopeForm& b, const std::function<bool(const PlaneRange&)>& is_out) {
  const std::size_t rows = std::max(a.net.rows, b.net.rows);
  const std::size_t columns = std::max(a.net.columns, b.net.columns);
  ZeroSearch search(is_out);
  search.visit(near_one(a, rows, columns), near_one(b, rows, columns), {});
  return std::move(search).found();
}

}  // namespace splinecore
