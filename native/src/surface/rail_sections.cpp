#include "rail_sections.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "base/positive_weights.hpp"
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

std::vector<double> mean_of(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> mean;
  for (std::size_t i = 0; i < a.size(); ++i) mean.push_back(0.5 * (a[i] + b[i]));
  return mean;
}

/// Lets rows go round; of two, their mean lies between them either way.
void close(RowConditions& given, double end) {
  if (end <= given.parameters.back()) {
    throw InvalidShape("a closed rail ends where it starts: there is one section too many");
  }
  if (given.rows.size() == 2) {
    const std::vector<double> mean = mean_of(given.rows[0], given.rows[1]);
    const std::vector<double> at = given.parameters;
    given.rows = {given.rows[0], mean, given.rows[1], mean};
    given.parameters = {at[0], 0.5 * (at[0] + at[1]), at[1], 0.5 * (at[1] + end)};
  }
  given.parameters.push_back(end);
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
  are_positive_ = std::ranges::all_of(made.rows, [](const SectionRow& row) { return have_positive_weights(row.points); });
  for (std::size_t j = 3; j < given.rows[0].size(); j += 4) {
    const double first = given.rows[0][j];
    const bool is_level = std::ranges::all_of(given.rows, [&](const std::vector<double>& row) { return row[j] == first; });
    level_weights_.push_back(is_level ? std::optional(first) : std::nullopt);
  }
  if (is_closed) close(given, sections[0].at + rail.domain().length());
  along_ = spline_through(given, std::min(kDegree, static_cast<int>(given.rows.size()) - 1), is_closed ? Closing::closed : Closing::open);
}

std::vector<RowJoint> RailSections::joints() const {
  std::vector<RowJoint> found;
  if (!along_) return found;
  constexpr int kKink = 3;
  const Interval known = along_->knots.domain();
  const bool goes_round = along_->knots.periodic();
  for (const double knot : along_->knots.knots()) {
    const bool is_end = !goes_round && (knot == known.start || knot == known.end);
    found.push_back({knot, is_end ? kKink : 1});
  }
  return found;
}

void RailSections::require_weights(const FittedRows& rows) const {
  if (!are_positive_ || have_positive_weights(rows.rows)) return;
  throw InvalidShape("the weights of the sections differ so much that between them some would not stay positive");
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
