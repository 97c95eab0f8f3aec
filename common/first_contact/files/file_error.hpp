#pragma once
#include <filesystem>
#include <stdexcept>
#include <string>

#include "first_contact/files/printable.hpp"

namespace first_contact {

/// A file that cannot be read or written. The message names the file, as it can be printed, and the reason.
class FileError : public std::runtime_error {
 public:
  /// \param rule  what the file must be, or why it is not that
  FileError(const std::filesystem::path& file, const std::string& rule)
      : std::runtime_error(printable(file.string()) + ": " + rule) {}
};

}  // namespace first_contact
