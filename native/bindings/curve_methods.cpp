#include "curve_methods.hpp"

#include "long_calls.hpp"
#include "splinecore/base/quotient.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/tessellate/polyline.hpp"

namespace bindings {

using splinecore::EvaluateOptions;
using splinecore::InvalidShape;
using splinecore::NurbsCurve;

namespace {

/// Parameters of a part of a long call: as many as take some hundredths of a second.
std::size_t part_size(const NurbsCurve& curve) {
  return (std::size_t{1} << 22) / static_cast<std::size_t>(std::max(64, curve.degree() + 1));
}

EvaluateOptions options_of(const py::object& side, const py::object& at_infinity) {
  return {side_of(side, "side"), at_infinity_of(at_infinity)};
}

/// in_parts() over parameters; one that is refused is named by its place among all of them.
template <class Work>
void in_parts_of(const Doubles& parameters, const NurbsCurve& curve, const EvaluateOptions& options,
                 const py::object& cancel, Work work) {
  try {
    in_parts(parameters.size(), part_size(curve), cancel, work);
  } catch (const InvalidShape&) {
    require_inside(curve.knot_vector(), parameters, options.side, "u");
    throw;
  }
}

}  // namespace

py::array evaluate(const NurbsCurve& curve, const py::object& u, const py::object& side,
                   const py::object& at_infinity, const py::object& dtype, const py::object& out,
                   const py::object& cancel) {
  const Doubles at = apart_from(real_array(u, "u"), out);
  Shape shape(at.shape(), at.shape() + at.ndim());
  shape.push_back(3);
  const Output output(shape, out, dtype);
  const EvaluateOptions options = options_of(side, at_infinity);
  in_parts_of(at, curve, options, cancel, [&](std::size_t begin, std::size_t end) {
    const std::span parameters(at.data() + begin, end - begin);
    if (output.single()) {
      splinecore::evaluate(curve, parameters, output.floats(3 * begin, 3 * (end - begin)), options);
    } else {
      splinecore::evaluate(curve, parameters, output.doubles(3 * begin, 3 * (end - begin)), options);
    }
  });
  return output.array();
}

py::array derivatives(const NurbsCurve& curve, const py::object& u, const py::object& order,
                      const py::object& side, const py::object& at_infinity, const py::object& cancel) {
  const Doubles at = real_array(u, "u");
  const int highest = integer(order, "order");
  splinecore::require_order(highest);
  Shape shape(at.shape(), at.shape() + at.ndim());
  shape.push_back(highest + 1);
  shape.push_back(3);
  const Output output(shape, py::none(), py::none());
  const EvaluateOptions options = options_of(side, at_infinity);
  const std::size_t row = 3 * (highest + 1);
  in_parts_of(at, curve, options, cancel, [&](std::size_t begin, std::size_t end) {
    splinecore::derivatives(curve, {at.data() + begin, end - begin}, highest,
                            output.doubles(row * begin, row * (end - begin)), options);
  });
  return output.array();
}

py::list polylines(const NurbsCurve& curve, const py::object& resolution, const py::object& reach,
                   const py::object& around) {
  py::list lines;
  const int steps = integer(resolution, "resolution");
  const std::optional<double> most = optional_real(reach, "reach");
  const auto places = around.is_none() ? std::vector<glm::dvec3>{} : vectors(real_array(around, "around"), "around", 1);
  for (const auto& line : unlocked([&] { return splinecore::polylines(curve, steps, most, places); })) {
    py::array_t<double> points({static_cast<py::ssize_t>(line.points.size() / 3), py::ssize_t{3}});
    std::ranges::copy(line.points, points.mutable_data());
    lines.append(py::make_tuple(points, line.closed));
  }
  return lines;
}

py::list finite_pieces(const NurbsCurve& curve) {
  py::list intervals;
  for (const auto& piece : unlocked([&] { return splinecore::pieces(curve); })) intervals.append(pair_of(piece));
  return intervals;
}

}  // namespace bindings
