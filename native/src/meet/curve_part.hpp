#pragma once

#include <glm/vec3.hpp>
#include <utility>
#include <vector>

#include "basis/bernstein_net.hpp"
#include "splinecore/base/interval.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A part of a Bernstein piece of a curve, and what its hull says of it.
struct CurvePart {
  std::size_t piece;
  Interval range;  ///< in [0, 1]
  BernsteinNet<glm::dvec4> net;
  BernsteinNet<glm::dvec4> sums;  ///< of what it is rounded by, if it runs through infinity
  bool is_boxed;    ///< or its weights have both signs, and nothing below is known
  glm::dvec3 along{1.0, 0.0, 0.0};  ///< a unit vector, nearly that of all tangents
  double spread;    ///< the largest angle of a tangent with it; above pi/2 where that is not known
  double size;      ///< no two points are farther apart
  double rounding = 0.0;  ///< how far that of weights and coordinates moves points across it
  std::vector<glm::dvec3> points;  ///< the net projected

  CurvePart(std::size_t of_piece, const Interval& of_range, BernsteinNet<glm::dvec4> given,
            BernsteinNet<glm::dvec4> given_sums = {});

  std::pair<CurvePart, CurvePart> halves() const;
};

/// Whether hulls are farther apart than that, as seen along some axes of both. Of a part that runs through infinity the
/// hull is what lies outside of a slab about the other one.
bool are_apart(const CurvePart& a, const CurvePart& b, double distance);

/// Whether the hulls of parts with boxes are farther apart than that, as seen along an axis.
bool are_apart_along(const CurvePart& a, const CurvePart& b, const glm::dvec3& axis, double distance);

/// Whether a point is farther than that beside the hull of a part with a box.
bool is_off(const glm::dvec3& point, const CurvePart& part, double distance);

/// Whether a part of a curve that runs through infinity lies as far outside as coordinates are less exact than places:
/// farther than 2^20 times the size of the shapes.
bool is_far_out(const CurvePart& part);

/// Whether no tangent of one is parallel to one of the other, by a margin, so that they leave each other by more than a
/// distance over the length of the shorter one: then they cross once at most.
bool do_tangents_differ(const CurvePart& a, const CurvePart& b, double distance);

/// Whether all tangents are within a right angle of one direction: then the part does not cross itself.
bool is_monotone(const CurvePart& part);

/// Whether all tangents of both together are within a right angle of one direction: then the parts, one after the other,
/// do not cross themselves.
bool are_monotone(const CurvePart& a, const CurvePart& b);

}  // namespace splinecore
#pragma GCC visibility pop
