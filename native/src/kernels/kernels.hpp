#pragma once

#include <cstddef>
#include <cstdint>

// What is computed for many parameters at once. Each kernel is compiled for every set of instructions that is worth it
// and chosen at run time; here are plain numbers alone, so that nothing of one set is taken for the other.
//
// A point is x, y, z, w: four doubles. A piece of a curve or of B-spline functions is kept as its Bernstein
// coefficients, each times its binomial, row after row. It is summed from the end of the span that is nearer: with
// x = (u - near) / (far - u) in [0, 1] the sum of rows[k] x^k is Horner's scheme in Bernstein form (Volk and Schumaker
// 1990), without a difference and exact at both ends. The factor ((far - u) / span)^degree cancels in quotients.

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The row of Pascal's triangle, up to degree 255 at least.
const double* binomials(int degree) noexcept;

/// Intervals, each of which begins where the one before ends: spans of a domain, or halves of them. It is cut into equal
/// parts that know how many of them start before.
struct IntervalParts {
  const double* starts;       ///< minus infinity for the first, and infinity behind the last
  const std::int32_t* first;  ///< of each part: how many start in those before it
  double begin;               ///< of the domain
  double scale;               ///< from a parameter behind it to its part
};

/// Half of a span of a curve, for derivatives 0 … order.
struct CurveHalf {
  double near;         ///< the end of the span in this half
  double far;          ///< the other end
  const double* rows;  ///< from the near end on; those of derivative k, degree + 1 - k, behind those of the ones before
};

/// Parameters, each with a half of its own.
struct ScatteredHalves {
  const double* u;
  const std::int32_t* half;   ///< twice the span, and 1 more in its second half
  const double* ends;         ///< the near and the far one of every half
  const double* table;        ///< the rows of all halves, `size` numbers each; or nullptr
  std::size_t size;
  const double* const* rows;  ///< those of each parameter where there is no table
};

/// What all parameters of a batch on a curve have in common.
struct CurveForm {
  int degree;
  int order;      ///< 0, 1 or 2
  bool rational;  ///< or every w is 1
};

/// Parameters on B-spline functions, each with the span that it lies in.
struct ScatteredSpans {
  const double* u;
  const std::int32_t* span;
  const double* bounds;       ///< where the spans start, and the end of the last
  const int* first_knots;     ///< of each span: the number of the knot that it starts at
  const double* table;        ///< the rows of all spans, `size` numbers each; or nullptr
  std::size_t size;
  const double* const* rows;  ///< those of each parameter where there is no table: of derivative k degree + 1 - k, one
                              ///< derivative after the other, table_width() numbers each
};

/// Numbers of a row of B-spline functions: those of a degree, filled up to whole lanes.
[[gnu::always_inline]] inline constexpr std::size_t table_width(int degree) noexcept { return (static_cast<std::size_t>(degree) + 4) / 4 * 4; }

/// A grid of pairs of parameters. The functions along u are summed for a row, then those along v.
struct GridForm {
  const double* points;  ///< homogeneous, row after row
  std::size_t width;     ///< points of a row
  int degree_u;
  int degree_v;
  bool rational;
};

/// What rounding may do to normals of a patch.
struct NormalRounding {
  double of_points;  ///< what it may leave of a point, which the slopes of functions multiply
  double plain;      ///< so large is |S_u x S_v|², by the squared slopes of functions, where it cannot be rounding
};

/// A row of a grid: where its functions begin, and their values and slopes; the last three for normals alone.
struct GridRow {
  std::size_t first;
  const double* values;
  const double* slopes;
  double size;  ///< of the slopes: the sum of all
  NormalRounding rounding;
};

/// The most neighbors in a row that a kernel computes at once.
inline constexpr std::size_t kMostLanes = 8;

