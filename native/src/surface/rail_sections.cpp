#include "rail_sections.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "loft_sections.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/basis/samples.hpp"

namespace splinecore {

namespace {

void require_sections(std::span<const RailSection> sections, const Interval& rail) {
  if (sections.empty()) throw InvalidShape("there is no section");
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const double at = sections[i].at;
    if (!(at >= rail.start && at <= rail.end)) {
      throw InvalidShape("sections" + index_text(i) + " belongs to the parameter " + text_of(at) + " of the rail, which runs from " +
                         text_of(rail.start) + " to " + text_of(rail.end));
    }
    if (i > 0 && !(at > sections[i - 1].at)) {
      throw InvalidShape("sections" + index_text(i) + " does not lie behind the section before it");
    }
  }
}

std::vector<glm::dvec4> near_row(std::vector<glm::dvec4> points, double unit) {
  for (glm::dvec4& p : points) p = glm::dvec4(glm::dvec3(p) / unit, p.w);
  return homogeneous(points);
}

std::vector<LoftSection> curves_of(std::span<const RailSection> sections) {
  std::vector<LoftSection> curves;
  for (const RailSection& section : sections) curves.emplace_back(section.curve);
  return curves;
}

}  // namespace

RailSections::RailSections(std::span<const RailSection> sections, const NurbsCurve& rail, double unit)
    : knots_(KnotVector::bezier(1)) {
  require_sections(sections, rail.domain());
  if (sections.size() == 1) {
    const NurbsCurve& curve = sections[0].curve;
    knots_ = curve.knot_vector();
    first_ = near_row({curve.points().begin(), curve.points().end()}, unit);
    return;
  }
  constexpr int kDegree = 3;
  const LoftSections made = loft_sections(curves_of(sections), {});
  knots_ = made.knots;
  const bool is_closed = rail.periodic();
  RowConditions given;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    given.rows.push_back(numbers_of(near_row(made.rows[i].points, unit)));
    given.parameters.push_back(sections[i].at);
  }
  for (std::size_t j = 3; j < given.rows[0].size(); j += 4) {
    const double first = given.rows[0][j];
    const bool is_level = std::ranges::all_of(given.rows, [&](const std::vector<double>& row) { return row[j] == first; });
    level_weights_.push_back(is_level ? std::optional(first) : std::nullopt);
  }
  if (is_closed && sections.size() > 2) given.parameters.push_back(sections[0].at + rail.domain().length());
  const bool goes_round = given.parameters.size() > sections.size();
  along_ = spline_through(given, std::min(kDegree, static_cast<int>(sections.size()) - 1),
                          goes_round ? Closing::closed : Closing::open);
}

std::vector<glm::dvec4> RailSections::at(std::span<const double> parameters) const {
  std::vector<glm::dvec4> found;
  if (!along_) {
    for (std::size_t i = 0; i < parameters.size(); ++i) found.insert(found.end(), first_.begin(), first_.end());
    return found;
  }
  std::vector<double> inside(parameters.begin(), parameters.end());
  const Interval known = along_->knots.domain();
  if (!along_->knots.periodic()) {
    for (double& v : inside) v = std::clamp(v, known.start, known.end);
  }
  const Samples samples = Samples::make(along_->knots, inside, 0, Side::left);
  const auto count = static_cast<std::size_t>(along_->knots.count());
  const std::size_t width = along_->controls.size() / 4 / count;
  for (std::size_t i = 0; i < inside.size(); ++i) {
    for (std::size_t j = 0; j < width; ++j) {
      glm::dvec4 point(0.0);
      auto row = static_cast<std::size_t>(samples.first(i));
      for (const double weight : samples.weights(i)) {
        const double* const p = &along_->controls[4 * ((row++ % count) * width + j)];
        point += weight * glm::dvec4(p[0], p[1], p[2], p[3]);
      }
      if (level_weights_[j]) point.w = *level_weights_[j];
      found.push_back(point);
    }
  }
  return found;
}

}  // namespace splinecore
