#include "splinecore/build/least_motion.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>

#include "base/length.hpp"
#include "base/quotient.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

constexpr double kDependentEquation = 1e-12;  // what is left of an equation beside others is rounding below this
constexpr double kMet = 1e-9;

/// One equation, made as long as 1.
struct Equation {
  std::vector<int> points;
  std::vector<double> factors;
  std::size_t column;   // of all that are given
  glm::dvec3 rest;      // what free points are to add to it
};

/// Equations and the free points that they have in common.
struct SharedEquations {
  std::vector<const Equation*> equations;
  bool is_met = true;
};

double largest_of(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

double dot(std::span<const double> a, std::span<const double> b) { return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); }

/// The rows of a linear system, with what each is to be.
struct MotionSystem {
  std::vector<int> unknowns;               // the points, in their order
  std::vector<std::vector<double>> rows;
  std::vector<glm::dvec3> rests;

  void subtract(std::size_t i, double share, std::size_t other) {
    for (std::size_t k = 0; k < rows[i].size(); ++k) rows[i][k] -= share * rows[other][k];
    rests[i] -= share * rests[other];
  }

  /// @returns whether it was longer than that
  bool to_length_one(std::size_t i, double least) {
    const double length = std::sqrt(dot(rows[i], rows[i]));
    if (!(length > least)) return false;
    for (double& entry : rows[i]) entry /= length;
    rests[i] /= length;
    return true;
  }
};

MotionSystem system_of(const SharedEquations& together, const std::vector<bool>& is_free) {
  MotionSystem system;
  for (const Equation* const equation : together.equations) {
    for (std::size_t k = 0; k < equation->points.size(); ++k) {
      if (is_free[equation->points[k]] && equation->factors[k] != 0.0) system.unknowns.push_back(equation->points[k]);
    }
  }
  std::ranges::sort(system.unknowns);
  system.unknowns.erase(std::ranges::unique(system.unknowns).begin(), system.unknowns.end());
  for (const Equation* const equation : together.equations) {
    std::vector<double> row(system.unknowns.size(), 0.0);
    for (std::size_t k = 0; k < equation->points.size(); ++k) {
      const auto at = std::ranges::lower_bound(system.unknowns, equation->points[k]);
      if (at != system.unknowns.end() && *at == equation->points[k]) row[at - system.unknowns.begin()] += equation->factors[k];
    }
    system.rows.push_back(std::move(row));
    system.rests.push_back(equation->rest);
  }
  return system;
}

/// Bring the equations of each column to right angles, in their order. @returns false where one has no free point.
bool set_upright(MotionSystem& system, const SharedEquations& together) {
  std::map<std::size_t, std::vector<std::size_t>> earlier;
  for (std::size_t i = 0; i < system.rows.size(); ++i) {
    if (!system.to_length_one(i, 0.0)) return false;
    std::vector<std::size_t>& before = earlier[together.equations[i]->column];
    for (int again = 0; again < 2; ++again) {  // once leaves rounding where the angle is small
      for (const std::size_t other : before) system.subtract(i, dot(system.rows[i], system.rows[other]), other);
      if (!before.empty() && !system.to_length_one(i, kDependentEquation)) return false;
    }
    before.push_back(i);
  }
  return true;
}

/// The shortest solution of those equations that do not depend on others.
std::vector<glm::dvec3> shortest_solution(MotionSystem system) {
  std::vector<glm::dvec3> solution(system.unknowns.size(), glm::dvec3(0.0));
  std::vector<std::size_t> open(system.rows.size());
  std::iota(open.begin(), open.end(), std::size_t{0});
  std::vector<std::size_t> chosen;
  while (!open.empty()) {
    const auto longest = std::ranges::max_element(open, {}, [&](std::size_t i) { return dot(system.rows[i], system.rows[i]); });
    const std::size_t next = *longest;
    open.erase(longest);
    const double length = std::sqrt(dot(system.rows[next], system.rows[next]));
    if (!(length > kDependentEquation)) break;
    for (const std::size_t other : chosen) system.subtract(next, dot(system.rows[next], system.rows[other]), other);
    if (!system.to_length_one(next, 0.5 * kDependentEquation)) continue;
    chosen.push_back(next);
    for (const std::size_t i : open) system.subtract(i, dot(system.rows[i], system.rows[next]), next);
  }
  for (const std::size_t i : chosen) {
    for (std::size_t k = 0; k < solution.size(); ++k) solution[k] += system.rows[i][k] * system.rests[i];
  }
  return solution;
}

