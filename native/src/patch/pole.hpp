#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory_resource>
#include <optional>
#include <span>
#include <vector>

#include "grid.hpp"
#include "splinecore/patch/isocurve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A side of a patch that is one point.
///
/// Seen from there the homogeneous patch begins with t C, where t leads away from the side and C is a curve along it:
/// the limit of the normals has the direction of C x C', as those of the cone over C have. The points of C are those
/// beside the pole.
class Pole {
 public:
  /// None where the side is more than a point, or is not where the net ends.
  static std::optional<Pole> at(const NurbsPatch& patch, Border side);

  /// The direction whose parameter is constant along the side, and its value there.
  Axis axis() const noexcept { return axis_of(side_); }
  double parameter() const noexcept { return parameter_; }

  /// Unit normals at the parameters along the side, NaN where rounding may have made them.
  /// @param along  made for normals @param rounding  of the patch
  std::pmr::vector<double> normals(const GridColumns& along, const NormalRounding& rounding,
                                   std::pmr::memory_resource* memory) const;

 private:
  Pole(Border side, double parameter, int degree) : side_(side), parameter_(parameter), degree_(degree) {}

  Border side_;
  double parameter_;
  int degree_;  ///< along the side
  std::vector<glm::dvec4> points_;
};

/// All sides of a patch that are points.
std::vector<Pole> poles_of(const NurbsPatch& patch);

/// The limits of normals in the poles of a patch, at the parameters of a grid.
class PoleNormals {
 public:
  PoleNormals(std::span<const Pole> poles, const NormalRounding& rounding, const GridPlan& plan,
              std::pmr::memory_resource* memory);

  /// NaN where none is known.
  glm::dvec3 at(std::size_t i, std::size_t j) const;

 private:
  struct Row {
    const Pole* pole;
    std::pmr::vector<double> normals;
  };
  const GridPlan& plan_;
  std::pmr::vector<Row> rows_;
};

}  // namespace splinecore
#pragma GCC visibility pop
