// All kernels for one set of instructions, which SPLINECORE_SET and SPLINECORE_SET_NAME name. A source file includes it
// once; everything has internal linkage, so that a linker cannot take code of one set for that of another.

#include "kernels.hpp"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

// Lanes are kept in registers only where nothing is called.
#define SPLINECORE_INLINE [[gnu::always_inline]] inline

#pragma GCC visibility push(hidden)
namespace splinecore {

namespace {

#include "lanes.hpp"
#include "spans.hpp"
#include "curves.hpp"
#include "lengths.hpp"
#include "distances.hpp"
#include "functions.hpp"
#include "patches.hpp"
#include "pairs.hpp"
#include "near_rows.hpp"
#include "tridiagonal.hpp"
#include "least_squares.hpp"

}  // namespace

extern const Kernels SPLINECORE_SET;
const Kernels SPLINECORE_SET{
    SPLINECORE_SET_NAME, kWide,
    are_between, are_increasing, are_weights_one, largest_size, chords, find_intervals,
    curve_run<double>, curve_run<float>, curve_scattered<double>, curve_scattered<float>,
    speed_sums, surface_sums,
    piece_slopes, square_sums, box_distances, turned_box_distances,
    functions,
    grid_points<double>, grid_points<float>, grid_normals<double>, grid_normals<float>,
    pair_sums, pair_points, pair_slopes, pair_normals,
    {near_rows<2>, near_rows<3>, near_rows<4>, near_rows<5>, near_rows<6>, near_rows<7>, near_rows<8>, near_rows<9>},
    knot_rows, eliminate, substitute, largest_left,
    {power_sums<1>, power_sums<2>, power_sums<3>, power_sums<4>, power_sums<5>, power_sums<6>, power_sums<7>, power_sums<8>, power_sums<9>},
    {residual_sums<1>, residual_sums<2>, residual_sums<3>, residual_sums<4>, residual_sums<5>,
     residual_sums<6>, residual_sums<7>, residual_sums<8>, residual_sums<9>}};

}  // namespace splinecore
#pragma GCC visibility pop
