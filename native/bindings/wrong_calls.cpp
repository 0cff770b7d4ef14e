#include "wrong_calls.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "arrays.hpp"
#include "signatures.hpp"

namespace bindings {

namespace {

std::string given_text(std::size_t count) { return std::to_string(count) + (count == 1 ? " is" : " are") + " given"; }

/// What keeps a value from being an argument; nothing if it can be one.
std::string trouble_with(const Parameter& parameter, const py::handle& value) {
  if (parameter.kind.empty() || type_name(value) == parameter.kind) return "";
  return parameter.name + " must be a " + parameter.kind + ", not " + type_name(value);
}

/// The first thing that is wrong with a call. @param from  the first argument that is not self
std::string trouble_with(const Signature& signature, const py::args& given, std::size_t from, const py::kwargs& named) {
  const auto& parameters = signature.parameters;
  const auto places = static_cast<std::size_t>(std::ranges::count(parameters, false, &Parameter::is_by_name));
  if (given.size() < from) return "is missing self";
  const std::size_t count = given.size() - from;
  if (count > places && !signature.takes_more) {
    const char* arguments = places == 1 ? " argument by place, " : " arguments by place, ";
    return "takes " + std::to_string(places) + arguments + given_text(count);
  }
  for (const auto& [key, value] : named) {
    const std::string name = py::str(key);
    const bool is_known = std::ranges::find(parameters, name, &Parameter::name) != parameters.end();
    if (!is_known) return "has no argument '" + name + "'";
  }
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Parameter& parameter = parameters[i];
    const bool is_placed = i < std::min(count, places);
    const bool is_named = named.contains(parameter.name.c_str());
    if (is_placed && is_named) return "is given " + parameter.name + " twice";
    if (!is_placed && !is_named && parameter.preset.empty()) return "is missing " + parameter.name;
    if (!is_placed && !is_named) continue;
    const py::object value = is_placed ? py::object(given[from + i]) : py::object(named[parameter.name.c_str()]);
    const std::string trouble = trouble_with(parameter, value);
    if (!trouble.empty()) return "cannot be called: " + trouble;
  }
  return "cannot be called so";
}

[[noreturn]] void refuse(const Signature& signature, const py::args& given, std::size_t from, const py::kwargs& named) {
  throw py::type_error(signature.name + "() " + trouble_with(signature, given, from, named) + "; it takes " +
                       list_of(signature));
}

/// Arguments as they were spelled before version 0.1, and as they are now.
constexpr std::array<std::array<const char*, 2>, 3> kSpellings{
    {{"neighbour", "neighbor"}, {"centre", "center"}, {"parametrisation", "parameterization"}}};

std::string spelled_now(std::string name) {
  for (const auto& [before, now] : kSpellings) {
    const std::size_t at = name.find(before);
    if (at != std::string::npos) name.replace(at, std::strlen(before), now);
  }
  return name;
}

/// The arguments by name as they are spelled now; none where no name changes to one that the function has.
std::optional<py::dict> respelled(const Signature& signature, const py::kwargs& named) {
  py::dict arguments;
  bool has_changed = false;
  for (const auto& [key, value] : named) {
    const std::string name = py::str(key);
    const std::string now = spelled_now(name);
    const bool is_known = std::ranges::find(signature.parameters, now, &Parameter::name) != signature.parameters.end();
    has_changed = has_changed || (now != name && is_known && !named.contains(now.c_str()));
    arguments[py::str(now)] = value;
  }
  return has_changed ? std::optional(arguments) : std::nullopt;
}

enum class Form { function, method, constructor };

/// Adds what is called when the function's own arguments do not fit. Its documentation stays as it was.
void explain(const py::object& scope, const std::string& name, const py::handle& function, Form form) {
  PyMethodDef* definition = reinterpret_cast<PyCFunctionObject*>(function.ptr())->m_ml;
  if (definition->ml_doc == nullptr || std::strchr(definition->ml_doc, '(') == nullptr) return;
  const std::string documentation = definition->ml_doc;
  const bool is_in_class = PyType_Check(scope.ptr()) != 0;
  const std::string class_name = is_in_class ? std::string(py::str(scope.attr("__name__"))) : "";
  const std::string shown = form == Form::constructor ? class_name : is_in_class ? class_name + "." + name : name;
  const Signature signature = signature_of(shown, documentation, form != Form::function);
  const py::sibling before(function);
  if (form == Form::constructor) {
    py::cpp_function([signature](py::detail::value_and_holder&, const py::args& given, const py::kwargs& named) {
      refuse(signature, given, 0, named);
    }, py::name(name.c_str()), py::is_method(scope), before, py::detail::is_new_style_constructor());
  } else {
    // The scope outlives its functions.
    const auto call = [signature, name, owner = py::handle(scope), from = form == Form::method ? 1U : 0U](
                          const py::args& given, const py::kwargs& named) -> py::object {
      const std::optional<py::dict> now = respelled(signature, named);
      if (now) return owner.attr(name.c_str())(*given, **py::kwargs(*now));
      refuse(signature, given, from, named);
    };
    if (form == Form::method) {
      py::cpp_function(call, py::name(name.c_str()), py::is_method(scope), before);
    } else {
      py::cpp_function(call, py::name(name.c_str()), py::scope(scope), before);
    }
  }
  replace_documentation(*definition, documentation);
}

/// Operators are left as they are: what does not fit them is NotImplemented.
bool is_special(const std::string& name) { return name.starts_with("__") && name != "__init__"; }

void explain_class(const py::object& cls) {
  const py::list members = py::dict(cls.attr("__dict__").attr("copy")()).attr("items")();
  for (const py::handle& member : members) {
    const std::string name = py::str(member[py::int_(0)]);
    const py::object value = member[py::int_(1)];
    if (is_special(name)) continue;
    if (PyInstanceMethod_Check(value.ptr()) != 0) {
      const py::handle function = PyInstanceMethod_GET_FUNCTION(value.ptr());
      explain(cls, name, function, name == "__init__" ? Form::constructor : Form::method);
    } else if (type_name(value) == "staticmethod") {
      explain(cls, name, cls.attr(name.c_str()), Form::function);
    }
  }
}

void explain_module(const py::object& module, const std::string& root) {
  const py::list members = py::dict(module.attr("__dict__")).attr("items")();
  for (const py::handle& member : members) {
    const std::string name = py::str(member[py::int_(0)]);
    const py::object value = member[py::int_(1)];
    if (PyCFunction_Check(value.ptr()) != 0) {
      explain(module, name, value, Form::function);
    } else if (PyType_Check(value.ptr()) != 0 && !PyExceptionClass_Check(value.ptr())) {
      explain_class(value);
    } else if (PyModule_Check(value.ptr()) != 0 && std::string(PyModule_GetName(value.ptr())).starts_with(root)) {
      explain_module(value, root);
    }
  }
}

}  // namespace

void explain_wrong_calls(py::module_& module) { explain_module(module, py::str(module.attr("__name__"))); }

}  // namespace bindings
