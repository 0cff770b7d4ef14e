#pragma once

#include <array>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

#include "curve_part.hpp"
#include "splinecore/base/pause.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Parts of a curve that lie beside each other, in a box along them; or one part.
struct CurveBundle {
  glm::dvec3 center;
  std::array<glm::dvec3, 3> axes;
  glm::dvec3 half;      ///< infinite where a part runs through infinity
  std::size_t parts;    ///< how many
  std::size_t first;    ///< the part, or the bundle of one half
  std::size_t second;   ///< the bundle of the other half
};

/// Parts in halves by where they lie, so that turns of a spiral beside each other are told apart many at a time.
class CurveBundles {
 public:
  explicit CurveBundles(std::span<const CurvePart> parts);

  const CurveBundle& operator[](std::size_t i) const noexcept { return bundles_[i]; }
  const CurveBundle& of_part(std::size_t part) const noexcept { return bundles_[of_parts_[part]]; }

  /// About how many parts are within a distance of a box: those in bundles as thin as it are counted together.
  std::size_t count_near(const CurveBundle& box, double distance) const;

 private:
  struct Hull {
    bool is_boxed;
    glm::dvec3 middle;
    glm::dvec3 way;
    std::size_t first;  ///< of its points
    std::size_t end;
  };
  std::array<glm::dvec3, 3> axes_of(std::span<const std::size_t> some) const;
  std::size_t add(std::span<std::size_t> some);

  std::vector<Hull> hulls_;  ///< of the parts, while they are put together
  std::vector<glm::dvec3> points_;

  std::vector<CurveBundle> bundles_;  ///< the first one has all
  std::vector<std::size_t> of_parts_;
};

/// Whether boxes are farther apart than that, as seen along one of their axes.
bool are_apart(const CurveBundle& a, const CurveBundle& b, double distance);

/// Calls work(i, j) with parts whose boxes are within a distance; of one curve with itself i <= j.
template <class Work>
class BundlePairs {
 public:
  BundlePairs(const CurveBundles& a, const CurveBundles& b, double distance, Work work)
      : a_(a), b_(b), is_one_(&a == &b), slack_(distance + 0x1p-40), work_(work) {}

  void visit() { is_one_ ? own(0) : pair(0, 0); }

 private:
  void own(std::size_t i) {
    if (a_[i].parts == 1) return work_(a_[i].first, a_[i].first);
    own(a_[i].first);
    own(a_[i].second);
    pair(a_[i].first, a_[i].second);
  }

  void pair(std::size_t i, std::size_t j) {
    breathe(32);
    const CurveBundle& a = a_[i];
    const CurveBundle& b = b_[j];
    if (are_apart(a, b, slack_)) return;
    if (a.parts == 1 && b.parts == 1) {
      const bool turns = is_one_ && a.first > b.first;
      return turns ? work_(b.first, a.first) : work_(a.first, b.first);
    }
    const bool halves_a = b.parts == 1 || (a.parts > 1 && glm::dot(a.half, a.half) >= glm::dot(b.half, b.half));
    pair(halves_a ? a.first : i, halves_a ? j : b.first);
    pair(halves_a ? a.second : i, halves_a ? j : b.second);
  }

  const CurveBundles& a_;
  const CurveBundles& b_;
  bool is_one_;
  double slack_;
  Work work_;
};

}  // namespace splinecore
#pragma GCC visibility pop
