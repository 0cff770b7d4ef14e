#include <cmath>

#include "arrays.hpp"
#include "basis_matrices.hpp"
#include "classes.hpp"
#include "long_calls.hpp"
#include "rooms.hpp"
#include "splinecore/base/order.hpp"
#include "splinecore/basis/functions.hpp"
#include "splinecore/basis/greville.hpp"
#include "splinecore/basis/knot_vector.hpp"
#include "splinecore/basis/samples.hpp"
#include "values.hpp"
#include "views.hpp"

namespace bindings {

using splinecore::KnotVector;
using splinecore::Samples;
using splinecore::Side;

namespace {

/// Values of all functions: (..., count).
py::array functions_at(const KnotVector& knots, const py::object& u, const py::object& side) {
  const Doubles at = real_array(u, "u");
  Shape shape(at.shape(), at.shape() + at.ndim());
  shape.push_back(knots.count());
  py::array_t<double> out(shape);
  const Side which = side_of(side, "side");
  require_inside(knots, at, which, "u");
  double* const values = out.mutable_data();
  unlocked([&] {
    std::fill_n(values, out.size(), 0.0);
    double* row = values;
    splinecore::Stencil stencil(knots, 0);
    for (std::size_t i = 0; i < static_cast<std::size_t>(at.size()); ++i, row += knots.count()) {
      stencil.move_to(knots.admit(at.data()[i], which, i), which);
      for (int j = 0; j <= knots.degree(); ++j) row[(stencil.first() + j) % knots.count()] += stencil.weights(0)[j];
    }
  });
  return out;
}

void require_finite(const Doubles& values, const char* name) {
  for (py::ssize_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values.data()[i])) continue;
    throw splinecore::InvalidShape(name + place_text(values, i) + " = " + splinecore::text_of(values.data()[i]) +
                                   " is not finite");
  }
}

py::array function_at(const KnotVector& knots, const py::object& i, const py::object& u) {
  const Doubles at = real_array(u, "u");
  const int function = integer(i, "i");
  py::array_t<double> out(Shape(at.shape(), at.shape() + at.ndim()));
  require_finite(at, "u");
  double* const values = out.mutable_data();
  unlocked([&] {
    for (py::ssize_t k = 0; k < at.size(); ++k) values[k] = splinecore::function_value(knots, function, at.data()[k]);
  });
  return out;
}

py::array function_derivatives_at(const KnotVector& knots, const py::object& i, const py::object& u,
                                  const py::object& order) {
  const Doubles at = real_array(u, "u");
  const int function = integer(i, "i");
  const int highest = integer(order, "order");
  splinecore::require_order(highest);
  require_finite(at, "u");
  Shape shape(at.shape(), at.shape() + at.ndim());
  shape.push_back(highest + 1);
  py::array_t<double> out(shape);
  const std::size_t width = highest + 1;
  double* const rows = out.mutable_data();
  unlocked([&] {
    for (py::ssize_t k = 0; k < at.size(); ++k) {
      splinecore::function_derivatives(knots, function, at.data()[k], {rows + k * width, width});
    }
  });
  return out;
}

/// [(indices, values, rising, falling), …] of the functions' numbers, folded where periodic.
py::list triangle_at(const KnotVector& knots, const py::object& u) {
  py::list rows;
  const double at = real(u, "u");
  for (const splinecore::TriangleRow& row : unlocked([&] { return splinecore::function_triangle(knots, at); })) {
    auto indices = new_numbers<std::int64_t>(row.values.size());
    for (py::ssize_t j = 0; j < indices.size(); ++j) {
      indices.mutable_data()[j] = knots.periodic() ? (row.first + j) % knots.count() : row.first + j;
    }
    const auto array = [](const std::vector<double>& values) { return new_numbers(std::span(values)); };
    rows.append(py::make_tuple(indices, array(row.values), array(row.rising), array(row.falling)));
  }
  return rows;
}

