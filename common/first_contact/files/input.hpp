#pragma once
#include <cstddef>
#include <filesystem>
#include <string>

#include "first_contact/files/file_error.hpp"

namespace first_contact {

/// How much is read of what is not a plain file, and so need not have an end: a pipe, a device.
inline constexpr std::size_t most_of_a_stream = std::size_t{1} << 30U;

/// All bytes of a file, a pipe or a device.
/// \param most  of what is not a plain file
/// \throws FileError that names the file and the reason, if it is a folder, cannot be opened, cannot be read
///     to its end, is no plain file and does not end within `most` bytes, or needs more memory than there is.
std::string read_file(const std::filesystem::path& file, std::size_t most = most_of_a_stream);

/// The text without the byte order mark that some editors put before UTF-8.
std::string without_byte_order_mark(std::string text);

}  // namespace first_contact
