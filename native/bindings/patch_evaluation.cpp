#include "patch_evaluation.hpp"

#include "long_calls.hpp"
#include "output.hpp"
#include "splinecore/base/order.hpp"
#include "splinecore/patch/evaluate.hpp"
#include "splinecore/patch/evaluate_set.hpp"

namespace bindings {

using splinecore::Axis;
using splinecore::InvalidShape;
using splinecore::NurbsPatch;
using splinecore::PatchOptions;
using splinecore::PatchSet;

namespace {

/// One side for both directions, or a pair.
PatchOptions options_of(const py::object& side, const py::object& at_infinity, const py::object& threads) {
  const bool is_pair = py::isinstance<py::tuple>(side) && py::len(side) == 2;
  const py::object side_u = is_pair ? py::object(side[py::int_(0)]) : side;
  const py::object side_v = is_pair ? py::object(side[py::int_(1)]) : side;
  return {side_of(side_u, "side"), side_of(side_v, "side"), at_infinity_of(at_infinity), threads_of(threads)};
}

/// u and v broadcast against each other.
struct Pairs {
  Doubles given_u;
  Doubles given_v;
  Doubles u;
  Doubles v;
  Shape shape;

  Pairs(const py::object& at_u, const py::object& at_v, const py::object& out)
      : given_u(apart_from(real_array(at_u, "u"), out)), given_v(apart_from(real_array(at_v, "v"), out)) {
    py::list both;
    try {
      both = py::module_::import("numpy").attr("broadcast_arrays")(given_u, given_v);
    } catch (py::error_already_set& error) {
      if (!error.matches(PyExc_ValueError)) throw;
      throw InvalidShape("u of shape " + shape_text(given_u) + " and v of shape " + shape_text(given_v) +
                         " do not broadcast");
    }
    u = Doubles(both[0]);
    v = Doubles(both[1]);
    shape.assign(u.shape(), u.shape() + u.ndim());
  }
  std::span<const double> us() const { return {u.data(), static_cast<std::size_t>(u.size())}; }
  std::span<const double> vs() const { return {v.data(), static_cast<std::size_t>(v.size())}; }
};

/// work() without the interpreter's lock. The parameter of a patch that is refused is named by its place.
template <class Work>
void unlocked_at(const PatchSet&, const Doubles&, const Doubles&, const PatchOptions&, const py::object& cancel,
                 Work work) {
  unlocked(work, cancel);
  heed(cancel);
}

template <class Work>
void unlocked_at(const NurbsPatch& patch, const Doubles& u, const Doubles& v, const PatchOptions& options,
                 const py::object& cancel, Work work) {
  try {
    unlocked(work, cancel);
  } catch (const InvalidShape&) {
    require_inside(patch.knot_vector(Axis::u), u, options.side_u, "u");
    require_inside(patch.knot_vector(Axis::v), v, options.side_v, "v");
    throw;
  }
  heed(cancel);
}

Doubles axis_parameters(const py::object& value, const char* name) {
  const Doubles array = real_array(value, name);
  if (array.ndim() == 1) return array;
  throw InvalidShape(std::string(name) + " has shape " + shape_text(array) + ", (n,) is expected");
}

/// Where points and normals go: None, or a pair of arrays.
std::pair<py::object, py::object> outputs_of(const py::object& out) {
  if (out.is_none()) return {py::none(), py::none()};
  return pair_argument(out, "out", "an array for points, one for normals");
}

Shape shape_of(const NurbsPatch&, const Doubles& u, const Doubles& v) { return {u.size(), v.size(), 3}; }

Shape shape_of(const PatchSet& set, const Doubles& u, const Doubles& v) {
  return {static_cast<py::ssize_t>(set.patches().size()), u.size(), v.size(), 3};
}

std::span<const double> span_of(const Doubles& array) { return {array.data(), static_cast<std::size_t>(array.size())}; }

void require_two_outputs(const Output& points, const Output& normals) {
  const bool are_one = py::module_::import("numpy").attr("may_share_memory")(points.array(), normals.array()).cast<bool>();
  if (are_one && points.array().size() > 0) throw InvalidShape("out: points and normals share memory");
  if (points.single() != normals.single()) throw py::type_error("out: points and normals have not one dtype");
}

/// evaluate_grid() of a patch or of a set.
template <class Value>
py::array grid(const Value& value, const py::object& at_u, const py::object& at_v, const py::object& side,
               const py::object& at_infinity, const py::object& dtype, const py::object& out, const py::object& threads,
               const py::object& cancel) {
  const Doubles u = apart_from(axis_parameters(at_u, "u"), out);
  const Doubles v = apart_from(axis_parameters(at_v, "v"), out);
  const Output output(shape_of(value, u, v), out, dtype);
  const PatchOptions options = options_of(side, at_infinity, threads);
  const auto count = static_cast<std::size_t>(output.array().size());
  unlocked_at(value, u, v, options, cancel, [&] {
    if (output.single()) {
      splinecore::evaluate_grid(value, span_of(u), span_of(v), output.floats(0, count), options);
    } else {
      splinecore::evaluate_grid(value, span_of(u), span_of(v), output.doubles(0, count), options);
    }
  });
  return output.array();
}

template <class Value>
py::tuple grid_with_normals(const Value& value, const py::object& at_u, const py::object& at_v, const py::object& side,
                            const py::object& at_infinity, const py::object& dtype, const py::object& out,
                            const py::object& threads, const py::object& cancel) {
  const auto [to_points, to_normals] = outputs_of(out);
  const Doubles u = apart_from(apart_from(axis_parameters(at_u, "u"), to_points), to_normals);
  const Doubles v = apart_from(apart_from(axis_parameters(at_v, "v"), to_points), to_normals);
  const Shape shape = shape_of(value, u, v);
  const Output points(shape, to_points, dtype);
  const Output normals(shape, to_normals, dtype);
  require_two_outputs(points, normals);
  const PatchOptions options = options_of(side, at_infinity, threads);
  const auto count = static_cast<std::size_t>(points.array().size());
  unlocked_at(value, u, v, options, cancel, [&] {
    if (points.single()) {
      splinecore::evaluate_grid_with_normals(value, span_of(u), span_of(v), points.floats(0, count),
                                             normals.floats(0, count), options);
    } else {
      splinecore::evaluate_grid_with_normals(value, span_of(u), span_of(v), points.doubles(0, count),
                                             normals.doubles(0, count), options);
    }
  });
  return py::make_tuple(points.array(), normals.array());
}

}  // namespace

py::array evaluate(const NurbsPatch& patch, const py::object& u, const py::object& v, const py::object& side,
                   const py::object& at_infinity, const py::object& dtype, const py::object& out,
                   const py::object& threads, const py::object& cancel) {
  const Pairs pairs(u, v, out);
  Shape shape = pairs.shape;
  shape.push_back(3);
  const Output output(shape, out, dtype);
  const PatchOptions options = options_of(side, at_infinity, threads);
  const std::size_t count = 3 * pairs.us().size();
  unlocked_at(patch, pairs.given_u, pairs.given_v, options, cancel, [&] {
    if (output.single()) {
      splinecore::evaluate(patch, pairs.us(), pairs.vs(), output.floats(0, count), options);
    } else {
      splinecore::evaluate(patch, pairs.us(), pairs.vs(), output.doubles(0, count), options);
    }
  });
  return output.array();
}

py::array derivatives(const NurbsPatch& patch, const py::object& u, const py::object& v, const py::object& order,
                      const py::object& side, const py::object& at_infinity, const py::object& out,
                      const py::object& threads, const py::object& cancel) {
  const Pairs pairs(u, v, out);
  const int highest = integer(order, "order");
  splinecore::require_order(highest);
  Shape shape = pairs.shape;
  shape.insert(shape.end(), {highest + 1, highest + 1, 3});
  const Output output(shape, out);
  const PatchOptions options = options_of(side, at_infinity, threads);
  const std::size_t width = static_cast<std::size_t>(highest) + 1;
  unlocked_at(patch, pairs.given_u, pairs.given_v, options, cancel, [&] {
    splinecore::derivatives(patch, pairs.us(), pairs.vs(), highest,
                            output.doubles(0, 3 * width * width * pairs.us().size()), options);
  });
  return output.array();
}

py::array first_derivatives(const NurbsPatch& patch, const py::object& u, const py::object& v, const py::object& side,
                            const py::object& at_infinity, const py::object& out, const py::object& threads,
                            const py::object& cancel) {
  const Pairs pairs(u, v, out);
  Shape shape = pairs.shape;
  shape.insert(shape.end(), {3, 3});
  const Output output(shape, out);
  const PatchOptions options = options_of(side, at_infinity, threads);
  unlocked_at(patch, pairs.given_u, pairs.given_v, options, cancel, [&] {
    splinecore::first_derivatives(patch, pairs.us(), pairs.vs(), output.doubles(0, 9 * pairs.us().size()), options);
  });
  return output.array();
}

py::array evaluate_grid(const NurbsPatch& patch, const py::object& u, const py::object& v, const py::object& side,
                        const py::object& at_infinity, const py::object& dtype, const py::object& out,
                        const py::object& threads, const py::object& cancel) {
  return grid(patch, u, v, side, at_infinity, dtype, out, threads, cancel);
}

py::tuple evaluate_grid_with_normals(const NurbsPatch& patch, const py::object& u, const py::object& v,
                                     const py::object& side, const py::object& at_infinity, const py::object& dtype,
                                     const py::object& out, const py::object& threads, const py::object& cancel) {
  return grid_with_normals(patch, u, v, side, at_infinity, dtype, out, threads, cancel);
}

py::array evaluate_grid(const PatchSet& set, const py::object& u, const py::object& v, const py::object& side,
                        const py::object& at_infinity, const py::object& dtype, const py::object& out,
                        const py::object& threads, const py::object& cancel) {
  return grid(set, u, v, side, at_infinity, dtype, out, threads, cancel);
}

py::tuple evaluate_grid_with_normals(const PatchSet& set, const py::object& u, const py::object& v,
                                     const py::object& side, const py::object& at_infinity, const py::object& dtype,
                                     const py::object& out, const py::object& threads, const py::object& cancel) {
  return grid_with_normals(set, u, v, side, at_infinity, dtype, out, threads, cancel);
}

}  // namespace bindings
