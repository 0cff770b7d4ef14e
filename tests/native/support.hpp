#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "splinecore/base/errors.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/patch/evaluate.hpp"

namespace splinecore::testing {

/// Draws the same numbers with every compiler and library; SPLINECORE_TESTS_SEED draws others.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed + shift()) {}

  std::uint64_t operator()() { return engine_(); }

 private:
  static std::uint64_t shift() {
    const char* const given = std::getenv("SPLINECORE_TESTS_SEED");
    return given ? 1000003 * std::strtoull(given, nullptr, 10) : 0;
  }

  std::mt19937_64 engine_;
};

inline double real(Random& random, double low, double high) {
  return low + (high - low) * std::ldexp(static_cast<double>(random() >> 11), -53);
}

inline int integer(Random& random, int low, int high) {
  const auto count = static_cast<std::uint64_t>(high - low + 1);
  return low + static_cast<int>((random() >> 32) * count >> 32);
}

template <class Values>
void shuffle(Random& random, Values& values) {
  for (int i = static_cast<int>(values.size()) - 1; i > 0; --i) std::swap(values[i], values[integer(random, 0, i)]);
}

enum class Ends { clamped, unclamped, periodic };
enum class Weights { one, positive, any };

struct Kind {
  int degree;
  int spans;
  Ends ends;
  Weights weights;
};

/// Every combination for degrees 1 to 9 and for one, two and seven spans.
inline std::vector<Kind> all_kinds() {
  std::vector<Kind> kinds;
  for (int degree = 1; degree <= 9; ++degree) {
    for (const int spans : {1, 2, 7}) {
      for (const Ends ends : {Ends::clamped, Ends::unclamped, Ends::periodic}) {
        for (const Weights weights : {Weights::one, Weights::positive, Weights::any}) {
          kinds.push_back({degree, spans, ends, weights});
        }
      }
    }
  }
  return kinds;
}

/// The same, with one kind of weights.
inline std::vector<Kind> all_kinds(Weights weights) {
  std::vector<Kind> kinds = all_kinds();
  std::erase_if(kinds, [&](const Kind& kind) { return kind.weights != weights; });
  return kinds;
}

inline std::string text_of(const Kind& kind) {
  return "degree " + std::to_string(kind.degree) + ", spans " + std::to_string(kind.spans) + ", ends " +
         std::to_string(static_cast<int>(kind.ends)) + ", weights " + std::to_string(static_cast<int>(kind.weights));
}

/// Unequal spans; inner knots of every multiplicity up to degree + 1; unclamped ends of any steps, also none.
inline KnotVector random_knots(Random& random, int degree, int spans, Ends ends) {
  std::vector<double> knots;
  double u = real(random, -3.0, 3.0);
  const auto step = [&] { u += integer(random, 0, 4) == 0 ? real(random, 0.01, 0.02) : real(random, 0.5, 1.5); };
  const auto add = [&](int times) { knots.insert(knots.end(), times, u); };
  const auto inner = [&] { return integer(random, 0, 2) == 0 ? integer(random, 1, degree + 1) : 1; };
  const bool periodic = ends == Ends::periodic;
  const int first = periodic ? integer(random, 1, degree + 1) : degree + 1;
  const auto outer = [&] {
    add(1);
    if (knots.size() % 3 != 0) step();
  };
  if (ends == Ends::unclamped) {
    for (int i = 0; i < degree; ++i) outer();
    add(1);
  } else {
    add(first);
  }
  for (int span = 1; span < spans; ++span) {
    step();
    add(inner());
  }
  step();
  if (ends != Ends::unclamped) {
    add(periodic ? integer(random, 1, degree + 2 - first) : degree + 1);
  } else {
    add(1);
    for (int i = 0; i < degree; ++i) {
      if (i % 2 == 0) step();
      add(1);
    }
  }
  return KnotVector::make(degree, std::move(knots), periodic);
}

inline glm::dvec3 random_vector(Random& random, double size = 10.0) {
  const double x = real(random, -size, size);
  const double y = real(random, -size, size);
  return {x, y, real(random, -size, size)};
}

inline double random_weight(Random& random, Weights weights) {
  if (weights == Weights::one) return 1.0;
  if (weights == Weights::positive || integer(random, 0, 1) == 0) {
    const int exponent = integer(random, -2, 1);
    return std::ldexp(real(random, 1.0, 2.0), exponent);
  }
  return integer(random, 0, 1) == 0 ? 0.0 : -real(random, 0.1, 2.0);
}

