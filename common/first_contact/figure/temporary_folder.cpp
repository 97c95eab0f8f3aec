#include "first_contact/figure/temporary_folder.hpp"

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>
#include <system_error>

#include "first_contact/files/printable.hpp"

namespace first_contact::figure {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(const std::error_code& error) {
  const char* const named = std::getenv("TMPDIR");
  throw std::runtime_error("TMPDIR " + (named != nullptr ? "'" + printable(named) + "'" : "(not set)") +
                           ": must be a folder that can be written to (" + error.message() + ")");
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::random_device random;
  std::error_code error;
  do {
    const std::uint64_t number = std::uint64_t{random()} << 32U | random();
    path_ = fs::temp_directory_path(error) / ("first-contact-" + std::to_string(number));
  } while (!error && !fs::create_directory(path_, error));
  if (error) refuse(error);
}

void TemporaryFolder::refuse_writing() const {
  constexpr std::size_t more_than_a_block = 1 << 16;
  errno = 0;
  std::ofstream out(path_ / "again", std::ios::binary);
  out << std::string(more_than_a_block, ' ') << std::flush;
  refuse(out || errno == 0 ? std::make_error_code(std::errc::io_error)
                           : std::error_code(errno, std::generic_category()));
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace first_contact::figure
