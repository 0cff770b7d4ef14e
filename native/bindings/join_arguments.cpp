#include "join_arguments.hpp"

#include <cctype>
#include <string>
#include <utility>

#include "splinecore/base/errors.hpp"

namespace bindings {

namespace py = pybind11;
using splinecore::InvalidShape;
using splinecore::JoinMoves;
using splinecore::PatchSmoothness;

PatchSmoothness smoothness_of(const py::object& value) {
  const std::pair<const char*, PatchSmoothness> known[] = {{"C0", PatchSmoothness::c0}, {"C1", PatchSmoothness::c1},
                                                           {"G1", PatchSmoothness::g1}, {"C2", PatchSmoothness::c2},
                                                           {"G2", PatchSmoothness::g2}};
  if (py::isinstance<py::str>(value)) {
    std::string word = value.cast<std::string>();
    if (!word.empty()) word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
    for (const auto& [name, smoothness] : known) {
      if (word == name) return smoothness;
    }
  }
  throw InvalidShape("continuity = " + std::string(py::repr(value)) + " is not 'C0', 'C1', 'G1', 'C2' or 'G2'");
}

JoinMoves moves_of(const py::object& value) {
  const std::pair<const char*, JoinMoves> known[] = {
      {"second", JoinMoves::second}, {"first", JoinMoves::first}, {"both", JoinMoves::both}};
  for (const auto& [name, moves] : known) {
    if (py::isinstance<py::str>(value) && value.cast<std::string>() == name) return moves;
  }
  throw InvalidShape("moves = " + std::string(py::repr(value)) + " is not 'second', 'first' or 'both'");
}

}  // namespace bindings
