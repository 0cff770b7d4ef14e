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
