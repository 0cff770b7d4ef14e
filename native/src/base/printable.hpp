#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <string_view>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A text as messages show it, valid UTF-8 whatever it was: unprintable bytes, and those of no character, as \x.. and
/// of one longer than `most` bytes the whole characters that fit, and "...".
std::string printable(std::string_view text, std::size_t most = std::string_view::npos);

/// A point in a few digits: where to look.
std::string place_text(const glm::dvec3& p);

}  // namespace splinecore
#pragma GCC visibility pop