/// Of two neighbors one has a weight, so that no part of a shape lies at infinity altogether.
inline std::vector<glm::dvec4> random_points(Random& random, int count, Weights weights) {
  std::vector<glm::dvec4> points;
  for (int i = 0; i < count; ++i) {
    const double weight = random_weight(random, weights);  // draws in an order that is the same with every compiler
    points.emplace_back(random_vector(random), weight);
    if (points[i].w == 0.0 && (i == 0 || points[i - 1].w == 0.0)) points[i].w = 1.0;
  }
  return points;
}

inline NurbsCurve random_curve(Random& random, const Kind& kind) {
  KnotVector knots = random_knots(random, kind.degree, kind.spans, kind.ends);
  std::vector<glm::dvec4> points = random_points(random, knots.count(), kind.weights);
  return NurbsCurve::make(std::move(knots), std::move(points));
}

/// Of two points or more: a period of one span may be a point.
inline Kind random_kind(Random& random, int most_degree, int most_spans, Weights weights) {
  const int degree = integer(random, 1, most_degree);
  const auto ends = static_cast<Ends>(integer(random, 0, 2));
  return {degree, integer(random, ends == Ends::periodic ? 2 : 1, most_spans), ends, weights};
}

inline NurbsCurve random_curve(Random& random, Weights weights = Weights::any) {
  return random_curve(random, random_kind(random, 9, 8, weights));
}

inline NurbsPatch random_patch(Random& random, const Kind& u, const Kind& v) {
  KnotVector knots_u = random_knots(random, u.degree, u.spans, u.ends);
  KnotVector knots_v = random_knots(random, v.degree, v.spans, v.ends);
  const int count = knots_u.count() * knots_v.count();
  return NurbsPatch::make(std::move(knots_u), std::move(knots_v), random_points(random, count, u.weights));
}

inline NurbsPatch random_patch(Random& random, Weights weights = Weights::any) {
  const Kind u = random_kind(random, 5, 3, weights);
  return random_patch(random, u, random_kind(random, 5, 3, weights));
}

inline std::vector<double> random_parameters(Random& random, Interval range, int count) {
  std::vector<double> parameters(count);
  for (double& u : parameters) u = real(random, range.start, range.end);
  return parameters;
}

inline glm::dvec3 point_at(const NurbsCurve& curve, double u, Side side = Side::right) {
  glm::dvec3 point;
  evaluate(curve, {&u, 1}, std::span(&point.x, 3), {.side = side});
  return point;
}

inline glm::dvec4 homogeneous_at(const NurbsCurve& curve, double u, Side side = Side::right) {
  glm::dvec4 point;
  evaluate_homogeneous(curve, {&u, 1}, {&point, 1}, side);
  return std::ldexp(1.0, curve.weight_exponent()) * point;
}

inline glm::dvec3 point_at(const NurbsPatch& patch, double u, double v, PatchOptions options = {}) {
  glm::dvec3 point;
  evaluate(patch, {&u, 1}, {&v, 1}, std::span(&point.x, 3), options);
  return point;
}

/// The homogeneous point, as the library evaluates wx, wy, wz and w where they are coordinates of patches without
/// weights: defined also where the patch is at infinity.
inline glm::dvec4 homogeneous_at(const NurbsPatch& patch, double u, double v) {
  std::vector<glm::dvec4> places;
  std::vector<glm::dvec4> weights;
  for (const glm::dvec4& p : patch.points()) {
    places.emplace_back((p.w == 0.0 ? 1.0 : p.w) * glm::dvec3(p), 1.0);
    weights.emplace_back(p.w, 0.0, 0.0, 1.0);
  }
  return {point_at(patch.with_points(places), u, v), point_at(patch.with_points(weights), u, v).x};
}

/// The larger of two errors; NaN, which no bound holds for, if one of them is.
inline double worse(double a, double b) { return a > b || std::isnan(a) ? a : b; }

template <class Vector>
double largest(const Vector& p) {
  double size = 0.0;
  for (int axis = 0; axis < p.length(); ++axis) size = worse(size, std::abs(static_cast<double>(p[axis])));
  return size;
}

/// Largest coordinate of any homogeneous point: what rounding is relative to.
template <class Shape>
double size_of(const Shape& shape) {
  double size = 0.0;
  for (const glm::dvec4& p : shape.homogeneous_points()) size = worse(size, largest(p));
  return std::ldexp(size, shape.weight_exponent());
}

/// The message with which an action is refused.
template <class Action>
std::string refusal(Action action) {
  try {
    action();
  } catch (const InvalidShape& error) {
    return error.what();
  }
  return "not refused";
}

}  // namespace splinecore::testing
