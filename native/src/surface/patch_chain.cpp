#include "patch_chain.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <numeric>
#include <span>

#include "base/length.hpp"
#include "fillet_between.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/curve/compatible.hpp"
#include "splinecore/patch/degree.hpp"
#include "splinecore/patch/isocurve.hpp"

namespace splinecore {

namespace {

/// Of one degree along u, and with one knot vector along v.
void make_alike(std::vector<NurbsPatch>& patches) {
  int degree = 0;
  std::vector<NurbsCurve> lines;
  for (const NurbsPatch& patch : patches) {
    degree = std::max(degree, patch.knot_vector(Axis::u).degree());
    lines.push_back(boundary(patch, Border::u_start));
  }
  const KnotVector across = compatible(lines)[0].knot_vector();
  for (NurbsPatch& patch : patches) {
    patch = swapped(on_knots(swapped(patch), across));
    const int more = degree - patch.knot_vector(Axis::u).degree();
    if (more > 0) patch = elevated(patch, Axis::u, more);
  }
}

/// How far two rows of control points are apart, with what their weights are apart by the size.
double apart(std::span<const glm::dvec4> a, std::span<const glm::dvec4> b, double factor, double size) {
  double most = 0.0;
  for (std::size_t j = 0; j < a.size(); ++j) {
    const double weight = std::abs(factor * b[j].w / a[j].w - 1.0);
    most = std::max({most, distance_of(glm::dvec3(a[j]), glm::dvec3(b[j])), size * weight});
  }
  return most;
}

}  // namespace

PatchChain chained(std::vector<NurbsPatch> patches, const std::vector<double>& lengths, const std::string& name) {
  constexpr double kSame = 1e-9;
  make_alike(patches);
  const double whole = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  const auto count_v = static_cast<std::size_t>(patches.front().count(Axis::v));
  const int degree = patches.front().knot_vector(Axis::u).degree();
  std::vector<double> joints{0.0};
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
  std::vector<glm::dvec4> points;
  double done = 0.0;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const auto own = patches[i].points();
    double factor = 1.0;
    if (i > 0) {
      const auto last = std::span<const glm::dvec4>(points).last(count_v);
      factor = last[0].w / own[0].w;
      const double size = extent(own);
      const double gap = apart(last, own.first(count_v), factor, size);
      if (!(gap <= kSame * size)) {
        throw InvalidShape("the " + name + " patches of edges " + std::to_string(i) + " and " + std::to_string(i + 1) +
                           " do not continue each other: their sides across the edge differ by " + text_of(gap / size) + " of their size");
      }
    }
    for (std::size_t k = i > 0 ? count_v : 0; k < own.size(); ++k) points.push_back({glm::dvec3(own[k]), factor * own[k].w});
    const double start = done / whole;
    done += lengths[i];
    const double end = i + 1 < patches.size() ? done / whole : 1.0;
    for (const double knot : patches[i].knot_vector(Axis::u).knots()) {
      if (knot > 0.0 && knot < 1.0) knots.push_back(start + knot * (end - start));
    }
    knots.insert(knots.end(), static_cast<std::size_t>(i + 1 < patches.size() ? degree : degree + 1), end);
    joints.push_back(end);
  }
  return {NurbsPatch::make(KnotVector::make(degree, std::move(knots)), patches.front().knot_vector(Axis::v), std::move(points)),
          std::move(joints)};
}

}  // namespace splinecore