/// Up to Kernels::lanes neighbors in a row whose functions begin at one point; lanes of values and slopes, function by
/// function.
struct alignas(kMostLanes * sizeof(double)) GridBlock {
  double sizes[kMostLanes];  ///< of the slopes
  std::size_t first;         ///< of the points in GridBlocks::ranges
  int count;
  const double* values;
  const double* slopes;
};

/// Neighboring points of a row.
struct GridRange {
  std::size_t first;
  std::size_t count;
};

struct GridBlocks {
  const GridBlock* blocks;
  std::size_t count;
  const GridRange* ranges;  ///< the points that blocks need
  std::size_t range_count;
  std::size_t width;  ///< how many points that are
  std::size_t columns;  ///< neighbors of all blocks
  bool is_far;          ///< whether what is written comes from far memory, which is asked for ahead
};

/// What normals of pairs need to know.
struct NormalForm {
  NormalRounding rounding;
  double scale_u;   ///< powers of two, about the lengths of the domains: derivatives are multiplied by them
  double scale_v;
};

/// Pairs of parameters.
struct ScatteredPairs {
  ScatteredSpans u;
  ScatteredSpans v;
};

/// A rule for the length of a piece over [0, 1] whose speed is |N| / W², both in Bernstein's form.
struct SpeedRule {
  int slopes_degree;              ///< of N
  int weight_degree;              ///< of W; 0 if it is 1
  std::size_t nodes;              ///< a multiple of 4
  const double* slope_functions;  ///< Bernstein polynomials of N's degree at the nodes, one after the other
  const double* weight_functions;
  const double* shares;           ///< of the nodes in the length
  const double* differences;      ///< between these and the shares of a rule with fewer nodes
};

/// A rule along v for areas: Bernstein polynomials of a degree at its nodes, one after the other. The first two nodes
/// are the ends.
struct SurfaceRule {
  int degree;
  std::size_t nodes;  ///< a multiple of 4
  const double* values;
  const double* slopes;
  const double* steps;        ///< the sums of the sizes of the slopes
  const double* shares;       ///< of the nodes in the integral
  const double* differences;  ///< between these and the shares of a rule with fewer nodes
};

/// A line along v of a piece of a surface.
struct SurfaceRow {
  const double* points;  ///< degree + 1 homogeneous ones
  const double* slopes;  ///< their derivatives by u
  double step;           ///< the sum of the sizes of the slopes of the functions along u
  double extent[3];      ///< how large the coordinates are, to which their rounding is relative
  double reach;          ///< and more of that where the weight is small: times one over the weight
  double origin[3];      ///< of volumes, seen from that of the points
  double direction[3];   ///< where normals are expected
};

/// What is found on a line: its part of the area and of the volume, each with the difference to that by the rule with
/// fewer nodes and the size of its terms; and how far normals go against the direction, at the ends and anywhere.
struct SurfaceSums {
  double area[3];
  double volume[3];
  double against_at_ends;
  double against;
};

/// Homogeneous control points of a Bernstein piece, row after row; a curve has one column.
struct PieceNet {
  int rows;
  int columns;
  const double* points;
};

/// Rows of control points filled up to `stride`, a multiple of four, and of sums that have `width` numbers.
struct SquareForm {
  int rows;
  int columns;
  std::size_t stride;
  std::size_t width;  ///< columns + stride at least
};

/// Bits of what a kernel found.
inline constexpr int kNotFinite = 1;   ///< a point that is no number: all are written
inline constexpr int kWeakNormal = 2;  ///< a normal that rounding may have made: NaN is written

/// How many boxes are looked at together.
inline constexpr std::size_t kBoxGroup = 8;

/// Boxes by their middles and half their widths, coordinate by coordinate.
struct alignas(64) BoxGroup {
  double middle[3][kBoxGroup];
  double half[3][kBoxGroup];
};

/// How many rows lie side by side.
inline constexpr std::size_t kNearRows = 64;

/// A tridiagonal matrix: what each row has before the diagonal, at it and behind it.
struct TridiagonalRows {
  double* before;
  double* at;
  double* after;
};

