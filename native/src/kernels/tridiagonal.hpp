// Kernels of tridiagonal systems. Included in the namespace of each set of instructions: see set.hpp.

/// Cubic functions at knots, by quotients of lengths, so that no product of knots leaves the numbers.
void knot_rows(const double* knots, std::size_t count, const TridiagonalRows& rows) {
  for (std::size_t i = 0; i < count; i += kWide) {
    // The last ones are written once more.
    const std::size_t first = i < count - kWide ? i : count - kWide;
    const auto knot = [&](std::ptrdiff_t k) { return load<WideLanes>(knots + static_cast<std::ptrdiff_t>(first) + k); };
    const WideLanes one = all<WideLanes>(1.0);
    const WideLanes before = knot(0) - knot(-1);
    const WideLanes behind = knot(1) - knot(0);
    const WideLanes both = one / (knot(1) - knot(-1));
    const WideLanes low = behind * both;
    const WideLanes high = before * both;
    const WideLanes three_low = one / (knot(1) - knot(-2));
    const WideLanes three_high = one / (knot(2) - knot(-1));
    const WideLanes at = low * ((knot(0) - knot(-2)) * three_low) + high * ((knot(2) - knot(0)) * three_high);
    store(low * (behind * three_low), rows.before + first);
    store(at, rows.at + first);
    store(high * (before * three_high), rows.after + first);
  }
}

/// Rows in the order in which elimination from an end takes them: kStep is 1 from the first one, -1 from the last one.
/// Pivot i is the quotient of determinant i + 1 and determinant i: these follow from each other by products alone, and
/// no division waits for another. Every block begins with 1, lest they leave the numbers.
template <std::ptrdiff_t kStep>
class RowsFromEnd {
 public:
  static constexpr std::ptrdiff_t kBlock = 48;

  SPLINECORE_INLINE explicit RowsFromEnd(const TridiagonalEnd& end)
      : taken_(kStep > 0 ? end.rows.before : end.rows.after), at_(end.rows.at),
        next_(kStep > 0 ? end.rows.after : end.rows.before), right_(end.right), factors_(end.factors),
        points_(end.points), value_(load(end.points - 4 * kStep)) {}

  SPLINECORE_INLINE void begin_minors(std::ptrdiff_t begin) {
    minors_[0] = 1.0;
    minors_[1] = at_[kStep * begin] - taken_[kStep * begin] * factors_[kStep * (begin - 1)];
  }

  SPLINECORE_INLINE void add_minor(std::ptrdiff_t begin, std::ptrdiff_t i) {
    const std::ptrdiff_t row = kStep * (begin + i);
    minors_[i + 1] = mul_add(at_[row], minors_[i], -(taken_[row] * next_[row - kStep] * minors_[i - 1]));
  }

  SPLINECORE_INLINE void find_factors(std::ptrdiff_t begin, std::ptrdiff_t count) {
    for (std::ptrdiff_t i = 0; i < count; ++i) inverses_[i] = minors_[i] / minors_[i + 1];
    for (std::ptrdiff_t i = 0; i < count; ++i) shares_[i] = -taken_[kStep * (begin + i)] * inverses_[i];
    for (std::ptrdiff_t i = 0; i < count; ++i) factors_[kStep * (begin + i)] = next_[kStep * (begin + i)] * inverses_[i];
  }

  SPLINECORE_INLINE void take(std::ptrdiff_t begin, std::ptrdiff_t i) {
    const std::ptrdiff_t row = kStep * (begin + i);
    value_ = mul_add(all(shares_[i]), value_, all(inverses_[i]) * load(right_ + 3 * row));
    store(value_, points_ + 4 * row);
  }

 private:
  const double* taken_;
  const double* at_;
  const double* next_;
  const double* right_;
  double* factors_;
  double* points_;
  Lanes value_;
  double minors_[kBlock + 1];
  double inverses_[kBlock];
  double shares_[kBlock];
};

/// The minors of a block wait for each other as values of the block before do: both go on together.
void eliminate(const TridiagonalEnd& start, const TridiagonalEnd& end, std::size_t rows) {
  constexpr std::ptrdiff_t kBlock = RowsFromEnd<1>::kBlock;
  const auto count = static_cast<std::ptrdiff_t>(rows);
  RowsFromEnd<1> low(start);
  RowsFromEnd<-1> high(end);
  const auto take = [&](std::ptrdiff_t begin, std::ptrdiff_t i) {
    low.take(begin, i);
    high.take(begin, i);
  };
  const auto add_minors = [&](std::ptrdiff_t begin, std::ptrdiff_t i) {
    low.add_minor(begin, i);
    high.add_minor(begin, i);
  };
  std::ptrdiff_t some = 0;
  for (std::ptrdiff_t begin = 0; begin < count; begin += kBlock) {
    const std::ptrdiff_t known = some;
    some = count - begin < kBlock ? count - begin : kBlock;
    low.begin_minors(begin);
    high.begin_minors(begin);
    if (known == 0) {
      for (std::ptrdiff_t i = 1; i < some; ++i) add_minors(begin, i);
    } else {
      take(begin - kBlock, 0);
      for (std::ptrdiff_t i = 1; i < some; ++i) {
        add_minors(begin, i);
        take(begin - kBlock, i);
      }
      for (std::ptrdiff_t i = some; i < known; ++i) take(begin - kBlock, i);
    }
    low.find_factors(begin, some);
    high.find_factors(begin, some);
  }
  for (std::ptrdiff_t i = 0; i < some; ++i) take(count - some, i);
}

