#include "patch_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <string>

#include "fit_options.hpp"
#include "quintic.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/patch/evaluate.hpp"

namespace splinecore {

namespace {

constexpr int kMaxCells = 100'000;
constexpr int kLeastMeasuredOfPatch = 16'384;

/// On these places along an edge the error is that of one direction alone.
constexpr std::array kEdgePlaces{0.5, 0.02, 0.98};
constexpr int kEdgeCount = 4 * static_cast<int>(kEdgePlaces.size());

/// The k-th place to measure in a cell: first on the edges along u, then along v, then inside, where the
/// sequence meets no regular pattern (Roberts 2018, of the plastic number).
glm::dvec2 measured_place_of_cell(int k) {
  constexpr int kPlaces = static_cast<int>(kEdgePlaces.size());
  constexpr double kPlastic = 1.324717957244746;
  const double along = kEdgePlaces[k % kPlaces];
  const double side = (k / kPlaces) % 2;
  if (k < kEdgeCount / 2) return {along, side};
  if (k < kEdgeCount) return {side, along};
  return {std::fmod(0.5 + k / kPlastic, 1.0), std::fmod(0.5 + k / (kPlastic * kPlastic), 1.0)};
}

/// Largest distances in a cell: on its edges along u, along v, and anywhere.
struct CellError {
  double along_u = 0.0;
  double along_v = 0.0;
  double largest = 0.0;
};

using Marks = std::vector<char>;

class PatchFit {
 public:
  PatchFit(std::span<const Formula> coordinates, const std::array<Interval, 2>& domains, double tolerance)
      : surface_(coordinates, domains), tolerance_(tolerance) {
    for (int axis = 0; axis < 2; ++axis) joints_[axis] = {domains[axis].start, domains[axis].end};
  }

  Approximation<NurbsPatch> run();

 private:
  int cells(int axis) const { return static_cast<int>(joints_[axis].size()) - 1; }
  Interval cell(int axis, int i) const { return {joints_[axis][i], joints_[axis][i + 1]}; }
  NurbsPatch assembled();
  CellError error_of(const NurbsPatch& patch, int i, int j);
  void mark(int i, int j, const CellError& error);
  void cut(int axis);

  FormulaSurface surface_;
  double tolerance_;
  std::vector<double> joints_[2];
  Marks marks_[2];
};

Approximation<NurbsPatch> PatchFit::run() {
  while (true) {
    NurbsPatch patch = assembled();
    double largest = 0.0;
    for (int axis = 0; axis < 2; ++axis) marks_[axis].assign(cells(axis), 0);
    for (int i = 0; i < cells(0); ++i) {
      for (int j = 0; j < cells(1); ++j) {
        const CellError error = error_of(patch, i, j);
        largest = std::max(largest, error.largest);
        if (error.largest > kAccepted * tolerance_) mark(i, j, error);
      }
    }
    if (largest <= kAccepted * tolerance_) return {std::move(patch), largest};
    for (int axis = 0; axis < 2; ++axis) cut(axis);
    if (static_cast<std::int64_t>(cells(0)) * cells(1) > kMaxCells) {
      throw ToleranceNotReached(std::to_string(kMaxCells) + " cells cannot follow the formulas", tolerance_, largest);
    }
  }
}

/// The control points that one direction of the grid has: weights of the derivatives at a joint.
struct PolarPoint {
  double joint;
  std::array<double, 3> weights;
};

std::vector<PolarPoint> polar_points(const std::vector<double>& knots) {
  std::vector<PolarPoint> points;
  for (std::size_t i = 1; i + 6 <= knots.size(); ++i) {
    const std::span<const double, 5> window(knots.data() + i, 5);
    points.push_back({window[2], polar_weights(window)});
  }
  return points;
}

NurbsPatch PatchFit::assembled() {
  std::vector<double> knots[2];
  std::vector<PolarPoint> polar[2];
  for (int axis = 0; axis < 2; ++axis) {
    knots[axis] = quintic_knots(joints_[axis], Marks(joints_[axis].size(), 1));
    polar[axis] = polar_points(knots[axis]);
  }
  std::vector<glm::dvec4> points;
  points.reserve(polar[0].size() * polar[1].size());
  for (const PolarPoint& a : polar[0]) {
    for (const PolarPoint& b : polar[1]) {
      const CornerJet& jet = surface_.jet(a.joint, b.joint);
      glm::dvec3 point(0.0);
      for (int k = 0; k < 9; ++k) point += a.weights[k / 3] * b.weights[k % 3] * jet[k];
      points.emplace_back(point, 1.0);
    }
  }
  return NurbsPatch::make(KnotVector::make(5, std::move(knots[0])), KnotVector::make(5, std::move(knots[1])),
                          std::move(points));
}

CellError PatchFit::error_of(const NurbsPatch& patch, int i, int j) {
  constexpr int kLeast = kEdgeCount + 20;
  const int count = std::max(kLeast, kLeastMeasuredOfPatch / (cells(0) * cells(1)));
  std::vector<double> u(count);
  std::vector<double> v(count);
  std::vector<glm::dvec3> wanted(count);
  std::vector<glm::dvec3> found(count);
  for (int k = 0; k < count; ++k) {
    const glm::dvec2 place = measured_place_of_cell(k);
    u[k] = cell(0, i).at(place.x);
    v[k] = cell(1, j).at(place.y);
  }
  surface_.evaluate(u, v, wanted);
  evaluate(patch, u, v, std::span(&found[0].x, 3 * found.size()));
  CellError error;
  for (int k = 0; k < count; ++k) {
    const double apart = glm::distance(wanted[k], found[k]);
    const double distance = std::isfinite(apart) ? apart : HUGE_VAL;
    error.largest = std::max(error.largest, distance);
    if (k >= kEdgeCount) continue;
    double& edge = k < kEdgeCount / 2 ? error.along_u : error.along_v;
    edge = std::max(edge, distance);
  }
  return error;
}

/// Marks the interval of the direction in which the patch fails; both, where the edges do not tell.
void PatchFit::mark(int i, int j, const CellError& error) {
  const double edges = std::max(error.along_u, error.along_v);
  const bool tells = edges > 0.1 * error.largest;
  const bool in_u = !tells || error.along_u > 0.3 * edges;
  const bool in_v = !tells || error.along_v > 0.3 * edges;
  const bool stuck = (in_u && !can_be_cut(cell(0, i))) || (in_v && !can_be_cut(cell(1, j)));
  if (stuck) {
    throw ToleranceNotReached("the patch cannot be followed at u = " + text_of(joints_[0][i]) + ", v = " +
                              text_of(joints_[1][j]) + " (a jump, a pole, or the end of the digits of float64)",
                              tolerance_, error.largest);
  }
  if (in_u) marks_[0][i] = 1;
  if (in_v) marks_[1][j] = 1;
}

void PatchFit::cut(int axis) {
  std::vector<double> joints;
  for (int i = 0; i < cells(axis); ++i) {
    joints.push_back(joints_[axis][i]);
    if (marks_[axis][i] != 0) joints.push_back(cell(axis, i).middle());
  }
  joints.push_back(joints_[axis].back());
  joints_[axis] = std::move(joints);
}

}  // namespace

Approximation<NurbsPatch> fitted_patch(std::span<const Formula> coordinates, const std::array<Interval, 2>& domains,
                                       double tolerance) {
  return PatchFit(coordinates, domains, tolerance).run();
}

}  // namespace splinecore
