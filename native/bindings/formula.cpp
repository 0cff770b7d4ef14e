
#include "classes.hpp"
#include "formulas.hpp"
#include "long_calls.hpp"
#include "output.hpp"
#include "rooms.hpp"
#include "splinecore/base/order.hpp"
#include "splinecore/basis/bernstein.hpp"
#include "splinecore/formula/evaluate.hpp"
#include "splinecore/formula/formula.hpp"
#include "splinecore/formula/polynomial.hpp"
#include "splinecore/formula/taylor.hpp"
#include "values.hpp"

namespace bindings {

using splinecore::AtUndefined;
using splinecore::Formula;
using splinecore::FormulaError;
using splinecore::InvalidShape;

namespace {

constexpr std::size_t kPart = 1 << 16;

AtUndefined at_undefined_of(const py::handle& value) {
  if (py::isinstance<py::str>(value)) {
    const std::string text = py::str(value);
    if (text == "raise") return AtUndefined::raise;
    if (text == "nan") return AtUndefined::nan;
  }
  throw InvalidShape("at_undefined = " + std::string(py::repr(value)) + " is neither 'raise' nor 'nan'");
}

[[noreturn]] void refuse_type(const py::handle& value, const std::string& name, const std::string& wanted) {
  throw py::type_error(name + " must be " + wanted + ", not " + type_name(value));
}

bool is_list(const py::handle& value) {
  return PySequence_Check(value.ptr()) != 0 && !py::isinstance<py::str>(value) && !py::isinstance<py::bytes>(value);
}

/// The values of all variables, broadcast against each other.
class Rows {
 public:
  Rows(const Formula& formula, const py::args& values) {
    if (values.size() != formula.variables().size()) {
      throw py::type_error("the formula takes " + std::to_string(formula.variables().size()) + " values, " +
                           std::to_string(values.size()) + " are given");
    }
    py::list given;
    for (std::size_t i = 0; i < values.size(); ++i) {
      given.append(real_array(values[i], formula.variables()[i].c_str()));
    }
    py::list together;
    try {
      together = py::module_::import("numpy").attr("broadcast_arrays")(*given);
    } catch (py::error_already_set& error) {
      if (!error.matches(PyExc_ValueError)) throw;
      std::string shapes;
      for (const py::handle& array : given) shapes += " " + shape_text(py::reinterpret_borrow<py::array>(array));
      throw InvalidShape("values of shapes" + shapes + " do not broadcast");
    }
    for (const py::handle& array : together) columns_.emplace_back(py::reinterpret_borrow<py::object>(array));
  }

  Shape shape() const { return {columns_[0].shape(), columns_[0].shape() + columns_[0].ndim()}; }
  std::size_t size() const { return columns_[0].size(); }

  std::vector<std::span<const double>> part(std::size_t begin, std::size_t end) const {
    std::vector<std::span<const double>> spans;
    for (const Doubles& column : columns_) spans.emplace_back(column.data() + begin, end - begin);
    return spans;
  }

 private:
  std::vector<Doubles> columns_;
};

py::array evaluate(const Formula& formula, const py::args& values, const py::object& at_undefined) {
  const Rows rows(formula, values);
  const AtUndefined otherwise = at_undefined_of(at_undefined);
  const Output output(rows.shape(), py::none(), py::none());
  in_parts(rows.size(), kPart, [&](std::size_t begin, std::size_t end) {
    splinecore::evaluate(formula, rows.part(begin, end), output.doubles(begin, end - begin), otherwise);
  });
  return output.array();
}

py::array gradient(const Formula& formula, const py::args& values, const py::object& at_undefined) {
  const Rows rows(formula, values);
  const AtUndefined otherwise = at_undefined_of(at_undefined);
  const std::size_t width = formula.variables().size();
  Shape shape = rows.shape();
  shape.push_back(static_cast<py::ssize_t>(width));
  const Output output(shape, py::none(), py::none());
  in_parts(rows.size(), kPart, [&](std::size_t begin, std::size_t end) {
    const std::span<double> out = output.doubles(width * begin, width * (end - begin));
    splinecore::gradients(formula, rows.part(begin, end), out, otherwise);
  });
  return output.array();
}

py::array derivatives(const Formula& formula, const py::object& t, const py::object& order,
                      const py::object& at_undefined) {
  const Doubles at = real_array(t, "t");
  const int highest = integer(order, "order");
  splinecore::require_order(highest);
  const AtUndefined otherwise = at_undefined_of(at_undefined);
  Shape shape(at.shape(), at.shape() + at.ndim());
  shape.push_back(highest + 1);
  const Output output(shape, py::none(), py::none());
  const std::size_t row = highest + 1;
  in_parts(at.size(), kPart, [&](std::size_t begin, std::size_t end) {
    splinecore::derivatives(formula, {at.data() + begin, end - begin}, highest,
                            output.doubles(row * begin, row * (end - begin)), otherwise);
  });
  return output.array();
}

py::object polynomial(const Formula& formula) {
  const auto coefficients = unlocked([&] { return splinecore::polynomial(formula, splinecore::kMaxDegree); });
  if (!coefficients) return py::none();
  return new_numbers(std::span(*coefficients));
}

py::tuple names_tuple(const Formula& formula) { return py::tuple(py::cast(formula.variables())); }

py::tuple parts_of(const Formula& formula) {
  return py::make_tuple(formula.text(), names_tuple(formula), py::cast(formula.constants()));
}

std::string shown(const Formula& formula) {
  std::string text = "Formula(" + std::string(py::repr(py::str(formula.text())));
  const bool is_plain = formula.variables() == std::vector<std::string>{"t"};
  if (!is_plain) text += ", variables=" + std::string(py::repr(names_tuple(formula)));
  if (!formula.constants().empty()) text += ", constants=" + std::string(py::repr(py::cast(formula.constants())));
  return text + ")";
}

Formula formula_of(const py::object& text, const py::object& variables, const py::object& constants) {
  return Formula::make(text_argument(text, "text"), names_of(variables, "variables"), constants_of(constants));
}

py::handle formula_error;

void bind_error(py::module_& module) {
  formula_error = py::exception<FormulaError>(module, "FormulaError", module.attr("InvalidShape")).release();
  py::register_local_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const FormulaError& error) {
      const py::object raised = formula_error(error.what());
      raised.attr("position") = error.position();
      PyErr_SetObject(formula_error.ptr(), raised.ptr());
    }
  });
}

}  // namespace