/// What elimination takes from an end of such a matrix on, where its next row is.
struct TridiagonalEnd {
  TridiagonalRows rows;
  const double* right;  ///< three numbers a row, and one behind them that is read
  double* factors;
  double* points;       ///< four numbers a row, of which the last one is anything
};

/// Values at neighboring parameters of a span.
struct SpanPoints {
  double start;  ///< of the span
  double end;
  double share;         ///< 1 over its length
  double scale;         ///< of distances
  double weight_scale;  ///< of weights
  std::size_t count;
  const double* parameters;
  const double* weights;  ///< or nullptr: each is 1
  const double* points;   ///< x, y, z; or nullptr for sums that need none
};

/// Boxes that lie along three directions of their own, coordinate by coordinate.
struct alignas(64) TurnedBoxGroup {
  double center[3][kBoxGroup];
  double axes[3][3][kBoxGroup];  ///< x, y, z of each direction
  double half[3][kBoxGroup];     ///< of the width in each direction
};

struct Kernels {
  const char* name;
  std::size_t lanes;  ///< 4 or 8

  /// Whether all numbers lie strictly between the two.
  bool (*are_between)(double low, double high, const double* u, std::size_t count);

  /// Whether each number is above the one before it.
  bool (*are_increasing)(const double* values, std::size_t count);

  /// Whether the last number of every four is 1.
  bool (*are_weights_one)(const double* points, std::size_t count);

  /// The largest absolute value; no number, or infinite, where one of them is.
  double (*largest_size)(const double* values, std::size_t count);

  /// The distances from points, 4 at least, to the next ones: `count` + 1 times x, y, z are read.
  /// @returns whether all squares lie strictly between the two
  bool (*chords)(const double* points, std::size_t count, double least, double most, double* out);

  /// The last interval that starts before each parameter, or `at` it. All lie in the domain.
  void (*find_intervals)(const IntervalParts&, bool at, const double* u, std::size_t count, std::int32_t* intervals);

  /// As many of the parameters as lie, `lanes` at once, strictly inside the half whose parameters are from low to high.
  /// Writes 3 (order + 1) numbers for each. @returns how many; `found` takes kNotFinite.
  std::size_t (*curve_run)(const CurveForm&, const CurveHalf&, double low, double high, const double* u,
                           std::size_t count, double* out, int* found);
  std::size_t (*curve_run_single)(const CurveForm&, const CurveHalf&, double low, double high, const double* u,
                                  std::size_t count, float* out, int* found);

  /// Writes as many numbers for each of the parameters from number `begin` to `end`, wherever they lie; `out` is the place of
  /// the first of these. @returns kNotFinite or 0
  int (*curve_scattered)(const CurveForm&, const ScatteredHalves&, std::size_t begin, std::size_t end, double* out);
  int (*curve_scattered_single)(const CurveForm&, const ScatteredHalves&, std::size_t begin, std::size_t end,
                                float* out);

  /// The length, its difference from that by the rule with fewer nodes, and the integral of the terms' size: 3 numbers.
  /// @param slopes  four numbers a coefficient of N, of which the last is the size of its terms
  void (*speed_sums)(const SpeedRule&, const double* slopes, const double* weights, double* out);

  void (*surface_sums)(const SurfaceRule&, const SurfaceRow&, SurfaceSums* out);

  /// Homogeneous derivatives by u: 0, 1, 2, and where there are columns by v, by u and v, twice by v; 4 numbers each.
  void (*piece_slopes)(const PieceNet&, const double* at, double* out);

  /// Adds to coefficients those of |N|² and W².
  /// @param scaled  x, y, z and W of all control points times their binomials, coordinate by coordinate
  void (*square_sums)(const SquareForm&, const double* scaled, double* squares, double* weights);

  /// The squares of the least distances that points of the boxes may have from x, y, z, up to rounding.
  void (*box_distances)(const BoxGroup&, const double* from, double* squares);
  void (*turned_box_distances)(const TurnedBoxGroup&, const double* from, double* squares);