py::array span_at(const KnotVector& knots, const py::object& u, const py::object& side) {
  const Doubles at = real_array(u, "u");
  const Side which = side_of(side, "side");
  require_inside(knots, at, which, "u");
  py::array_t<std::int64_t> out(Shape(at.shape(), at.shape() + at.ndim()));
  for (py::ssize_t k = 0; k < at.size(); ++k) {
    const double admitted = knots.admit(at.data()[k], which, k);
    out.mutable_data()[k] = knots.spans()[knots.span_of(admitted, which)];
  }
  return out;
}

void require_sampled(const Samples& samples, int order) {
  if (order >= 0 && order <= samples.order()) return;
  throw splinecore::InvalidShape("order = " + std::to_string(order) + " is outside [0, " +
                                 std::to_string(samples.order()) + "]");
}

py::array sample_weights(const Samples& samples, int order, std::size_t width) {
  require_sampled(samples, order);
  py::array_t<double> out({samples.size(), width});
  for (std::size_t i = 0; i < samples.size(); ++i) {
    std::ranges::copy(samples.weights(i, order), out.mutable_data() + i * width);
  }
  return out;
}

/// Applies weights to any rows of numbers, by the distinct control points they belong to.
py::array apply_samples(const Samples& samples, int count, const py::object& values, int order) {
  const Doubles rows = real_array(values, "values");
  if (rows.ndim() < 1 || rows.shape(0) != count) {
    throw splinecore::InvalidShape("values has shape " + shape_text(rows) + ", " + std::to_string(count) +
                                   " rows are expected");
  }
  require_sampled(samples, order);
  Shape shape(rows.shape(), rows.shape() + rows.ndim());
  shape[0] = static_cast<py::ssize_t>(samples.size());
  py::array_t<double> out(shape);
  const std::size_t width = rows.size() / count;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    double* row = out.mutable_data() + i * width;
    std::fill_n(row, width, 0.0);
    const auto weights = samples.weights(i, order);
    for (std::size_t j = 0; j < weights.size(); ++j) {
      const double* from = rows.data() + (samples.first(i) + j) % count * width;
      for (std::size_t k = 0; k < width; ++k) row[k] += weights[j] * from[k];
    }
  }
  return out;
}

/// Samples together with the count of distinct points, which folds periodic indices.
struct BoundSamples {
  KnotVector knots;
  Side side;
  Samples samples;

  static BoundSamples of(const KnotVector& knots, const std::vector<double>& at, int order, Side side) {
    splinecore::require_order(order);
    return {knots, side, unlocked([&] { return Samples::make(knots, at, order, side); })};
  }

  py::object state() const {
    std::vector<double> at(samples.size());
    for (std::size_t i = 0; i < at.size(); ++i) at[i] = samples.parameter(i);
    return py::make_tuple(knots, new_numbers(std::span<const double>(at)), samples.order(), side == Side::left);
  }
};

/// Numbers that nobody can write into, whatever is asked of the array: bytes hold them.
py::array frozen_numbers(const std::vector<double>& numbers) {
  const py::bytes held(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
  const auto* first = reinterpret_cast<const double*>(PyBytes_AS_STRING(held.ptr()));
  return view_of_numbers(std::span(first, numbers.size()), held);
}

}  // namespace

