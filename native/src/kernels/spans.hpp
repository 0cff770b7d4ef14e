// Which intervals parameters lie in. Included in the namespace of each set of instructions: see set.hpp.

bool are_between(double low, double high, const double* u, std::size_t count) {
  std::size_t i = 0;
  for (; i + kWide <= count; i += kWide) {
    if (!is_between(low, high, load<WideLanes>(u + i))) return false;
  }
  for (; i < count; ++i) {
    if (!(u[i] > low && u[i] < high)) return false;
  }
  return true;
}

bool are_increasing(const double* values, std::size_t count) {
  std::size_t i = 0;
  for (; i + kWide + 1 <= count; i += kWide) {
    if (!are_below(load<WideLanes>(values + i), load<WideLanes>(values + i + 1))) return false;
  }
  for (; i + 1 < count; ++i) {
    if (!(values[i] < values[i + 1])) return false;
  }
  return true;
}

/// Without an end before the last: those of most shapes are. Bits that differ from those of 1 are gathered.
bool are_weights_one(const double* points, std::size_t count) {
  constexpr std::size_t kTogether = 4;
  constexpr std::int64_t kOne = __builtin_bit_cast(std::int64_t, 1.0);
  const WideBits one = WideBits{} + kOne;
  WideBits others[kTogether]{};
  const std::size_t numbers = 4 * count;
  std::size_t i = 0;
  for (; i + kTogether * kWide <= numbers; i += kTogether * kWide) {
    for (std::size_t k = 0; k < kTogether; ++k) {
      others[k] |= one ^ reinterpret_cast<WideBits>(load<WideLanes>(points + i + k * kWide));
    }
  }
  const WideBits most = (others[0] | others[1]) | (others[2] | others[3]);
  bool are_ones = true;
  for (int lane = 3; lane < kWide; lane += 4) are_ones &= most[lane] == 0;
  for (; i < numbers; i += 4) are_ones &= __builtin_bit_cast(std::int64_t, points[i + 3]) == kOne;
  return are_ones;
}

/// Bits without the sign are in the order of the absolute values, infinity and what is no number behind all others.
double largest_size(const double* values, std::size_t count) {
  constexpr std::int64_t kSize = 0x7fffffffffffffff;
  constexpr std::size_t kTogether = 4;  // comparisons, because each waits for itself
  WideBits sizes[kTogether]{};
  std::size_t i = 0;
  for (; i + kTogether * kWide <= count; i += kTogether * kWide) {
    for (std::size_t k = 0; k < kTogether; ++k) {
      const WideBits size = reinterpret_cast<WideBits>(load<WideLanes>(values + i + k * kWide)) & kSize;
      sizes[k] = size > sizes[k] ? size : sizes[k];
    }
  }
  std::int64_t most = 0;
  for (; i < count; ++i) {
    const std::int64_t size = __builtin_bit_cast(std::int64_t, values[i]) & kSize;
    most = size > most ? size : most;
  }
  for (std::size_t k = 0; k < kTogether; ++k) {
    for (int lane = 0; lane < kWide; ++lane) most = sizes[k][lane] > most ? sizes[k][lane] : most;
  }
  return __builtin_bit_cast(double, most);
}

/// The starts of a part that are before u, or at it, by halving.
template <bool kAt>
std::int32_t begun_of_many(const IntervalParts& parts, std::size_t part, double u) {
  std::int32_t next = parts.first[part];
  for (std::int32_t end = parts.first[part + 1]; next < end;) {
    const std::int32_t middle = next + (end - next) / 2;
    const double start = parts.starts[middle];
    if (kAt ? start <= u : start < u) {
      next = middle + 1;
    } else {
      end = middle;
    }
  }
  return next;
}

template <bool kAt>
SPLINECORE_INLINE void intervals_of(const IntervalParts& given, const double* u, std::size_t count, std::int32_t* intervals) {
  const IntervalParts parts = given;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = u[i];
    const auto part = static_cast<std::size_t>(static_cast<std::int64_t>((at - parts.begin) * parts.scale));
    std::int32_t next = parts.first[part];
    if (__builtin_expect(parts.first[part + 1] - next > 1, 0)) {
      next = begun_of_many<kAt>(parts, part, at);
    } else {
      const double start = parts.starts[next];
      next += static_cast<std::int32_t>(kAt ? start <= at : start < at);
    }
    intervals[i] = next - 1;
  }
}

void find_intervals(const IntervalParts& parts, bool at, const double* u, std::size_t count, std::int32_t* intervals) {
  return at ? intervals_of<true>(parts, u, count, intervals) : intervals_of<false>(parts, u, count, intervals);
}