  /// The functions of a degree and their derivatives 0 … order, table_width() numbers for each derivative.
  void (*functions)(int degree, int order, const ScatteredSpans&, std::size_t count, double* out);

  /// x, y, z of a row of the grid; scratch has 4 numbers for each of GridBlocks::width.
  int (*grid_points)(const GridForm&, const GridRow&, const GridBlocks&, double* scratch, double* out);
  int (*grid_points_single)(const GridForm&, const GridRow&, const GridBlocks&, double* scratch, float* out);

  /// And unit normals; scratch has twice as many numbers.
  int (*grid_normals)(const GridForm&, const GridRow&, const GridBlocks&, double* scratch, double* out,
                      double* normals);
  int (*grid_normals_single)(const GridForm&, const GridRow&, const GridBlocks&, double* scratch, float* out,
                             float* normals);

  /// Homogeneous sums of derivatives k along u and l along v, k, l <= order, at one pair: 4 (order + 1)² numbers. The
  /// functions of each order have table_width() numbers.
  void (*pair_sums)(const GridForm&, int order, const double* corner, const double* u, const double* v, double* out);

  /// x, y, z of pairs; with their first derivatives 3 * 3 numbers each: point, along u, along v.
  int (*pair_points)(const GridForm&, const ScatteredPairs&, std::size_t count, double* out);
  int (*pair_slopes)(const GridForm&, const ScatteredPairs&, std::size_t count, double* out);

  /// And unit normals.
  int (*pair_normals)(const GridForm&, const NormalForm&, const ScatteredPairs&, std::size_t count, double* out,
                      double* normals);

  /// Of degree 2 + index: `count` rows of functions at parameters, from 4 to kNearRows of them, of which the one of row i
  /// lies from knot i + 1 on and before knot i + degree. Each has 2 degree - 1 numbers, from column i - degree + 1 on,
  /// kNearRows apart: all first ones, then all second ones.
  /// @param near  knot 0, with degree - 2 before it and count + 2 degree - 2 behind it
  /// @returns whether all parameters lie so
  bool (*near_rows[8])(const double* near, const double* parameters, std::size_t count, double* out);

  /// Rows of cubic functions at simple knots, of which two lie before them and two behind.
  /// @param count  `lanes` at least
  void (*knot_rows)(const double* knots, std::size_t count, const TridiagonalRows&);

  /// Gaussian elimination without exchanges goes on from both ends at once, from the rows taken before, whose factors and
  /// points stand beside: x[i] + factors[i] x[next] = points[i] is what is left of row i. Each step waits for the one
  /// before it, and two wait together.
  void (*eliminate)(const TridiagonalEnd& start, const TridiagonalEnd& end, std::size_t count);

  /// Writes x over so many points to each side of the two in the middle, which are known, and 1 behind each.
  /// @param points  the second one in the middle
  void (*substitute)(const double* factors, double* points, std::size_t count);

  /// The largest square of a distance times the scale of rows' sums of points from their right sides; infinity where
  /// one is no number.
  /// @param count  `lanes` at least
  double (*largest_left)(const TridiagonalRows&, std::size_t count, const double* points, const double* right,
                         double scale);

  /// Of degree 1 + index: sums over the points of a span of weight t^k s^(2 degree - k), where t and s are the parts of
  /// the span before and behind: 2 degree + 1 numbers.
  void (*power_sums[9])(const SpanPoints&, double* sums);

  /// Sums of weight t^k s^(degree - k) times what is left of the points by a piece: x, y, z for each k.
  /// @param piece  its Bezier points, each times its binomial and -1
  /// @returns the square of the largest distance times the scale
  double (*residual_sums[9])(const SpanPoints&, const double* piece, double* sums);
};

/// The kernels for this machine, or those that the environment variable SPLINECORE_KERNELS names, if it can run them.
const Kernels& kernels() noexcept;

}  // namespace splinecore
#pragma GCC visibility pop
