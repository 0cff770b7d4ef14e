#include "rail_sections.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "base/harmonic_slope.hpp"
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

/// Whether rows follow each other so unevenly that a smooth spline through them would swing out between.
bool is_uneven(const std::vector<double>& at) {
  constexpr double kMost = 3.0;
  for (std::size_t i = 2; i < at.size(); ++i) {
    const double before = at[i - 1] - at[i - 2];
    const double after = at[i] - at[i - 1];
    if (std::max(before, after) > kMost * std::min(before, after)) return true;
  }
  return false;
}

/// Cubics from row to row that do not leave what lies between them (Fritsch and Butland 1984).
RowSpline within_rows(std::vector<std::vector<double>> rows, std::vector<double> at, Closing closing) {
  const bool is_closed = closing == Closing::closed;
  const std::size_t width = rows.front().size();
  if (is_closed) rows.push_back(rows.front());
  const std::size_t last = at.size() - 1;
  const auto secant = [&](std::size_t i, std::size_t j) { return (rows[i + 1][j] - rows[i][j]) / (at[i + 1] - at[i]); };
  const auto slope = [&](std::size_t i, std::size_t j) {
    if (i > 0 && i < last) return harmonic_slope(secant(i - 1, j), secant(i, j));
    if (is_closed) return harmonic_slope(secant(last - 1, j), secant(0, j));
    return secant(i == 0 ? 0 : last - 1, j);
  };
  std::vector<double> knots(4, at.front());
  RowSpline made{KnotVector::bezier(3), {}};
  for (std::size_t i = 0; i <= last; ++i) {
    const auto add = [&](double step) {
      for (std::size_t j = 0; j < width; ++j) made.controls.push_back(rows[i][j] + (step == 0.0 ? 0.0 : step / 3.0 * slope(i, j)));
    };
    if (i == 0 || i == last) {
      if (i == last) add(at[i - 1] - at[i]);
      add(0.0);
      if (i == 0) add(at[1] - at[0]);
      continue;
    }
    add(at[i - 1] - at[i]);
    add(at[i + 1] - at[i]);
    knots.insert(knots.end(), 2, at[i]);
  }
  knots.insert(knots.end(), 4, at.back());
  made.knots = KnotVector::make(3, std::move(knots));
  return made;
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
  const Closing closing = is_closed ? Closing::closed : Closing::open;
  goes_round_ = is_closed;
  along_ = is_uneven(given.parameters) ? within_rows(given.rows, given.parameters, closing)
                                       : spline_through(given, std::min(kDegree, static_cast<int>(given.rows.size()) - 1), closing);
}

std::vector<RowJoint> RailSections::joints() const {
  std::vector<RowJoint> found;
  if (!along_) return found;
  constexpr int kKink = 3;
  constexpr int kSlopes = 2;
  const Interval known = along_->knots.domain();
  const bool is_smooth = along_->knots.periodic();
  for (const double knot : along_->knots.knots()) {
    const bool is_end = !is_smooth && (knot == known.start || knot == known.end);
    const int copies = is_end && !goes_round_ ? kKink : is_end ? kSlopes : std::min(kSlopes, multiplicity(along_->knots, knot));
    found.push_back({knot, copies});
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
  for (double& v : inside) {
    if (along_->knots.periodic()) break;
    if (goes_round_ && v < known.start) v += known.length();
    v = std::clamp(v, known.start, known.end);
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
