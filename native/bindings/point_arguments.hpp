#pragma once

#include <glm/vec3.hpp>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/build/parameterization.hpp"

namespace bindings {

/// Points of two or three numbers, row after row.
std::vector<glm::dvec3> points_of(const py::object& points);

/// Points of two or three numbers; three are read where they lie.
class GivenPoints {
 public:
  /// @param dimensions  1 for a row of points, 2 for a net
  GivenPoints(const py::object& value, const char* name, int dimensions);

  std::span<const glm::dvec3> points() const noexcept { return points_; }
  std::size_t count(int dimension) const { return static_cast<std::size_t>(array_.shape(dimension)); }

 private:
  Doubles array_;
  std::vector<glm::dvec3> copies_;
  std::span<const glm::dvec3> points_;
};

/// Derivatives 1, 2, … at an end of a curve; one vector is the first, None none.
std::vector<glm::dvec3> derivatives_of(const py::object& value, const char* name);

/// One value stands for both directions of a patch.
std::pair<py::object, py::object> both(const py::object& value, const char* name, const char* of = "one for u, one for v");

/// 'uniform', 'centripetal' or 'chordal'
splinecore::Parameterization parameterization_of(const py::object& value, const char* name);

/// A word, or the parameters themselves.
/// @param name  of the argument
std::vector<double> parameters_of(std::span<const glm::dvec3> points, const py::object& parameterization,
                                  splinecore::Closing closing, const char* name);

/// The value that a word stands for. @throws py::type_error if it is no text, InvalidShape if not one of them.
template <class Choice>
Choice chosen(const py::object& word, const char* name, std::initializer_list<std::pair<const char*, Choice>> choices) {
  const bool is_text = py::isinstance<py::str>(word);
  if (!is_text) throw py::type_error(std::string(name) + " must be a str, not " + type_name(word));
  for (const auto& [text, choice] : choices) {
    if (PyUnicode_CompareWithASCIIString(word.ptr(), text) == 0) return choice;
  }
  std::string all;
  for (const auto& [text, choice] : choices) all += std::string(all.empty() ? "'" : ", '") + text + "'";
  throw splinecore::InvalidShape(std::string(name) + " = " + std::string(py::repr(word)) + " is none of " + all);
}

/// 'start' or 'end': whether it is the end.
inline bool is_end_of(const py::object& word, const char* name) {
  return chosen<bool>(word, name, {{"start", false}, {"end", true}});
}

}  // namespace bindings
