#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "basis/bernstein_net.hpp"
#include "slope_form.hpp"
#include "splinecore/base/axis.hpp"
#include "splinecore/base/interval.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A side of a piece: where the parameter of an axis begins or ends.
struct PieceSide {
  Axis axis;
  bool is_end;
};

/// The values on it, as a column.
template <class Value>
BernsteinNet<Value> side_of(const BernsteinNet<Value>& net, const PieceSide& side) {
  const std::size_t last = net.count(side.axis) - 1;
  const std::size_t at = side.is_end ? last : 0;
  std::vector<Value> values;
  const std::size_t count = side.axis == Axis::u ? net.columns : net.rows;
  for (std::size_t k = 0; k < count; ++k) values.push_back(side.axis == Axis::u ? net.at(at, k) : net.at(k, at));
  return BernsteinNet<Value>::of_curve(std::move(values));
}

/// Whether two homogeneous points are the same finite one.
bool are_one(const glm::dvec4& a, const glm::dvec4& b, double rounding);

/// Whether it is a single point, a pole. @param rounding  how much of a coordinate may be rounding
bool is_point(const BernsteinNet<glm::dvec4>& piece, const PieceSide& side, double rounding);

/// A form that is zero on a side, divided by the parameter from there.
SlopeForm divided(const SlopeForm& form, const PieceSide& side);

/// How the distance goes on a piece along u and along v, without zeros on sides that are poles: all derivatives along
/// such a side are zero.
struct PieceForms {
  SlopeForm u;
  SlopeForm v;
};

/// @param part  of the whole piece: only sides of that are poles
PieceForms forms_of(const BernsteinNet<glm::dvec4>& piece, const std::array<Interval, 2>& part, const glm::dvec3& point,
                    double rounding);

/// Whether the distance rises from a pole into the piece (1), falls (-1), or does either (0), to first order, or where
/// that is zero to second; and whether it is.
struct PoleSigns {
  bool rises = false;
  bool falls = false;
  bool is_stationary = false;
};

PoleSigns pole_signs(const BernsteinNet<glm::dvec4>& piece, const PieceSide& side, const glm::dvec3& point,
                     double rounding);

}  // namespace splinecore
#pragma GCC visibility pop