/// Sets of numbers that are joined one by one.
class Sets {
 public:
  explicit Sets(std::size_t count) : leaders_(count) { std::iota(leaders_.begin(), leaders_.end(), std::size_t{0}); }
  std::size_t of(std::size_t i) {
    while (leaders_[i] != i) i = leaders_[i] = leaders_[leaders_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { leaders_[std::max(of(a), of(b))] = std::min(of(a), of(b)); }

 private:
  std::vector<std::size_t> leaders_;
};

/// Those of order 1 first.
std::vector<Equation> equations_of(std::span<const MotionEquations> given, std::span<const glm::dvec3> moved) {
  std::vector<Equation> all;
  std::size_t first = 0;
  for (const MotionEquations& some : given) {
    const std::size_t columns = some.points.size() / some.width;
    for (const std::vector<double>& factors : some.factors) {
      for (std::size_t i = 0; i < columns; ++i) {
        const auto begin = static_cast<std::ptrdiff_t>(i * some.width);
        const auto end = begin + static_cast<std::ptrdiff_t>(some.width);
        Equation one{{some.points.begin() + begin, some.points.begin() + end},
                     {factors.begin() + begin, factors.begin() + end}, first + i, glm::dvec3(0.0)};
        const double length = std::sqrt(dot(one.factors, one.factors));
        for (double& factor : one.factors) factor /= length;
        for (std::size_t k = 0; k < some.width; ++k) one.rest -= one.factors[k] * moved[one.points[k]];
        all.push_back(std::move(one));
      }
    }
    first += columns;
  }
  return all;
}

std::vector<SharedEquations> sharing_points(const std::vector<Equation>& equations, const std::vector<bool>& is_free) {
  constexpr double kMoves = 1e-3 * kMet;
  const std::size_t points = is_free.size();
  Sets sets(points + equations.size());
  for (std::size_t i = 0; i < equations.size(); ++i) {
    for (std::size_t k = 0; k < equations[i].points.size(); ++k) {
      const int point = equations[i].points[k];
      if (is_free[point] && equations[i].factors[k] != 0.0) sets.join(static_cast<std::size_t>(point), points + i);
    }
  }
  std::map<std::size_t, SharedEquations> found;
  for (std::size_t i = 0; i < equations.size(); ++i) {
    SharedEquations& own = found[sets.of(points + i)];
    own.equations.push_back(&equations[i]);
    if (!(largest_of(equations[i].rest) <= kMoves)) own.is_met = false;
  }
  std::vector<SharedEquations> all;
  for (auto& [leader, own] : found) all.push_back(std::move(own));
  return all;
}

void require_equations(std::span<const MotionEquations> equations, std::span<const glm::dvec3> moved, const std::vector<bool>& is_free) {
  if (is_free.size() != moved.size()) {
    throw InvalidShape("free has " + std::to_string(is_free.size()) + " values for " + std::to_string(moved.size()) + " points");
  }
  for (const MotionEquations& some : equations) {
    if (some.width == 0) throw InvalidShape("equations have no points");
    for (const int point : some.points) {
      if (point < 0 || point >= static_cast<int>(moved.size())) throw InvalidShape("there is no point " + std::to_string(point));
    }
    for (const std::vector<double>& factors : some.factors) {
      if (factors.size() != some.points.size()) throw InvalidShape("equations have other numbers of factors than of points");
      for (std::size_t begin = 0; begin < factors.size(); begin += some.width) {
        const double square = dot(std::span(factors).subspan(begin, some.width), std::span(factors).subspan(begin, some.width));
        if (!(square > 0.0 && std::isfinite(square))) throw InvalidShape("the factors of an equation are all zero, or too large or small");
      }
    }
  }
  if (!std::ranges::all_of(moved, [](const glm::dvec3& p) { return is_finite(p); })) throw InvalidShape("a motion is not finite");
}

}  // namespace

std::optional<std::vector<glm::dvec3>> least_motion(std::span<const MotionEquations> given, std::span<const glm::dvec3> moved,
                                                    const std::vector<bool>& is_free) {
  require_equations(given, moved, is_free);
  std::vector<glm::dvec3> motion(moved.size(), glm::dvec3(0.0));
  double most = 0.0;
  for (const glm::dvec3& one : moved) most = std::max(most, largest_of(one));
  if (most == 0.0) return motion;
  std::vector<glm::dvec3> shares(moved.begin(), moved.end());
  for (glm::dvec3& one : shares) one /= most;
  const std::vector<Equation> equations = equations_of(given, shares);
  double missed = 0.0;
  double largest = 1.0;
  for (const SharedEquations& together : sharing_points(equations, is_free)) {
    if (together.is_met) continue;
    MotionSystem system = system_of(together, is_free);
    if (!set_upright(system, together)) return std::nullopt;
    const std::vector<glm::dvec3> found = shortest_solution(system);
    for (std::size_t k = 0; k < found.size(); ++k) {
      if (!is_finite(found[k])) return std::nullopt;
      largest = std::max(largest, largest_of(found[k]));
      motion[system.unknowns[k]] = found[k] * most;
    }
    for (std::size_t i = 0; i < system.rows.size(); ++i) {
      glm::dvec3 reached(0.0);
      for (std::size_t k = 0; k < found.size(); ++k) reached += system.rows[i][k] * found[k];
      missed = std::max(missed, largest_of(reached - system.rests[i]));
    }
  }
  if (missed > kMet * largest) return std::nullopt;
  return motion;
}

}  // namespace splinecore
