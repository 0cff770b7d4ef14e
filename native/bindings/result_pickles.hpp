#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "arrays.hpp"
#include "classes.hpp"
#include "values.hpp"

// Results pickle as tuples of their members, in the order in which these are declared.
namespace bindings {

/// How a member becomes a Python object, and comes of one. @throws py::type_error if that is of another kind.
template <class Member>
struct StateOf {
  static py::object from(const Member& member) { return py::cast(member); }
  static Member to(const py::object& state) {
    if (py::isinstance<Member>(state)) return py::cast<const Member&>(state);
    throw py::type_error("the state has " + type_name(state) + " for another kind");
  }
};

template <>
struct StateOf<py::object> {
  static py::object from(const py::object& member) { return member; }
  static py::object to(const py::object& state) { return state; }
};

template <>
struct StateOf<py::tuple> {
  static py::object from(const py::tuple& member) { return member; }
  static py::tuple to(const py::object& state) {
    if (py::isinstance<py::tuple>(state)) return state;
    throw py::type_error("the state has " + type_name(state) + " for a tuple");
  }
};

/// Of numbers that may be nan or infinite.
template <>
struct StateOf<double> {
  static py::object from(double member) { return py::float_(member); }
  static double to(const py::object& state) {
    if (py::isinstance<py::float_>(state)) return py::cast<double>(state);
    throw py::type_error("the state has " + type_name(state) + " for a number");
  }
};

template <>
struct StateOf<int> {
  static py::object from(int member) { return py::int_(member); }
  static int to(const py::object& state) { return integer(state, "the state"); }
};

template <>
struct StateOf<std::size_t> {
  static py::object from(std::size_t member) { return py::int_(member); }
  static std::size_t to(const py::object& state) {
    const int count = integer(state, "the state");
    if (count >= 0) return static_cast<std::size_t>(count);
    throw splinecore::InvalidShape("the state has a count below 0");
  }
};

template <>
struct StateOf<bool> {
  static py::object from(bool member) { return py::bool_(member); }
  static bool to(const py::object& state) { return boolean(state, "the state"); }
};

template <class Number>
struct StateOf<py::array_t<Number>> {
  static py::object from(const py::array_t<Number>& member) { return member; }
  static py::array_t<Number> to(const py::object& state) {
    const bool is_array = py::isinstance<py::array>(state);
    if (is_array && py::array(state).dtype().equal(py::dtype::of<Number>())) return py::array_t<Number>(state);
    throw py::type_error("the state has " + type_name(state) + " for an array of its kind");
  }
};

template <>
struct StateOf<glm::dvec3> {
  static py::object from(const glm::dvec3& member) { return py::make_tuple(member.x, member.y, member.z); }
  static glm::dvec3 to(const py::object& state) {
    const py::tuple parts = state_of_size(state, 3);
    return {StateOf<double>::to(parts[0]), StateOf<double>::to(parts[1]), StateOf<double>::to(parts[2])};
  }
};

template <class Item>
struct StateOf<std::optional<Item>> {
  static py::object from(const std::optional<Item>& member) {
    return member ? StateOf<Item>::from(*member) : py::object(py::none());
  }
  static std::optional<Item> to(const py::object& state) {
    if (state.is_none()) return {};
    return StateOf<Item>::to(state);
  }
};

template <class Item>
struct StateOf<std::vector<Item>> {
  static py::object from(const std::vector<Item>& member) {
    py::tuple items(member.size());
    for (std::size_t i = 0; i < member.size(); ++i) items[i] = StateOf<Item>::from(member[i]);
    return items;
  }
  static std::vector<Item> to(const py::object& state) {
    std::vector<Item> items;
    for (const py::handle& item : StateOf<py::tuple>::to(state)) {
      items.push_back(StateOf<Item>::to(py::reinterpret_borrow<py::object>(item)));
    }
    return items;
  }
};

template <class Item, std::size_t Count>
struct StateOf<std::array<Item, Count>> {
  static py::object from(const std::array<Item, Count>& member) {
    return StateOf<std::vector<Item>>::from({member.begin(), member.end()});
  }
  static std::array<Item, Count> to(const py::object& state) {
    const py::tuple parts = state_of_size(state, Count);
    return [&]<std::size_t... I>(std::index_sequence<I...>) {
      return std::array<Item, Count>{StateOf<Item>::to(parts[I])...};
    }(std::make_index_sequence<Count>());
  }
};

/// Of aggregates whose members these are, all of them, in their order.
template <class Result, class... Members>
py::tuple members_of(const Result& result, Members Result::*... members) {
  return py::make_tuple(StateOf<Members>::from(result.*members)...);
}

template <class Result, class... Members>
Result made_of_members(const py::object& state, Members Result::*...) {
  const py::tuple parts = state_of_size(state, sizeof...(Members));
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return Result{StateOf<Members>::to(parts[I])...};
  }(std::index_sequence_for<Members...>());
}

/// Of a member that has members itself.
template <auto... kMembers>
struct StateOfMembers {
  static py::object from(const auto& member) { return members_of(member, kMembers...); }
  static auto to(const py::object& state) { return made_of_members(state, kMembers...); }
};

template <class Result, class... Members>
void pickle_members(Class<Result>& cls, Members Result::*... members) {
  cls.def(py::pickle([members...](const Result& self) -> py::object { return members_of(self, members...); },
                     [members...](const py::object& state) { return made_of_members(state, members...); }));
}

}  // namespace bindings
