#include "signatures.hpp"

#include <cstdlib>
#include <cstring>
#include <new>
#include <string_view>

namespace bindings {

namespace {

/// The parts between commas outside brackets and quotes, up to the bracket that closes.
std::vector<std::string> parts_of(std::string_view text) {
  std::vector<std::string> parts(1);
  int depth = 0;
  char quote = 0;
  for (const char letter : text) {
    if (quote != 0) {
      quote = letter == quote ? '\0' : quote;
    } else if (letter == '\'' || letter == '"') {
      quote = letter;
    } else if (std::strchr("([{", letter) != nullptr) {
      ++depth;
    } else if (std::strchr(")]}", letter) != nullptr && depth-- == 0) {
      break;
    } else if (letter == ',' && depth == 0) {
      parts.emplace_back();
      continue;
    }
    if (letter != ' ' || quote != 0 || !parts.back().empty()) parts.back() += letter;
  }
  return parts;
}

/// "u: object" or "times: object = 1"
Parameter parameter_of(const std::string& part, bool is_by_name) {
  const std::size_t colon = part.find(':');
  const std::size_t equals = part.find(" = ");
  Parameter parameter{part.substr(0, colon), "", "", is_by_name};
  if (equals != std::string::npos) parameter.preset = part.substr(equals + 3);
  if (colon == std::string::npos) return parameter;
  const std::string kind = part.substr(colon + 2, equals == std::string::npos ? equals : equals - colon - 2);
  if (kind != "object") parameter.kind = kind.substr(kind.rfind('.') + 1);
  return parameter;
}

char* copy_of(const std::string& text) {
  auto* copy = static_cast<char*>(std::malloc(text.size() + 1));
  if (copy == nullptr) throw std::bad_alloc();
  std::memcpy(copy, text.c_str(), text.size() + 1);
  return copy;
}

}  // namespace

Signature signature_of(const std::string& name, const std::string& documentation, bool has_self) {
  Signature signature{name, {}};
  const std::string line = documentation.substr(0, documentation.find('\n'));
  bool is_by_name = false;
  std::vector<std::string> parts = parts_of(std::string_view(line).substr(line.find('(') + 1));
  if (has_self) parts.erase(parts.begin());
  for (const std::string& part : parts) {
    if (part.starts_with('*')) {
      is_by_name = true;
      signature.takes_more = signature.takes_more || part.size() > 1;
    } else if (!part.empty() && part != "/") {
      signature.parameters.push_back(parameter_of(part, is_by_name));
    }
  }
  return signature;
}

std::string list_of(const Signature& signature, bool has_self) {
  std::string text = has_self ? "self" : "";
  bool is_by_name = false;
  const auto add = [&text](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  for (const Parameter& parameter : signature.parameters) {
    if (parameter.is_by_name && !is_by_name) add(signature.takes_more ? "*values" : "*");
    is_by_name = parameter.is_by_name;
    add(parameter.name + (parameter.preset.empty() ? "" : "=" + parameter.preset));
  }
  return "(" + text + ")";
}

void replace_documentation(PyMethodDef& definition, const std::string& text) {
  char* copy = copy_of(text);
  std::free(const_cast<char*>(definition.ml_doc));
  definition.ml_doc = copy;
}

}  // namespace bindings