void bind_basis(py::module_& module) {
  py::module_ basis = module.def_submodule("basis", "Knot vectors, basis functions, samples.");
  Class<KnotVector> knot_vector(basis, "KnotVector", py::module_local());
  seal(knot_vector);
  knot_vector
      .def(py::init([](const py::object& degree, const py::object& knots, const py::object& periodic) {
             return KnotVector::make(integer(degree, "degree"), numbers(knots, "knots"), boolean(periodic, "periodic"));
           }),
           py::arg("degree"), py::arg("knots"), py::arg("periodic") = false)
      .def_property_readonly("degree", &KnotVector::degree)
      .def_property_readonly("periodic", &KnotVector::periodic)
      .def_property_readonly("count", &KnotVector::count)
      .def_property_readonly("knots", [](const py::object& self) {
        return view_of_numbers(py::cast<const KnotVector&>(self).knots(), self);
      })
      .def_property_readonly("domain", [](const KnotVector& self) { return pair_of(self.domain()); })
      .def_property_readonly("greville", [](const KnotVector& self) {
        return frozen_numbers(splinecore::greville_abscissae(self));
      })
      .def("span", &span_at, py::arg("u"), py::kw_only(), py::arg("side") = "right")
      .def("functions", &functions_at, py::arg("u"), py::kw_only(), py::arg("side") = "right")
      .def("function", &function_at, py::arg("i"), py::arg("u"))
      .def("support", [](const KnotVector& self, const py::object& i) {
             return pair_of(splinecore::function_support(self, integer(i, "i")));
           }, py::arg("i"))
      .def("function_derivatives", &function_derivatives_at, py::arg("i"), py::arg("u"), py::arg("order"))
      .def("triangle", &triangle_at, py::arg("u"))
      .def_property_readonly("spans", [](const py::object& self) {
        return view_of_numbers(py::cast<const KnotVector&>(self).spans(), self);
      })
      .def("multiplicity", [](const KnotVector& self, const py::object& u) {
             return splinecore::multiplicity(self, real(u, "u"));
           }, py::arg("u"))
      .def("__eq__", [](const KnotVector& self, const KnotVector& other) { return self == other; }, py::is_operator())
      .def("__hash__", [](const KnotVector& self) { return hash_of(self); })
      .def(py::pickle([](const KnotVector& self) -> py::object {
             return py::make_tuple(self.degree(), std::vector<double>(self.knots().begin(), self.knots().end()),
                                   self.periodic());
           },
           [](const py::object& state) {
             const py::tuple parts = state_of_size(state, 3);
             return KnotVector::make(integer(parts[0], "degree"), numbers(parts[1], "knots"),
                                     boolean(parts[2], "periodic"));
           }))
      .def("__repr__", [](const KnotVector& self) {
        return "KnotVector(degree=" + std::to_string(self.degree()) + ", " + std::to_string(self.knots().size()) +
               " knots" + (self.periodic() ? ", periodic)" : ")");
      });

  bind_matrices(basis);
  Class<BoundSamples> bound_samples(basis, "Samples", py::module_local());
  seal(bound_samples);
  bound_samples
      .def(py::pickle([](const BoundSamples& self) -> py::object { return self.state(); },
                      [](const py::object& state) {
                        const py::tuple parts = state_of_size(state, 4);
                        if (!py::isinstance<KnotVector>(parts[0])) throw py::type_error("the state has no knot vector");
                        return BoundSamples::of(py::cast<const KnotVector&>(parts[0]), numbers(parts[1], "u"),
                                                integer(parts[2], "order"),
                                                boolean(parts[3], "left") ? Side::left : Side::right);
                      }))
      .def(py::init([](const py::object& knots, const py::object& u, const py::object& order, const py::object& side) {
             if (!py::isinstance<KnotVector>(knots)) {
               throw py::type_error("knots must be a KnotVector, not " + type_name(knots));
             }
             const auto& vector = py::cast<const KnotVector&>(knots);
             const std::vector<double> at = numbers(u, "u");
             return BoundSamples::of(vector, at, integer(order, "order"), side_of(side, "side"));
           }),
           py::arg("knots"), py::arg("u"), py::arg("order") = 0, py::kw_only(), py::arg("side") = "right")
      .def("__len__", [](const BoundSamples& self) { return self.samples.size(); })
      .def_property_readonly("first", [](const BoundSamples& self) {
        auto out = new_numbers<std::int64_t>(self.samples.size());
        for (std::size_t i = 0; i < self.samples.size(); ++i) out.mutable_data()[i] = self.samples.first(i) % self.knots.count();
        return out;
      })
      .def("weights", [](const BoundSamples& self, const py::object& order) {
             return sample_weights(self.samples, integer(order, "order"), self.knots.degree() + 1);
           }, py::arg("order") = 0)
      .def("apply", [](const BoundSamples& self, const py::object& values, const py::object& order) {
             return apply_samples(self.samples, self.knots.count(), values, integer(order, "order"));
           }, py::arg("values"), py::arg("order") = 0)
      .def("__repr__", [](const BoundSamples& self) {
        return "Samples(count=" + std::to_string(self.samples.size()) + ", degree=" + std::to_string(self.knots.degree()) +
               ", order=" + std::to_string(self.samples.order()) + ")";
      });
}

}  // namespace bindings
