#pragma once
#include <stdexcept>

namespace first_contact {

/// A file that cannot be read or written. The message names the file and the reason.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace first_contact
