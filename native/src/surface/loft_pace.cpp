#include "loft_pace.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>

#include "base/length.hpp"
#include "base/quotient.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/build/parameterization.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

/// Places along sections, and what each counts: together 1.
struct SectionPlaces {
  std::vector<double> at;
  std::vector<double> shares;
};

/// Several in every span, which together count as much as it is long.
SectionPlaces places_along(const KnotVector& knots) {
  constexpr double kAll = 64.0;
  constexpr int kLeast = 4;
  SectionPlaces places;
  const double whole = knots.domain().length();
  for (int i = 0; i < static_cast<int>(knots.spans().size()); ++i) {
    const Interval span = knots.span_interval(i);
    const double share = span.length() / whole;
    const int count = std::max(kLeast, static_cast<int>(std::ceil(kAll * share)));
    for (int k = 0; k < count; ++k) {
      places.at.push_back(span.start + span.length() * (k + 0.5) / count);
      places.shares.push_back(share / count);
    }
  }
  return places;
}

/// Sums of steps from section to section over all lines along which sections are in sight.
class SectionSteps {
 public:
  SectionSteps(const LoftSections& sections, Closing closing)
      : places_(places_along(sections.knots)), count_(sections.rows.size()), closing_(closing) {
    points_.resize(places_.at.size() * count_);
    std::vector<glm::dvec3> line(places_.at.size());
    for (std::size_t j = 0; j < count_; ++j) {
      const NurbsCurve curve = NurbsCurve::from_homogeneous(sections.knots, sections.rows[j].near);
      evaluate(curve, places_.at, {&line.front().x, 3 * line.size()}, {.at_infinity = AtInfinity::nan});
      for (std::size_t k = 0; k < line.size(); ++k) points_[k * count_ + j] = line[k];
    }
  }

  /// Parameters from 0 by the mean of distances, or of their roots.
  std::vector<double> parameters(Parameterization kind) const {
    const std::size_t steps = count_ - (closing_ == Closing::closed ? 0 : 1);
    std::vector<double> sums(steps, 0.0);
    double seen = 0.0;
    for (std::size_t k = 0; k < places_.at.size(); ++k) {
      const auto line = std::span(points_).subspan(k * count_, count_);
      if (!std::ranges::all_of(line, [](const glm::dvec3& p) { return is_finite(p); })) continue;
      seen += places_.shares[k];
      for (std::size_t j = 0; j < steps; ++j) sums[j] += places_.shares[k] * step(line[j], line[(j + 1) % count_], kind);
    }
    if (seen == 0.0) throw InvalidShape("no plane shows all sections side by side");
    std::vector<double> found{0.0};
    for (const double sum : sums) found.push_back(found.back() + sum / seen);
    for (std::size_t j = 0; j < steps; ++j) {
      if (!(found[j + 1] > found[j])) throw InvalidShape("two consecutive sections are equal");
    }
    return found;
  }

 private:
  static double step(const glm::dvec3& from, const glm::dvec3& to, Parameterization kind) {
    if (kind == Parameterization::uniform) return 1.0;
    const double chord = distance_of(from, to);
    return kind == Parameterization::centripetal ? std::sqrt(chord) : chord;
  }

  SectionPlaces places_;
  std::size_t count_;
  Closing closing_;
  std::vector<glm::dvec3> points_;  ///< line after line, of which each goes from section to section
};

Parameterization parameterization_of(LoftStyle style) {
  if (style == LoftStyle::tight) return Parameterization::centripetal;
  return style == LoftStyle::uniform ? Parameterization::uniform : Parameterization::chordal;
}

}  // namespace

Pace pace_along(const LoftSections& sections, const LoftOptions& options) {
  const SectionSteps steps(sections, options.closing);
  Pace pace{options.parameters, 0.0};
  const double length = steps.parameters(Parameterization::chordal).back();
  if (pace.parameters.empty()) {
    pace.parameters = steps.parameters(parameterization_of(options.style));
    const double last = pace.parameters.back();
    for (double& parameter : pace.parameters) parameter /= last;
  }
  pace.speed = length / (pace.parameters.back() - pace.parameters.front());
  return pace;
}

}  // namespace splinecore
