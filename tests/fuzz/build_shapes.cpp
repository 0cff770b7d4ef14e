#include "build_steps.hpp"
#include "looks.hpp"
#include "shapes.hpp"
#include "splinecore/basis/uniform.hpp"
#include "splinecore/build/cardinal.hpp"
#include "splinecore/build/chain.hpp"
#include "splinecore/build/patch_from_formulas.hpp"
#include "splinecore/build/polynomial.hpp"
#include "splinecore/build/primitives.hpp"

namespace splinecore::fuzz {

namespace {

Turn turn(Bytes& bytes) {
  Turn result;
  if (bytes.flag()) return result;
  result.start = bytes.number();
  result.sweep = bytes.number();
  return result;
}

/// None as a rule.
std::vector<double> maybe_parameters(Bytes& bytes, std::size_t count) {
  return bytes.integer(0, 2) == 0 ? increasing(bytes, count) : std::vector<double>{};
}

void check_matrix(const BasisMatrix& matrix) { demand_finite<double>(matrix.values, "a number of a matrix"); }

constexpr BuildStep kBuilders[] = {
    [](Bytes& bytes) {
      const auto places = vectors(bytes, bytes.integer(0, 12));
      std::vector<Shaping> shaping(bytes.flag() ? places.size() : 1);
      for (Shaping& one : shaping) one = {bytes.number(), bytes.number(), bytes.number()};
      const auto closing = bytes.flag() ? Closing::closed : Closing::open;
      const auto ends = static_cast<EndTangent>(bytes.integer(0, 2));
      std::vector<double> at = maybe_parameters(bytes, places.size() + (closing == Closing::closed ? 1 : 0));
      if (bytes.flag()) at = parameters_of(places, static_cast<Parameterization>(bytes.integer(0, 2)), closing);
      const HermiteCurve chain = kochanek_bartels(places, shaping, std::move(at), closing, ends);
      look_at(chain);
      look_at_points(chain.nurbs());
    },
    [](Bytes& bytes) {
      const auto places = vectors(bytes, bytes.integer(0, 12));
      const std::vector<double> at = maybe_parameters(bytes, places.size() < 3 ? 1 : places.size() - 2);
      const std::vector<BezierCurve> chain = chain_from_polygon(places, at);
      for (const BezierCurve& one : chain) look_at_points(one.nurbs());
      polygon_of_chain(chain, bytes.flag() ? increasing(bytes, chain.size()) : std::vector<double>{});
    },
    [](Bytes& bytes) {
      const auto p = vectors(bytes, 5);
      const double a = bytes.number();
      const auto pair = c2_pair(p[0], p[1], p[2], p[3], p[4], a, bytes.number());
      look_at_points(pair.first.nurbs());
      look_at_points(pair.second.nurbs());
    },
    [](Bytes& bytes) {
      const auto places = vectors(bytes, bytes.integer(0, 30));
      const std::vector<double> at = maybe_parameters(bytes, places.size());
      std::vector<glm::dvec3> out(3);
      attempt([&] {
        const std::array asked{at.empty() ? 0.0 : at.front(), bytes.within({}), bytes.number()};
        lagrange_evaluate(places, at, asked, out);
      });
      look_at_points(polynomial_through(places, at));
    },
    [](Bytes& bytes) {
      std::vector<Osculation> data(bytes.integer(0, 6));
      const std::vector<double> at = increasing(bytes, data.size());
      for (std::size_t i = 0; i < data.size(); ++i) {
        data[i].parameter = at[i];
        data[i].derivatives = vectors(bytes, bytes.integer(0, 5));
      }
      look_at_points(osculating_polynomial(data));
    },
    [](Bytes& bytes) {
      const auto p = vectors(bytes, 3);
      look_at_points(plane(p[0], p[1], p[2]));
    },
    [](Bytes& bytes) {
      const auto p = vectors(bytes, 2);
      const double radius = bytes.number();
      const double height = bytes.number();
      attempt([&] { look_at_points(cylinder(p[0], p[1], radius, height, turn(bytes))); });
      const double top = bytes.number();
      look_at_points(cone(p[0], p[1], radius, height, top, turn(bytes)));
    },
    [](Bytes& bytes) {
      const auto p = vectors(bytes, 2);
      const double radius = bytes.number();
      attempt([&] { look_at_points(disc(p[0], p[1], radius, turn(bytes))); });
      attempt([&] { look_at_points(sphere(p[0], radius, p[1], turn(bytes))); });
      const double tube = bytes.number();
      look_at_points(torus(p[0], p[1], radius, tube, turn(bytes)));
    },
    [](Bytes& bytes) {
      const NurbsCurve profile = nurbs_curve(bytes);
      const auto p = vectors(bytes, 2);
      attempt([&] { look_at_points(extrude(profile, p[0])); });
      attempt([&] { look_at_points(revolve(profile, p[0], p[1], turn(bytes))); });
      look_at_points(ruled(profile, nurbs_curve(bytes)));
    },
    [](Bytes& bytes) {
      const int degree = bytes.integer(0, 40) - 1;
      attempt([&] { check_matrix(uniform_matrix(degree)); });
      attempt([&] { check_matrix(uniform_to_bezier(degree)); });
      check_matrix(bezier_matrix(degree));
    },
    [](Bytes& bytes) {
      const std::array<Interval, 2> domains{Interval{0.0, bytes.number()}, Interval{-1.0, bytes.number()}};
      const std::string height(bytes.rest());
      std::vector<Formula> coordinates;
      for (const std::string& text : {std::string("u"), std::string("v"), height}) {
        coordinates.push_back(Formula::make(text, {"u", "v"}));
      }
      const auto found = patch_from_formulas(coordinates, domains, 0.25);
      demand(found.error >= 0.0 && found.error <= 0.25, "a patch of formulas misses its tolerance");
      look_at_points(found.value);
    },
};

}  // namespace

std::span<const BuildStep> shape_builders() { return kBuilders; }

}  // namespace splinecore::fuzz