std::string text_argument(const py::handle& value, const char* name) {
  if (!py::isinstance<py::str>(value)) refuse_type(value, name, "a str");
  // A lone surrogate has no UTF-8; as \ud800 it is refused where it stands.
  return py::bytes(value.attr("encode")("utf-8", "backslashreplace"));
}

std::vector<std::string> names_of(const py::object& value, const char* name) {
  if (!is_list(value)) refuse_type(value, name, "a sequence of str");
  std::vector<std::string> names;
  for (const py::handle& one : value) {
    const std::string place = name + splinecore::index_text(names.size());
    names.push_back(text_argument(one, place.c_str()));
  }
  return names;
}

Formula::Constants constants_of(const py::object& value) {
  Formula::Constants constants;
  if (value.is_none()) return constants;
  if (!py::isinstance<py::dict>(value)) refuse_type(value, "constants", "a dict of names and numbers");
  for (const auto& [key, number] : py::reinterpret_borrow<py::dict>(value)) {
    const std::string name = text_argument(key, "a name in constants");
    constants[name] = real(number, ("constants[" + splinecore::quoted(name) + "]").c_str());
  }
  return constants;
}

std::vector<Formula> formulas_of(const py::object& value, const std::vector<std::string>& variables,
                                 const py::object& constants) {
  if (!is_list(value)) refuse_type(value, "formulas", "a sequence of str or Formula");
  const Formula::Constants numbers = constants_of(constants);
  std::vector<Formula> formulas;
  for (const py::handle& one : value) {
    if (py::isinstance<Formula>(one)) {
      formulas.push_back(py::cast<const Formula&>(one));
      continue;
    }
    const std::string name = "formulas" + splinecore::index_text(formulas.size());
    if (!py::isinstance<py::str>(one)) refuse_type(one, name, "a str or a Formula");
    try {
      formulas.push_back(Formula::make(text_argument(one, name.c_str()), variables, numbers));
    } catch (const FormulaError& error) {
      throw FormulaError(name + ": " + error.reason(), error.position());
    }
  }
  return formulas;
}

void bind_formula(py::module_& module) {
  bind_error(module);
  Class<Formula> cls(
      module, "Formula", py::module_local());
  seal(cls);
  cls.def(py::init(&formula_of), py::arg("text"), py::arg("variables") = py::make_tuple("t"),
          py::arg("constants") = py::none());
  cls.def_property_readonly("text", &Formula::text);
  cls.def_property_readonly("variables", &names_tuple);
  cls.def_property_readonly("constants", [](const Formula& self) { return self.constants(); });
  cls.def("evaluate", &evaluate, py::kw_only(), py::arg("at_undefined") = "raise");
  cls.def("derivatives", &derivatives, py::arg("t"), py::arg("order"), py::kw_only(), py::arg("at_undefined") = "raise");
  cls.def("gradient", &gradient, py::kw_only(), py::arg("at_undefined") = "raise");
  cls.def("polynomial", &polynomial);
  cls.def("__eq__", [](const Formula& self, const Formula& other) { return self == other; }, py::is_operator());
  cls.def("__hash__", [](const Formula& self) {
    const py::tuple constants(py::cast(self.constants()).attr("items")());
    return py::hash(py::make_tuple(self.text(), names_tuple(self), constants));
  });
  cls.def(py::pickle([](const Formula& self) -> py::object { return parts_of(self); }, [](const py::object& state) {
    const py::tuple parts = state_of_size(state, 3);
    return formula_of(parts[0], parts[1], parts[2]);
  }));
  cls.def("__repr__", &shown);
}

}  // namespace bindings
