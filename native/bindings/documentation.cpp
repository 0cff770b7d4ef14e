#include "documentation.hpp"

#include <algorithm>
#include <cstring>
#include <new>
#include <string>
#include <string_view>

#include "arrays.hpp"
#include "signatures.hpp"

namespace bindings {

namespace {

std::string docstring_of(const std::string& name) {
  const auto all = documentation();
  const auto found = std::ranges::lower_bound(all, std::string_view(name), {}, [](const Documented& one) {
    return std::string_view(one.name);
  });
  return found != all.end() && name == found->name ? found->text : "";
}

/// As Python has it of its own functions: "name(u, times=1)\n--\n\n…" is read as a signature and a text.
std::string with_signature(const Signature& signature, bool has_self, const std::string& text) {
  return signature.name + list_of(signature, has_self) + "\n--\n\n" + text;
}

void document_function(const std::string& name, const py::handle& function, bool has_self) {
  PyMethodDef* definition = reinterpret_cast<PyCFunctionObject*>(function.ptr())->m_ml;
  if (definition->ml_doc == nullptr || std::strchr(definition->ml_doc, '(') == nullptr) return;
  const Signature signature = signature_of(definition->ml_name, definition->ml_doc, has_self);
  replace_documentation(*definition, with_signature(signature, has_self, docstring_of(name)));
}

/// Where Python looks for the signature of a class: beside the attribute __doc__, which has none.
void set_signature(const py::handle& cls, const std::string& text) {
#if PY_VERSION_HEX < 0x030D0000
  constexpr auto allocate = &PyObject_Malloc;
  constexpr auto release = &PyObject_Free;
#else
  constexpr auto allocate = &PyMem_Malloc;
  constexpr auto release = &PyMem_Free;
#endif
  auto* type = reinterpret_cast<PyTypeObject*>(cls.ptr());
  auto* copy = static_cast<char*>(allocate(text.size() + 1));
  if (copy == nullptr) throw std::bad_alloc();
  std::memcpy(copy, text.c_str(), text.size() + 1);
  release(const_cast<char*>(type->tp_doc));
  type->tp_doc = copy;
}

void document_constructor(const py::handle& cls, const std::string& name, const py::handle& function) {
  const std::string own = name.substr(name.rfind('.') + 1);
  const PyMethodDef* definition = reinterpret_cast<PyCFunctionObject*>(function.ptr())->m_ml;
  if (definition->ml_doc == nullptr) return;
  set_signature(cls, with_signature(signature_of(own, definition->ml_doc, true), false, docstring_of(name)));
}

void document_class(const py::object& cls, const std::string& name) {
  cls.attr("__doc__") = docstring_of(name);
  const py::list members = py::dict(cls.attr("__dict__").attr("copy")()).attr("items")();
  for (const py::handle& member : members) {
    const std::string own = py::str(member[py::int_(0)]);
    const py::object value = member[py::int_(1)];
    if (PyInstanceMethod_Check(value.ptr()) != 0) {
      const py::handle function = PyInstanceMethod_GET_FUNCTION(value.ptr());
      if (own == "__init__") document_constructor(cls, name, function);
      document_function(name + "." + own, function, true);
    } else if (type_name(value) == "staticmethod") {
      document_function(name + "." + own, cls.attr(own.c_str()), false);
    } else if (type_name(value) == "property") {
      value.attr("__doc__") = docstring_of(name + "." + own);
    }
  }
}

void document_below(const py::object& module, const std::string& prefix, const std::string& root) {
  const py::list members = py::dict(module.attr("__dict__")).attr("items")();
  for (const py::handle& member : members) {
    const std::string name = prefix + std::string(py::str(member[py::int_(0)]));
    const py::object value = member[py::int_(1)];
    if (PyCFunction_Check(value.ptr()) != 0) {
      document_function(name, value, false);
    } else if (PyType_Check(value.ptr()) != 0) {
      document_class(value, name);
    } else if (PyModule_Check(value.ptr()) != 0 && std::string(PyModule_GetName(value.ptr())).starts_with(root)) {
      document_below(value, name + ".", root);
    }
  }
}

}  // namespace

void document(py::module_& module) { document_below(module, "", py::str(module.attr("__name__"))); }

}  // namespace bindings