SPLINECORE_INLINE Lanes solved_point(const double* factor, const double* point, Lanes next) {
  return mul_add(all(-*factor), next, load(point));
}

SPLINECORE_INLINE void store_point(Lanes value, double* point) {
  store(__builtin_shufflevector(value, all(1.0), 0, 1, 2, 4), point);
}

void substitute(const double* factors, double* points, std::size_t count) {
  Lanes low = load(points - 4);
  Lanes high = load(points);
  for (std::ptrdiff_t i = 1; i <= static_cast<std::ptrdiff_t>(count); ++i) {
    low = solved_point(factors - 1 - i, points - 4 * (1 + i), low);
    high = solved_point(factors + i, points + 4 * i, high);
    store_point(low, points - 4 * (1 + i));
    store_point(high, points + 4 * i);
  }
}

/// What is left of rows' right sides: their coordinates.
struct WideLeft {
  WideLanes x, y, z;
};

#if defined(SPLINECORE_WIDE_LANES)
/// Two neighbors' numbers, each four times.
template <int kPair>
SPLINECORE_INLINE WideLanes for_pair(WideLanes numbers) {
  constexpr int a = 2 * kPair;
  constexpr int b = 2 * kPair + 1;
  return __builtin_shufflevector(numbers, numbers, a, a, a, a, b, b, b, b);
}

/// Of rows 2 kPair and the next one, one after the other.
template <int kPair>
SPLINECORE_INLINE WideLanes pair_left(WideLanes before, WideLanes at, WideLanes after, const double* points,
                                      const double* right) {
  const double* const point = points + 8 * kPair;
  const WideLanes value = twice(load(right + 6 * kPair), load(right + 6 * kPair + 3));
  const WideLanes sum = mul_add(for_pair<kPair>(before), load<WideLanes>(point - 4), value);
  return mul_add(for_pair<kPair>(after), load<WideLanes>(point + 4),
                 mul_add(for_pair<kPair>(at), load<WideLanes>(point), sum));
}

SPLINECORE_INLINE WideLeft rows_left(const TridiagonalRows& rows, std::size_t i, const double* points,
                                     const double* right) {
  const WideLanes before = -load<WideLanes>(rows.before + i);
  const WideLanes at = -load<WideLanes>(rows.at + i);
  const WideLanes after = -load<WideLanes>(rows.after + i);
  const WideLanes a = pair_left<0>(before, at, after, points + 4 * i, right + 3 * i);
  const WideLanes b = pair_left<1>(before, at, after, points + 4 * i, right + 3 * i);
  const WideLanes c = pair_left<2>(before, at, after, points + 4 * i, right + 3 * i);
  const WideLanes d = pair_left<3>(before, at, after, points + 4 * i, right + 3 * i);
  const WideLanes xz_ab = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
  const WideLanes xz_cd = __builtin_shufflevector(c, d, 0, 8, 2, 10, 4, 12, 6, 14);
  const WideLanes y_ab = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
  const WideLanes y_cd = __builtin_shufflevector(c, d, 1, 9, 3, 11, 5, 13, 7, 15);
  return {__builtin_shufflevector(xz_ab, xz_cd, 0, 1, 8, 9, 4, 5, 12, 13),
          __builtin_shufflevector(y_ab, y_cd, 0, 1, 8, 9, 4, 5, 12, 13),
          __builtin_shufflevector(xz_ab, xz_cd, 2, 3, 10, 11, 6, 7, 14, 15)};
}
#else
SPLINECORE_INLINE WideLeft rows_left(const TridiagonalRows& rows, std::size_t i, const double* points,
                                     const double* right) {
  Lanes left[4];
  for (std::size_t k = 0; k < 4; ++k) {
    const double* const at = points + 4 * (i + k);
    const Lanes sum = mul_add(all(-rows.before[i + k]), load(at - 4), load(right + 3 * (i + k)));
    left[k] = mul_add(all(-rows.after[i + k]), load(at + 4), mul_add(all(-rows.at[i + k]), load(at), sum));
  }
  const Points points_left = transposed(left[0], left[1], left[2], left[3]);
  return {points_left.x, points_left.y, points_left.z};
}
#endif

double largest_left(const TridiagonalRows& rows, std::size_t count, const double* points, const double* right,
                    double scale) {
  WideLanes largest{};
  WideLanes doubts{};
  for (std::size_t i = 0; i < count; i += kWide) {
    const WideLeft left = rows_left(rows, i < count - kWide ? i : count - kWide, points, right);
    const WideLanes x = all<WideLanes>(scale) * left.x;
    const WideLanes y = all<WideLanes>(scale) * left.y;
    const WideLanes z = all<WideLanes>(scale) * left.z;
    const WideLanes square = mul_add(x, x, mul_add(y, y, z * z));
    largest = square > largest ? square : largest;
    doubts = mul_add(square, WideLanes{}, doubts);
  }
  double most = 0.0;
  double doubt = 0.0;
  for (int lane = 0; lane < kWide; ++lane) {
    most = largest[lane] > most ? largest[lane] : most;
    doubt += doubts[lane];
  }
  return doubt == 0.0 ? most : __builtin_inf();
}
