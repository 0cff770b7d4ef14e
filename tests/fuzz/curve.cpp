#include "curve_steps.hpp"
#include "finding.hpp"
#include "shapes.hpp"
#include "targets.hpp"

namespace splinecore::fuzz {

namespace {

constexpr int kMostSteps = 12;

std::vector<CurveStep> all_steps() {
  std::vector<CurveStep> steps;
  for (const auto& some : {curve_verbs(), curve_measures(), curve_forms()}) {
    steps.insert(steps.end(), some.begin(), some.end());
  }
  return steps;
}

}  // namespace

void curve(Input data) {
  static const std::vector<CurveStep> steps = all_steps();
  Bytes bytes(data);
  std::vector<std::uint8_t> walk(bytes.integer(1, kMostSteps));
  for (std::uint8_t& step : walk) step = bytes.byte();
  attempt([&] {
    NurbsCurve walker = nurbs_curve(bytes);
    for (const std::uint8_t step : walk) {
      if (walker.points().size() > kManyPoints) return;
      attempt([&] { steps[step % steps.size()](bytes, walker); });
    }
  });
}

}  // namespace splinecore::fuzz
