#include "first_contact/figure/temporary_folder.hpp"

#include <cstdint>
#include <cstdlib>
#include <random>
#include <stdexcept>
#include <string>
#include <system_error>

#include "first_contact/files/printable.hpp"

namespace first_contact::figure {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
  std::random_device random;
  std::error_code error;
  do {
    const std::uint64_t number = std::uint64_t{random()} << 32U | random();
    path_ = fs::temp_directory_path(error) / ("first-contact-" + std::to_string(number));
  } while (!error && !fs::create_directory(path_, error));
  if (!error) return;
  const char* const named = std::getenv("TMPDIR");
  throw std::runtime_error("TMPDIR " + (named != nullptr ? "'" + printable(named) + "'" : "(not set)") +
                           ": must be a folder that can be written to (" + error.message() + ")");
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace first_contact::figure
