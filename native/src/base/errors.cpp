#include "splinecore/base/errors.hpp"

#include <array>
#include <charconv>

namespace splinecore {

PointAtInfinity::PointAtInfinity(double u)
    : std::domain_error("the curve passes through infinity at u = " + text_of(u)) {}

PointAtInfinity::PointAtInfinity(double u, double v)
    : std::domain_error("the patch passes through infinity at u = " + text_of(u) +
                        ", v = " + text_of(v)) {}

std::string text_of(double value) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

std::string index_text(std::size_t index, std::size_t row_length) {
  if (row_length == 0) return "[" + std::to_string(index) + "]";
  return "[" + std::to_string(index / row_length) + ", " + std::to_string(index % row_length) + "]";
}

}  // namespace splinecore
