// A bottle: closed sections through points, a loft through them, its area, and a mesh in an STL file.
//
//     bottle FILE.stl

#include <cmath>
#include <iostream>
#include <numbers>
#include <splinecore/base/errors.hpp>
#include <splinecore/exchange/meshes.hpp>
#include <splinecore/fit/interpolate.hpp>
#include <splinecore/measure/area.hpp>
#include <splinecore/surface/loft.hpp>

namespace sc = splinecore;

namespace {

/// A closed cubic through eight points of an ellipse with flattened sides.
sc::NurbsCurve section(double height, double width, double depth) {
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 8; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 8.0;
    const double flat = i % 2 == 0 ? 1.0 : 1.1;
    points.emplace_back(flat * width * std::cos(angle), flat * depth * std::sin(angle), height);
  }
  return sc::interpolate_calmly(points, {.closing = sc::Closing::closed}).value;
}

}  // namespace

int main(int count, char** arguments) try {
  if (count != 2) {
    std::cerr << "bottle FILE.stl\n";
    return 2;
  }
  const std::vector<sc::LoftSection> sections{section(0.0, 3.0, 1.6), section(4.0, 3.4, 2.0), section(9.0, 3.0, 1.8),
                                              section(11.0, 1.2, 1.2), section(12.5, 1.2, 1.2)};
  const sc::NurbsPatch side = sc::loft(sections).value;
  sc::save_meshes(arguments[1], side, {.tolerance = 0.01, .angle = 0.3});
  std::cout << "area " << sc::area(side, 1e-6).value << "\n";
  return 0;
} catch (const std::exception& error) {
  std::cerr << "bottle: " << error.what() << "\n";
  return 1;
}
