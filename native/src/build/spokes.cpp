#include "spokes.hpp"

#include <cmath>

#include "base/length.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/conic/ellipse.hpp"

namespace splinecore {

void require_place(const glm::dvec3& place, const std::string& argument) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::isfinite(place[axis])) continue;
    throw InvalidShape(argument + "." + "xyz"[axis] + " = " + text_of(place[axis]) + " is not finite");
  }
}

double require_length(const glm::dvec3& vector, const std::string& argument) {
  require_place(vector, argument);
  const double length = length_of(vector);
  if (std::isnormal(length)) return length;
  throw InvalidShape(argument + " has no direction: its length is " + text_of(length));
}

NurbsCurve closed_ring(const NurbsCurve& curve) {
  const auto knots = curve.knot_vector().knots();
  const std::size_t count = curve.points().size() - 1;
  std::vector<glm::dvec4> points(count);
  for (std::size_t i = 0; i < count; ++i) points[(i + 1) % count] = curve.points()[i];
  return NurbsCurve::make(2, {knots.begin() + 1, knots.begin() + count + 2}, std::move(points), true);
}

NurbsPatch turned(const KnotVector& profile, const std::vector<Spoke>& spokes, const Turn& turn) {
  const NurbsCurve arc = ellipse_arc(glm::dvec3(0.0), {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, turn.start, turn.sweep);
  const bool is_whole = arc.points().front() == arc.points().back();
  const NurbsCurve ring = is_whole ? closed_ring(arc) : arc;
  std::vector<glm::dvec4> net;
  net.reserve(ring.points().size() * spokes.size());
  for (const glm::dvec4& p : ring.points()) {
    for (const Spoke& spoke : spokes) {
      const glm::dvec3 place = spoke.foot + (p.x * spoke.out + p.y * spoke.across);
      // A direction has no weight to take that of the ring.
      net.push_back(spoke.weight == 0.0 ? glm::dvec4(p.w * place, 0.0) : glm::dvec4(place, p.w * spoke.weight));
    }
  }
  return NurbsPatch::make(ring.knot_vector(), profile, std::move(net));
}

}  // namespace splinecore
