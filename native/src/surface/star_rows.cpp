#include "star_rows.hpp"

#include "basis/selection.hpp"
#include "greville.hpp"
#include "rows_beside.hpp"
#include "star_claims.hpp"

namespace splinecore {

namespace {

/// Rows of control points of a patch along its part of a side, one more than the highest order.
std::vector<std::vector<glm::dvec3>> rows_along(const PartOfSide& part, const KnotVector& knots, const KnotVector& inwards,
                                                const ValuesAlong& values, int most) {
  std::vector<double> s;
  for (const double place : interpolation_places(knots)) s.push_back(part.from + (part.to - part.from) * place);
  std::vector<std::vector<glm::dvec3>> across;
  for (int order = 0; order <= most; ++order) across.push_back(values(part.side, s, order));
  return rows_beside(knots, is_at_end(part.border) ? reversed(inwards).knots : inwards, across);
}

}  // namespace

std::vector<PartOfSide> star_parts(const Hole& hole) {
  if (hole.share == 1.0) {
    return {{0, 0.0, 1.0, 0, Border::v_start},
            {1, 0.0, 1.0, 0, Border::u_end},
            {2, 1.0, 0.0, 0, Border::v_end},
            {3, 1.0, 0.0, 0, Border::u_start}};
  }
  std::vector<PartOfSide> parts;
  for (std::size_t k = 0; k < hole.sides.size(); ++k) {
    parts.push_back({k, 0.0, hole.share, k, Border::v_start});
    parts.push_back({hole.before(k), 1.0, hole.share, k, Border::u_start});
  }
  return parts;
}

std::vector<std::optional<glm::dvec3>> claimed_points(const Hole& hole, const Star& star, const ValuesAlong& values,
                                                      const std::vector<int>& orders) {
  StarClaims claims(star);
  for (const PartOfSide& part : star_parts(hole)) {
    const Axis inwards = axis_of(part.border);
    const bool is_along_u = inwards == Axis::v;
    const KnotVector& knots = star.along(part.patch, is_along_u ? Axis::u : Axis::v);
    const auto rows = rows_along(part, knots, star.along(part.patch, inwards), values, orders[part.side]);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const std::size_t across = is_at_end(part.border) ? star.last(part.patch, inwards) - r : r;
      for (std::size_t j = 0; j < rows[r].size(); ++j) {
        claims.add(part.patch, is_along_u ? j : across, is_along_u ? across : j, rows[r][j], static_cast<int>(r));
      }
    }
  }
  return claims.points();
}

std::vector<NurbsPatch> patches_of(const Star& star, const std::vector<glm::dvec3>& points) {
  std::vector<NurbsPatch> patches;
  for (std::size_t k = 0; k < star.count(); ++k) {
    std::vector<glm::dvec4> net;
    for (std::size_t i = 0; i < star.width(k, Axis::u); ++i) {
      for (std::size_t j = 0; j < star.width(k, Axis::v); ++j) net.emplace_back(points[star.at(k, i, j)], 1.0);
    }
    patches.push_back(NurbsPatch::make(star.along(k, Axis::u), star.along(k, Axis::v), std::move(net)));
  }
  return patches;
}

}  // namespace splinecore
