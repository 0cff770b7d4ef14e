#pragma once

#include <span>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Writes degree + 1 - order rows of table_width(degree) numbers: row j has the weights of the degree + 1 control points
/// in Bezier point j of derivative `order` on the span that begins at *start.
void fill_derivative_table(const double* start, int degree, int order, double* out);

/// From weights of the lower + 1 control points of a derivative to those of the weights.size() control points that it
/// is of. *start is the knot at which the span begins. Only steps between knots that a function covers divide, so a
/// short span costs no digits (The NURBS Book, A2.3).
void differentiate(const double* start, int lower, std::span<double> weights);

}  // namespace splinecore
#pragma GCC visibility pop
