#include "numbers_along.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "base/harmonic_slope.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

void require_numbers(std::span<const RailNumber> numbers, const Interval& domain, bool is_closed, const std::string& name) {
  if (numbers.empty()) throw InvalidShape("there is no " + name);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto& [at, value] = numbers[i];
    if (!(value > 0.0 && std::isfinite(value))) {
      throw InvalidShape("a " + name + " of " + text_of(value) + ": above 0 is expected");
    }
    if (!(at >= domain.start && at <= domain.end)) {
      throw InvalidShape("the " + name + " at " + text_of(at) + " is off the rail, which runs from " + text_of(domain.start) +
                         " to " + text_of(domain.end));
    }
    if (i > 0 && !(at > numbers[i - 1].at)) throw InvalidShape("parameters at which a " + name + " is given do not increase");
  }
  if (is_closed && numbers.back().at - numbers.front().at >= domain.length()) {
    throw InvalidShape("a closed rail ends where it starts: there is one " + name + " too many");
  }
}

double secant(const RailNumber& a, const RailNumber& b) { return (b.value - a.value) / (b.at - a.at); }

/// From 1 at t = 0 to 0 at 1, with three derivatives that are 0 at both.
double value_part(double t) {
  const double s = 1.0 - t;
  return s * s * s * s * (1.0 + t * (4.0 + t * (10.0 + 20.0 * t)));
}

/// With the slope 1 at t = 0, otherwise 0 with three derivatives at both ends.
double slope_part(double t) {
  const double s = 1.0 - t;
  return t * s * s * s * s * (1.0 + t * (4.0 + 10.0 * t));
}

double slope_part_slope(double t) {
  const double s = 1.0 - t;
  const double cubes = t * t * t * s * s * s;
  return value_part(t) - 140.0 * t * cubes - 80.0 * cubes * (s - t);
}

/// By which numbers between others rise: harmonic means of secants (Fritsch and Butland 1984), and so much of the lesser one at most that
/// polynomials of at() do not turn back.
double rising_slope(double before, double behind) {
  constexpr double kMost = 1.8;
  const double slope = harmonic_slope(before, behind);
  const double most = kMost * std::min(std::abs(before), std::abs(behind));
  return std::clamp(slope, -most, most);
}

/// Two periods round those given, so that each number of a period has its neighbors.
std::vector<RailNumber> repeated(std::span<const RailNumber> numbers, double period) {
  constexpr int kBeyond = 2;
  const int count = static_cast<int>(numbers.size());
  std::vector<RailNumber> all;
  for (int i = -kBeyond; i < count + kBeyond; ++i) {
    const int turn = (i + kBeyond * count) / count - kBeyond;
    const RailNumber& number = numbers[static_cast<std::size_t>(i - turn * count)];
    all.push_back({number.at + turn * period, number.value});
  }
  return all;
}

}  // namespace

NumbersAlong::NumbersAlong(std::span<const RailNumber> numbers, const Interval& domain, bool is_closed, const char* name)
    : domain_(domain), is_closed_(is_closed) {
  require_numbers(numbers, domain, is_closed, name);
  numbers_ = is_closed ? repeated(numbers, domain.length()) : std::vector<RailNumber>(numbers.begin(), numbers.end());
  slopes_.assign(numbers_.size(), 0.0);
  for (std::size_t i = 1; i + 1 < numbers_.size(); ++i) {
    slopes_[i] = rising_slope(secant(numbers_[i - 1], numbers_[i]), secant(numbers_[i], numbers_[i + 1]));
  }
  if (numbers_.size() < 2 || is_closed) return;
  if (numbers_.front().at <= domain.start) slopes_.front() = secant(numbers_[0], numbers_[1]);
  if (numbers_.back().at >= domain.end) slopes_.back() = secant(numbers_[numbers_.size() - 2], numbers_.back());
}

bool NumbersAlong::is_one() const {
  return std::ranges::all_of(numbers_, [&](const RailNumber& number) { return number.value == numbers_.front().value; });
}

std::vector<double> NumbersAlong::joints() const {
  std::vector<double> found;
  for (const RailNumber& number : numbers_) found.push_back(number.at);
  return found;
}

double NumbersAlong::largest() const { return std::ranges::max(numbers_, {}, &RailNumber::value).value; }

NumbersAlong::Part NumbersAlong::part_at(double parameter) const {
  const auto next = std::ranges::upper_bound(numbers_, parameter, {}, &RailNumber::at);
  const auto i = static_cast<std::size_t>(next - numbers_.begin()) - 1;
  const double length = numbers_[i + 1].at - numbers_[i].at;
  return {i, length, (parameter - numbers_[i].at) / length};
}

/// By polynomials of degree 7 with these slopes, whose second and third derivatives are 0 at the ends.
double NumbersAlong::at(double parameter) const {
  if (parameter <= numbers_.front().at) return numbers_.front().value;
  if (parameter >= numbers_.back().at) return numbers_.back().value;
  const auto [i, length, t] = part_at(parameter);
  const double s = 1.0 - t;
  const double a = numbers_[i].value;
  const double b = numbers_[i + 1].value;
  const double by_slopes = slopes_[i] * slope_part(t) - slopes_[i + 1] * slope_part(s);
  const double value = a * value_part(t) + b * value_part(s) + length * by_slopes;
  const auto [low, high] = std::minmax(a, b);
  return std::clamp(value, low, high);
}

double NumbersAlong::slope_inside(double parameter) const {
  if (parameter <= numbers_.front().at || parameter >= numbers_.back().at) return 0.0;
  const auto [i, length, t] = part_at(parameter);
  const double s = 1.0 - t;
  const double steep = 140.0 * t * t * t * s * s * s;
  return steep * secant(numbers_[i], numbers_[i + 1]) + slopes_[i] * slope_part_slope(t) + slopes_[i + 1] * slope_part_slope(s);
}

double NumbersAlong::beyond(double parameter) const {
  if (is_closed_) {
    const double turns = std::floor((parameter - domain_.start) / domain_.length());
    return at(parameter - turns * domain_.length());
  }
  if (parameter < numbers_.front().at && numbers_.front().at == domain_.start) {
    return numbers_.front().value + (parameter - domain_.start) * slopes_.front();
  }
  if (parameter > numbers_.back().at && numbers_.back().at == domain_.end) {
    return numbers_.back().value + (parameter - domain_.end) * slopes_.back();
  }
  return at(parameter);
}

double NumbersAlong::slope_beyond(double parameter) const {
  if (is_closed_) {
    const double turns = std::floor((parameter - domain_.start) / domain_.length());
    return slope_inside(parameter - turns * domain_.length());
  }
  if (parameter <= numbers_.front().at && numbers_.front().at == domain_.start) return slopes_.front();
  if (parameter >= numbers_.back().at && numbers_.back().at == domain_.end) return slopes_.back();
  return slope_inside(parameter);
}

}  // namespace splinecore
