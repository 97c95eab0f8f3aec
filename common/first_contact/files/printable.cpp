#include "first_contact/files/printable.hpp"

#include <algorithm>

namespace first_contact {
namespace {

bool continues(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

// The length of the UTF-8 sequence that the text begins with; 0 if it begins with none, or with a control
// character.
std::size_t character(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  if (lead < 0x80U) return lead < 0x20U || lead == 0x7FU ? 0 : 1;
  const std::size_t length = lead < 0xC2U ? 0 : lead < 0xE0U ? 2 : lead < 0xF0U ? 3 : lead < 0xF5U ? 4 : 0;
  if (length == 0 || text.size() < length) return 0;
  if (lead == 0xC2U && static_cast<unsigned char>(text[1]) < 0xA0U) return 0;  // the controls of Latin-1
  return std::all_of(text.begin() + 1, text.begin() + static_cast<std::ptrdiff_t>(length), continues) ? length
                                                                                                      : 0;
}

std::string escaped(char byte) {
  if (byte == '\n') return "\\n";
  if (byte == '\r') return "\\r";
  if (byte == '\t') return "\\t";
  constexpr std::string_view digits = "0123456789abcdef";
  const auto value = static_cast<unsigned char>(byte);
  return std::string("\\x") + digits[value >> 4U] + digits[value & 15U];
}

}  // namespace

std::string printable(std::string_view text, std::size_t most) {
  std::string shown;
  for (std::size_t i = 0; i < text.size();) {
    if (i >= most) return shown + "... (" + std::to_string(text.size()) + " bytes)";
    const std::size_t length = character(text.substr(i));
    shown += length > 0 ? std::string(text.substr(i, length)) : escaped(text[i]);
    i += std::max<std::size_t>(length, 1);
  }
  return shown;
}

}  // namespace first_contact
