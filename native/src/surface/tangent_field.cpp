#include "tangent_field.hpp"

#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>
#include <utility>

#include "base/length.hpp"
#include "fit/row_spline.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/meet/nearest.hpp"
#include "splinecore/patch/evaluate.hpp"
#include "splinecore/patch/isocurve.hpp"

namespace splinecore {

TangentField::TangentField(NurbsCurve border, NurbsPatch neighbor, std::vector<double> at, std::span<const glm::dvec3> across,
                           std::string name, const std::string& crossing)
    : border_(std::move(border)), neighbor_(std::move(neighbor)), side_(boundary(neighbor_, Border::v_start)),
      name_(std::move(name)), at_(std::move(at)), parts_(border_) {
  const std::vector<PlaneFrame> planes = frames(std::span(at_).first(across.size()));
  for (std::size_t j = 0; j < planes.size(); ++j) {
    crossed_.emplace_back(glm::dot(across[j], planes[j].out), glm::dot(across[j], planes[j].along));
    if (crossed_.back().x > 0.0) continue;
    throw InvalidShape(crossing + index_text(j) + " turns back over " + name_ + ": every surface there would fold");
  }
  parts_ = through_crossed();
}

NurbsCurve TangentField::through_crossed() const {
  constexpr int kCubic = 3;
  RowConditions given{at_, {}, {}, {}};
  for (const glm::dvec2& pair : crossed_) given.rows.push_back({pair.x, pair.y});
  if (slopes_[0]) given.start.push_back({slopes_[0]->x, slopes_[0]->y});
  if (slopes_[1]) given.end.push_back({slopes_[1]->x, slopes_[1]->y});
  const std::size_t conditions = crossed_.size() + given.start.size() + given.end.size();
  const int degree = std::min(kCubic, static_cast<int>(conditions) - 1);
  const RowSpline spline = spline_through(given, degree, border_.periodic() ? Closing::closed : Closing::open);
  std::vector<glm::dvec4> points;
  for (std::size_t i = 0; i < spline.controls.size(); i += 2) {
    points.emplace_back(spline.controls[i], spline.controls[i + 1], 0.0, 1.0);
  }
  return NurbsCurve::make(spline.knots, std::move(points));
}

void TangentField::bend(bool is_end, const glm::dvec2& slopes) {
  const double at[] = {is_end ? border_.domain().end : border_.domain().start};
  glm::dvec3 jet[2];
  derivatives(parts_, at, 1, std::span(&jet[0].x, 6), {.side = is_end ? Side::left : Side::right});
  slopes_[is_end] = glm::dvec2(jet[1]) + slopes;
  parts_ = through_crossed();
}

std::vector<PlaneFrame> TangentField::frames(std::span<const double> at) const {
  const std::size_t count = at.size();
  std::vector<glm::dvec3> jets(2 * count);
  derivatives(border_, at, 1, {&jets.front().x, 6 * count});
  std::vector<glm::dvec3> points;
  for (std::size_t k = 0; k < count; ++k) points.push_back(jets[2 * k]);
  std::vector<NearestOnCurve> places(count);
  nearest(side_, points, places);
  std::vector<double> s;
  for (const NearestOnCurve& place : places) s.push_back(place.parameter);
  const std::vector<double> edge(count, neighbor_.knot_vector(Axis::v).domain().start);
  std::vector<glm::dvec3> by(4 * count);
  derivatives(neighbor_, s, edge, 1, {&by.front().x, 12 * count});
  std::vector<PlaneFrame> found;
  for (std::size_t k = 0; k < count; ++k) {
    const glm::dvec3 inwards = by[4 * k + 1];
    const glm::dvec3 normal = glm::cross(by[4 * k + 2], inwards);
    const glm::dvec3 out = glm::cross(normal, jets[2 * k + 1]);
    const double length = length_of(out);
    if (!(length > 0.0)) throw InvalidShape(name_ + " has no tangent plane somewhere along its side, or the border has a zero derivative");
    const glm::dvec3 away = out / (glm::dot(out, inwards) > 0.0 ? -length : length);
    const glm::dvec3 along = glm::cross(normal, away);
    found.push_back({away, along / length_of(along)});
  }
  return found;
}

std::vector<glm::dvec3> TangentField::vectors(std::span<const double> at) const {
  const std::vector<PlaneFrame> planes = frames(at);
  std::vector<glm::dvec3> pairs(at.size());
  evaluate(parts_, at, {&pairs.front().x, 3 * at.size()});
  std::vector<glm::dvec3> found;
  for (std::size_t k = 0; k < at.size(); ++k) found.push_back(pairs[k].x * planes[k].out + pairs[k].y * planes[k].along);
  return found;
}

}  // namespace splinecore
