#include "printable.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace splinecore {

namespace {

/// How many bytes the character at the start of a text has; 0 where there is none that is printed (RFC 3629).
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned first = byte(0);
  if (first < 0x80U) return first >= 0x20U && first != 0x7FU ? 1 : 0;
  const std::size_t length = first >= 0xC2U && first < 0xE0U ? 2 : first >= 0xE0U && first < 0xF0U ? 3 : 4;
  const unsigned least = first == 0xE0U ? 0xA0U : first == 0xF0U ? 0x90U : 0x80U;
  const unsigned most = first == 0xEDU ? 0x9FU : first == 0xF4U ? 0x8FU : 0xBFU;
  if (first < 0xC2U || first > 0xF4U || byte(1) < least || byte(1) > most) return 0;
  for (std::size_t i = 2; i < length; ++i) {
    if (byte(i) < 0x80U || byte(i) > 0xBFU) return 0;
  }
  return length;
}

}  // namespace

std::string printable(std::string_view text, std::size_t most) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string shown;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    const std::size_t taken = std::max<std::size_t>(length, 1);
    if (taken > most) return shown + "...";
    const auto byte = static_cast<unsigned char>(text[0]);
    if (length > 0) {
      shown += text.substr(0, length);
    } else {
      shown += {'\\', 'x', kDigits[byte >> 4U], kDigits[byte & 15U]};
    }
    text.remove_prefix(taken);
    most -= taken;
  }
  return shown;
}

std::string place_text(const glm::dvec3& p) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "(%.5g, %.5g, %.5g)", p.x, p.y, p.z);
  return text.data();
}

}  // namespace splinecore
