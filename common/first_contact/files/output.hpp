#pragma once
#include <filesystem>
#include <string_view>

#include "first_contact/files/file_error.hpp"

namespace first_contact {

/// Writes a whole file, or leaves what is there as it is. The content is written aside, under a name that no
/// other run has, and takes the file's place at once; permissions stay. A symbolic link is followed. What is
/// not a plain file, such as a pipe or /dev/stdout, is written to and never replaced.
/// \throws FileError that names the file and the reason, if it cannot be written; nothing is left then.
void write_file(const std::filesystem::path& file, std::string_view content);

/// Throws what `write_file` would throw, as far as it can be known before: nothing is written or left.
void require_writable(const std::filesystem::path& file);

/// Makes a folder, and those above it, where they are missing.
/// \throws FileError that names the folder and the reason.
void make_folder(const std::filesystem::path& folder);

/// Throws if `make_folder` would, or if nothing could be written there, as far as it can be known before.
void require_folder(const std::filesystem::path& folder);

}  // namespace first_contact
