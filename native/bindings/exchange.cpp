#include "arrays.hpp"
#include "long_calls.hpp"
#include "mesh_files.hpp"
#include "rooms.hpp"
#include "splinecore/exchange/json.hpp"
#include "values.hpp"

namespace bindings {

namespace py = pybind11;
using splinecore::Document;
using splinecore::Value;

namespace {

Value value_of(const py::handle& object) {
  std::optional<Value> value;
  if (unwrap(object, value)) return *value;
  throw py::type_error("value must be a curve, a patch, a PatchSet, or a list of them, not " +
                       type_name(object));
}

/// The text of a str or of bytes, in UTF-8.
std::string utf8_of(const py::object& text) {
  if (!py::isinstance<py::str>(text) && !py::isinstance<py::bytes>(text)) {
    throw py::type_error("text must be a str, not " + type_name(text));
  }
  try {
    const bool is_text = py::isinstance<py::str>(text);
    return py::bytes(is_text ? text.attr("encode")() : text.attr("decode")().attr("encode")());
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_UnicodeError)) throw;
    throw splinecore::InvalidShape("text is not Unicode: " + std::string(py::str(error.value())));
  }
}

Document document_of(const py::object& object) {
  if (!py::isinstance<py::list>(object) && !py::isinstance<py::tuple>(object)) return value_of(object);
  std::vector<Value> items;
  for (const py::handle& item : py::cast<py::sequence>(object)) items.push_back(value_of(item));
  return items;
}

py::object object_of(const Document& document) {
  if (const auto* value = std::get_if<Value>(&document)) return wrap(*value);
  py::list items;
  for (const Value& item : std::get<std::vector<Value>>(document)) items.append(wrap(item));
  return items;
}

}  // namespace

void bind_exchange(py::module_& module) {
  module.def(
      "dumps", [](const py::object& value) {
        const Document document = document_of(value);
        return unlocked([&] { return splinecore::to_json(document); });
      },
      py::arg("value"));
  module.def(
      "loads",
      [](const py::object& text) {
        const std::string utf8 = utf8_of(text);
        return object_of(unlocked([&] { return splinecore::from_json(utf8); }));
      },
      py::arg("text"));
  bind_mesh_files(module);
}

}  // namespace bindings
