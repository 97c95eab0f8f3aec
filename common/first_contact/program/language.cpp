#include "first_contact/program/language.hpp"

#include <cstdint>

namespace first_contact::program {

namespace {

// The length of a UTF-8 sequence, and the bits of the code point in it, from its first byte.
struct Lead {
  std::size_t length;
  std::uint32_t bits;
};

Lead lead_of(unsigned char byte) {
  if (byte < 0x80U) return {1, byte};
  if (byte < 0xE0U) return {2, byte & 0x1FU};
  if (byte < 0xF0U) return {3, byte & 0x0FU};
  return {4, byte & 0x07U};
}

// Of what the chapters print: mathematics and Chinese. wcwidth depends on the locale, and Windows has none; the
// fmt library takes a combining mark for a column; utf8proc knows all, for thirty lines less here and one
// package more on each system.
std::size_t columns(std::uint32_t code) {
  const bool combining = (code >= 0x0300 && code <= 0x036F) || (code >= 0x20D0 && code <= 0x20FF);
  if (combining) return 0;
  const bool wide = (code >= 0x2E80 && code <= 0xA4CF) || (code >= 0xF900 && code <= 0xFAFF) ||
                    (code >= 0xFE30 && code <= 0xFE4F) || (code >= 0xFF00 && code <= 0xFF60) ||
                    (code >= 0x20000 && code <= 0x3FFFF);
  return wide ? 2 : 1;
}

}  // namespace

std::size_t columns(const std::string& text) {
  std::size_t sum = 0;
  for (std::size_t i = 0; i < text.size();) {
    auto [length, code] = lead_of(static_cast<unsigned char>(text[i]));
    for (std::size_t k = 1; k < length && i + k < text.size(); ++k)
      code = code << 6U | (static_cast<unsigned char>(text[i + k]) & 0x3FU);
    sum += columns(code);
    i += length;
  }
  return sum;
}

std::string padded(const std::string& text, std::size_t width) {
  const std::size_t taken = columns(text);
  return taken < width ? text + std::string(width - taken, ' ') : text;
}

}  // namespace first_contact::program
