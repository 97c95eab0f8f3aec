#include "first_contact/figure/temporary_folder.hpp"

#include <cstdint>
#include <random>
#include <string>
#include <system_error>

namespace first_contact::figure {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
  std::random_device random;
  do
    path_ = fs::temp_directory_path() /
            ("first-contact-" + std::to_string(std::uint64_t{random()} << 32U | random()));
  while (!fs::create_directory(path_));
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace first_contact::figure
