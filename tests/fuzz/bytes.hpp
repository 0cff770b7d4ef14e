#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "splinecore/base/interval.hpp"

namespace splinecore::fuzz {

using Input = std::span<const std::uint8_t>;

/// Numbers that rounding, overflow and cancellation are made of.
inline constexpr std::array<double, 40> kHard{
    0.0,    -0.0,   1.0,    -1.0,       2.0,      0.5,     1.0 / 3, 3.141592653589793, 0.7071067811865476, 1e-3,
    1e-8,   1e-12,  1e-16,  1e-30,      1e-100,   1e-150,  1e-162,  1e-200,            1e-300,             2.3e-308,
    1e-310, 5e-324, 1e3,    1e8,        1e16,     1e36,    3.5e38,  1e75,              1e100,              1e150,
    1e154,  1e200,  1e275,  1.7976931348623157e308, -1e300,  1e308,  1.0000000000000002, 0.9999999999999999, 2147483648.0,
    9007199254740993.0};

/// The bytes of an input, one after the other; behind its end goes on what an own sequence gives, so that a short
/// input describes a large shape.
class Bytes {
 public:
  explicit Bytes(Input data) : data_(data) {}

  bool is_at_end() const noexcept { return next_ >= data_.size(); }

  std::uint8_t byte() noexcept {
    if (!is_at_end()) return data_[next_++];
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<std::uint8_t>(state_ >> 56);
  }

  bool flag() noexcept { return (byte() & 1) != 0; }

  /// low … high, at most 256 of them.
  int integer(int low, int high) noexcept { return low + byte() % (high - low + 1); }

  /// Behind the end of the input no more than small ones.
  double number() noexcept {
    const std::uint8_t tag = is_at_end() ? byte() & 0x7f : byte();
    if (tag < 0x80) return (tag - 64) / 8.0;
    if (tag < 0xc0) return kHard[(tag - 0x80) % kHard.size()];
    if (tag < 0xe0) return of_eight_bytes();
    const int high = byte();
    return static_cast<std::int16_t>(high << 8 | byte()) / 256.0;
  }

  /// Of the interval as a rule: its ends, the middle, parts of it, and what a number says.
  double within(Interval range) noexcept {
    const std::uint8_t tag = byte();
    if (tag == 0) return range.start;
    if (tag == 1) return range.end;
    if (tag == 2) return range.middle();
    if (tag == 3) return number();
    return range.start + (range.end - range.start) * (tag / 255.0);
  }

  /// Above 0 as a rule.
  double tolerance() noexcept {
    const std::uint8_t tag = byte();
    if (tag >= 0xf0) return number();
    return std::array{1e-15, 1e-12, 1e-9, 1e-6, 1e-4, 1e-2, 0.1, 1.0}[tag % 8];
  }

  std::string_view rest() noexcept {
    const auto* begin = reinterpret_cast<const char*>(data_.data());
    const std::string_view text(begin + next_, data_.size() - next_);
    next_ = data_.size();
    return text;
  }

 private:
  double of_eight_bytes() noexcept {
    std::uint64_t bits = 0;
    for (unsigned shift = 0; shift < 64; shift += 8) bits |= std::uint64_t{byte()} << shift;
    return std::bit_cast<double>(bits);
  }

  Input data_;
  std::size_t next_ = 0;
  std::uint64_t state_ = 1;
};

}  // namespace splinecore::fuzz
