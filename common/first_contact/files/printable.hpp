#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace first_contact {

/// How many bytes of a text a message quotes at most.
inline constexpr std::size_t quoted_bytes = 200;

/// A text as a message can quote it: on one line, and harmless to a terminal. Control characters, and bytes
/// that are not UTF-8, are escaped as in C, "\n" or "\x1b"; of more than `most` bytes the first are shown,
/// and how many there are.
std::string printable(std::string_view text, std::size_t most = quoted_bytes);

}  // namespace first_contact
