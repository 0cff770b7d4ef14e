#include "joints.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "arrays.hpp"
#include "classes.hpp"
#include "join_arguments.hpp"
#include "long_calls.hpp"
#include "point_arguments.hpp"
#include "splinecore/build/joint_equations.hpp"
#include "splinecore/build/joint_points.hpp"
#include "splinecore/build/least_motion.hpp"

namespace bindings {

using splinecore::ColumnFactors;
using splinecore::EdgeStrip;
using splinecore::InvalidShape;
using splinecore::JointPoints;
using splinecore::JointSide;
using splinecore::MotionEquations;

namespace {

std::vector<bool> moved_of(const py::object& value, const char* name) {
  std::vector<bool> moved;
  if (value.is_none()) return moved;
  if (!py::isinstance<py::list>(value) && !py::isinstance<py::tuple>(value)) {
    throw py::type_error(std::string(name) + " must be a list of bool, not " + type_name(value));
  }
  for (const py::handle& item : value) moved.push_back(boolean(item, name));
  return moved;
}

JointSide side_of_joint(const py::object& points, const char* points_name, const py::object& degree, const char* degree_name,
                        const py::object& spans, const char* spans_name, const py::object& moved, const char* moved_name) {
  const auto [first, second] = numbers_in<2>(spans, spans_name);
  return {rows_of_four(real_array(points, points_name), points_name, 1), integer(degree, degree_name), first, second,
          moved_of(moved, moved_name)};
}

py::array_t<double> rows_array(const std::vector<glm::dvec4>& rows) {
  py::array_t<double> out(Shape{static_cast<py::ssize_t>(rows.size()), 4});
  std::copy_n(&rows.front().x, 4 * rows.size(), out.mutable_data());
  return out;
}

py::tuple joint_points(const py::object& first, const py::object& first_degree, const py::object& first_spans,
                       const py::object& second, const py::object& second_degree, const py::object& second_spans,
                       const py::object& continuity, const py::object& moves, const py::object& first_moved,
                       const py::object& second_moved) {
  const JointSide before =
      side_of_joint(first, "first", first_degree, "first_degree", first_spans, "first_spans", first_moved, "first_moved");
  const JointSide after = side_of_joint(second, "second", second_degree, "second_degree", second_spans, "second_spans",
                                        second_moved, "second_moved");
  const JointPoints made = splinecore::joint_points(before, after, smoothness_of(continuity), moves_of(moves));
  return py::make_tuple(rows_array(made.first), rows_array(made.second));
}

EdgeStrip strip_of(const py::object& points, const char* name, const py::object& degree, const char* degree_name,
                   const py::object& spans, const char* spans_name) {
  const Doubles array = real_array(points, name);
  const std::vector<glm::dvec4> all = rows_of_four(array, name, 2);
  if (array.shape(0) != 3) throw InvalidShape(std::string(name) + " has shape " + shape_text(array) + ", 3 rows of points are expected");
  EdgeStrip strip;
  strip.degree = integer(degree, degree_name);
  const auto [first, second] = numbers_in<2>(spans, spans_name);
  strip.first_span = first;
  strip.second_span = second;
  const auto columns = static_cast<std::ptrdiff_t>(array.shape(1));
  for (std::ptrdiff_t i = 0; i < 3; ++i) strip.rows[i].assign(all.begin() + i * columns, all.begin() + (i + 1) * columns);
  return strip;
}

py::object joint_equations(const py::object& first, const py::object& first_degree, const py::object& first_spans,
                           const py::object& second, const py::object& second_degree, const py::object& second_spans,
                           const py::object& continuity) {
  const EdgeStrip before = strip_of(first, "first", first_degree, "first_degree", first_spans, "first_spans");
  const EdgeStrip after = strip_of(second, "second", second_degree, "second_degree", second_spans, "second_spans");
  const auto equations = splinecore::joint_equations(before, after, smoothness_of(continuity));
  if (!equations) return py::none();
  py::array_t<double> out(Shape{static_cast<py::ssize_t>(equations->size()), static_cast<py::ssize_t>(before.rows[0].size()), 6});
  double* entry = out.mutable_data();
  for (const std::vector<ColumnFactors>& order : *equations) {
    for (const ColumnFactors& factors : order) entry = std::ranges::copy(factors, entry).out;
  }
  return out;
}

/// (n, k): the numbers of points.
std::vector<int> numbers_of_points(const py::array& array) {
  if (array.dtype().kind() != 'i' && array.dtype().kind() != 'u') {
    throw py::type_error("the numbers of points in equations must be integers, not " + std::string(py::str(array.dtype())));
  }
  const py::array_t<long long, py::array::c_style | py::array::forcecast> given(array);
  std::vector<int> points;
  for (py::ssize_t i = 0; i < given.size(); ++i) {
    const long long one = given.data()[i];
    if (one < 0 || one > std::numeric_limits<int>::max()) throw InvalidShape("there is no point " + std::to_string(one));
    points.push_back(static_cast<int>(one));
  }
  return points;
}

MotionEquations motion_equations(const py::object& value) {
  const auto [first, second] = pair_argument(value, "equations", "the numbers of points and their factors");
  const py::array points = array_of(first, "equations");
  const Doubles factors = real_array(second, "equations");
  if (points.ndim() != 2 || factors.ndim() != 3 || factors.shape(1) != points.shape(0) || factors.shape(2) != points.shape(1)) {
    throw InvalidShape("equations have points of shape " + shape_text(points) + " and factors of shape " + shape_text(factors) +
                       ": (n, k) and (orders, n, k) are expected");
  }
  MotionEquations made{static_cast<std::size_t>(points.shape(1)), numbers_of_points(points), {}};
  const auto size = static_cast<std::ptrdiff_t>(points.size());
  for (std::ptrdiff_t i = 0; i < factors.shape(0); ++i) made.factors.emplace_back(factors.data() + i * size, factors.data() + (i + 1) * size);
  return made;
}

std::vector<bool> free_of(const py::object& value) {
  const py::array array = array_of(value, "free");
  if (array.ndim() != 1 || array.dtype().kind() != 'b') {
    throw py::type_error("free must be a row of bool, not " + std::string(py::str(array.dtype())) + " of shape " + shape_text(array));
  }
  const py::array_t<bool, py::array::c_style | py::array::forcecast> given(array);
  return std::vector<bool>(given.data(), given.data() + given.size());
}

py::object least_motion(const py::object& equations, const py::object& moved, const py::object& free, const py::object& cancel) {
  std::vector<MotionEquations> given;
  for (const py::handle& one : py::iter(equations)) given.push_back(motion_equations(py::reinterpret_borrow<py::object>(one)));
  const GivenPoints already(moved, "moved", 1);
  const std::vector<bool> is_free = free_of(free);
  const auto motion = unlocked([&] { return splinecore::least_motion(given, already.points(), is_free); }, cancel);
  if (!motion) return py::none();
  py::array_t<double> out(Shape{static_cast<py::ssize_t>(motion->size()), 3});
  if (!motion->empty()) std::copy_n(&motion->front().x, 3 * motion->size(), out.mutable_data());
  return out;
}

}  // namespace

void bind_joints(py::module_& build) {
  build.def("joint_points", &joint_points, py::arg("first"), py::arg("first_degree"), py::arg("first_spans"), py::arg("second"),
            py::arg("second_degree"), py::arg("second_spans"), py::arg("continuity") = "G1", py::arg("moves") = "second",
            py::kw_only(), py::arg("first_moved") = py::none(), py::arg("second_moved") = py::none());
  build.def("joint_equations", &joint_equations, py::arg("first"), py::arg("first_degree"), py::arg("first_spans"), py::arg("second"),
            py::arg("second_degree"), py::arg("second_spans"), py::arg("continuity") = "G1");
  build.def("least_motion", &least_motion, py::arg("equations"), py::arg("moved"), py::arg("free"), py::kw_only(),
            py::arg("cancel") = py::none());
}

}  // namespace bindings
