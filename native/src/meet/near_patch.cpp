#include "near_patch.hpp"

#include <cmath>
#include <limits>

#include "piece_side.hpp"
#include "slope_form.hpp"

namespace splinecore {

NearPatch::NearPatch(const NurbsPatch& patch, const glm::dvec3& point)
    : space_(patch.points()), u_(patch.knot_vector(Axis::u)), v_(patch.knot_vector(Axis::v)),
      from_(point, space_, "point") {
  const auto own = space_.homogeneous(patch.points(), patch.homogeneous_points(), static_cast<std::size_t>(v_.count()),
                                      static_cast<std::size_t>(v_.unrolled_count()));
  for (int i = 0; i < static_cast<int>(spans(Axis::u)); ++i) {
    for (int j = 0; j < static_cast<int>(spans(Axis::v)); ++j) {
      nets_.push_back(bezier_piece(u_, i, v_, j, own.data()));
      scale_weights(nets_.back());
    }
  }
  is_closed_ = {closes(Axis::u), closes(Axis::v)};
}

bool NearPatch::closes(Axis axis) const {
  constexpr double kSame = 0x1p-46;
  const KnotVector& own = knots(axis);
  if (own.periodic()) return multiplicity(own, own.domain().end) <= own.degree();
  for (std::size_t i = 0; i < spans(axis == Axis::u ? Axis::v : Axis::u); ++i) {
    const std::size_t last = spans(axis) - 1;
    const auto& begin = net(axis == Axis::u ? std::array{std::size_t{0}, i} : std::array{i, std::size_t{0}});
    const auto& end = net(axis == Axis::u ? std::array{last, i} : std::array{i, last});
    const std::vector<glm::dvec4> a = side_of(begin, {axis, false}).values;
    const std::vector<glm::dvec4> b = side_of(end, {axis, true}).values;
    for (std::size_t k = 0; k < a.size(); ++k) {
      if (!are_one(a[k], b[k], rounding())) return false;
      const double across = a[k].w * b[0].w;
      if (std::abs(across - b[k].w * a[0].w) > kSame * std::abs(across)) return false;
    }
  }
  return true;
}

double NearPatch::near_length(double length) const noexcept {
  const double unit = space_.length(1.0);
  return unit >= std::numeric_limits<double>::min() ? length / unit : std::numeric_limits<double>::infinity();
}

Slopes<2> NearPatch::slopes(const PiecePlace& place) const noexcept {
  const BernsteinNet<glm::dvec4>& piece = net(place.piece);
  return slopes_of<2>(kernels(), piece.values.data(), piece.rows, piece.columns, place.at, point());
}

std::array<double, 2> NearPatch::parameters(const PiecePlace& place) const noexcept {
  return {span(Axis::u, place.piece[0]).at(place.at[0]),
          span(Axis::v, place.piece[1]).at(place.at[1])};
}

}  // namespace splinecore
